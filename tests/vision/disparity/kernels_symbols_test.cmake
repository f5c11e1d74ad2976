# SPDX-License-Identifier: Apache-2.0
# The kernels' objects may hold no function of a library, nor ask for any but those that move
# memory: the linker keeps one copy of such a function for the whole program, and it might be the
# one made of instructions that a processor lacks.
#   cmake -DNM=... -DOBJECTS=a.o,b.o -P kernels_symbols_test.cmake
if(NOT NM)
  message("SKIPPED: nm was not found, and nothing else here lists what an object holds")
  return()
endif()

string(REPLACE "," ";" objects "${OBJECTS}")
# The last two are what a compiler may add by itself.
set(allowed "memcpy|memmove|memset|__stack_chk_fail|_GLOBAL_OFFSET_TABLE_")
set(checked 0)
foreach(object ${objects})
  if(NOT object MATCHES "closed_form_kernels_(avx2|avx512|portable)")
    continue()
  endif()
  set(own "horopter::vision::${CMAKE_MATCH_1}::|horopter::vision::k_${CMAKE_MATCH_1}_kernels$")
  execute_process(COMMAND ${NM} -C ${object} OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${NM} cannot read ${object}")
  endif()
  string(REGEX REPLACE "[][;]" "_" symbols "${symbols}")  # which would split or join a list
  string(REPLACE "\n" ";" symbols "${symbols}")
  set(loops 0)
  foreach(symbol ${symbols})
    string(REGEX REPLACE "^[0-9a-f ]* ([A-Za-z]) " "\\1 " symbol "${symbol}")
    if(symbol MATCHES "^. (${own})")
      math(EXPR loops "${loops} + 1")
    elseif(NOT symbol MATCHES "^[tdrbn] |^U (${allowed})$")
      message(SEND_ERROR "${object}: \"${symbol}\" belongs to no kernel")
    endif()
  endforeach()
  if(loops LESS 11)  # ten loops and their table
    message(SEND_ERROR "${object}: only ${loops} symbols of its own: is it what it should be?")
  endif()
  math(EXPR checked "${checked} + 1")
endforeach()
if(checked EQUAL 0)
  message(FATAL_ERROR "no object of the kernels among ${OBJECTS}")
endif()
message("${checked} objects checked")
