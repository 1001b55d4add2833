#!/usr/bin/env bash
# Installs what is missing, builds, and passes the tests. With `full` also the sanitizers, a minute of fuzzing and clang-tidy.
# Usage: test.sh [full]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$(dirname "$here")"
mode=${1:-usual}

step() { printf '\n== %s (%s)\n' "$1" "$(date +%H:%M:%S)"; }

step "Packages"
"$here/install_packages.sh" build test

step "Format"
"$here/check_format.sh"

step "Release: build"
cmake --preset release -DBUILD_TESTING=ON >/dev/null
cmake --build build/release
step "Release: tests"
thorough=()
[ "$mode" = full ] || thorough=(--label-exclude thorough)
# Windows and archives wait in part. On a loaded machine a window can miss a deadline; a defect fails twice.
ctest --preset release --parallel $(($(nproc) + 1)) --repeat until-pass:2 "${thorough[@]}"

if [ "$mode" = full ]; then
    step "Release: benchmarks"
    cmake --build build/release --target benchmarks
    step "Address and undefined-behaviour sanitizers: build"
    cmake --preset asan >/dev/null
    cmake --build build/asan
    step "Address and undefined-behaviour sanitizers: tests"
    ctest --preset asan
    step "Thread sanitizer: jobs"
    cmake --preset tsan >/dev/null
    cmake --build build/tsan --target job_test
    ctest --preset tsan -R '^app\.jobs'
    step "Fuzzing: a minute"
    "$here/fuzz.sh" 60
    step "clang-tidy"
    "$here/check_tidy.sh"
fi
step "Done"
