#!/usr/bin/env bash
# What ./dev package makes is installed, used and removed, on a bare Debian as root: ./dev package calls it in a root of
# its own, which is not the one that they were made in.
#
# usage: install_and_remove.sh FOLDER SUITE      (FOLDER has the sources, and SUITE/ the package and the wheel)
#
# The wheel by pip, without an index; the package with its dependencies alone, then Python, then what the library needs;
# the sdist by pip; and the archive without git. Each is used as the READMEs say, and says the version of the project
# and this commit. The lines "SECONDS s  WHAT" are times. It fails where something is left behind, and where Python has
# no first result two seconds after pip has ended.
set -euo pipefail
cd "$(dirname "$0")/../.."
source=$PWD folder=$(realpath "$1") suite=$2
version=$(sed -n 's/^project(flowcert VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
commit=$(git rev-parse --short=12 HEAD)
scratch=$(mktemp -d)
# A compiler cache serves the archive and the sdist, which have the same files in other folders.
export CCACHE_BASEDIR=$scratch DEBIAN_FRONTEND=noninteractive
# pip would keep the wheel that it makes of the sdist.
export PIP_NO_CACHE_DIR=1 PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1

fail() { echo "FAIL: $*" >&2; exit 1; }
install() { apt-get -qq install -y --no-install-recommends "$@" >/dev/null; }
# timed WHAT COMMAND…: its seconds, to hundredths, and what it says where it fails.
timed() {
  local what=$1 start=${EPOCHREALTIME/./}
  shift
  "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "$what"; }
  hundredths=$(((${EPOCHREALTIME/./} - start) / 10000))
  printf '%4d.%02d s  %s\n' $((hundredths / 100)) $((hundredths % 100)) "$what"
}
# The lines between the fences of the block after <!-- example: NAME --> of a page.
block() {
  awk -v mark="<!-- example: $1 -->" '
    inside && /^```/ { exit }
    inside { print }
    marked && /^```/ { inside = 1; marked = 0 }
    $0 == mark { marked = 1 }' "$source/$2"
}
# same PAGE NAME COMMAND…: the command prints the block NAME of the page.
same() {
  block "$2" "$1" >"$scratch/expected"
  [ -s "$scratch/expected" ] || fail "$1 has no block $2"
  "${@:3}" | diff "$scratch/expected" - || fail "$1 says something else than $3 prints"
}
# Files of it, but for those that it was made of.
remains() { find / -xdev -ipath '*flowcert*' -not -path "$source*" -not -path "$folder*" -not -path "$scratch*"; }
nothing_remains() { [ -z "$(remains)" ] || { remains | head; fail "that is left of $1"; }; }
says_version() {
  case "$("$1" --version)" in
    "flowcert $version (commit $commit; "*) ;;
    *) "$1" --version; fail "$1 has another version than $version of $commit" ;;
  esac
}
# python_example PYTHON: the README's.
python_example() {
  timed "a first result of Python" "$1" "$scratch/first.py"
  [ "$hundredths" -le 200 ] || fail "that is more than two seconds"
  [ "$("$1" -c 'import flowcert; print(flowcert.__version__)')" = "$version" ] || fail "the module's version is another"
  [ "$("$1" -c 'from importlib import metadata; print(metadata.version("flowcert"))')" = "$version" ] ||
    fail "the metadata's version is another"
  same src/python/README.md 'python output' "$1" "$scratch/example.py"
}
# pip_installs WHAT WORDS…: into a new environment that sees Debian's NumPy, and out of it.
pip_installs() {
  local what=$1 python=$scratch/environment/bin/python site
  shift
  rm -rf "$scratch/environment"
  /usr/bin/python3 -m venv --system-site-packages "$scratch/environment"
  timed "pip install, $what" "$python" -m pip install "$@"
  python_example "$python"
  site=$(echo "$scratch"/environment/lib/python3*/site-packages)
  for file in flowcert/py.typed flowcert/_core.pyi "flowcert-$version.dist-info/LICENSE"; do
    [ -e "$site/$file" ] || fail "$what has no $file"
  done
  [ "$what" = sdist ] || [ -s "$site/flowcert-$version.dist-info/sboms/flowcert.spdx.json" ] || fail "$what has no bill"
  "$python" -m pip uninstall -qy flowcert
  [ -z "$(find "$site" -iname '*flowcert*')" ] || fail "that is left of $what"
}

