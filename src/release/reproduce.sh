#!/bin/sh
# Builds what is committed twice, apart in place, time zone and language, and compares all artifacts byte for byte.
#
#   src/release/reproduce.sh [OPTIONS OF MAVEN]
#
# Needs git, a JDK 17 or newer and Maven with a network, for the bill of materials. Ends with 0 if both builds are equal, with 1 if not or if one failed.
set -eu
cd "$(dirname "$0")/../.."

commit=$(git rev-parse HEAD)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

# Archives hold the permissions of the files that go into them.
umask 022

# build FOLDER TIME_ZONE LOCALE [OPTIONS]
build() {
    folder=$work/$1 sums=$work/$1.sums zone=$2 locale=$3
    shift 3
    mkdir -p "$folder"
    git archive "$commit" | tar -x --no-same-permissions -C "$folder"
    # A release is not made here: nothing is signed, and addresses may be missing.
    (cd "$folder" && TZ=$zone LC_ALL=$locale mvn -B -q -Prelease -DskipTests -Dspotless.check.skip -Dgpg.skip -Denforcer.skip "$@" verify)
    (cd "$folder/target" && find . -maxdepth 1 -type f \( -name '*.jar' -o -name '*.zip' -o -name '*.json' \) ! -name 'original-*' |
        LC_ALL=C sort | while read -r file; do sha256sum "$file"; done) > "$sums"
    # Maven leaves the bill out without a word where it is offline.
    for made in .jar -app.zip -sources.jar -javadoc.jar bom.json; do
        grep -q -F -e "$made" "$sums" || { echo "reproduce.sh: a build made no *$made; is Maven online?" >&2; exit 1; }
    done
}

build one UTC C "$@"
build elsewhere/another Pacific/Auckland C.UTF-8 "$@"
cat "$work/one.sums"
if cmp -s "$work/one.sums" "$work/elsewhere/another.sums"; then
    echo "both builds are equal, byte for byte"
else
    echo "reproduce.sh: the builds differ:" >&2
    diff "$work/one.sums" "$work/elsewhere/another.sums" >&2 || true
    exit 1
fi
