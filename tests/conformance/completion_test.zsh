#!/usr/bin/env zsh
# What `flowcert completion zsh` prints completes words, in the zsh that runs this.
#
# usage: zsh -f completion_test.zsh FLOWCERT
#
# Another zsh runs on a terminal of its own (zsh/zpty). A line is typed there, then the key for its completion, and what
# the line becomes is looked at. Where several words are possible, all are put into the line.
zmodload zsh/zpty
setopt extendedglob
flowcert=$1:A
scratch=$(mktemp -d)
cd $scratch
touch scan.xyz mesh.off
mkdir folder bin
ln -s $flowcert bin/flowcert
failures=0

zpty shell "PATH=$scratch/bin:\$PATH TERM=dumb zsh -f -i"
zpty -w shell 'unsetopt zle; PS1= ; autoload -U compinit; compinit -u -D; source <(flowcert completion zsh); setopt zle'
# Control-X c shows the line, complete, between two marks.
zpty -w shell 'show() { zle list-expand 2>/dev/null; zle expand-or-complete; print -r -- "<<$BUFFER>>"; BUFFER=; }'
zpty -w shell 'zle -N show; bindkey "^Xc" show; print -r READY'
zpty -r shell seen '*READY*READY*' || zpty -r shell seen '*READY*'

# expect WANTED LINE: what the line becomes.
expect() {
  local seen
  zpty -w -n shell "$2"$'\C-Xc'
  zpty -r shell seen '*<<*>>*'
  seen=${${seen##*<<}%%>>*}
  [[ ${seen%% #} == $1 ]] && return
  print -r -- "FAIL: '$2' [TAB] becomes '$seen', not '$1'"
  (( ++failures ))
}

expect 'flowcert persistence' 'flowcert per'
expect 'flowcert fuzz merge' 'flowcert fuzz m'
expect 'flowcert compute --kernel=lazy' 'flowcert compute --kernel=l'
expect 'flowcert compute scan.xyz' 'flowcert compute sc'
expect 'flowcert conformance --keep=' 'flowcert conformance --ke'
expect 'flowcert completion fish' 'flowcert completion f'
expect 'flowcert generate --vectors folder/' 'flowcert generate --vectors fo'

zpty -d shell
cd /
rm -rf $scratch
(( failures == 0 )) || exit 1
print "zsh completes commands, options, values and files"