cube=$scratch/cube
printf '0 0 0\n0 0 1\n0 1 0\n0 1 1\n1 0 0\n1 0 1\n1 1 0\n1 1 1\n' >"$cube.xyz"
block python src/python/README.md >"$scratch/example.py"
echo 'import flowcert; print(flowcert.FlowComplex([[0, 0, 0], [2, 0, 0]]).counts)' >"$scratch/first.py"
# What is used of the programs: the README's first commands.
used() {
  says_version "$1"
  "$1" compute "$cube.xyz" -o "$cube.jsonl" --certificate "$cube.fcert" >"$scratch/table" 2>&1
  "$1" points "$cube.xyz" -o "$cube.f64"
  grep -q "^critical points of index 3 *1 " "$scratch/table" || fail "$1 computes something else"
}

apt-get -qq update
nothing_remains "a bare root"
install python3-numpy python3-venv
pip_installs wheel --find-links "$folder/$suite" "flowcert==$version"

deb=$(echo "$folder/$suite"/flowcert_*.deb)
[[ $(dpkg-deb -f "$deb" Version) == "$version"-1* ]] || fail "$deb has another version"
timed "apt-get install, package" install "$deb"
used flowcert
[ "$(cd /usr/bin && echo flowcert*)" = "flowcert flowcert-proof" ] || fail "the package has other programs"
flowcert-proof "$cube.f64" "$cube.fcert" "$cube.jsonl" >/dev/null || fail "flowcert-proof proves nothing"
zgrep -q "flowcert $version" /usr/share/man/man1/flowcert.1.gz || fail "the manual page has another version"
grep -q "\"flowcert-$version\"" /usr/share/doc/flowcert/flowcert.spdx.json || fail "the bill has another version"
for file in bash-completion/completions/flowcert doc/flowcert/copyright man/man1/flowcert-proof.1.gz \
  fish/vendor_completions.d/flowcert.fish zsh/vendor-completions/_flowcert; do
  [ -s "/usr/share/$file" ] || fail "there is no /usr/share/$file"
done
python_example /usr/bin/python3
mapfile -t -d , suggested < <(dpkg-deb -f "$deb" Suggests | tr -d ' \n')
install "${suggested[@]}" make
mkdir "$scratch/library"
block cmake src/README.md | sed "s/find_package(flowcert/& $version/" >"$scratch/library/CMakeLists.txt"
block library src/README.md >"$scratch/library/example.cpp"
timed "cmake, the library's example" cmake -S "$scratch/library" -B "$scratch/library/build"
timed "compiling it" cmake --build "$scratch/library/build"
same src/README.md output "$scratch/library/build/example"
timed "apt-get purge, package" apt-get -qq purge -y flowcert
nothing_remains "the package"

# What ./dev build installs.
install cmake g++ libboost-dev libcgal-dev libcli11-dev libeigen3-dev libexpat1-dev libfmt-dev libgmp-dev libmpfr-dev \
  librapidcheck-dev ninja-build nlohmann-json3-dev pybind11-dev python3-dev zlib1g-dev
apt-get -qq purge -y git >/dev/null
mkdir "$scratch/archive"
tar -C "$scratch/archive" --strip-components=1 -xf "$folder/flowcert-$version-source.tar.gz"
timed "cmake, the archive without git" cmake -S "$scratch/archive" -B "$scratch/archive/build" -G Ninja \
  -DFLOWCERT_JUDGE=OFF -DFLOWCERT_TESTS=OFF
timed "building it" cmake --build "$scratch/archive/build"
used "$scratch/archive/build/flowcert"
TMPDIR=$scratch pip_installs sdist "$folder/flowcert-$version.tar.gz"
nothing_remains "wheel and sdist"
rm -rf "$scratch"
