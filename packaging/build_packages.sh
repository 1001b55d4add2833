#!/usr/bin/env bash
# Builds the Debian packages of the last commit: angiopose, libangiopose, libangiopose-dev, python3-angiopose, angiopose-doc.
# Usage: build_packages.sh [--use FOLDER]
#   --use FOLDER   takes what is built in FOLDER (it is configured for /usr meanwhile); otherwise everything is built
#                  from the commit's files in a tree of its own, with Debian's hardening
# The packages are put into build/packages. The same commit gives the same bytes: times are the commit's, and neither
# folder names nor the user come in.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
cd "$root"
case ${1:-} in
    '') ;;
    --use) ANGIOPOSE_BUILD=$(cd "${2:?folder of a build}" && pwd) && export ANGIOPOSE_BUILD ;;
    *) sed -n '2,/^set /s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2 && exit 2 ;;
esac

"$here/install_packages.sh" build package

out=$root/build/packages
tree=$out/source
rm -rf "$out"
mkdir -p "$tree"
git archive HEAD | tar -x -C "$tree"
cp -r "$here/debian" "$tree/debian"

# Of a commit that is no release the version says which it is.
version=$(sed -n 's/^project(AngioPose VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
soversion=${version%.*}
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
if ! git describe --exact-match --match "v$version" HEAD >/dev/null 2>&1; then
    version=$version+git$(date -u -d "@$SOURCE_DATE_EPOCH" +%Y%m%d).$(git rev-parse --short=8 HEAD)
fi
maintainer=maintainers@angiopose.example
build_depends=$(awk '/^\[/ {inside = ($0 == "[build]" || $0 == "[package]")}
    inside && NF && !/^[#[]/ && $1 !~ /^(build-essential|debhelper|lintian|debootstrap|patchelf|file|fakeroot)$/ {printf "%s%s", separator, $1; separator = ", "}' "$here/packages.txt")
sed -e "s/@MAINTAINER@/$maintainer/; s/@SOVERSION@/$soversion/; s/@BUILD_DEPENDS@/$build_depends/" \
    "$tree/debian/control.in" >"$tree/debian/control"
sed -i "s/@SOVERSION@/$soversion/" "$tree/debian/rules"
rm "$tree/debian/control.in"
cat >"$tree/debian/changelog" <<END
angiopose ($version-1) bookworm; urgency=medium

  * What changed is in /usr/share/doc/angiopose/changelog.gz.

 -- AngioPose maintainers <$maintainer>  $(LC_ALL=C date -u -R -d "@$SOURCE_DATE_EPOCH")
END

# Whoever lent the folder gets it back as it was.
give_back() {
    mv "$out/lent-cache" "$ANGIOPOSE_BUILD/CMakeCache.txt"
    cmake "$ANGIOPOSE_BUILD" >/dev/null 2>&1
}
if [ -n "${ANGIOPOSE_BUILD:-}" ]; then
    cp "$ANGIOPOSE_BUILD/CMakeCache.txt" "$out/lent-cache"
    trap give_back EXIT
fi

cd "$tree"
export SOURCE_DATE_EPOCH LC_ALL=C.UTF-8 TZ=UTC
umask 022
dpkg-buildpackage -b -us -uc -nc
cd "$out"
[ -n "${ANGIOPOSE_KEEP_SOURCE:-}" ] || rm -rf "$tree"
sha256sum ./*.deb
