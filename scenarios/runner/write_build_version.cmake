# SPDX-License-Identifier: Apache-2.0
# Writes HEADER with the commit that SOURCE_DIR is at, "-dirty" behind it when tracked files differ
# from it, or "unknown" where there is no git. A header that would not change keeps its time, and
# DEPFILE names all that the answer depends on, so that an unchanged tree has nothing to build.
#   cmake -DSOURCE_DIR=... -DHEADER=... -DDEPFILE=... -P write_build_version.cmake
cmake_minimum_required(VERSION 3.25)
set(commit unknown)
set(inputs "")
find_package(Git QUIET)

function(git out)
  execute_process(COMMAND ${GIT_EXECUTABLE} --no-optional-locks -C ${SOURCE_DIR} ${ARGN}
                  OUTPUT_VARIABLE text ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE
                  RESULT_VARIABLE failed)
  if(failed)
    set(text "")
  endif()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

if(GIT_FOUND)
  # A copy without history inside another project's repository is not at that project's commit.
  git(top rev-parse --show-toplevel)
  file(REAL_PATH ${SOURCE_DIR} source)
  if(top STREQUAL source)
    git(described describe --always)
    if(described)
      # Not describe's own --dirty, which writes the index and so would call for another build.
      git(changes status --porcelain --untracked-files=no)
      set(commit ${described})
      if(changes)
        string(APPEND commit -dirty)
      endif()
    endif()
    git(branch symbolic-ref -q HEAD)
    foreach(name HEAD logs/HEAD packed-refs refs/tags ${branch})
      git(path rev-parse --git-path ${name})
      get_filename_component(path ${path} ABSOLUTE BASE_DIR ${SOURCE_DIR})
      list(APPEND inputs ${path})
    endforeach()
    git(tracked ls-files)
    string(REPLACE "\n" ";" tracked "${tracked}")
    list(TRANSFORM tracked PREPEND ${SOURCE_DIR}/)
    list(APPEND inputs ${tracked})
  endif()
endif()

set(rule "${HEADER}:")
foreach(input ${inputs})
  if(EXISTS ${input})
    string(REPLACE " " "\\ " input "${input}")
    string(APPEND rule " \\\n  ${input}")
  endif()
endforeach()
file(WRITE ${DEPFILE} "${rule}\n")

file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
"// Written by the build.
#pragma once
#define HOROPTER_COMMIT \"@commit@\"
")
