#!/usr/bin/env bash
# Time from starting the program to its first window on the screen: median and range of some starts, one after the other,
# on an X server of its own (Xvfb), with fresh settings. Several programs (two builds, say) take turns in one run.
# Usage: start_time.sh [--starts N] PROGRAM [PROGRAM…]
set -euo pipefail
starts=9
if [ "${1:-}" = --starts ]; then
    starts=$2
    shift 2
fi
[ $# -ge 1 ] || { sed -n 2,4p "$0" | cut -c3-; exit 2; }
for needed in Xvfb xev; do
    command -v "$needed" >/dev/null || { echo "start_time.sh: $needed is missing: apt install xvfb x11-utils"; exit 3; }
done

folder=$(mktemp -d)
exec 3<>"$folder/display"
Xvfb -displayfd 3 -screen 0 1440x900x24 >"$folder/server.log" 2>&1 &
server=$!
trap 'kill "$server" 2>/dev/null || true; rm -rf "$folder"' EXIT
until [ -s "$folder/display" ]; do sleep 0.05; done
DISPLAY=:$(tr -d '[:space:]' <"$folder/display")
export DISPLAY XDG_CONFIG_HOME="$folder/config" XDG_STATE_HOME="$folder/state" XDG_CACHE_HOME="$folder/cache"
export XDG_RUNTIME_DIR="$folder/run"
mkdir -m 700 "$XDG_RUNTIME_DIR"
exec 4< <(exec stdbuf -oL xev -root -event substructure)
watcher=$!
trap 'kill "$watcher" "$server" 2>/dev/null || true; rm -rf "$folder"' EXIT

milliseconds() { echo $((${EPOCHREALTIME/[.,]/} / 1000)); }

# Prints the milliseconds from the start of $1 until the server maps its window. Measured by an event: polling
# would take the processor from what is measured.
one_start() {
    local begin process line
    begin=$(milliseconds)
    "$1" >>"$folder/program.log" 2>&1 &
    process=$!
    while read -r -t 20 line <&4; do
        [[ $line == MapNotify* ]] && break
    done || { echo "start_time.sh: no window of $1 within 20 s" >&2; exit 1; }
    echo $(($(milliseconds) - begin))
    kill "$process"
    wait "$process" 2>/dev/null || true
    while read -r -t 0.3 line <&4; do :; done   # its end
}

for program in "$@"; do one_start "$program" >/dev/null; done   # once for the disk's cache and the fonts'
for ((k = 0; k < starts; ++k)); do
    for ((number = 1; number <= $#; ++number)); do
        one_start "${!number}" >>"$folder/times.$number"
    done
done
for ((number = 1; number <= $#; ++number)); do
    sort -n "$folder/times.$number" | awk -v program="${!number}" '{ t[NR] = $1 }
        END { printf "%s: median %d ms of %d starts (%d to %d)\n", program, t[int((NR + 1) / 2)], NR, t[1], t[NR] }'
done
