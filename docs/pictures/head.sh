#!/bin/bash
# The built-in head from all sides, close up, back-lit, in six tones and at two ages: head.sh DERMIS OUT.png [SAMPLES]
# Needs ImageMagick. Some seven minutes on two cores that have nothing else to do. From 32 samples on reflections are integrated.
set -euo pipefail
dermis=$1 out=$2 samples=${3:-40}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
rows=()

camera() {  # X Y Z of the camera, X Y Z of what it looks at, in metres; degrees
  printf '{"position": [%s, %s, %s], "target": [%s, %s, %s], "vertical_fov_degrees": %s}' "$@"
}
picture() {  # ROW LABEL SIZE CAMERA, then what `dermis render` takes
  local row=$1 label=$2 size=$3 place=$4
  shift 4
  "$dermis" render --model builtin:head --camera "$place" --size "$size" --samples "$samples" --no-metadata -o "$folder/$row-$label.png" "$@"
}
row() {  # NAME PICTURES A ROW, in the order of the labels that follow
  local name=$1 across=$2 pictures=() label
  shift 2
  for label in "$@"; do pictures+=(-label "${label//_/ }" "$folder/$name-$label.png"); done
  montage "${pictures[@]}" -tile "${across}x1" -geometry +3+2 -background '#202020' -fill '#d0d0d0' \
    -font "$(fc-match -f '%{file}' sans)" -pointsize 13 "$folder/$name.png"
  rows+=("$folder/$name.png")
}

from_front=$(camera 0.06 -0.02 1.02 0 -0.035 0 22)
picture views front 300x386 "$from_front" --environment builtin:window
picture views three-quarter 300x386 "$(camera 0.6 -0.01 0.82 0 -0.035 0 22)" --environment builtin:studio
picture views profile 300x386 "$(camera -1.02 -0.02 0 0 -0.035 0 22)" --environment builtin:clinic
picture views from_below 300x386 "$(camera 0.12 -0.42 0.62 0 -0.045 0.04 20)" --environment builtin:overcast
row views 4 front three-quarter profile from_below

picture close eye 300x260 "$(camera -0.06 0.01 0.45 -0.032 0.004 0.07 9)" --environment builtin:window
picture close mouth 300x260 "$(camera -0.1 -0.05 0.5 -0.004 -0.062 0.09 9)" --environment builtin:window
picture close ear 300x260 "$(camera -0.55 0 0.06 -0.075 -0.015 -0.01 9)" --environment builtin:studio
picture close back-lit 300x260 "$(camera 0.24 0.01 0.62 0.082 -0.016 -0.01 8)" --environment "${0%/*}/back-light.json"
row close 4 eye mouth ear back-lit

face=$(camera 0.1 -0.02 0.95 0 -0.02 0.02 17)
tones=()
for tone in i ii iii iv v vi; do
  case $tone in  # the eyes that mostly go with it
    i | ii | iii) iris=() ;;
    *) iris=(--material eye=builtin:eye_brown) ;;
  esac
  picture tones "tone_$tone" 198x250 "$face" --environment builtin:clamshell --material "face=builtin:face_tone_$tone" "${iris[@]}"
  tones+=("tone_$tone")
done
row tones 6 "${tones[@]}"

grey=(--material hair=builtin:hair_grey)
picture ages 28_years 300x386 "$from_front" --environment builtin:golden_hour
picture ages 72_years 300x386 "$from_front" --environment builtin:golden_hour --material face=builtin:face_aged "${grey[@]}"
picture ages flushed 300x386 "$from_front" --environment builtin:overcast --material face=builtin:face_flushed
picture ages night 300x386 "$from_front" --environment builtin:night_street --material face=builtin:face_tone_iv
row ages 4 28_years 72_years flushed night

convert "${rows[@]}" -background '#202020' -gravity center -append +repage -depth 8 -define png:compression-level=9 "$out"
