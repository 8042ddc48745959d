#!/usr/bin/env bash
# ./dev fresh: what a newcomer does, on a Debian machine that has nothing.
#
# usage: fresh_machine.sh [--suite SUITE] [--new] [--ccache DIR] [--keep] [--only COMMAND]… [--then COMMAND]…
#                         [--data DIR] [--take PATH]…
#
# Makes a bare root of SUITE (bookworm, which is Debian 12, without the option; trixie, Debian 13; sid, unstable) with
# mmdebstrap (minbase, git, ca-certificates), clones HEAD into it, and runs there, word for word, the commands of
# README.md's first block; then it installs the library and builds its example with it, and runs each COMMAND of
# --then. With --only, it runs these commands instead of the README's and the example. The last lines are the time of
# each step, the clock's and the processors'. Roots and packages are kept in a cache folder; --new makes the root anew.
# Commands see DIR of --data as FLOWCERT_BENCH_DATA. PATHs of the clone are copied into this tree where all went well.
#
# Guarantees: everything is mounted in a mount namespace of its own, so no removal ever sees the machine's own files.
# Nothing that was installed by hand on this machine is there. Exit status: 0; 1 where a step fails; 3 where no root
# can be made here, which one line on standard error explains.
set -euo pipefail
repository=$(realpath "$(dirname "$0")/..")
cache=${XDG_CACHE_HOME:-$HOME/.cache}/flowcert-fresh
new=0 keep=0 ccache= data= later=() only=() taken=() suite=bookworm

cannot() { echo "fresh: no bare Debian root can be made here: $*" >&2; exit 3; }
fail() { echo "fresh: $*" >&2; exit 1; }
say() { printf '\n== fresh: %s\n' "$*"; }

while [ $# -gt 0 ]; do
  case "$1" in
    --suite) suite=${2:?--suite SUITE}; shift ;;
    --new) new=1 ;;
    --keep) keep=1 ;;
    --ccache) ccache=$(realpath -m "${2:?--ccache DIR}"); shift ;;
    --only) only+=("${2:?--only COMMAND}"); shift ;;
    --data) data=$(realpath "${2:?--data DIR}"); shift ;;
    --take) taken+=("${2:?--take PATH}"); shift ;;
    --then) later+=("${2:?--then COMMAND}"); shift ;;
    *) echo "fresh: unknown option $1" >&2; exit 2 ;;
  esac
  shift
done
[[ $suite =~ ^[a-z]+$ ]] || { echo "fresh: not the name of a suite: $suite" >&2; exit 2; }

