#!/usr/bin/env bash
# The core, src/geometry to src/morse, needs CGAL with Eigen, GMP, MPFR and Boost alone.
#
# usage: core_alone_test.sh COMPILER
#
# The core is configured where CMake finds no other package that the project uses. What is compiled then has to be the
# core's sources, all of them and no others, and what they and their precompiled header include, read by the
# preprocessor, must hold no header of the other packages. It fails as well when GMP and CGAL are not seen there.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
compiler=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
  echo "FAIL: $*"
  exit 1
}

absent=()
for package in fmt CLI11 nlohmann_json ZLIB EXPAT GTest rapidcheck valijson MPI; do
  absent+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
# A Debug build compiles each file alone.
cmake -S "$root" -B "$scratch/build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
  -DFLOWCERT_CCACHE= -DFLOWCERT_CORE_ONLY=ON "${absent[@]}" >"$scratch/log" 2>&1 ||
  { cat "$scratch/log"; fail "the core cannot be configured alone"; }

ls "$root"/src/{geometry,voronoi,flow,morse}/*.cpp | sort >"$scratch/sources"
ninja -C "$scratch/build" -t inputs flowcert_core | grep -F "$root/" | grep -E '\.cpp$' | sort -u >"$scratch/compiled"
diff -u "$scratch/sources" "$scratch/compiled" || fail "flowcert_core is not compiled from the core's sources"
others=$(ninja -C "$scratch/build" -t inputs all | grep -F "$root/" | grep -vxFf "$scratch/sources" || true)
[ -z "$others" ] || fail "more than the core is compiled: $others"

# All sources are preprocessed at once, as a file of the topmost layer is compiled.
sed 's/.*/#include "&"/' "$scratch/sources" >"$scratch/core.cpp"
command=$(ninja -C "$scratch/build" -t commands flowcert_core | grep -F ' -c '"$root/src/morse/flow_complex.cpp")
# CGAL reads Eigen where it triangulates R^4, and nothing else does.
eigen=$(ninja -C "$scratch/build" -t commands flowcert_core | grep -F ball_diagram.cpp |
  grep -oE -- '-isystem [^ ]*eigen3' || true)
# The precompiled header's text is read, for it is not compiled. clang would ask for the compiled one as well.
$(sed 's/ -MD .*//; s/-Xclang -include-pch -Xclang [^ ]*//' <<<"$command") $eigen -M "$scratch/core.cpp" |
  tr -d '\\' | tr -s ' ' '\n' >"$scratch/read"
for name in gmp.h CGAL/Delaunay_triangulation_3.h cmake_pch.hxx "$root/src/morse/include/flowcert/flow_complex.h"; do
  grep -qE "(^|/)${name#/}\$" "$scratch/read" || fail "$name is not read; the list cannot be right"
done
! grep -E '/(tbb|fmt|nlohmann|CLI|gtest|rapidcheck|valijson)/|/(zlib|expat|rapidcheck|mpi)\.h$' \
  "$scratch/read" || fail "the core reads a header of another package"
echo "the core's $(wc -l <"$scratch/sources") sources read $(wc -l <"$scratch/read") files, none of another package"
