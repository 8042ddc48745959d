#!/usr/bin/env fish
# What `flowcert completion fish` prints completes words, in the fish that runs this.
#
# usage: fish --no-config completion_test.fish FLOWCERT
#
# The shell itself is asked what it offers for a line, by `complete -C`.
set flowcert $argv[1]
set scratch (mktemp -d)
cd $scratch
touch scan.xyz mesh.off
mkdir folder
$flowcert completion fish | source
set failures 0

# expect WANTED LINE: the words that are offered, without their descriptions, sorted, with commas between.
function expect
    set got (complete -C $argv[2] | string replace -r '\t.*' '' | sort | string join ,)
    if test "$got" != "$argv[1]"
        echo "FAIL: '$argv[2]' [TAB] offers '$got', not '$argv[1]'"
        set failures (math $failures + 1)
    end
end

expect completion,compute,conformance 'flowcert co'
expect merge 'flowcert fuzz m'
expect --keep 'flowcert conformance --ke'
expect --help,--json,--known,--out 'flowcert fuzz merge --'
expect --kernel=cascade,--kernel=exact,--kernel=lazy 'flowcert compute --kernel='
expect cascade,exact,lazy 'flowcert compute --kernel '
expect bash,fish,zsh 'flowcert completion '
expect scan.xyz 'flowcert compute sc'
expect folder/ 'flowcert generate --vectors fo'
expect '' 'flowcert compute --runs '
# All options of a command.
set options ($flowcert check --help | string match -rg '^ {2,4}(?:-[a-z],)?(--[a-z-]+)' | sort -u | string join ,)
expect $options 'flowcert check --'

cd /
rm -rf $scratch
test $failures -eq 0; or exit 1
echo "fish completes commands, options, values and files"
