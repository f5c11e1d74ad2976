#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes results/paper/disparity_tables.md, disparity_time.svg and disparity_fields.png: accuracy,
# time, robustness, memory and ablation of the disparity methods on real and rendered pairs.
# Needs a release build (./test makes one), the published pairs (real_pair.h says where), pngquant,
# and three minutes of an idle machine.
#   tests/vision/disparity/paper_tables.sh
set -eu
cd "$(dirname "$0")/../../.."
readonly horopter=build/release/scenarios/cli/horopter
readonly accuracy=build/release/tests/vision/disparity/horopter_accuracy_vision_disparity
readonly out=results/paper
readonly all=v1:accurate,v1:dense,v1:fast,v1:realtime,v1:checked,v1:paper_2009,v1:paper_2018,dis:medium,dis:medium_unchecked,farneback,sgbm:3way,sgbm:sgbm,bm
readonly main=v1:accurate,v1:fast,v1:realtime,dis:medium,sgbm:3way
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# render NAME SCENE OPTION...: a verged pair of VGA with a webcam's noise.
render() {
  local name=$1 scene=$2
  shift 2
  "$horopter" render "$scene" --profile vga_noise --truth --seed 1 --out "$work/$name" "$@" >/dev/null
  rendered+=(--rendered "$work/$name")
}
rendered=()
render koala_room_far koala/room.xml --pan 0 --vergence 2
render koala_room_near koala/room.xml --pan 20 --tilt 10 --vergence 8
render nao_workspace nao/workspace.xml --tilt 15 --camera eyes
render yorick_table_near yorick/tabletop.xml --vergence 12 --camera peripheral
"$horopter" render koala/room.xml --pan 20 --tilt 10 --vergence 8 --seed 1 --out "$work/clean" >/dev/null

{
  echo "# Disparity: tables"
  echo
  echo "Made by \`tests/vision/disparity/paper_tables.sh\`; disparity.md says what they mean."
  "$accuracy" --methods $all --parts scenes --repeat 5 --plot "$out/disparity_time.svg"
  "$accuracy" --methods $main --parts noise,gain,vertical,range --repeat 1
  "$accuracy" --methods $main --parts ablation --repeat 3 "${rendered[@]}"
  echo
  echo "### Memory of \`horopter disparity\` at 640x480 [MB]"
  echo
  echo "| preset | peak | of it before the pair is matched |"
  echo "|---|---:|---:|"
  for preset in accurate fast realtime; do
    "$horopter" disparity "$work"/clean/000000/{left,right}.png --preset $preset --json |
      awk -v preset=$preset -F '[:,]' '
        /"peak_memory_mb"/ { peak = $2 } /"peak_memory_before_mb"/ { before = $2 }
        END { printf "| v1:%s | %.0f | %.0f |\n", preset, peak, before }'
  done
} >"$out/disparity_tables.md"
"$accuracy" --methods v1:accurate,v1:dense,v1:realtime,dis:medium --parts scenes --scene "verged A" \
  --repeat 1 --pictures "$work/fields.png" >/dev/null
pngquant --force --output "$out/disparity_fields.png" 64 "$work/fields.png"
