#!/usr/bin/env bash
# Replaces the kept pictures by what the program draws now. Look at each that `git diff` shows before committing it.
#   tests/golden/update.sh [BUILD FOLDER] [CASE PATTERN]
set -eu
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.." && pwd)
build=${1:-$root/build}
mkdir -p "$root/tests/golden/pictures"
DERMIS_GOLDEN_UPDATE=1 "$build/bin/dermis_cli_tests" --gtest_filter="*Golden*${2:-}*"
git -C "$root" status --short -- tests/golden
