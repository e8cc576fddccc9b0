#!/usr/bin/env bash
# Collects the words of the editor for translators: writes translations/dermis_template.ts anew, and takes new words over
# into every translations/dermis_LANGUAGE.ts there is. To begin a language: packaging/translations.sh hr
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
lupdate=$(command -v lupdate || echo /usr/lib/qt6/bin/lupdate)
[[ -x $lupdate ]] || { echo "lupdate is missing: install qt6-l10n-tools" >&2; exit 1; }
# The core's tables of parameters, models and maps know no Qt: the program itself says what they hold.
dermis=${DERMIS:-build/bin/dermis}
[[ -x $dermis ]] || { echo "$dermis is missing: ./run builds it, or DERMIS=… says where it is" >&2; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$dermis" parameters --words | while IFS= read -r word; do
  word=${word//\\/\\\\}
  printf 'QT_TRANSLATE_NOOP("tables", "%s")\n' "${word//\"/\\\"}"
done >"$folder/tables.cpp"
# Places in the source are left out: they would change with every line.
"$lupdate" -silent -I . -locations none -no-obsolete -source-language en ui "$folder/tables.cpp" -ts translations/dermis_template.ts
for language in "$@"; do
  "$lupdate" -silent -I . -locations none -source-language en -target-language "$language" ui "$folder/tables.cpp" -ts "translations/dermis_$language.ts"
done
for file in translations/dermis_*.ts; do
  [[ $file == *_template.ts ]] || "$lupdate" -silent -I . -locations none ui "$folder/tables.cpp" -ts "$file"
done