# The commands of the README's first block of code, one a line.
readme_commands() {
  awk '/^    [^ ]/ { inside = 1; print substr($0, 5); next } inside { exit }' "$repository/README.md"
}
mapfile -t commands < <(readme_commands)
[ ${#commands[@]} -ge 2 ] || fail "README.md does not begin with a block of commands"

# ---- What the root takes over from this machine

# Debian's own package sources, as this machine has them, of the suite. A third party's key is a file outside the root.
# Another suite's are at the same mirror; its updates stand beside it, and those for security at their own address.
# Another system than Debian may have the suite's own sources, but its mirror has no Debian.
codename=$(. /etc/os-release && [ "${ID:-}" = debian ] && echo "${VERSION_CODENAME:-$suite}" || echo "$suite")
debian_sources() {
  local file
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ -f "$file" ] || continue
    grep -E '^deb( \[signed-by=[^] ]*debian-archive[^] ]*\])? [^[]' "$file" | grep -w "$codename" || true
  done | in_suite
}
debian_stanzas() {
  local file
  for file in /etc/apt/sources.list.d/*.sources; do
    [ ! -f "$file" ] || awk -v RS= -v ORS='\n\n' -v suite="$codename" \
      '$0 ~ "Suites:.*" suite && (!/Signed-By:/ || /Signed-By:[^\n]*debian-archive/)' "$file"
  done | in_suite
}
# Unstable has neither updates nor security of its own.
in_suite() {
  case "$suite" in
    "$codename") cat ;;
    sid) awk -v RS='\n\n' -v ORS='\n\n' '!/-security/' |
           sed -E "s/\b$codename-[a-z]+\b//g; s/\b$codename\b/sid/g" ;;
    *) sed "s/\b$codename\b/$suite/g" ;;
  esac
}
# How this machine reaches them: proxies, whether dates count.
acquire_settings() {
  apt-config dump --format '%f "%v";%n' Acquire | grep -vE 'IndexTargets|CompressionTypes|cdrom|""'
}

# ---- Steps

steps=() seconds=() processors=()
# Sets `spent` to the seconds of processor time of all that has ended. Not in a subshell: it would know its own alone.
read_processor_time() {
  local file
  file=$(mktemp)
  times >"$file"  # bash's own time in line 1, and its children's in line 2: "0m1.234s 0m0.567s"
  spent=$(awk 'NR == 2 { for (k = 1; k <= 2; ++k) { split($k, part, "[ms]"); sum += 60 * part[1] + part[2] } }
               END { printf "%d", sum }' "$file")
  rm -f "$file"
}
# step WHAT COMMAND…: runs it, notes the time, and ends everything where it fails. A subshell, because bash ignores -e
# in a function that is called with "||".
step() {
  local what=$1 start=$SECONDS before status
  read_processor_time
  before=$spent
  shift
  say "$what"
  set +e
  (set -e; "$@")
  status=$?
  set -e
  [ "$status" -ne 3 ] || exit 3  # no root can be made
  [ "$status" -eq 0 ] || { report; fail "failed: $what"; }
  steps+=("$what")
  seconds+=($((SECONDS - start)))
  read_processor_time
  processors+=($((spent - before)))
}
report() {
  local k
  printf '\n%9s %9s  on %s, %s processors\n' clock processor "$suite" "$(nproc)"
  for k in "${!steps[@]}"; do printf '%7d s %7d s  %s\n' "${seconds[k]}" "${processors[k]}" "${steps[k]}"; done
}

# ---- The root

check_machine() {
  [ "$(id -u)" -eq 0 ] || cannot "that needs the rights of root"
  command -v unshare >/dev/null && unshare --mount --pid --fork mount -t tmpfs none /mnt 2>/dev/null ||
    cannot "this machine does not let it mount"
  command -v apt-get >/dev/null || cannot "there is no apt-get"
  if ! command -v mmdebstrap >/dev/null; then
    { apt-get update -qq &&
      DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends mmdebstrap; } >/dev/null 2>&1 ||
      cannot "mmdebstrap cannot be installed"
  fi
}

# Only one run at a time uses a suite's cache.
prepare() {
  cache+=/$suite
  mkdir -p "$cache/archives"
  exec 9>"$cache/lock"
  flock -n 9 || cannot "another run is using $cache"
  rm -rf --one-file-system "$cache"/run.*  # left by a run that was killed
  work=$(mktemp -d "$cache/run.XXXXXX")
  root=$work/root
  trap finish EXIT
  acquire_settings >"$work/acquire"
  debian_sources >"$work/debian.list"
  debian_stanzas >"$work/debian.sources"
}
finish() {
  if [ "$keep" -eq 1 ]; then echo "kept: $root"; else rm -rf --one-file-system "$work"; fi
}

make_root() {
  local sources=("$work/debian.sources")
  [ ! -s "$work/debian.list" ] || sources=("$work/debian.list")
  [ -s "${sources[0]}" ] || sources=()
  mmdebstrap --quiet --format=tar --variant=minbase --include=git,ca-certificates --aptopt="$work/acquire" \
    --setup-hook='mkdir -p "$1"/var/cache/apt/archives' --setup-hook="sync-in $cache/archives /var/cache/apt/archives" \
    --customize-hook="sync-out /var/cache/apt/archives $cache/archives" \
    "$suite" "$cache/root.tar.new" "${sources[@]}" 2>"$work/log" ||
    { tail -n 5 "$work/log" >&2; cannot "mmdebstrap fails, or the package mirror does not answer"; }
  mv "$cache/root.tar.new" "$cache/root.tar"
}

unpack_root() {
  mkdir "$root"
  tar -C "$root" -xpf "$cache/root.tar"
  cp "$work/acquire" "$root/etc/apt/apt.conf.d/99machine"
  rm -f "$root/etc/apt/sources.list" "$root"/etc/apt/sources.list.d/*
  if [ -s "$work/debian.list" ]; then cp "$work/debian.list" "$root/etc/apt/sources.list"; fi
  if [ -s "$work/debian.sources" ]; then cp "$work/debian.sources" "$root/etc/apt/sources.list.d/"; fi
  cp /etc/hosts "$root/etc/hosts"
  cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  git clone --quiet --no-hardlinks "$repository" "$root/root/flowcert"
  git -C "$root/root/flowcert" checkout --quiet "$(git -C "$repository" rev-parse HEAD)"
}
# inside COMMAND: a line of shell, run in the clone as a newcomer would, in namespaces of its own.
inside() {
  local settings=(HOME=/root LANG=C.UTF-8 TERM=dumb) name
  settings+=(PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  for name in http_proxy https_proxy no_proxy CI FLOWCERT_PROPERTY_SCALE; do
    [ -z "${!name:-}" ] || settings+=("$name=${!name}")
  done
  [ -z "$ccache" ] || settings+=(CCACHE_DIR=/ccache)
  [ -z "$data" ] || settings+=(FLOWCERT_BENCH_DATA=/data)
  unshare --mount --pid --fork --kill-child bash -c '
    set -e
    root=$1 archives=$2 ccache=$3 data=$4
    shift 4
    mount -t proc proc "$root/proc"
    mount --rbind /dev "$root/dev"
    mount --bind "$archives" "$root/var/cache/apt/archives"
    if [ -n "$ccache" ]; then mkdir -p "$root/ccache"; mount --bind "$ccache" "$root/ccache"; fi
    if [ -n "$data" ]; then mkdir -p "$root/data"; mount --bind -o ro "$data" "$root/data"; fi
    exec chroot "$root" env -i "${@:2}" bash -c "cd /root/flowcert && $1"
  ' fresh "$root" "$cache/archives" "$ccache" "$data" "$1" "${settings[@]}" </dev/null || return 1
}

# ---- All of it. In a function, because bash reads a script as it goes: it may be edited meanwhile.

main() {
  check_machine
  prepare
  [ -z "$(git -C "$repository" status --porcelain)" ] ||
    echo "fresh: warning: HEAD is tried; what is not committed is not in it" >&2
  [ "$new" -eq 0 ] || rm -f "$cache/root.tar"
  [ -s "$cache/root.tar" ] || step "making a bare root" make_root
  step "unpacking the root, cloning $(git -C "$repository" rev-parse --short HEAD)" unpack_root
  inside 'apt-get update -qq -o APT::Update::Error-Mode=any' || cannot "the package mirror does not answer"
  inside 'rm -rf /var/lib/apt/lists/*'
  if [ -n "$ccache" ]; then
    mkdir -p "$ccache"
    step "installing ccache" inside \
      'apt-get update -qq && apt-get install -y -qq --no-install-recommends ccache >/dev/null'
  fi
  local command path
  [ ${#only[@]} -eq 0 ] || commands=("${only[@]}")
  for command in "${commands[@]}"; do step "$command" inside "$command"; done
  [ ${#only[@]} -gt 0 ] ||
    step "installing the library, building its example" inside 'bash tests/conformance/install_test.sh build'
  for command in "${later[@]}"; do step "$command" inside "$command"; done
  for path in "${taken[@]}"; do
    rm -rf "${repository:?}/$path"
    mkdir -p "$(dirname "$repository/$path")"
    cp -r "$root/root/flowcert/$path" "$repository/$path"
  done
  report
  exit 0
}
main
