#!/bin/bash
# The contact sheet of the built-in presets: presets.sh DERMIS HEAD ENVIRONMENT OUT.jpg [SAMPLES]
# HEAD is any head in metres, ENVIRONMENT a lat-long image. Needs ImageMagick.
set -euo pipefail
dermis=$1 head=$2 environment=$3 out=$4 samples=${5:-32}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
pictures=()
for preset in skin_tone_{i,ii,iii,iv,v,vi} skin_{freckled,flushed,pale_thin,elderly} wax jade marble milk; do
  "$dermis" render --model "$head" --environment "$environment" --material "builtin:$preset" --camera three-quarter \
    --size 256x320 --samples "$samples" --no-metadata -o "$folder/$preset.png"
  label=${preset#skin_}
  pictures+=(-label "${label//_/ }" "$folder/$preset.png")
done
montage "${pictures[@]}" -tile 7x2 -geometry +4+2 -background '#303030' -fill '#d8d8d8' -pointsize 15 -quality 88 "$out"
