#!/usr/bin/env bash
# libraries.sh FOLDER: what the modules are linked with, for WebAssembly, in FOLDER/usr. Runs on Debian 13.
#
# GMP, MPFR, zlib and Expat are built of Debian's sources, which sources.txt pins by SHA-256. clang does it directly:
# emscripten's programs take half a second longer for each of a thousand files. Boost, CGAL, Eigen, JSON, {fmt} and
# fast_float are headers. They are copied from where Debian's packages have them, with what these say to CMake, because
# the machine's own /usr/include would also give its C library.
#
# Guarantees: what does not have its SHA-256 is not built. FOLDER-build keeps what was built, for GMP's tests.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
prefix=$(realpath -m "$1")/usr
build=$(realpath -m "$1")-build
headers=(libboost1.83-dev libcgal-dev libeigen3-dev nlohmann-json3-dev libfmt-dev libfast-float-dev)

sysroot=/usr/share/emscripten/cache/sysroot
compiler="clang-19 --target=wasm32-unknown-emscripten --sysroot=$sysroot -D__EMSCRIPTEN__"
! command -v ccache >/dev/null || compiler="ccache $compiler"
# What emscripten links with without being asked. With it, clang links what configure asks about.
linked='-lstandalonewasm-nocatch -lc -lc++abi -lcompiler_rt -ldlmalloc -lstubs'

# quietly COMMAND…: shows the end of what it prints where it fails.
quietly() { "$@" >log 2>&1 || { tail -n 20 log >&2; echo "libraries.sh: failed: $*" >&2; exit 1; }; }

# unpack NAME FILE SUM: into NAME/source, where it goes. Any of the machine's mirrors will do.
unpack() {
  local mirror file=pool/main/${1:0:1}/$1/$2
  mkdir -p "$build/$1/source"
  cd "$build/$1"
  for mirror in $(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | sort -u); do
    if /usr/lib/apt/apt-helper download-file "$mirror$file" packed "SHA256:$3" >/dev/null 2>&1; then
      tar -C source --strip-components=1 -xf packed
      return
    fi
  done
  echo "libraries.sh: no mirror has $2 with its SHA-256" >&2
  exit 1
}

# configured OPTION…
configured() {
  quietly source/configure --host=none --disable-shared --prefix="$prefix" CC="$compiler -nodefaultlibs" \
    AR=llvm-ar-19 RANLIB='llvm-ar-19 s' NM=llvm-nm-19 LIBS="$linked" "$@"
}

build_gmp() {
  # Debian leaves the manual out. No number here is so long that products by Fourier transforms would pay.
  mkdir -p source/doc
  echo 'all install check:' >source/doc/Makefile.in
  configured --disable-assembly --disable-fft CC_FOR_BUILD=gcc CFLAGS="-O2 -w -include $here/wasm_limbs.h"
  quietly make -j "$(nproc)" install
  cp source/gmpxx.h "$prefix/include"  # what is in it alone, without a library for C++
}
build_mpfr4() {
  configured --with-gmp="$prefix" CFLAGS='-Os -w'
  quietly make -j "$(nproc)" -C src install
}
# compiled LIBRARY OPTION… FILE…
compiled() {
  local library=$1
  shift
  quietly $compiler -O2 -w -c "$@"
  llvm-ar-19 rcs "$prefix/lib/$library" ./*.o
}
build_zlib() {
  compiled libz.a -DHAVE_UNISTD_H source/*.c
  cp source/zlib.h source/zconf.h "$prefix/include"
}
build_expat() {
  # Its hash tables are salted by the time: no claim is read twice.
  touch expat_config.h
  compiled libexpat.a -I. -DXML_NS -DXML_DTD -DXML_GE=1 -DXML_CONTEXT_BYTES=1024 -DXML_POOR_ENTROPY \
    source/expat/lib/xml{parse,role,tok}.c
  cp source/expat/lib/expat.h source/expat/lib/expat_external.h "$prefix/include"
}

copy_headers() {
  # {fmt} is headers here, whatever processor its library is for.
  dpkg -L "${headers[@]}" | grep -E '^/usr/(include|(lib|share)/.*cmake)/' | sort -u |
    grep -vE 'fmt-(targets-none|config-version)' |
    tar -c --no-recursion -C / --files-from <(sed 's,^/,,') | tar -x -C "${prefix%/usr}"
}

mkdir -p "$prefix/include" "$prefix/lib"
copy_headers
while read -r file sum; do
  echo "building $file for WebAssembly"
  (unpack "${file%%_*}" "$file" "$sum"; "build_${file%%_*}")
done < <(grep -v '^#' "$here/sources.txt")
