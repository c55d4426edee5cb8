#!/usr/bin/env bash
# Renders the pictures of the gallery, after a build: docs/gallery/make.sh for all, docs/gallery/make.sh NAME... for those of these names.
# SAMPLES=N in the environment takes N samples per pixel for each of the large ones. SCENES=FOLDER has scenes by others, as downloaded, in folders of theirs.
set -euo pipefail
cd "$(dirname "$0")/../.."
wanted=" $* "
render() { java -jar target/enlightenment.jar render "$@" --progress none; }
is_wanted() { [[ "$wanted" == "  " || "$wanted" == *" $1 "* ]]; }

# clean NAME SCENE METHOD SAMPLES [OPTION...]: the picture without grain is kept; its figures are in the report of the picture as rendered.
clean() {
    is_wanted "$1" || return 0
    render "$2" -o "target/$1-rendered.png" --denoised "docs/gallery/$1.png" --method "$3" --samples "${SAMPLES:-$4}" --report "target/$1-report.json" "${@:5}"
}
# exact NAME SCENE [OPTION...]: the picture as rendered.
exact() {
    is_wanted "$1" || return 0
    render "$2" -o "docs/gallery/$1.png" --report "target/$1-report.json" "${@:3}"
}
# small NAME [OPTION...]: the scene of this name.
small() { exact "$1" "scenes/$1.json" "${@:2}"; }

# Methods are chosen by `auto`, or by trial.
clean watchmaker scenes/watchmaker.json raytrace 96
clean dandelions scenes/dandelions.json cluster 20
clean copper scenes/copper.json raytrace 64
clean breakfast scenes/breakfast.json raytrace 32
clean lanterns scenes/lanterns.json raytrace 96
clean chess scenes/chess.json raytrace 48 --frame 3
clean glass-and-prism scenes/glass-and-prism.json raytrace 96
clean candle scenes/candle.json raytrace 24
clean serpents scenes/serpents.json raytrace 24
clean terrace scenes/terrace.json raytrace 32
clean shapes scenes/shapes.json cluster 48
clean minerals scenes/minerals.json cluster 32
exact panorama scenes/panorama.json --method cluster --samples 64
exact fire-and-ice scenes/fire-and-ice.json --size 1280x640 --antialias 8 --shadow-samples 64
exact fire-and-ice-physical scenes/fire-and-ice-physical.json --size 1280x640 --method cluster --error 0.003
# A part of a picture of 2560 x 1440 pixels, with the ship in its middle.
if [ -d "${SCENES:-}" ]; then
    clean spaceship "$SCENES/spaceship/scene.xml" raytrace 48 --exposure 1.1 --size 2560x1440 --crop 600,260,1280,720
    clean ajar "$SCENES/veach-ajar/scene.xml" cluster 200 --exposure -0.6 --size 1280x720
fi

film() {
    is_wanted "$1" || return 0
    local frames
    frames=$(mktemp -d)
    java -jar target/enlightenment.jar animate "$2" -o "$frames/%04d.png" --progress none --video "docs/gallery/$1.gif" "${@:3}"
    rm -r "$frames"
}
film bounce scenes/bounce.json --size 640x320 --antialias 8
film film scenes/fire-and-ice-tween.json --size 160x80 --antialias 3 --shadow-samples 4

exact blur scenes/bounce.json --frame 5 --size 400x200 --antialias 6
small primitives --size 400x225 --antialias 6
small glass --size 400x200 --antialias 6
small torus --size 400x225 --antialias 6
small cylinders --size 400x200
small cone --size 400x200
small cube --size 212x300
small cornell-box --size 300x300 --samples 128 --method cluster
small caustics --size 400x267 --samples 256
small sky --size 400x267 --samples 200 --method cluster
small prism --size 400x267 --samples 1024
small fluorescent-poster --size 400x200 --samples 256
small wax --size 400x267 --method light --samples 1000
small milk-and-glass --size 400x267 --samples 256
small fog --size 400x267 --samples 256
for scene in metals glass-physical lamp-room; do
    small "$scene" --size 400x200 --samples 128
done
# The same times for each method, with two threads: ten minutes.
for method in raytrace light bidirectional cluster bidirectional-cluster; do
    for seconds in 1 10 100; do
        exact "door-ajar-$method-$seconds" scenes/door-ajar.json --size 240x160 --method "$method" --time "$seconds" --threads 2
    done
done
