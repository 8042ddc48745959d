#!/usr/bin/env bash
# What `flowcert completion bash` prints completes words, in the bash that runs this.
#
# usage: bash_completion_test.sh FLOWCERT      (the program, or any path that ends in /flowcert)
#
# The shell calls the function as it does for the words of a line; nothing is typed. What must be offered is told word
# by word. That all commands and options are there is asked of --help, so a new one is looked at, too.
set -euo pipefail
export LC_ALL=C
flowcert=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
touch scan.xyz scan.PLY mesh.off 'two words.obj' notes.pdf claim.jsonl shape.pers curve.svg zipped.xyz.gz
mkdir folder
failures=0

source /dev/stdin <<<"$("$flowcert" completion bash)"
complete -p flowcert >/dev/null || { echo "FAIL: the script completes no flowcert"; exit 1; }

# offered WORD...: what is offered for the last of these words, sorted, with commas between.
offered() {
  COMP_WORDS=(flowcert "$@")
  COMP_CWORD=$#
  COMPREPLY=()
  _flowcert
  printf '%s\n' "${COMPREPLY[@]}" | sort | paste -sd,
}

# expect WANTED WORD...
expect() {
  local wanted=$1 got
  shift
  got=$(offered "$@")
  [ "$got" = "$wanted" ] && return
  echo "FAIL: flowcert $* [TAB] offers '$got', not '$wanted'"
  failures=$((failures + 1))
}

# The names in the lists of a help, and its options.
names_in_help() {
  "$flowcert" "$@" --help | sed -nE '/^(Examples|More examples|Positionals):/,/^$/d; s/^  ([a-z]+)  .*/\1/p'
}
options_in_help() { "$flowcert" "$@" --help | sed -nE 's/^ {2,4}((-[a-z],)?--[a-z-]+).*/\1/p' | tr , '\n' | sort -u; }

# Commands.
expect "$(names_in_help | sort | paste -sd,)" ''
expect completion,compute,conformance co
expect '' compute scan.xyz nothing
expect merge fuzz m
expect '' quartz
[ "$(names_in_help | wc -l)" -ge 13 ] || { echo "FAIL: --help has too few commands"; failures=$((failures + 1)); }

# All options of all commands.
for command in $(names_in_help) 'fuzz merge'; do
  expect "$(options_in_help $command | paste -sd,)" $command -
done
expect --help,--version --
expect --kernel compute scan.xyz --k
expect --keep conformance --against x --ke

# Values that can be listed, also after an equals sign, which the shell makes a word of its own.
expect cascade,exact,lazy compute scan.xyz --kernel ''
expect lazy compute --kernel l
expect lazy compute --kernel = l
expect cascade,exact,lazy compute --kernel =
expect all,s2,u2 compute --manifolds ''
expect 'u2,all,u2,s2' compute --manifolds u2,
expect '' compute --manifolds u2,u
expect bash,fish,zsh completion ''
# No file is offered where a number is asked for, and an option that wants a value has it.
expect '' compute --runs ''
expect '' orbit scan.xyz --from -1
expect --json orbit scan.xyz --from -1,0,0 --js

# Files, by what they are for; folders always.
expect 'folder,mesh.off,scan.xyz,two words.obj,zipped.xyz.gz' compute ''
expect scan.xyz persistence s
expect claim.jsonl,folder,shape.pers check scan.xyz ''
expect folder,shape.pers persistence scan.xyz -o ''
expect folder compute scan.xyz --export ''
expect curve.svg,folder pores scan.xyz --curve ''
expect folder generate --vectors ''
expect --help,--hex generate --vectors --h
expect 'folder,merge,mesh.off,scan.xyz,two words.obj,zipped.xyz.gz' fuzz --replay scan.xyz ''
expect folder fuzz merge folder ''
# The second argument of surface does not exist, so options are what is left.
expect "$(options_in_help surface | paste -sd,)" surface scan.xyz ''

# An option that speaks of a file or a folder is in the table of described_command.cpp, except commands, a mere name and
# radii: those have no file to complete.
# The script for fish has each option with what it says on one line.
forgotten=$("$flowcert" completion fish | grep -iE -- '-x -d .*(file|folder|director)' |
  grep -vE -- '-l ([a-z-]*against|out-name|radii) ' || true)
[ -z "$forgotten" ] || { echo "FAIL: no file is completed: $forgotten"; failures=$((failures + 1)); }

[ "$failures" -eq 0 ] || exit 1
echo "bash completes commands, options, values and files"
