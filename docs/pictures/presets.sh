#!/bin/bash
# The contact sheet of the built-in presets, each as its thumbnail shows it: presets.sh DERMIS OUT.png [SAMPLES]
# Needs ImageMagick.
set -euo pipefail
dermis=$1 out=$2 samples=${3:-40}
here=$(cd -- "$(dirname -- "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
presets=()
for file in "$here"/../../resources/presets/*.json; do presets+=("$(basename "$file" .json)"); done
"$dermis" thumbnails "${presets[@]/#/builtin:}" --size 152x152 --samples "$samples" -o "$folder" >/dev/null
pictures=()
for preset in "${presets[@]}"; do pictures+=(-label "${preset//_/ }" "$folder/$preset.png"); done
montage "${pictures[@]}" -tile 8x -geometry +3+2 -background '#202020' -fill '#d0d0d0' -font "$(fc-match -f '%{file}' sans)" -pointsize 11 \
  -define png:compression-level=9 "$out"
