#!/usr/bin/env bash
# Builds build/packages/angiopose-VERSION-linux-x86_64.tar.xz: the programs with their libraries, for machines without root.
# Usage: build_archive.sh [--use FOLDER]
#   --use FOLDER   takes what is built in FOLDER; otherwise build/release is configured and built
# glibc and OpenGL stay the system's. What else the programs load comes from this machine's Debian packages; one library
# finds the other beside itself ($ORIGIN). The same packages and the same build give the same bytes.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
cd "$root"
"$here/install_packages.sh" build package
build=$root/build/release
case ${1:-} in
    '')
        [ -f build/release/build.ninja ] || cmake --preset release -DBUILD_TESTING=OFF >/dev/null
        cmake --build build/release --target angiopose angiopose-cli installed_extras
        ;;
    --use) build=$(cd "${2:?folder of a build}" && pwd) ;;
    *) sed -n '2,/^set /s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2 && exit 2 ;;
esac

version=$(sed -n 's/^project(AngioPose VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
name=angiopose-$version-linux-$(uname -m)
out=$root/build/packages
tree=$out/$name
system=/usr/lib/$(gcc -print-multiarch)
umask 022
rm -rf "$tree" "$out/$name.tar.xz"
mkdir -p "$tree"/{bin,etc,lib/angiopose,lib/fallback,lib/qt6/plugins,licenses,share/fonts,share/dcmtk,share/qt6/translations}

# The programs, which launchers of their names start.
cmake --install "$build" --prefix "$tree" --component runtime >/dev/null
mv "$tree"/bin/angiopose "$tree"/bin/angiopose-cli "$tree/lib/angiopose/"
for program in angiopose angiopose-cli; do
    install -m 755 "$here/archive/launch.sh" "$tree/bin/$program"
done
find "$tree/lib/angiopose" "$tree/libexec" -type f -exec strip --strip-unneeded {} +
cp "$here/archive/qt.conf" "$tree/lib/angiopose/"
cp "$here/archive/fonts.conf" "$tree/etc/"
install -m 755 "$here/archive/integrate" "$tree/"
sed "s/@VERSION@/$version/" "$here/archive/README.txt" >"$tree/README.txt"
cp LICENSE THIRD_PARTY_NOTICES.md "$tree/"

# What they load while running without being linked to it.
: >"$out/foreign"   # files of packages, for the licences
take() {   # TARGET-FOLDER FILE…
    local folder=$1
    shift
    mkdir -p "$folder"
    for file in "$@"; do
        cp -L "$file" "$folder/"
        readlink -f "$file" >>"$out/foreign"
    done
}
for plugin in platforms/libqxcb platforms/libqoffscreen platforms/libqminimal xcbglintegrations/libqxcb-glx-integration \
    xcbglintegrations/libqxcb-egl-integration imageformats/libqsvg iconengines/libqsvgicon \
    platforminputcontexts/libcomposeplatforminputcontextplugin platforminputcontexts/libibusplatforminputcontextplugin; do
    take "$tree/lib/qt6/plugins/${plugin%/*}" "$system/qt6/plugins/$plugin.so"
done
take "$tree/share/qt6/translations" /usr/share/qt6/translations/qtbase_{de,zh_CN}.qm
take "$tree/share/dcmtk" "$(echo /usr/share/libdcmtk*/dicom.dic)" "$(echo /usr/share/libdcmtk*/private.dic)"
take "$tree/share/fonts" /usr/share/fonts/opentype/inter/Inter-{Regular,Medium,SemiBold,Bold}.otf \
    /usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc

# glibc stays the system's; GL, X and the compiler's library too wherever it has them (see launch.sh).
is_glibc() { [[ $1 =~ ^(ld-linux.*\.so|lib(c|m|dl|rt|pthread|resolv|util|anl|mvec)\.so|libnsl\.so\.1) ]]; }
is_fallback() { [[ $1 =~ ^lib(GL|GLX|EGL|OpenGL|GLdispatch|GLU|X11|X11-xcb|xcb|Xau|Xdmcp|bsd|md|drm|gbm|wayland-.*|stdc\+\+|gcc_s)\.so ]]; }
find "$tree/lib/angiopose" "$tree/libexec" "$tree/lib/qt6" -type f ! -name qt.conf -exec ldd {} + |
    awk '$2 == "=>" && $3 ~ /^\// {print $3}' | sort -u >"$out/linked"
while read -r library; do
    soname=${library##*/}
    if is_glibc "$soname"; then
        continue
    elif is_fallback "$soname"; then
        take "$tree/lib/fallback" "$library"
    else
        take "$tree/lib" "$library"
    fi
done <"$out/linked"

# One finds the other beside itself, whatever LD_LIBRARY_PATH says.
rpath() {   # RPATH FILE…
    local path=$1
    shift
    chmod u+w "$@"
    for file in "$@"; do patchelf --force-rpath --set-rpath "$path" "$file"; done
}
rpath '$ORIGIN/..' "$tree"/lib/angiopose/angiopose*
rpath '$ORIGIN/../../lib' "$tree"/libexec/angiopose/*
rpath '$ORIGIN' "$tree"/lib/*.so*
rpath '$ORIGIN:$ORIGIN/..' "$tree"/lib/fallback/*.so*
rpath '$ORIGIN/../../..' "$tree"/lib/qt6/plugins/*/*.so

# The licences of what came along, and where its sources are.
# dpkg knows some files of /usr/lib by the name below /lib that they were shipped under.
sort -u "$out/foreign" | sed 'p; s|^/usr/lib/|/lib/|' | { xargs dpkg -S 2>/dev/null || true; } |
    sed 's/[:,].*//' | sort -u >"$out/foreign-packages"
while read -r package; do
    cp -L "/usr/share/doc/$package/copyright" "$tree/licenses/$package"
    dpkg-query -W -f '${source:Package} ${source:Version} (${binary:Package})\n' "$package"
done <"$out/foreign-packages" | sort -u >"$tree/licenses/PACKAGES"
rm "$out/foreign" "$out/linked" "$out/foreign-packages"

epoch=$(git log -1 --format=%ct)
chmod -R u=rwX,go=rX "$tree"
tar -C "$out" --sort=name --format=gnu --mtime="@$epoch" --owner=0 --group=0 --numeric-owner -cf - "$name" |
    xz -T2 --block-size=24MiB >"$out/$name.tar.xz"
du -sh "$tree" "$out/$name.tar.xz"
sha256sum "$out/$name.tar.xz"
