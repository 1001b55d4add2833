#!/usr/bin/env bash
# Fuzzes every family of readers with coverage, one after the other, and stops at the first finding.
# Usage: fuzz.sh [SECONDS] [FOLDER]: seconds for all of them together (default 60), folder that keeps what was learned and
# found (default build/fuzz/corpus). Longer in turns: each run begins with what the last one learned.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$(dirname "$here")"
seconds=${1:-60}
corpus=${2:-build/fuzz/corpus}
data=${ANGIOPOSE_TEST_DATA:-../shared/data}

cmake --preset fuzz >/dev/null
cmake --build build/fuzz
mkdir -p "$corpus/found"
[ -d "$data" ] || data=
build/fuzz/tests/fuzz/fuzz_seeds "$corpus/seeds" ${data:+"$data"}
harnesses=(build/fuzz/tests/fuzz/fuzz_{volume,dicom,picture,tree,surface,table,case,peer,exchange,object})
each=$(((seconds + ${#harnesses[@]} - 1) / ${#harnesses[@]}))
memory=/dev/shm
[ -w "$memory" ] || memory=${TMPDIR:-/tmp}
ANGIOPOSE_FUZZ_FOLDER=$(mktemp -d "$memory/angiopose-fuzz-XXXXXX")
export ANGIOPOSE_FUZZ_FOLDER
# Leaks are found by the tests under the address sanitizer; ITK's NRRD reader leaks on bad comments. Absurd sizes fail as
# they do in the program, which then refuses the file.
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1
trap 'rm -rf "$ANGIOPOSE_FUZZ_FOLDER"' EXIT
for harness in "${harnesses[@]}"; do
    family=${harness##*fuzz_}
    mkdir -p "$corpus/$family" "$corpus/seeds/$family"
    echo "$family: $each s"
    "$harness" -max_total_time="$each" -timeout=60 -rss_limit_mb=3000 -malloc_limit_mb=2500 -max_len=40000 \
        -print_final_stats=1 -artifact_prefix="$corpus/found/$family-" "$corpus/$family" "$corpus/seeds/$family" \
        >"$corpus/$family.log" 2>&1 || { tail -60 "$corpus/$family.log"; exit 1; }
    grep -E "stat::number_of_executed_units|cov:.*DONE" "$corpus/$family.log" | tail -2
done
