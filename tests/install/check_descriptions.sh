#!/usr/bin/env bash
# Man pages and completions know every command and option of --help, and bash completes by them.
# Usage: check_descriptions.sh ANGIOPOSE ANGIOPOSE-CLI PACKAGING-LINUX-FOLDER
set -u
window=$1 cli=$2 linux=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
faults=0
complain() { echo "$*"; faults=$((faults + 1)); }

# Lines of --help that begin with an option, or with an indented command.
options_of() { "$@" | grep -oE '^  (-[A-Za-z], ?)?--[A-Za-z0-9-]+(,--[A-Za-z0-9-]+)*' | grep -oE -- '--[A-Za-z0-9-]+'; }
commands_of() { "$cli" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p'; }

for kind in man bash zsh fish; do
    "$cli" description $kind >"$work/cli.$kind" || complain "description $kind fails"
done
sed -i 's/\\-/-/g' "$work/cli.man"
sed 's/\\-/-/g' "$linux/angiopose.1" >"$work/window.man"

# Section of one command in the description of all.
part_of() {   # KIND COMMAND
    case $1 in
        man) sed -n "/^\.SS $2\$/,/^\.S[SH] /{/^\.SS $2\$/p;/^\.S[SH] /!p}" "$work/cli.man" ;;
        bash) grep -E "^        $2\)" "$work/cli.bash" ;;
        zsh) sed -n "/^ *$2)\$/,/^ *;;\$/p" "$work/cli.zsh" ;;
        fish) grep -E "seen_subcommand_from $2'| -a $2 " "$work/cli.fish" ;;
    esac
}

count=0
for command in $(commands_of); do
    for option in $(options_of "$cli" "$command" --help); do
        for kind in man bash zsh fish; do
            [[ $kind == man && $option == --help ]] && continue   # described once, above the commands
            wanted="(^|[^a-z-])$option([^a-z0-9-]|\$)"
            [ $kind = fish ] && wanted=" -l ${option#--} "
            count=$((count + 1))
            part_of $kind "$command" | grep -qE -- "$wanted" || complain "$kind lacks $option of $command"
        done
    done
done
[ $count -gt 200 ] || complain "only $count options were found in --help"
for option in $(options_of "$cli" --help); do
    grep -q -- "$option" "$work/cli.man" || complain "the man page lacks $option"
done

for option in $(options_of env -u DISPLAY LC_ALL=C.UTF-8 "$window" --help); do
    for file in "$work/window.man" "$linux/completion/angiopose.bash" "$linux/completion/_angiopose"; do
        grep -qE -- "$option([^a-z-]|\$)" "$file" || complain "${file##*/} lacks $option of angiopose"
    done
    grep -q -- " -l ${option#--} " "$linux/completion/angiopose.fish" || complain "angiopose.fish lacks $option"
done

# Bash, as it does it: the words of the line, the last one being completed.
# shellcheck disable=SC1090,SC1091
completes() {   # EXPECTED WORD…
    local expected=$1
    shift
    local got
    got=$(cd "$work" && bash -c 'source cli.bash; source "$1/completion/angiopose.bash"; shift
        COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
        function=$(complete -p "$1" | sed "s/.*-F \([^ ]*\) .*/\1/"); "$function" 2>/dev/null
        echo "${COMPREPLY[*]}"' bash "$linux" "$@")
    [ "$got" = "$expected" ] || complain "bash completes '$*' by '$got' instead of '$expected'"
}
touch "$work/one.angiopose" "$work/two words.angiopose"
completes "register" angiopose-cli reg
completes "trace-angiogram trace-vessel" angiopose-cli trace
completes "--width" angiopose-cli project --wi
completes "one.angiopose" angiopose-cli register on
completes "two words.angiopose" angiopose-cli register tw
completes "one.angiopose" angiopose-cli register --deformable on
completes "dynaweight" angiopose-cli register one.angiopose --method dyna
completes "dynaweight" angiopose-cli register one.angiopose --method = dyna
completes "" angiopose-cli project one.angiopose --width ""
completes "turn" angiopose-cli movie --show t
completes "toy trust" angiopose-cli evaluate t
completes "simulate" angiopose-cli help sim
completes "priorWeight=" angiopose-cli register one.angiopose --set priorW
completes "--version" angiopose-cli --vers
completes "vtk" angiopose --renderer v
completes "--renderer" angiopose --ren
completes "one.angiopose" angiopose on

if command -v zsh >/dev/null; then
    zsh -n "$work/cli.zsh" && zsh -n "$linux/completion/_angiopose" || complain "zsh does not read its completion"
fi
if command -v fish >/dev/null; then
    got=$(HOME=$work fish --no-config -c "source $work/cli.fish; complete -C 'angiopose-cli project --wi'" | cut -f1)
    [ "$got" = --width ] || complain "fish completes --wi by '$got'"
fi
if command -v man >/dev/null && command -v groff >/dev/null; then
    "$cli" description man >"$work/angiopose-cli.1"
    for page in "$work/angiopose-cli.1" "$linux/angiopose.1"; do
        warnings=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null)
        [ -z "$warnings" ] || complain "${page##*/}: $warnings"
    done
fi
exit $((faults > 0))
