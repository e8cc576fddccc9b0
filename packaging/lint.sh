# ./test --lint [BASE]. To be sourced by bash after setup.sh and run_tests.sh.
#
# clang-format looks at every source file, the include arrows at every layer. clang-tidy takes 5 to 20 s a file, so it looks at the .cpp
# files changed since BASE (a changed header brings the .cpp of its name, or else one that includes it) and stops starting new ones
# after DERMIS_TIDY_SECONDS (300 by default, 0 for no end), naming how many were left. Without BASE: since the commit the branch left
# origin's main branch, or where it hasn't, since the commit before.

dermis_sources() { git -C "$dermis_root" ls-files -- '*.cpp' '*.h'; }

dermis_lint_base() {
  local name base head
  head=$(git -C "$dermis_root" rev-parse HEAD)
  for name in origin/HEAD origin/main; do
    base=$(git -C "$dermis_root" merge-base HEAD "$name" 2>/dev/null) || continue
    [[ $base != "$head" ]] && printf '%s' "$base" && return
  done
  git -C "$dermis_root" rev-parse --verify -q HEAD~1 || git -C "$dermis_root" rev-list --max-parents=0 HEAD | tail -n 1
}

# The .cpp files to look at, those changed since $1, each once, and only what the build compiles.
dermis_tidy_files() {
  local file source
  git -C "$dermis_root" diff --name-only --diff-filter=d "$1" -- '*.cpp' '*.h' | while read -r file; do
    case $file in
      *.cpp) printf '%s\n' "$file" ;;
      *)
        source=${file%.h}.cpp
        if [[ -e $dermis_root/$source ]]; then
          printf '%s\n' "$source"
        else
          git -C "$dermis_root" grep -l --fixed-strings "/${file##*/}\"" -- '*.cpp' | head -n 1
        fi
        ;;
    esac
  done | sort -u
}

dermis_format_check() {
  local -a files
  mapfile -t files < <(dermis_sources)
  (cd "$dermis_root" && clang-format --dry-run --Werror "${files[@]}") 2>&1 | awk -F: '/error:.*clang-format/ { n[$1]++ } END { for (f in n) print f ": " n[f] " places are not laid out as .clang-format says; run clang-format -i on it" }' | sort
  return "${PIPESTATUS[0]}"
}

# How each file of the build in the folder $1 is compiled, in $2, without GCC's precompiled headers: clang can't read them, and a
# file has to include what it uses.
dermis_tidy_commands() {
  mkdir -p "$2" &&
    sed -E 's/ -Winvalid-pch//g; s/ -include [^ ]*cmake_pch\.hxx//g' "$1/compile_commands.json" >"$2/compile_commands.json"
}

# One clang-tidy a core; a file's output is printed whole.
dermis_tidy() {
  local folder=$1 limit=${DERMIS_TIDY_SECONDS:-300} file started=$SECONDS failures left=0
  shift
  failures=$(mktemp)
  for file; do
    if ((limit > 0 && SECONDS - started >= limit)); then
      left=$((left + 1))
      continue
    fi
    while (($(jobs -rp | wc -l) >= $(nproc))); do wait -n; done
    (
      output=$(cd "$dermis_root" && clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option -p "$folder" "$file" 2>&1) || {
        printf '%s\n' "$output" | grep -v -E '^[0-9]+ warnings? (and [0-9]+ errors? )?generated|^Suppressed |^Use -header-filter|^Error while processing'
        printf '%s\n' "$file" >>"$failures"
      }
    ) &
  done
  wait
  ((left == 0)) || printf 'clang-tidy: %d more files were left, DERMIS_TIDY_SECONDS=%d has passed\n' "$left" "$limit"
  dermis_tidy_checked=$(($# - left))
  dermis_tidy_failed=$(wc -l <"$failures")
  rm -f "$failures"
}

dermis_lint() {
  local folder base passed=0 failed=0
  local -a files
  if [[ -n $1 ]]; then
    base=$(git -C "$dermis_root" rev-parse --verify -q "$1^{commit}") || {
      dermis_say "$1 names no commit here."
      exit 2
    }
  fi
  dermis_lock
  dermis_packages build run test lint
  folder=$(dermis_build_folder release)
  # Compiling makes the generated sources that clang-tidy reads; where everything is built this takes no time.
  dermis_build release check_arrows all
  dermis_unlock
  [[ -n $1 ]] || base=$(dermis_lint_base)

  dermis_format_check && printf 'clang-format: %d files are laid out as they should be\n' "$(dermis_sources | wc -l)"
  (($? == 0)) && passed=$((passed + 1)) || failed=$((failed + 1))

  mapfile -t files < <(dermis_tidy_files "$base")
  dermis_tidy_commands "$folder" "$folder/tidy"
  dermis_tidy "$folder/tidy" "${files[@]}"
  printf 'clang-tidy: %d files changed since %s looked at, %d with findings\n' "$dermis_tidy_checked" "${base:0:10}" "$dermis_tidy_failed"
  passed=$((passed + dermis_tidy_checked - dermis_tidy_failed)) failed=$((failed + dermis_tidy_failed))

  dermis_scratch_home "$folder"
  dermis_run_tests "$folder" '*' arrows
  dermis_passed=$((dermis_passed + passed)) dermis_failed=$((dermis_failed + failed))
  dermis_close
}
