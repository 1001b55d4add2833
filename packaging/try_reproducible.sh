#!/usr/bin/env bash
# Builds the Debian packages of the last commit twice from nothing, in two folders of different names, with different time
# zones, umasks, homes and users' names, and compares them byte by byte. Takes twice the time of a build.
# Usage: try_reproducible.sh [FOLDER]: where the two trees are made (default a new one in TMPDIR)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
folder=${1:-$(mktemp -d "${TMPDIR:-/tmp}/angiopose-twice-XXXXXX")}
mkdir -p "$folder"
commit=$(git -C "$root" rev-parse HEAD)   # of both, whatever is committed meanwhile

# Builds in $1 with the time zone $2, the umask $3 and the user's name $4.
build_once() {
    rm -rf "$1"
    git clone -q "$root" "$1"
    git -C "$1" checkout -q "$commit"
    mkdir -p "$1-home"
    (cd "$1" && umask "$3" && TZ=$2 HOME=$1-home USER=$4 LOGNAME=$4 packaging/build_packages.sh) >"$1.log" 2>&1 ||
        { tail -30 "$1.log"; echo "try_reproducible.sh: no packages; all of it in $1.log" >&2; exit 1; }
}

build_once "$folder/first" Europe/Berlin 022 anna
build_once "$folder/a-second-one-elsewhere" Pacific/Auckland 077 bert
different=0
for package in "$folder"/first/build/packages/*.deb; do
    name=${package##*/}
    if cmp -s "$package" "$folder/a-second-one-elsewhere/build/packages/$name"; then
        echo "the same bytes  $(sha256sum <"$package" | cut -c1-16)  $name"
    else
        echo "DIFFERENT       $name"
        different=1
    fi
done
exit "$different"
