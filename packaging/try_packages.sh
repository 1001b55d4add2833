#!/usr/bin/env bash
# Installs the packages of build/packages into clean Debian 12 roots and registers the sample case there; prints what it
# measured. Asks for root. Usage: try_packages.sh [--fresh FOLDER]
#   --fresh FOLDER   a root as debootstrap makes it, which is copied instead of making one
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
packages=$(dirname "$here")/build/packages
[ "$(id -u)" -eq 0 ] || exec sudo "$0" "$@"
work=$(mktemp -d /var/tmp/angiopose-try.XXXXXX)
trap 'rm -rf --one-file-system "$work"' EXIT
ls "$packages"/angiopose_*.deb >/dev/null || { echo "Build the packages first: packaging/build_packages.sh" >&2; exit 1; }

faults=0
say() { printf '%-34s %s\n' "$1" "$2"; }
expect() {   # WHAT COMMAND…: says whether it succeeds
    local what=$1
    shift
    if "$@" >"$work/out" 2>&1; then say "$what" yes; else say "$what" NO; sed 's/^/    /' "$work/out" | tail -5; faults=$((faults + 1)); fi
}

if [ "${1:-}" = --fresh ]; then
    fresh=$2
else
    fresh=$work/fresh
    debootstrap --variant=minbase bookworm "$fresh" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}" >"$work/debootstrap.log"
fi

new_root() {   # NAME PATTERN…: a clean root with these packages lying in it
    root=$work/$1
    shift
    cp -a "$fresh" "$root"
    cp /etc/resolv.conf "$root/etc/"
    mkdir -p "$root/debs" "$root/home/user"
    for pattern in "$@"; do cp "$packages"/$pattern "$root/debs/"; done
    chroot "$root" apt-get update -qq
    chroot "$root" dpkg-query -W -f '${Package}\n' | sort >"$work/before"
}
in_root() { env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/home/user DEBIAN_FRONTEND=noninteractive chroot "$root" "$@"; }
install_all() { in_root sh -c 'apt-get install -y -qq /debs/*.deb' >"$work/apt.log" 2>&1; }
seconds() { local begin=$EPOCHREALTIME; "$@"; awk "BEGIN {printf \"%.1f s\", $EPOCHREALTIME - $begin}"; }

echo "== angiopose alone: apt install ./angiopose_*.deb"
new_root program 'angiopose_*.deb'
say "installing, with downloads" "$(seconds install_all)"
in_root dpkg-query -W -f '${Package}\n' | sort >"$work/after"
comm -13 "$work/before" "$work/after" >"$work/new"
sizes=$(xargs -a "$work/new" env -i PATH="$PATH" chroot "$root" dpkg-query -W -f '${Installed-Size}\n' | awk '{sum += $1} END {printf "%d MB", sum / 1024}')
say "packages that came" "$(wc -l <"$work/new"), $sizes"
developing=$(grep -E -- '-dev$|^gcc|^g\+\+|^cmake' "$work/new" | grep -vE '^gcc-[0-9]+-base$' || true)
say "of them for developing" "${developing:-none}"
[ -z "$developing" ] || faults=$((faults + 1))
expect "all dependencies satisfied" in_root apt-get check
expect "angiopose --version" in_root angiopose --version
expect "angiopose --help" in_root angiopose --help
expect "man page" in_root sh -c 'zcat /usr/share/man/man1/angiopose-cli.1.gz | grep -q "SS register"'
expect "sample case made" in_root sh -c 'cd && angiopose-cli simulate --seed 1 --output demo'
register() { in_root sh -c 'cd && angiopose-cli register demo/case.angiopose --output result' >"$work/register.log"; }
say "sample case registered in" "$(seconds register)"
sed 's/^/    /' "$work/register.log"
expect "overlay.png" in_root sh -c 'test -s ~/result/overlay.png'
expect "decoder helper runs (.h5)" in_root sh -c 'cd && angiopose-cli convert result/result.json pose.h5 && angiopose-cli info pose.h5'
expect "thumbnail" in_root sh -c 'cd && angiopose-cli thumbnail demo/case.angiopose thumb.png && test -s thumb.png'
expect "report without a display" in_root sh -c 'cd && angiopose-cli report demo/case.angiopose --register --output report.pdf && test -s report.pdf'
expect "window starts (offscreen), closes" in_root sh -c 'cd && QT_QPA_PLATFORM=offscreen timeout 5 angiopose demo/case.angiopose; test $? = 124'
expect "removed without a trace" in_root sh -c 'apt-get purge -y -qq angiopose && ! find /usr /etc /var/lib/mime -iname "*angiopose*" | grep .'
rm -rf --one-file-system "$root"

echo "== library, headers, Python module and documents"
new_root library 'libangiopose*.deb' 'python3-angiopose_*.deb' 'angiopose-doc_*.deb'
say "installing, with downloads" "$(seconds install_all)"
expect "Python module registers" in_root python3 -c '
import angiopose
simulated = angiopose.simulateCase(7)
result = angiopose.registerVessels(angiopose.inputOf(simulated.session), simulated.session.options)
assert result.metrics.medianPx < 1, result.metrics.medianPx'
expect "library runs its own helper (.h5)" in_root python3 -c '
import angiopose, numpy
pose = numpy.eye(4)
angiopose.writePose(pose, "/home/user/pose.h5")
assert (angiopose.readPose("/home/user/pose.h5") == pose).all()'
in_root apt-get install -y -qq --no-install-recommends g++ cmake make >"$work/apt.log" 2>&1
expect "C++ example builds and runs" in_root sh -c 'cd && cp -r /usr/share/doc/angiopose-doc/resources/examples/cpp . &&
    cmake -S cpp -B cpp/build && cmake --build cpp/build --target simulate_and_stop && cpp/build/simulate_and_stop'
exit $((faults > 0))
