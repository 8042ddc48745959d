#!/bin/bash -eu
# What OSS-Fuzz runs in its image: builds the fuzz targets of fuzz/targets/ into $OUT, each with its seeds, its words if
# it has any, and its options.
#
# The compiler, all flags for sanitizers and coverage, and the engine are those of the environment: CC, CXX, CXXFLAGS,
# LDFLAGS, LIB_FUZZING_ENGINE. A target needs no other file, and no library but those of C. It fails where a target has
# no seeds.
cd "$SRC/flowcert"
build=$WORK/build static=$WORK/static

# The C libraries that machines without compilers lack, in a folder without shared ones: so the linker takes these.
mkdir -p "$static"
for library in expat gmp mpfr z; do
  cp "$($CC -print-file-name="lib$library.a")" "$static/"
done

# -O1 is one of the flags of the environment, and CMake's own for Release would come after it.
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-DNDEBUG \
  -DCMAKE_LIBRARY_PATH="$static" -DCMAKE_EXE_LINKER_FLAGS="-L$static ${LDFLAGS:-}" \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DFLOWCERT_BATCHES=ON \
  -DFLOWCERT_FUZZERS=ON -DFLOWCERT_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" -DFLOWCERT_PYTHON=OFF -DFLOWCERT_TESTS=OFF
cmake --build "$build" --target fuzz_targets

for program in "$build"/fuzz/fuzz_*; do
  name=${program##*/} target=${program##*/fuzz_}
  cp "$program" "$OUT/"
  cp fuzz/oss-fuzz/target.options "$OUT/$name.options"
  (cd "fuzz/corpus/$target" && cmake -E tar cf "$OUT/${name}_seed_corpus.zip" --format=zip -- *)
  [ ! -f "fuzz/targets/$target.dict" ] || cp "fuzz/targets/$target.dict" "$OUT/$name.dict"
done
