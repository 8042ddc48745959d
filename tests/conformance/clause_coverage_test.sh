#!/usr/bin/env bash
# Spec and tests name each other: every clause of the spec is cited by a test that ctest runs, and every clause id
# in the code is one of the spec's. Ids that are withdrawn are listed in spec/formats/README.md; only pages of the spec
# name them.
#
# usage: clause_coverage_test.sh [ROOT]        prints clause, level, number of citing tests
#        clause_coverage_test.sh --self-test   damages a small tree in every way that must fail, and sees it fail
#
# A C++ test cites by CITES("ID", ...), the first statement of its body; a test in another language by a line
# `# CITES: ID ID`. Only files that a CMakeLists.txt of tests/ registers (flowcert_test_program, flowcert_script_test,
# add_test with --file) count, and no DISABLED_ test.
set -euo pipefail

# The pages that have to have clauses. Other pages may have some. normative_text_test.py sees that all normative text is
# that of clauses, so that only normative text is counted here.
spec_files=(spec/flow_complex.md spec/claims.md)
id='FC-[A-Z]+-[0-9]+'

# Lines "ID<tab>level" of the clauses in a file; a clause with another level, or none, gets the level "?".
clauses() {
  awk '/^\*\*FC-[A-Z]+-[0-9]+\*\*/ {
    match($0, /FC-[A-Z]+-[0-9]+/)
    name = substr($0, RSTART, RLENGTH)
    level = "?"
    if (match($0, /^\*\*FC-[A-Z]+-[0-9][0-9]\*\* \((determined|permitted variation|must reject)(, theorem)?\)\. /)) {
      level = substr($0, index($0, "(") + 1)
      level = substr(level, 1, index(level, ")") - 1)
    }
    print name "\t" level
  }' "$1"
}

# The test files that ctest runs, as they are registered in the CMakeLists.txt files.
registered_files() {
  local list folder text
  while read -r list; do
    folder=$(dirname "$list")
    text=$(sed 's/#.*//' "$list" | tr '\n' ' ')
    # What stands between TESTS and the next word in capitals.
    grep -oE 'flowcert_test_program\([^)]*' <<<"$text" | grep -oP '\bTESTS\b\K[^A-Z]*' | grep -oE '[a-z0-9_]+_test\b' |
      sed "s|.*|$folder/&.cpp|" || true
    grep -oE 'add_test\([^)]*' <<<"$text" | grep -oP -- '--file \K[a-z0-9_]+\.cpp' | sed "s|.*|$folder/&|" || true
    grep -oE 'flowcert_script_test\([^)]*' <<<"$text" | grep -oP '\$\{scripts\}/\K[a-z0-9_]+\.(sh|py)' |
      sed "s|.*|$folder/&|" || true
  done < <(find "$1/tests" -name CMakeLists.txt | sort) | sort -u
}

