#!/bin/bash
# The views that B goes through, of the built-in look: views.sh DERMIS OUT.jpg [SAMPLES]
# Needs ImageMagick.
set -euo pipefail
dermis=$1 out=$2 samples=${3:-64}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
camera='{"position": [0.30, -0.02, 0.92], "target": [0, -0.02, 0.02], "vertical_fov_degrees": 17}'
views=(diffuse diffuse_scattered specular transmission thickness normal occlusion energy depth)
"$dermis" render --camera "$camera" --size 256x320 --samples "$samples" --no-metadata "${views[@]/#/--aov=}" \
  -o "$folder/view.png"
pictures=(-label 'final picture' "$folder/view.png")
for view in "${views[@]}"; do
  case $view in
    diffuse) name='diffuse before diffusion' ;;
    diffuse_scattered) name='diffuse after diffusion' ;;
    occlusion) name='ambient occlusion' ;;
    *) name=$view ;;
  esac
  pictures+=(-label "$name" "$folder/view.$view.png")
done
montage "${pictures[@]}" -tile 5x -geometry +3+2 -background '#202020' -fill '#d0d0d0' -font "$(fc-match -f '%{file}' sans)" -pointsize 12 \
  -quality 92 "$out"
