#!/usr/bin/env bash
# Installs the programs into an empty place and looks at what desktops, shells and users find there.
# Usage: check_installed_program.sh BUILD-FOLDER WORK-FOLDER VERSION
set -u
build=$1 work=$2 version=$3
prefix=$work/usr
faults=0
complain() { echo "$*"; faults=$((faults + 1)); }

rm -rf "$work"
mkdir -p "$work"
cmake --install "$build" --prefix "$prefix" --component runtime >"$work/log" || { cat "$work/log"; exit 1; }
share=$prefix/share

expected="bin/angiopose bin/angiopose-cli libexec/angiopose/angiopose-decode-itk libexec/angiopose/angiopose-decode-vtk
    share/applications/org.angiopose.AngioPose.desktop share/mime/packages/org.angiopose.AngioPose.mime.xml
    share/metainfo/org.angiopose.AngioPose.metainfo.xml share/thumbnailers/org.angiopose.AngioPose.thumbnailer
    bin/angiopose-study share/man/man1/angiopose-study.1 share/man/man1/angiopose.1 share/man/man1/angiopose-cli.1 share/icons/hicolor/scalable/apps/angiopose.svg
    share/bash-completion/completions/angiopose share/bash-completion/completions/angiopose-cli
    share/zsh/vendor-completions/_angiopose share/zsh/vendor-completions/_angiopose-cli
    share/fish/vendor_completions.d/angiopose.fish share/fish/vendor_completions.d/angiopose-cli.fish
    share/angiopose/slicer/README.md share/angiopose/slicer/AngioPose/AngioPose.py
    share/angiopose/slicer/AngioPose/AngioPoseLib/__init__.py share/angiopose/slicer/AngioPose/AngioPoseLib/command_line.py
    share/angiopose/slicer/AngioPoseRegister/AngioPoseRegister.py
    share/angiopose/slicer/AngioPoseRegister/AngioPoseRegister.xml"
for size in 16 22 24 32 36 48 64 72 96 128 192 256 512; do
    icon=share/icons/hicolor/${size}x$size/apps/angiopose.png
    expected="$expected $icon"
    # Width and height stand at byte 16 of a PNG.
    seen=$(od -An -tu1 -j16 -N8 "$prefix/$icon" 2>/dev/null | awk '{print ($3 * 256 + $4) "x" ($7 * 256 + $8)}')
    [ "$seen" = "${size}x$size" ] || complain "$icon is $seen"
done
diff <(printf '%s\n' $expected | sort) <(cd "$prefix" && find . -type f | sed 's|^\./||' | sort) ||
    complain "what is installed (>) is not what is expected (<)"

entry=$share/applications/org.angiopose.AngioPose.desktop
meta=$share/metainfo/org.angiopose.AngioPose.metainfo.xml
thumbnailer=$share/thumbnailers/org.angiopose.AngioPose.thumbnailer
out=$(desktop-file-validate "$entry" 2>&1) && [ -z "$out" ] || complain "desktop-file-validate: $out"
out=$(appstreamcli validate --no-net --no-color "$meta" 2>&1) || complain "appstreamcli: $out"
grep -q "<release version=\"$version\"" "$meta" || complain "the metainfo has no release $version"
update-mime-database "$share/mime" >/dev/null 2>&1 || complain "update-mime-database fails"
type=$(sed -n 's/^[0-9]*:\([^:]*\):\*\.angiopose$/\1/p' "$share/mime/globs2")
for file in "$entry" "$thumbnailer"; do
    grep -q "^MimeType=$type;\$" "$file" || complain "${file##*/} is not for *.angiopose, which is '$type'"
    program=$(sed -n 's/^TryExec=//p' "$file")
    [ -x "$prefix/bin/$program" ] || complain "${file##*/} runs $program, which is not installed"
done
grep -q '^Exec=angiopose %F$' "$entry" || complain "files are not given to the program"

PATH=$prefix/bin:$PATH
for program in angiopose angiopose-cli; do
    env -u DISPLAY -u WAYLAND_DISPLAY "$program" --version | grep -q " $version\$" || complain "$program is of another version"
done

# The thumbnailer's line, as a file manager runs it: a picture of the size asked for, without a word in it, quickly.
angiopose-cli simulate --seed 7 --output "$work/Doe John" >/dev/null || complain "no case is made"
picture="$work/thumb nail.png"
line=$(sed -n 's/^Exec=//p' "$thumbnailer" | sed 's|%s|128|; s|%i|"$case"|; s|%o|"$picture"|')
case="$work/Doe John/case.angiopose" picture=$picture timeout 10 bash -c "$line" || complain "the thumbnailer fails: $line"
[ "$(od -An -tu1 -j18 -N2 "$picture" | tr -d ' ')" = 0128 ] || complain "the thumbnail has another width"
[ "$(head -c 8 "$picture" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || complain "the thumbnail is no PNG"
! grep -aqE 'tEXt|iTXt|zTXt|eXIf|Doe' "$picture" || complain "the thumbnail holds words"
timeout 10 angiopose-cli thumbnail --limit 0 "$work/Doe John/case.angiopose" "$work/none.png" 2>/dev/null &&
    complain "a thumbnail without time is made"
[ ! -e "$work/none.png" ] || complain "a thumbnail without time is left"
exit $((faults > 0))
