#!/usr/bin/env bash
# Runs clang-tidy. Arguments: files to check; default: all own sources.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# clang cannot read the headers that GCC precompiles: a configuration of its own, which is never built.
cmake --preset release -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DBUILD_TESTING=OFF >/dev/null
# Debian's ITK refuses compilers other than the one it was built with: here clang passes for that.
detection=$(find /usr/include -name itk_compiler_detection.h | head -n 1)
sed 's/define ITK_COMPILER_IS_Clang 1/define ITK_COMPILER_IS_GNU 1/' "$detection" >build/tidy/itk_compiler_detection.h
cat >build/tidy/overlay.yaml <<END
{"version": 0, "roots": [{"type": "directory", "name": "${detection%/*}", "contents": [{"type": "file",
    "name": "${detection##*/}", "external-contents": "$PWD/build/tidy/itk_compiler_detection.h"}]}]}
END
if [ $# -gt 0 ]; then
    printf '%s\0' "$@"
else
    find core io ui app -name '*.cpp' -print0
fi | xargs -0 -P "$(nproc)" -n 4 clang-tidy --quiet -p build/tidy --extra-arg=-Wno-unknown-warning-option \
    --extra-arg=-UNDEBUG --extra-arg=-fgnuc-version=8.3 --vfsoverlay="$PWD/build/tidy/overlay.yaml"
