#!/usr/bin/env bash
# A study by GNU parallel and by Slurm on the loopback address, one shard killed: its table is that of one run.
# Usage: check_study.sh ANGIOPOSE-CLI ANGIOPOSE-STUDY [CASES [SHARDS]]
set -u
cli=$1 study=$2 cases=${3:-6} shards=${4:-3}
export ANGIOPOSE_CLI=$cli
work=$(mktemp -d)
# shellcheck source=tests/cluster/slurm_loopback.sh disable=SC1091
. "$(dirname "$0")/slurm_loopback.sh"
trap 'stop_slurm; rm -rf "$work"' EXIT
faults=0
complain() { echo "FAULT: $*"; faults=$((faults + 1)); }

echo case,name >"$work/cases.csv"
for n in $(seq "$cases"); do
    "$cli" simulate --seed "$n" --branches 6 --output "$work/c$n" >/dev/null || complain "case $n is not simulated"
    echo "c$n/case.angiopose,c$n" >>"$work/cases.csv"
done
code=0
"$cli" batch "$work/cases.csv" --output "$work/one" >"$work/one.log" 2>&1 || code=$?

# Kills the first program that works on a shard of that output.
kill_a_shard() {   # OUTPUT
    local id words
    for _ in $(seq 3000); do
        for id in $(pgrep -f -- "^[^ ]*angiopose-cli batch $work/cases.csv --shard [0-9/]* .*--output $1\$"); do
            words=$(tr '\0' ' ' <"/proc/$id/cmdline") 2>/dev/null
            kill -9 "$id" 2>/dev/null && echo "killed ${words#*--}" && return
        done
        sleep 0.02
    done
}

# A whole study with a shard killed meanwhile.
try_engine() {   # NAME OPTIONS...
    local name=$1 ended=0
    shift
    kill_a_shard "$work/$name" >"$work/killed" 2>/dev/null &
    local killer=$!
    "$study" run "$work/cases.csv" --output "$work/$name" --shards "$shards" "$@" >"$work/$name.log" 2>&1 || ended=$?
    kill "$killer" 2>/dev/null
    wait "$killer" 2>/dev/null
    grep -q killed "$work/killed" || complain "$name: no shard was caught at work"
    [ "$ended" -eq "$code" ] || complain "$name ends with $ended instead of $code: $(cat "$work/$name.log")"
    cmp -s "$work/one/summary.csv" "$work/$name/summary.csv" || complain "$name: the table is another than that of one run"
    "$study" status "$work/cases.csv" --output "$work/$name" >"$work/status" || true
    grep -q missing "$work/status" && complain "$name: rows are missing: $(cat "$work/status")"
    echo "$name: $(cat "$work/killed"); $(wc -l <"$work/$name/summary.csv") lines, $(tr -s ' \n' ' ' <"$work/status")"
}

[ "$("$study" plan "$work/cases.csv" --rows 2)" = "$cases rows, $(((cases + 1) / 2)) shards" ] || complain "the plan is another"
"$study" run 2>/dev/null && complain "no manifest is no complaint"
if command -v parallel >/dev/null; then
    try_engine parallel --engine parallel --jobs 2
else
    echo "GNU parallel is not installed: not tried"
fi
if command -v slurmctld >/dev/null && command -v slurmd >/dev/null; then
    if start_slurm "$work/loopback" 2; then
        try_engine slurm --engine slurm --wait
        cat "$work/slurm/.study/jobs.log" 2>/dev/null
    else
        complain "Slurm does not answer: $(tail -3 "$work"/loopback/*.out "$work/loopback/slurmctld.log")"
    fi
else
    echo "Slurm is not installed: not tried"
fi
exit $((faults > 0))
