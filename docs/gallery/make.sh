#!/usr/bin/env bash
# Renders the pictures of the gallery, after a build: docs/gallery/make.sh for all, docs/gallery/make.sh NAME... for large ones by name.
set -euo pipefail
cd "$(dirname "$0")/../.."

# Samples per pixel of the large pictures, some hours of one processor for all; SAMPLES=N in the environment takes N for each of them.
declare -A samples=([watchmaker]=96 [breakfast]=256 [glass-and-prism]=512 [minerals]=32 [terrace]=32 [dandelions]=96 [serpents]=24
    [chess]=48 [lanterns]=96 [shapes]=48 [candle]=512 [panorama]=256)
# Chosen by `auto`, or by trial.
declare -A method=([watchmaker]=raytrace [lanterns]=raytrace [chess]=raytrace [shapes]=cluster [serpents]=raytrace [terrace]=raytrace [minerals]=cluster)
declare -A frame=([chess]="--frame 3")
# The picture without grain is kept; its figures are in the report of the picture as rendered.
large() {
    java -jar target/enlightenment.jar render "scenes/$1.json" -o "target/$1-rendered.png" --denoised "docs/gallery/$1.png" \
        --method "${method[$1]:-raytrace}" --samples "${SAMPLES:-${samples[$1]}}" --report "target/$1-report.json" --progress none ${frame[$1]:-}
}
if [ $# -gt 0 ]; then
    for scene in "$@"; do large "$scene"; done
    exit
fi
for scene in "${!samples[@]}"; do large "$scene"; done

run() { java -jar target/enlightenment.jar render "scenes/$1.json" -o "docs/gallery/$2.png" --progress none "${@:3}"; }
run fire-and-ice fire-and-ice --antialias 6 --shadow-samples 32
run bounce blur --frame 5 --size 400x200 --antialias 6
frames=$(mktemp -d)
java -jar target/enlightenment.jar animate scenes/fire-and-ice-tween.json -o "$frames/%04d.png" --size 160x80 --antialias 3 \
    --shadow-samples 4 --progress none --video docs/gallery/film.gif
rm -r "$frames"
run primitives primitives --size 400x225 --antialias 6
run glass glass --size 400x200 --antialias 6
run torus torus --size 400x225 --antialias 6
run cylinders cylinders --size 400x200
run cone cone --size 400x200
run cube cube --size 212x300
run cornell-box cornell-box --size 300x300 --samples 128 --method cluster
run caustics caustics --size 400x267 --samples 256
run sky sky --size 400x267 --samples 200 --method cluster
run prism prism --size 400x267 --samples 1024
run fluorescent-poster fluorescent-poster --size 400x200 --samples 256
run wax wax --size 400x267 --method light --samples 1000
run milk-and-glass milk-and-glass --size 400x267 --samples 256
run fog fog --size 400x267 --samples 256
for scene in metals glass-physical lamp-room fire-and-ice-physical; do
    run "$scene" "$scene" --size 400x200 --samples 128
done
# The same time for each, with two threads.
for method in raytrace bidirectional metropolis; do
    run door-ajar "door-ajar-$method" --size 240x160 --method "$method" --time 18 --threads 2
done
