#!/usr/bin/env bash
# Builds the manual as a site that needs no network: pages of resources/manual, the window's help, the command line's own
# words, the documents and the public headers, put together by MkDocs.
# Usage: build_manual.sh [BUILD] [OUTPUT]: folder of a build (default build/release), and where the site goes (default
# build/manual/site)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
cd "$root"
build=${1:-build/release}
output=$(realpath -m "${2:-build/manual/site}")
program=$build/app/angiopose-cli
[ -x "$program" ] || { echo "build_manual.sh: no $program. Build first: packaging/test.sh, or name the folder of a build." >&2; exit 3; }
command -v mkdocs >/dev/null || { echo "build_manual.sh: mkdocs is missing: packaging/install_packages.sh test" >&2; exit 3; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
docs=$work/docs
mkdir -p "$docs"
cp resources/manual/mkdocs.yml "$work/"
cp resources/manual/*.md resources/manual/*.svg "$docs/"
cp resources/screenshot.png "$docs/"
"$program" description markdown >"$docs/commands.md"

# The overlay of the tutorial, by the program itself.
"$program" simulate --seed 7 --branches 9 --output "$work/demo" >/dev/null
"$program" register "$work/demo/case.angiopose" --output "$work/result" >/dev/null
"$program" convert "$work/result/overlay.png" "$docs/overlay.png" --deidentify >/dev/null 2>&1   # without the time in its texts
python3 "$here/manual_reference.py" cpp app/library/include/angiopose/*.h >"$docs/cpp.md"
python3 "$here/manual_reference.py" python app/python/angiopose/__init__.pyi >"$docs/python.md"

cp resources/slicer/README.md "$docs/slicer.md"

# The window's help, page after page, each heading a step lower.
lower() { sed 's/^#/##/' "$1"; echo; }
{
    printf '# The window\n\nThe same texts as F1 shows beside the part that the mouse points at.\n\n'
    lower resources/help/panels/overview.md
    for page in resources/help/panels/*.md; do
        [ "$page" = resources/help/panels/overview.md ] || lower "$page"
    done
} >"$docs/window.md"
{
    printf '# Methods\n\nThe same texts as the window shows beside a method.\n\n'
    for page in resources/help/methods/*.md; do lower "$page"; done
} >"$docs/methods.md"

# The documents; what they point to in the source has no page here.
for page in resources/docs/{FORMATS,ALGORITHMS,BENCHMARKS,LIBRARY}.md KNOWN_ISSUES.md CHANGELOG.md; do
    sed -E 's#\]\(resources/docs/(FORMATS|ALGORITHMS|BENCHMARKS|LIBRARY)\.md#](\1.md#g
        s#\]\((\.\./\.\./)?(KNOWN_ISSUES|CHANGELOG)\.md#](\2.md#g
        s#\[([^]]*)\]\(([^)#h][^)]*/[^)]*|[A-Z_]*DECISIONS\.md[^)]*|ARCHITECTURE\.md[^)]*|[A-Z]+|[A-Z]+\.cff)\)#\1#g' \
        "$page" >"$docs/$(basename "$page")"
done
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH
(cd "$work" && mkdocs build --quiet --strict --site-dir "$output")
# The theme's fonts come twice, and in forms for browsers before 2016.
rm -rf "$output/css/fonts"
find "$output/fonts" -type f ! -name '*.woff2' -delete
echo "$output/index.html"
