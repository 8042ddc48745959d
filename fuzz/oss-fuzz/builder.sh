#!/usr/bin/env bash
# Builds the fuzz targets as OSS-Fuzz's image base-builder does, on a bare Debian 13 as root: ./dev fuzz --oss calls it
# in a root of its own.
#
# usage: builder.sh FOLDER      (FOLDER/address and FOLDER/undefined are what the image has as $OUT)
#
# The packages are those that Dockerfile names; the flags are those of the image, of November 2026, for libFuzzer and
# x86_64. Debian's clang is made like that of the image in two ways, which change this root for good: libc++ is linked
# from its archives, and the engine is an archive that brings its own standard library, which no other code sees.
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p "$1"
export DEBIAN_FRONTEND=noninteractive
folder=$(realpath "$1") base=/oss-fuzz

# Only libc++ before version 20 needs what else Flowcert reads doubles with.
mapfile -t packages < <(sed -n '/apt-get install/,/[^\\]$/p' fuzz/oss-fuzz/Dockerfile | grep -oE '[a-z0-9-]+' |
  grep -vxE 'RUN|apt-get|update|install|-y|--no-install-recommends')
apt-get -qq update
apt-get -qq install -y --no-install-recommends "${packages[@]}" \
  clang cmake git libc++-dev libc++abi-dev libclang-rt-dev libfast-float-dev >/dev/null

library=$(realpath "$(clang++ -print-file-name=libc++.so)")
echo "INPUT($(clang++ -print-file-name=libc++.a) $(clang++ -print-file-name=libc++abi.a))" >"$library"

# Debian's libFuzzer wants GNU's standard library, whose symbols would meet those of libc++.
mkdir -p "$base"
runtime=$(clang++ -print-file-name="lib/linux/libclang_rt.fuzzer-$(uname -m).a")
[ -f "$runtime" ] || runtime=$(clang++ -print-runtime-dir)/libclang_rt.fuzzer-$(uname -m).a
nm "$runtime" 2>/dev/null | awk 'NF == 3 && $2 ~ /[BDTVW]/ { print $3 }' |
  grep -E '^(main$|LLVMFuzzer|__libfuzzer|__sancov_|__sanitizer_|_ZTW)' | sort -u >"$base/engine.symbols"
ld -r --force-group-allocation --whole-archive "$runtime" --no-whole-archive \
  "$(clang++ -print-file-name=libstdc++.a)" -o "$base/engine.o"
objcopy --keep-global-symbols="$base/engine.symbols" "$base/engine.o"
ar rcs "$base/libFuzzingEngine.a" "$base/engine.o"

export CC=clang CXX=clang++ CCC=clang++ FUZZING_LANGUAGE=c++ FUZZING_ENGINE=libfuzzer ARCHITECTURE=x86_64
export LIB_FUZZING_ENGINE=$base/libFuzzingEngine.a SRC=$base/src UBSAN_OPTIONS=silence_unsigned_overflow=1
common='-O1 -fno-omit-frame-pointer -gline-tables-only -Wno-error=incompatible-function-pointer-types
  -Wno-error=int-conversion -Wno-error=deprecated-declarations -Wno-error=implicit-function-declaration
  -Wno-error=implicit-int -Wno-error=unknown-warning-option -Wno-error=vla-cxx-extension
  -DFUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION'
fatal=array-bounds,bool,builtin,enum,function,integer-divide-by-zero,null,object-size,return
fatal+=,returns-nonnull-attribute,shift,signed-integer-overflow,unreachable,vla-bound,vptr
declare -A flags=(
  [address]="-fsanitize=address -fsanitize-address-use-after-scope"
  [undefined]="-fsanitize=$fatal,unsigned-integer-overflow -fno-sanitize-recover=$fatal"
)
mkdir -p "$SRC"
git clone --quiet --depth 1 "file://$PWD" "$SRC/flowcert"
cp fuzz/oss-fuzz/build.sh "$SRC/"
for SANITIZER in ${SANITIZERS:-address undefined}; do
  export SANITIZER OUT=$folder/$SANITIZER WORK=$base/$SANITIZER
  CFLAGS="$(echo $common) ${flags[$SANITIZER]} -fsanitize=fuzzer-no-link"
  export CFLAGS CXXFLAGS="$CFLAGS -stdlib=libc++"
  mkdir -p "$OUT" "$WORK"
  start=$SECONDS
  (cd "$SRC/flowcert" && bash -eux "$SRC/build.sh")
  echo "built for the sanitizer $SANITIZER in $((SECONDS - start)) s: $(du -sh "$OUT" | cut -f 1)"
done
