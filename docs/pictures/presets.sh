#!/bin/bash
# The contact sheet of the built-in presets on the built-in head: presets.sh DERMIS OUT.png [SAMPLES]
# Needs ImageMagick.
set -euo pipefail
dermis=$1 out=$2 samples=${3:-40}
here=$(cd -- "$(dirname -- "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
camera='{"position": [0.14, -0.02, 0.95], "target": [0, -0.02, 0.02], "vertical_fov_degrees": 17}'
pictures=()
for file in "$here"/../../resources/presets/*.json; do
  preset=$(basename "$file" .json)
  case $preset in
    eye_* | *_eye) slot=eye ;;
    hair_*) slot=hair ;;
    *_lens) slot=lens ;;
    *) slot=face ;;
  esac
  "$dermis" render --model builtin:head --camera "$camera" --material "$slot=builtin:$preset" \
    --size 152x190 --samples "$samples" --no-metadata -o "$folder/$preset.png"
  pictures+=(-label "${preset//_/ }" "$folder/$preset.png")
done
montage "${pictures[@]}" -tile 8x -geometry +3+2 -background '#202020' -fill '#d0d0d0' -font "$(fc-match -f '%{file}' sans)" -pointsize 11 \
  -define png:compression-level=9 "$out"
