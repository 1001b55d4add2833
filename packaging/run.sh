#!/usr/bin/env bash
# Installs what is missing, builds, and runs the main job on a built-in case: in the window where there is a display,
# headless otherwise, saying where the overlay lies. Arguments are passed on to the program (e.g. a case file).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
cd "$root"

"$here/install_packages.sh" build
[ -f build/release/build.ninja ] || cmake --preset release -DBUILD_TESTING=OFF >/dev/null
cmake --build build/release --target angiopose angiopose-cli

demo=build/demo
[ -f "$demo/case.angiopose" ] || build/release/app/angiopose-cli simulate --seed 1 --output "$demo"

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    if [ $# -gt 0 ]; then
        exec build/release/app/angiopose "$@"
    fi
    exec build/release/app/angiopose "$demo/case.angiopose"
fi
case_file=${1:-$demo/case.angiopose}
result=$demo/result
build/release/app/angiopose-cli register "$case_file" --output "$result"
echo "No display: the overlay lies in $root/$result/overlay.png"
