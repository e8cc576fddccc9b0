#!/bin/bash
# The contact sheet of the built-in presets: presets.sh DERMIS HEAD OUT.jpg [SAMPLES]
# HEAD is a head in metres, the middle of its face near the origin, looking along +Z. Needs ImageMagick.
set -euo pipefail
dermis=$1 head=$2 out=$3 samples=${4:-32}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
pictures=()
for preset in skin_tone_{i,ii,iii,iv,v,vi} skin_{freckled,flushed,pale_thin,elderly} wax jade marble milk; do
  "$dermis" render "${0%/*}/portrait.dermis" --model "$head" --material "builtin:$preset" \
    --size 256x320 --samples "$samples" --no-metadata -o "$folder/$preset.png"
  label=${preset#skin_}
  pictures+=(-label "${label//_/ }" "$folder/$preset.png")
done
montage "${pictures[@]}" -tile 7x2 -geometry +4+2 -background '#303030' -fill '#d8d8d8' -font "$(fc-match -f "%{file}" sans)" -pointsize 15 -quality 88 "$out"
