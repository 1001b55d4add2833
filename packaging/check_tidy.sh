#!/usr/bin/env bash
# Runs clang-tidy. Arguments: files to check; default: all own sources.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# clang cannot read the headers that GCC precompiles: a configuration of its own, which is never built.
cmake --preset release -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DBUILD_TESTING=OFF >/dev/null
if [ $# -gt 0 ]; then
    printf '%s\0' "$@"
else
    find core io ui app -name '*.cpp' -print0
fi | xargs -0 -P "$(nproc)" -n 4 clang-tidy --quiet -p build/tidy --extra-arg=-Wno-unknown-warning-option
