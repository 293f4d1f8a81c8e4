#!/bin/sh
# gallery.sh PROGRAM EXAMPLES FOLDER: writes FOLDER/gallery.md with the papers' figures and the fitted examples.
set -eu
program=$1 examples=$2 folder=$3
mkdir -p "$folder"
{
  echo '# Gallery'
  echo
  echo "Every picture is drawn from what the library computes: \`torse figures -o DIR\` draws the papers' figures,"
  echo '`torse fit RAILS -o OUT --svg PICTURE` the strips.'
  echo
  echo "## The papers' figures"
  "$program" figures -o "$folder" | while read -r id title; do
    printf '\n### %s: %s\n\n![%s](%s.svg)\n' "$id" "$title" "$title" "$id"
  done
  echo
  echo '## Strips between two rails'
  for rails in "$examples"/*.json; do
    name=$(basename "$rails" .json)
    "$program" fit "$rails" -o "$folder/$name.strip.json" --svg "$folder/$name.svg" > "$folder/$name.txt"
    printf '\n### %s\n\n    torse fit examples/%s.json -o strip.step --svg picture.svg\n\n![The strip before and after, its mapping and its warp](%s.svg)\n' "$name" "$name" "$name"
  done
} > "$folder/gallery.md"
