#!/usr/bin/env bash
# Tries ./run and ./test as a new user would: in a fresh Debian 12 (minbase, made by debootstrap) to which only git and
# ca-certificates are added, from a clone of what is committed here.
#   sudo packaging/try-fresh-debian.sh [--keep] [FOLDER]
# FOLDER (a temporary one by default) must be empty or missing; --keep leaves the system there afterwards. Needs root, debootstrap and
# about 6 GiB. The host's package sources and its settings for fetching (a proxy, a mirror) are used inside too. The last lines are what
# each step took; exit 1 where one failed.
set -u
repository=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
keep=''
if [[ ${1:-} == --keep ]]; then
  keep=1
  shift
fi

die() {
  printf '%s\n' "$*" >&2
  exit 1
}

((EUID == 0)) || die "A chroot needs root: start this with sudo."
command -v debootstrap >/dev/null || die "debootstrap is missing: apt-get install -y --no-install-recommends debootstrap"
target=${1:-$(mktemp -d)} || die "No temporary folder can be made."
mkdir -p "$target" && [[ -z $(ls -A "$target") ]] || die "$target is not an empty folder."
target=$(cd "$target" && pwd)

# Nothing of the host's may be below the folder when it is removed, so without a clean unmount it stays.
clean_up() {
  local mounted
  for mounted in proc dev/pts dev; do
    mountpoint -q "$target/$mounted" && umount "$target/$mounted"
  done
  if grep -qF " $target/" /proc/mounts; then
    printf 'Something is still mounted below %s; it is left there.\n' "$target" >&2
  elif [[ -z $keep ]]; then
    rm -rf --one-file-system -- "$target"
  else
    printf 'Kept in %s\n' "$target"
  fi
}
trap clean_up EXIT
trap 'exit 130' INT TERM

# The first mirror that the host itself uses for Debian.
mirror=$(sed -n -e 's/^URIs: *\([^ ]*\).*/\1/p' -e 's/^deb \(\[[^]]*\] \)\{0,1\}\([^ ]*\).*/\2/p' \
  /etc/apt/sources.list /etc/apt/sources.list.d/*.sources /etc/apt/sources.list.d/*.list 2>/dev/null | grep '/debian/\{0,1\}$' | head -n 1)
failed=0
times=''

step() {
  local name=$1 started=$SECONDS result=ok
  shift
  printf '\n=== %s\n' "$name"
  "$@" </dev/null || {
    result="FAILED with $?"
    failed=1
  }
  times+=$(printf '%-48s %5d s  %s' "$name" $((SECONDS - started)) "$result")$'\n'
  [[ $result == ok ]]
}

# A command inside, as root with a plain environment: no display, nothing of the caller's but how to reach the network.
inside() {
  local -a network=()
  local name
  for name in http_proxy https_proxy no_proxy; do [[ -n ${!name:-} ]] && network+=("$name=${!name}"); done
  chroot "$target" /usr/bin/env -i HOME=/var/dermis PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 CI=true "${network[@]}" bash -c "$1"
}

bare_system() {
  local file
  debootstrap --variant=minbase bookworm "$target" "${mirror:-http://deb.debian.org/debian}" || return
  cp /etc/resolv.conf /etc/hosts "$target/etc/" 2>/dev/null
  mkdir -p "$target/etc/apt/sources.list.d" "$target/etc/apt/apt.conf.d"
  for file in /etc/apt/sources.list.d/debian.sources; do
    [[ -e $file ]] && cp "$file" "$target/etc/apt/sources.list.d/" && rm -f "$target/etc/apt/sources.list"
  done
  for file in /etc/apt/apt.conf.d/*; do
    grep -qs '^ *Acquire::' "$file" && cp "$file" "$target/etc/apt/apt.conf.d/"
  done
  # The host's own certificates, where the network needs them.
  if [[ -d /usr/local/share/ca-certificates ]]; then
    mkdir -p "$target/usr/local/share" && cp -r /usr/local/share/ca-certificates "$target/usr/local/share/"
  fi
  mount -t proc proc "$target/proc" && mount --bind /dev "$target/dev" && mount --bind /dev/pts "$target/dev/pts"
}

step "minimal Debian 12" bare_system || exit 1
step "git and ca-certificates" inside 'apt-get -q update && DEBIAN_FRONTEND=noninteractive apt-get -q -y install --no-install-recommends git ca-certificates' || exit 1
git clone -q --no-hardlinks "$repository" "$target/var/dermis/dermis" || exit 1

step "./run --version, nothing installed" inside 'cd /var/dermis/dermis && ./run --version >/var/dermis/version.txt && cat /var/dermis/version.txt && [ "$(wc -l </var/dermis/version.txt)" = 1 ]'
step "./run --version again: silent and quick" inside 'cd /var/dermis/dermis && time ./run --version >/var/dermis/again.txt 2>/var/dermis/again.err && cmp /var/dermis/version.txt /var/dermis/again.txt && cat /var/dermis/again.err && [ ! -s /var/dermis/again.err ]'
step "./run with no display" inside 'mkdir -p /var/dermis/elsewhere && cd /var/dermis/elsewhere && ../dermis/run && [ -s first-look.png ]'
[[ -z $keep ]] || cp "$target/var/dermis/elsewhere/first-look.png" "$target/" 2>/dev/null
step "./test" inside 'cd /var/dermis/dermis && ./test'
step "nothing left in the clone" inside 'cd /var/dermis/dermis && git status --porcelain && [ -z "$(git status --porcelain)" ]'

printf '\n%s' "$times"
exit "$failed"
