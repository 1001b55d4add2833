#!/bin/sh
# Starts the program of this name from the tree that this file is in: with its own fonts and DICOM dictionary, and with
# its own copies of GL and X libraries where the system has none, which is enough for the command line.
self=$(readlink -f -- "$0")
name=${self##*/}
root=${self%/*/*}
export DCMDICTPATH="${DCMDICTPATH:-$root/share/dcmtk/dicom.dic:$root/share/dcmtk/private.dic}"
export FONTCONFIG_FILE="${FONTCONFIG_FILE:-$root/etc/fonts.conf}"

is_there() {
    for folder in /usr/lib/x86_64-linux-gnu /lib/x86_64-linux-gnu /usr/lib64 /lib64 /usr/lib /lib; do
        if [ -e "$folder/$1" ]; then return 0; fi
    done
    return 1
}
for library in libGL.so.1 libGLX.so.0 libOpenGL.so.0 libEGL.so.1 libX11.so.6 libX11-xcb.so.1 libxcb.so.1 libstdc++.so.6; do
    if ! is_there "$library"; then
        export LD_LIBRARY_PATH="${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$root/lib/fallback"
        break
    fi
done
# Without any driver Qt would end the program where it asks for OpenGL; the processor draws then.
if ! is_there libGL.so.1; then
    export QT_XCB_GL_INTEGRATION="${QT_XCB_GL_INTEGRATION:-none}"
fi
exec "$root/lib/angiopose/$name" "$@"
