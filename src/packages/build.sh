#!/usr/bin/env bash
# build.sh OUT: the package of Debian and the wheel of this system, in OUT. It runs on Debian as root, and installs what
# it needs: ./dev package calls it in a root of its own.
#
# It fails where lintian has an error or a warning that debian/lintian-overrides does not explain, and where a file is
# larger than it may be.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=$(realpath -m "$1")
export DEBIAN_FRONTEND=noninteractive
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

# pybind11 of Debian 12 fails with NumPy 2, so its headers are those of Debian 13, which serve both.
newer_pybind11() {
  local folder file options
  folder=$(mktemp -d)
  mkdir -p "$folder/sources" "$folder/lists"
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.sources; do
    [ ! -s "$file" ] || sed 's/bookworm/trixie/g' "$file" >"$folder/sources/${file##*/}"
  done
  options=(-o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$folder/sources"
           -o Dir::State::Lists="$folder/lists" -o APT::Sandbox::User=root)
  apt-get -qq "${options[@]}" update
  (cd "$folder" && apt-get -qq "${options[@]}" download pybind11-dev)
  apt-get -qq install -y --no-install-recommends "$folder"/pybind11-dev_*.deb >/dev/null
  rm -rf "$folder"
}

at_most() {
  local size
  size=$(stat -c %s "$2")
  echo "$(basename "$2"): $size bytes"
  [ "$size" -le "$1" ] || { echo "$2 is larger than $1 bytes" >&2; exit 1; }
}

apt-get -qq update
apt-get -qq install -y --no-install-recommends dpkg-dev file lintian patchelf python3-minimal >/dev/null
# Unlike dpkg, apt knows the version without an installation.
newest=$(apt-cache policy pybind11-dev | sed -n 's/^ *Candidate: //p')
if dpkg --compare-versions "$newest" lt 2.12; then newer_pybind11; fi
./dev build
# Only where files are installed depends on the prefix.
cmake build -DCMAKE_INSTALL_PREFIX=/usr >/dev/null

mkdir -p build/bill "$out"
src/packages/bill_of_materials.py build -o build/bill/flowcert.spdx.json --notices build/bill/notices
FLOWCERT_BUILD=$PWD/build cpack --config src/packages/deb.cmake -B build/deb
lintian --allow-root --fail-on error,warning build/deb/*.deb
cp build/deb/*.deb "$out"
src/packages/wheel.py build "$out"
at_most 20000000 "$out"/*.deb
at_most 15000000 "$out"/*.whl
