#!/usr/bin/env bash
# build.sh [--check]: the npm package of WebAssembly, in build-wasm/npm/. It runs on Debian 13 as root, and installs
# what it needs: ./dev wasm calls it in a root of its own.
#
# --check: also GMP's own tests, and the tests of the modules, which compare them with the program as this machine's g++
# builds it. FLOWCERT_BENCH_DATA may name a folder with scans, FOLDER/*.xyz, for these.
set -euo pipefail
cd "$(dirname "$0")/../.."
# zlib and Expat are here for their licences, as those of the others are, too.
packages=(cmake emscripten g++ libboost-dev libcgal-dev libeigen3-dev libexpat1-dev libfast-float-dev libfmt-dev m4 make
          ninja-build nlohmann-json3-dev npm xz-utils zlib1g-dev)

install() {
  apt-get -qq update
  DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends "$@" >/dev/null
}

install "${packages[@]}"
src/web/libraries.sh build-wasm-libraries
# emscripten asks the cache about what clang compiles. It takes ccache itself for a compiler.
if command -v ccache >/dev/null; then export EM_COMPILER_WRAPPER=/usr/bin/ccache; fi
cmake --preset wasm -Wno-dev
cmake --build build-wasm --target flowcert_module radii_module check_module flowcert_records
src/web/package/pack.sh build-wasm /usr/share/doc build-wasm/npm

[ "${1:-}" = --check ] || exit 0
install node-typescript python3-minimal
tests/web_module/gmp_tests.sh build-wasm-libraries
./dev build
python3 tests/web_module/same_bytes.py build/flowcert build-wasm
tests/web_module/package_test.sh "$PWD/build/flowcert"
