#!/usr/bin/env bash
# The manual pages that the build leaves for `cmake --install`: there is one of each command and of flowcert-proof, it
# says every option that --help says, and a linter of manual pages has nothing to say of it.
#
# usage: manual_pages_test.sh BUILD_DIR      (a build with the program; Debian's mandoc)
#
# Pages have no date, on purpose, and the linter is asked to leave that alone. A page with a fault has to be seen.
set -euo pipefail
build=$1
flowcert=$build/flowcert
pages=$build/share/man/man1
failures=0
command -v mandoc >/dev/null || { echo "FAIL: there is no mandoc; ./dev test installs it"; exit 1; }

fail() {
  echo "FAIL: $*"
  failures=$((failures + 1))
}

complaints_about() { mandoc -Tlint -W warning "$1" | grep -v 'missing date' || true; }

# The names in the lists of a help, and its options.
names_in_help() {
  "$flowcert" "$@" --help | sed -nE '/^(Examples|More examples|Positionals):/,/^$/d; s/^  ([a-z]+)  .*/\1/p'
}
options_in_help() { "$flowcert" "$@" --help | grep -oE '^ {2,4}(-[a-z],)?--[a-z-]+' | tr -d ' ' | tr , '\n' | sort -u; }

faulty=$(mktemp)
printf '.TH A 1\n.SH NAME\na \\- b\n.TP\n\\fBno end\n.NOSUCH\n' >"$faulty"
[ -n "$(complaints_about "$faulty")" ] || fail "the linter sees no fault in a faulty page"
rm -f "$faulty"

commands=$(names_in_help)
[ "$(wc -w <<<"$commands")" -ge 13 ] || fail "--help has too few commands: $commands"
count=0
for command in '' $commands 'fuzz merge'; do
  page=$pages/flowcert${command:+-${command// /-}}.1
  [ -s "$page" ] || { fail "there is no page $page"; continue; }
  count=$((count + 1))
  complaint=$(complaints_about "$page")
  [ -z "$complaint" ] || fail "$complaint"
  if command -v groff >/dev/null; then
    complaint=$(groff -man -ww -z "$page" 2>&1)
    [ -z "$complaint" ] || fail "$page: $complaint"
  fi
  "$flowcert" manual $command | cmp - "$page" || fail "flowcert manual $command prints another page"
  ! LC_ALL=C grep -q '[^ -~]' "$page" || fail "$page is not ASCII"
  text=$(mandoc -Tascii "$page" | sed 's/.\x08//g')
  for option in $(options_in_help $command); do
    grep -qE -- "^ +(-[a-z], )?$option([ ,]|$)" <<<"$text" || fail "$page does not say $option"
  done
  "$flowcert" $command --help | sed -nE '/xamples:/,/^$/s/^ +//p' | while IFS= read -r line; do
    grep -qF -- "$line" <<<"$text" || fail "$page does not have the example $line"
  done
  for name in $commands; do
    [ -n "$command" ] || grep -q "flowcert-$name(1)" <<<"$text" || fail "$page does not name flowcert-$name"
  done
done
# The page of the checker is written by hand.
page=$build/oracle/proof/flowcert-proof.1
complaint=$(complaints_about "$page")
[ -z "$complaint" ] || fail "$complaint"
version=$("$build/flowcert-proof" --version)
[ "flowcert ${version#* }" = "$("$flowcert" --version | grep -oE '^flowcert [0-9.]+')" ] || fail "it says $version"
grep -qF "\"flowcert ${version#* }\"" "$page" || fail "$page is not of $version"
for option in $("$build/flowcert-proof" --help | grep -oE '^ +--[a-z]+'); do
  mandoc -Tascii "$page" | sed 's/.\x08//g' | grep -qE -- "^ +$option( |$)" || fail "$page does not say $option"
done
[ "$(find "$pages" -name '*.1' | wc -l)" -eq "$count" ] || fail "there are pages of commands that do not exist"

[ "$failures" -eq 0 ] || exit 1
echo "$count manual pages say what --help says"