# For C++ files: a line "cites<tab>ID" for each id that a test cites, and "misplaced<tab>FILE:LINE" for each
# CITES that is not the first statement of a test. The head of a test may take two lines.
citations_in_cpp() {
  awk '
    FNR == 1 { head = 0; collecting = 0 }
    /^[ \t]*\/\// || /^#define/ { next }
    /^(TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(/ { head = FNR; disabled = 0 }
    head && FNR <= head + 1 && /DISABLED_/ { disabled = 1 }
    /CITES\(/ {
      if (head && FNR - head <= 2 && previous ~ /\{$/ && $0 ~ /^[ \t]*CITES\(/) {
        collecting = !disabled
      } else {
        print "misplaced\t" FILENAME ":" FNR
      }
      head = 0
    }
    collecting {
      rest = $0
      while (match(rest, /"FC-[A-Z]+-[0-9]+"/)) {
        print "cites\t" substr(rest, RSTART + 1, RLENGTH - 2)
        rest = substr(rest, RSTART + RLENGTH)
      }
      if (/\);/) collecting = 0
    }
    { previous = $0 }' "$@"
}

citations_in_scripts() { grep -hE '^# CITES: ' "$@" | grep -oE "$id" | sed 's/^/cites\t/' || true; }

# All that is wrong with the tree, one line each, after the table; fails if anything is.
check() {
  local root=$1 failures=0 known found registered cited ids withdrawn
  fail() {
    echo "FAIL: $*"
    failures=$((failures + 1))
  }

  known=
  for file in "${spec_files[@]}"; do
    [ -n "$(clauses "$root/$file" || true)" ] || fail "no clause found in $file"
  done
  while read -r file; do
    found=$(clauses "$file")
    known+=${found:+${known:+$'\n'}$found}
  done < <(find "$root/spec" -name '*.md' | sort)
  while IFS=$'\t' read -r clause level; do
    [ "$level" != '?' ] || fail "$clause has no level: determined, permitted variation or must reject"
  done <<<"$known"
  while read -r clause; do
    [ -z "$clause" ] || fail "$clause is the id of two clauses"
  done < <(cut -f1 <<<"$known" | sort | uniq -d)

  registered=$(registered_files "$root")
  while read -r file; do
    [ -f "$file" ] || fail "$file is registered, but is no file"
  done <<<"$registered"
  while read -r file; do
    grep -qxF "$file" <<<"$registered" || fail "$file cites clauses, but no CMakeLists.txt registers it"
  done < <(grep -rlE '^[^/#]*CITES\(' "$root/tests" --include='*.cpp' --include='*.h'
    grep -rlE '^# CITES: ' "$root/tests" --include='*.sh' --include='*.py')

  cited=$({
    grep '\.cpp$' <<<"$registered" | while read -r file; do [ ! -f "$file" ] || citations_in_cpp "$file"; done
    grep -E '\.(sh|py)$' <<<"$registered" | while read -r file; do
      [ ! -f "$file" ] || citations_in_scripts "$file"
    done
  } || true)
  while IFS=$'\t' read -r what where; do
    [ "$what" != misplaced ] || fail "$where: CITES is not the first statement of a test"
  done <<<"$cited"

  while IFS=$'\t' read -r clause level; do
    count=$(grep -cxF $'cites\t'"$clause" <<<"$cited" || true)
    printf '%-12s %-20s %4d\n' "$clause" "$level" "$count"
    [ "$count" -gt 0 ] || fail "$clause is cited by no test"
  done <<<"$known"

  ids=$(cut -f1 <<<"$known")
  withdrawn=$(withdrawn_ids "$root")
  while read -r clause; do
    ! grep -qxF "$clause" <<<"$ids" || fail "$clause is a clause, but listed as withdrawn"
    found=$(cd "$root" && grep -rlwF "$clause" $(trees .) | grep -v '^spec/.*\.md$' | tr '\n' ' ' || true)
    [ -z "$found" ] || fail "$clause is withdrawn, but named in: $found"
  done < <(grep . <<<"$withdrawn")
  while read -r clause; do
    [ -z "$clause" ] || grep -qxF "$clause" <<<"$ids"$'\n'"$withdrawn" ||
      fail "$clause is no clause of the spec, but named in: $(cd "$root" && grep -rlwF "$clause" $(trees .) | tr '\n' ' ')"
  done < <(cd "$root" && grep -rhoE "\b$id\b" $(trees .) | sort -u)
  [ "$failures" -eq 0 ]
}

# The ids in the list below the heading "Withdrawn ids".
withdrawn_ids() {
  [ ! -f "$1/spec/formats/README.md" ] ||
    sed -n '/^## Withdrawn ids$/,$p' "$1/spec/formats/README.md" | grep -oP "^- \K$id(?=, withdrawn in )" || true
}

# Where clause ids are looked for.
trees() { for tree in spec tests oracle src fuzz; do [ ! -d "$1/$tree" ] || echo "$tree"; done; }

# A tree of four clauses and three tests, with everything right.
make_small_tree() {
  mkdir -p "$1"/{spec/formats,tests/unit,src}
  printf '%s\n' '**FC-IN-01** (must reject). One.' '' '**FC-IN-02** (determined). Two.' >"$1/spec/flow_complex.md"
  printf '%s\n' '**FC-CLAIM-01** (must reject). Three.' >"$1/spec/claims.md"
  printf '%s\n' '**FC-FILE-01** (determined). Four.' >"$1/spec/formats/points.md"
  printf '%s\n' '## Withdrawn ids' '' '- FC-''OUT-01, withdrawn in 1.1.' >"$1/spec/formats/README.md"
  printf '%s\n' '// FC-IN-01' >"$1/src/a.cpp"
  printf '%s\n' 'flowcert_test_program(unit_tests' '  TESTS' '    a_test' '  LINKS d_test)' 'flowcert_script_test(b bash' \
    '  ${scripts}/b_test.sh)' 'flowcert_script_test(c ${scripts}/c_test.py)' >"$1/tests/unit/CMakeLists.txt"
  printf '%s\n' 'TEST(A,' '     B) {' '  CITES("FC-IN-01");' '}' >"$1/tests/unit/a_test.cpp"
  printf '%s\n' '# CITES: FC-IN-02 FC-CLAIM-01' >"$1/tests/unit/b_test.sh"
  printf '%s\n' '# CITES: FC-FILE-01' >"$1/tests/unit/c_test.py"
}

# must_fail WHAT FILE SED-SCRIPT MESSAGE: after that edit of the small tree, the check fails, and says so.
must_fail() {
  rm -rf "$scratch/tree"
  make_small_tree "$scratch/tree"
  sed -i "$3" "$scratch/tree/$2"
  if check "$scratch/tree" >"$scratch/said"; then
    echo "SELF-TEST: not noticed: $1"
    self_failures=$((self_failures + 1))
  elif ! grep -qF "FAIL: $4" "$scratch/said"; then
    echo "SELF-TEST: noticed otherwise: $1"
    cat "$scratch/said"
    self_failures=$((self_failures + 1))
  fi
}

self_test() {
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  self_failures=0
  make_small_tree "$scratch/right"
  check "$scratch/right" || { echo "SELF-TEST: the small tree is right"; self_failures=1; }

  # The ids are put together here, so that the check of the real tree does not find them.
  local none="FC-NONE"-01 third="FC-IN"-03 withdrawn="FC-OUT"-01 list=spec/formats/README.md
  local spec=spec/flow_complex.md claims=spec/claims.md points=spec/formats/points.md cpp=tests/unit/a_test.cpp cmake=tests/unit/CMakeLists.txt
  must_fail "an id that is no clause" src/a.cpp "s/FC-IN-01/$none/" "$none is no clause"
  must_fail "a citation of no clause" $cpp "s/FC-IN-01/FC-IN-01\", \"$none/" "$none is no clause"
  must_fail "a withdrawn id in the code" src/a.cpp "s/FC-IN-01/$withdrawn/" "$withdrawn is withdrawn, but named in: src"
  must_fail "a citation of a withdrawn id" $cpp "s/FC-IN-01/FC-IN-01\", \"$withdrawn/" "$withdrawn is withdrawn, but"
  must_fail "a withdrawn id that is a clause" $spec "\$a **$withdrawn** (determined). Five." "$withdrawn is a clause, but"
  must_fail "a withdrawn id that is not listed" $list 's/^- /* /' "$withdrawn is no clause"
  must_fail "a clause that nothing cites" $spec "\$a **$third** (determined). Three." "$third is cited by no test"
  must_fail "a clause on claims that nothing cites" $claims "\$a **$third** (determined). Four." "$third is cited by no"
  must_fail "a clause on files that nothing cites" $points "\$a **$third** (determined). Five." "$third is cited by no"
  must_fail "a script in Python that is not registered" $cmake 's/c_test.py/d_test.py/' 'FC-FILE-01 is cited by no test'
  must_fail "an id in both files" $claims '$a **FC-IN-02** (determined). Two.' 'FC-IN-02 is the id of two clauses'
  must_fail "an id twice" $spec '$a **FC-IN-02** (determined). Two.' 'FC-IN-02 is the id of two clauses'
  must_fail "an unknown level" $spec 's/(determined)/(mostly)/' 'FC-IN-02 has no level'
  must_fail "no level" $spec 's/ (determined)//' 'FC-IN-02 has no level'
  must_fail "no clauses" $spec 's/\*\*//g' "no clause found in $spec"
  must_fail "no clauses on claims" $claims 's/\*\*//g' "no clause found in $claims"
  must_fail "a test file that is not registered" $cmake 's/a_test/c_test/' 'FC-IN-01 is cited by no test'
  must_fail "a library for a test" $cmake 's/LINKS d_test/LINKS a_test/; s/^    a_test//' 'FC-IN-01 is cited by no test'
  must_fail "a registration in a comment" $cmake 's/^    a_test/# a_test/' 'FC-IN-01 is cited by no test'
  must_fail "a script that is not registered" $cmake 's/b_test/c_test/' 'FC-IN-02 is cited by no test'
  must_fail "a citation in a comment" $cpp 's/  CITES/  \/\/ CITES/' 'FC-IN-01 is cited by no test'
  must_fail "a citation outside a test" $cpp 's/^TEST/void f/' "$scratch/tree/$cpp:3: CITES is not the first"
  must_fail "a citation that is not the first" $cpp 's/  CITES/  int i = 0;\n  CITES/' "$scratch/tree/$cpp:4: CITES"
  must_fail "a disabled test" $cpp 's/B)/DISABLED_B)/' 'FC-IN-01 is cited by no test'
  [ "$self_failures" -eq 0 ] || exit 1
  echo "all damages noticed"
}

if [ "${1:-}" = --self-test ]; then
  self_test
else
  check "$(realpath "${1:-$(dirname "$0")/../..}")"
fi
