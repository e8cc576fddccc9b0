# What ./run and ./test share: Debian's packages, and an up-to-date build. To be sourced by bash with dermis_root set to the repository.
#
#   dermis_packages SECTION…        installs what is missing of packages.txt
#   dermis_build PRESET TARGET…     configures and builds, one at a time
#
# Both say nothing when nothing is to be done, and never write to stdout: that belongs to the program.

dermis_say() { printf '%s\n' "$*" >&2; }

dermis_die() {
  dermis_say "$*"
  exit 1
}

# The folder of a preset: build for release, build-NAME for the others.
dermis_build_folder() {
  if [[ $1 == release ]]; then printf '%s/build' "$dermis_root"; else printf '%s/build-%s' "$dermis_root" "$1"; fi
}

# One process at a time installs and builds; the others wait. The lock ends with the descriptor, thus also with a killed process.
dermis_lock() {
  { mkdir -p "$dermis_root/build" && exec 9>"$dermis_root/build/.lock"; } 2>/dev/null ||
    dermis_die "$dermis_root/build cannot be written: copy the repository to a folder of your own and start from there."
  if ! flock -w 2 9; then
    dermis_say "Waiting for another build in $dermis_root to end."
    flock 9
  fi
}

dermis_unlock() { exec 9>&-; }

# --- packages -----------------------------------------------------------------------------------------------------------------------

# The names in the given sections of packages.txt.
dermis_package_names() {
  local line section='' wanted=" $* "
  while read -r line; do
    case $line in
      '' | '#'*) ;;
      '['*']')
        section=${line#[}
        section=${section%]}
        ;;
      *) [[ $wanted == *" $section "* ]] && printf '%s\n' "${line%%[[:space:]]*}" ;;
    esac
  done <"$dermis_root/packaging/packages.txt"
}

# Those of the given packages that are not installed.
dermis_missing() {
  local name
  local -A installed=()
  while read -r name; do installed[$name]=1; done < <(
    dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p')
  for name; do [[ -n ${installed[$name]:-} ]] || printf '%s\n' "$name"; done
}

# Runs a command as root: directly, or through a sudo that works.
dermis_as_root() {
  if ((EUID == 0)); then "$@"; else sudo "$@"; fi
}

dermis_can_be_root() {
  ((EUID == 0)) && return 0
  command -v sudo >/dev/null || return 1
  if [[ -t 0 && -t 2 ]]; then sudo -v; else sudo -n true 2>/dev/null; fi
}

dermis_packages() {
  command -v dpkg-query >/dev/null || return 0 # not a Debian: CMake says what it misses
  local stamp=$dermis_root/build/.packages-$*
  stamp=${stamp// /-}
  # Nothing was installed or removed since all of them were there, and the list is the same.
  [[ $stamp -nt /var/lib/dpkg/status && $stamp -nt $dermis_root/packaging/packages.txt ]] && return 0

  local -a names missing
  mapfile -t names < <(dermis_package_names "$@")
  mapfile -t missing < <(dermis_missing "${names[@]}")
  if ((${#missing[@]})); then
    dermis_can_be_root ||
      dermis_die "Missing packages: have root run  apt-get install -y --no-install-recommends ${missing[*]}  and start again."
    dermis_say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
    local -a apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3)
    # An update that fails in part may still be enough; the installation will tell.
    dermis_as_root "${apt[@]}" update </dev/null >&2 9>&- || dermis_say "apt-get update failed; trying with the lists that are there."
    dermis_as_root "${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null >&2 9>&- ||
      dermis_die "apt-get could not install: ${missing[*]} (its reason stands above)."
  fi
  : >"$stamp"
}

# --- building -----------------------------------------------------------------------------------------------------------------------

# Compilations at once: a core each, as long as there is 1 GiB of memory for each.
dermis_jobs() {
  local cores key kib available=0
  cores=$(nproc)
  while read -r key kib _; do [[ $key == MemAvailable: ]] && available=$((kib / 1048576)); done </proc/meminfo
  ((available < 1)) && available=1
  printf '%d' $((cores < available ? cores : available))
}

# Ninja's and CMake's lines to stderr, without those that only say that there was nothing to do.
dermis_build_output() {
  local line progress=''
  while IFS= read -r line; do
    case $line in
      'ninja: no work to do.' | 'ninja: Entering directory'* | '['*'] Re-checking globbed directories'*) continue ;;
      '-- '* | '' | 'Preset CMake variables:' | '  '[A-Z]*'="'*) continue ;;
    esac
    if [[ -t 2 && $line == '['[0-9]* ]]; then
      printf '\r\033[K%.*s' "${COLUMNS:-80}" "$line" >&2
      progress=1
    else
      [[ -n $progress ]] && printf '\r\033[K' >&2
      progress=''
      printf '%s\n' "$line" >&2
    fi
  done
  [[ -z $progress ]] || printf '\r\033[K' >&2
}

# ccache is used where it is installed and has a folder it may write to.
dermis_ccache_works() {
  command -v ccache >/dev/null && mkdir -p "$(ccache --get-config cache_dir)" 2>/dev/null
}

dermis_build() {
  local preset=$1 folder key
  shift
  folder=$(dermis_build_folder "$preset")
  # What configuring depends on and CMake does not look at again by itself.
  key="$dermis_root $(command -v ccache)"
  [[ -e /usr/include/gtest/gtest.h ]] && key+=' gtest'
  [[ -e /usr/include/benchmark/benchmark.h ]] && key+=' benchmark'
  if [[ ! -e $folder/build.ninja || ! -e $folder/.configured || $(<"$folder/.configured") != "$key" ]]; then
    dermis_say "Configuring Dermis ($preset) in $folder"
    local -a options=()
    dermis_ccache_works && options=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    mkdir -p "$folder"
    (cd "$dermis_root" && cmake --fresh --preset "$preset" "${options[@]}") 2>&1 | dermis_build_output
    ((PIPESTATUS[0] == 0)) || dermis_die "CMake could not configure Dermis; its reason stands above."
    printf '%s\n' "$key" >"$folder/.configured"
  fi
  ninja -C "$folder" -j "$(dermis_jobs)" "$@" 2>&1 </dev/null | dermis_build_output
  ((PIPESTATUS[0] == 0)) || dermis_die "Dermis did not build; the first error stands above."
}
