#!/usr/bin/env bash
# Unpacks the archive of build/packages in a Debian 12 root that has no library of it, without OpenGL and X, registers the
# sample case there and says which libraries of the system were used. Asks for root. Usage: try_archive.sh [--fresh FOLDER]
#   --fresh FOLDER   a root as debootstrap makes it, which is copied instead of making one
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
archive=$(ls "$(dirname "$here")"/build/packages/angiopose-*-linux-*.tar.xz) || { echo "Build it first: packaging/build_archive.sh" >&2; exit 1; }
[ "$(id -u)" -eq 0 ] || exec sudo "$0" "$@"
# In a name space of its own, so that what is mounted goes with it.
[ -n "${ANGIOPOSE_TRY_INSIDE:-}" ] || ANGIOPOSE_TRY_INSIDE=1 exec unshare -m "$0" "$@"
work=$(mktemp -d /var/tmp/angiopose-try.XXXXXX)
trap 'umount "$root/proc" 2>/dev/null; rm -rf --one-file-system "$work"' EXIT

root=$work/root
if [ "${1:-}" = --fresh ]; then
    cp -a "$2" "$root"
else
    debootstrap --variant=minbase bookworm "$root" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}" >"$work/debootstrap.log"
fi
mount -t proc proc "$root/proc"   # where $ORIGIN comes from
mkdir -p "$root/home/user/some where"
tar -xf "$archive" -C "$root/home/user/some where"
mv "$root/home/user/some where"/angiopose-* "$root/home/user/some where/moved"
bin='/home/user/some where/moved/bin'

faults=0
say() { printf '%-34s %s\n' "$1" "$2"; }
in_root() { env -i PATH=/usr/bin:/bin:/usr/sbin HOME=/home/user LC_ALL=C.UTF-8 bin="$bin" chroot "$root" sh -c "cd && $1"; }
expect() {   # WHAT COMMAND
    if in_root "$2" >"$work/out" 2>&1; then say "$1" yes; else say "$1" NO; sed 's/^/    /' "$work/out" | tail -5; faults=$((faults + 1)); fi
}
say "archive" "$(du -h "$archive" | cut -f1), unpacked $(du -sh "$root/home/user/some where/moved" | cut -f1)"
expect "angiopose-cli --version" '"$bin/angiopose-cli" --version'
expect "angiopose --version" '"$bin/angiopose" --version'
expect "started by a link" 'ln -sf "$bin/angiopose-cli" cli && ./cli --version'
expect "sample case made" '"$bin/angiopose-cli" simulate --seed 1 --output demo'
begin=$EPOCHREALTIME
expect "sample case registered" '"$bin/angiopose-cli" register demo/case.angiopose --output result && test -s result/overlay.png'
say "  in" "$(awk "BEGIN {printf \"%.1f s\", $EPOCHREALTIME - $begin}")"
expect "decoder helper runs (.h5)" '"$bin/angiopose-cli" convert result/result.json pose.h5 && "$bin/angiopose-cli" info pose.h5'
expect "other LD_LIBRARY_PATH does no harm" 'mkdir -p bad && : >bad/libvtkCommonCore-9.1.so.1 && LD_LIBRARY_PATH=$HOME/bad "$bin/angiopose-cli" --version'
expect "report without a display" '"$bin/angiopose-cli" report demo/case.angiopose --register --output report.pdf && test -s report.pdf'
expect "window starts (offscreen)" 'QT_QPA_PLATFORM=offscreen timeout 5 "$bin/angiopose" demo/case.angiopose; test $? = 124'
expect "fonts and dictionary are its own" 'LD_DEBUG=files QT_QPA_PLATFORM=offscreen timeout 5 "$bin/angiopose" --version &&
    test -s "$bin/../share/fonts/Inter-Regular.otf" && test -s "$bin/../share/dcmtk/dicom.dic"'
expect "desktop entry for this user" '"$bin/../integrate" && grep -q "^Exec=\"$bin/angiopose\" %F" .local/share/applications/*.desktop &&
    grep -q "^Exec=\"$bin/angiopose-cli\" thumbnail" .local/share/thumbnailers/*.thumbnailer &&
    "$bin/../integrate" --remove && ! find .local/share/applications .local/share/thumbnailers .local/share/mime .local/share/icons -type f | grep .'
outside=$(in_root 'LD_DEBUG=libs QT_QPA_PLATFORM=offscreen timeout 5 "$bin/angiopose" demo/case.angiopose 2>&1' |
    sed -n 's|.*calling init: \(/.*\)|\1|p' | grep -v "^$bin/\|/some where/" | sort -u | tr '\n' ' ' || true)
say "libraries of the system" "$outside"
if grep -qvE '^/lib(64)?/([^/]*/)?(ld-linux[^/]*|lib(c|m|dl|rt|pthread|resolv)\.so[^ ]*)$' <<<"$(tr ' ' '\n' <<<"${outside% }")"; then
    say "only glibc" NO
    faults=$((faults + 1))
fi
exit $((faults > 0))
