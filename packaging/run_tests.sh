# Runs the built test programs and counts. To be sourced by bash after setup.sh.
#
#   dermis_run_tests BUILD_FOLDER FILTER KIND…   one program a kind (tests/CMakeLists.txt); FILTER is GoogleTest's
#   dermis_close                                 the closing line, and the exit status

dermis_passed=0 dermis_failed=0 dermis_skipped=0
dermis_scratch='' dermis_xvfb=''

dermis_clean_up() {
  [[ -z $dermis_xvfb ]] || kill "$dermis_xvfb" 2>/dev/null
  [[ -z $dermis_scratch ]] || rm -rf "$dermis_scratch"
}

# A home of their own, so that no test reads or changes a person's settings and caches, and a private temporary folder.
dermis_scratch_home() {
  dermis_scratch=$(mktemp -d) || dermis_die "No temporary folder can be made; is the disk full?"
  trap dermis_clean_up EXIT
  trap 'exit 130' INT TERM
  mkdir -p "$dermis_scratch"/{home,tmp,run,config,data}
  chmod 700 "$dermis_scratch/run"
  # The GL driver's compiled shaders stay from one run to the next; nothing else does.
  mkdir -p "$1/test-shader-cache"
  export HOME=$dermis_scratch/home TMPDIR=$dermis_scratch/tmp XDG_RUNTIME_DIR=$dermis_scratch/run \
    XDG_CONFIG_HOME=$dermis_scratch/config XDG_DATA_HOME=$dermis_scratch/data XDG_CACHE_HOME=$dermis_scratch/home/.cache \
    MESA_SHADER_CACHE_DIR=$1/test-shader-cache LC_ALL=C.UTF-8
  unset DISPLAY WAYLAND_DISPLAY DERMIS_SHADER_DIR OCIO QT_QPA_PLATFORM
}

# An X server on a free display number; its number on stdout of the server's -displayfd.
dermis_start_xvfb() {
  local number='' tries
  [[ -n $dermis_xvfb ]] && return 0
  : >"$dermis_scratch/display"
  Xvfb -displayfd 3 -screen 0 1600x1000x24 +extension GLX -nolisten tcp 3>"$dermis_scratch/display" >"$dermis_scratch/xvfb.log" 2>&1 &
  dermis_xvfb=$!
  for ((tries = 0; tries < 100; ++tries)); do
    number=$(<"$dermis_scratch/display")
    [[ -n $number ]] && break
    kill -0 "$dermis_xvfb" 2>/dev/null || break
    sleep 0.1
  done
  [[ -n $number ]] || dermis_die "Xvfb did not start: $(tail -n 1 "$dermis_scratch/xvfb.log")"
  dermis_display=:$number
}

dermis_run_tests() {
  local folder=$1 filter=$2 kind program status counts passed failed skipped total seconds rest
  shift 2
  for kind; do
    program=$folder/bin/dermis_${kind/arrows/arrow}_tests
    [[ -x $program ]] || continue
    local -a environment=(env)
    if [[ $kind == ui ]]; then
      dermis_start_xvfb
      environment+=("DISPLAY=$dermis_display" QT_QPA_PLATFORM=xcb)
    fi
    counts=$dermis_scratch/counts
    : >"$counts"
    seconds=$SECONDS
    timeout --foreground --kill-after=10 1200 "${environment[@]}" "$program" --gtest_color=no --gtest_filter="$filter" 2>&1 </dev/null |
      tee "$folder/test-$kind.log" | awk -v counts="$counts" -f "$dermis_root/packaging/gtest_report.awk"
    status=${PIPESTATUS[0]}
    read -r passed failed skipped total <"$counts" || { passed=0 failed=1 skipped=0 total=1; }
    rest=$((total - passed - failed - skipped))
    if ((rest > 0)); then
      printf '%s: %d tests were not reached, the program ended with %d before them\n' "$kind" "$rest" "$status"
      failed=$((failed + rest))
    elif ((status != 0 && failed == 0)); then
      printf '%s: the program ended with %d after its tests\n' "$kind" "$status"
      failed=1
    fi
    dermis_passed=$((dermis_passed + passed)) dermis_failed=$((dermis_failed + failed)) dermis_skipped=$((dermis_skipped + skipped))
    ((total == 0 && failed == 0)) || printf '%-7s %4d passed, %d failed, %d skipped in %d s\n' "$kind" "$passed" "$failed" "$skipped" $((SECONDS - seconds))
  done
}

dermis_close() {
  local line="$dermis_passed passed, $dermis_failed failed"
  ((dermis_skipped == 0)) || line+=", $dermis_skipped skipped"
  printf '%s\n' "$line"
  ((dermis_failed == 0 && dermis_passed > 0))
}
