#!/usr/bin/env bash
# Runs clang-tidy over the sources of the release build. Arguments: files to check; default: all own sources.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ -f build/release/compile_commands.json ] || cmake --preset release >/dev/null
if [ $# -gt 0 ]; then
    printf '%s\0' "$@"
else
    git ls-files -z 'core/*.cpp' 'io/*.cpp' 'ui/*.cpp' 'app/*.cpp'
fi | xargs -0 -P "$(nproc)" -n 4 clang-tidy --quiet -p build/release
