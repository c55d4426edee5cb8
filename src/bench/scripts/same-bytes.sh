#!/bin/sh
# Proves that a picture does not depend on the Java that renders it: renders scenes with two Javas, with the optimising
# compiler, interpreted only, and without fused multiply-add instructions, and compares the files byte by byte.
#
#   mvn -q -B -DskipTests package
#   src/bench/scripts/same-bytes.sh JAVA17 JAVA_LTS [FOLDER]
#
# JAVA17, JAVA_LTS   paths of two `java` executables: the oldest that is supported, and the newest with long-term support
# FOLDER             where the pictures go; default: target/same-bytes
#
# Ends with 1 if any two pictures differ, with 2 if something cannot be run.
set -eu

usage() {
    sed -n '5,9s/^# \{0,1\}//p' "$0" >&2
    exit 2
}

[ $# -ge 2 ] && [ $# -le 3 ] || usage
old=$1
new=$2
root=$(cd "$(dirname "$0")/../../.." && pwd)
out=${3:-$root/target/same-bytes}
jar=$root/target/enlightenment.jar
for java in "$old" "$new"; do
    "$java" -version >/dev/null 2>&1 || { echo "same-bytes: cannot run $java" >&2; exit 2; }
done
[ -f "$jar" ] || { echo "same-bytes: $jar is missing; run: mvn -q -B -DskipTests package" >&2; exit 2; }
mkdir -p "$out"
rm -f "$out"/*.pfm "$out"/*.png

version() {
    "$1" -version 2>&1 | sed -n '1s/.*"\(.*\)".*/\1/p'
}

failed=0

# render NAME JAVA SCENE SIZE [JVM OPTION...]: NAME.pfm (exact floats) and NAME.png (16 bits)
render() {
    name=$1
    java=$2
    scene=$3
    size=$4
    shift 4
    for kind in pfm png; do
        depth=
        [ $kind = pfm ] || depth='--depth 16'
        # shellcheck disable=SC2086 # the option and its value are two words
        "$java" "$@" -jar "$jar" render "$root/scenes/$scene.json" -o "$out/$name.$kind" $depth \
            --size "$size" --antialias 2 --shadow-samples 9 --progress none ||
            { echo "same-bytes: cannot render $scene with $java $*" >&2; exit 2; }
    done
}

# compare WHAT A B: one row of the table
compare() {
    result=same
    for kind in pfm png; do
        cmp -s "$out/$2.$kind" "$out/$3.$kind" || result=DIFFERENT
    done
    [ $result = same ] || failed=1
    printf '%-16s %-9s %-44s %s\n' "$scene" "$size" "$1" "$result"
}

old_version=$(version "$old")
new_version=$(version "$new")
printf '%-16s %-9s %-44s %s\n' scene size compared bytes
for scene_size in fire-and-ice:800x400 primitives:800x450 glass:800x400 torus:800x450; do
    scene=${scene_size%%:*}
    # The same picture at three sizes: large for compiled code, smaller the slower the JVM is made.
    for width in 800 200 48; do
        size=$width"x$((width * ${scene_size##*x} / 800))"
        base=$scene-$width
        render "$base-old" "$old" "$scene" "$size"
        render "$base-new" "$new" "$scene" "$size"
        compare "$old_version = $new_version" "$base-old" "$base-new"
        case $width in
        200) slow=-Xint ;;
        48) slow=-XX:-UseFMA ;;
        *) continue ;;
        esac
        render "$base-old-slow" "$old" "$scene" "$size" $slow
        render "$base-new-slow" "$new" "$scene" "$size" $slow
        compare "$old_version: default = $slow" "$base-old" "$base-old-slow"
        compare "$new_version: default = $slow" "$base-new" "$base-new-slow"
    done
done
exit $failed
