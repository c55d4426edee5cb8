#!/usr/bin/env bash
# Makes the pictures of docs/cluster-sampler.md: docs/cluster-pictures/make.sh, after a build.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=docs/cluster-pictures
run() { java -jar target/enlightenment.jar render "scenes/$1.json" -o "$out/$2.png" --progress none --stats "${@:3}" | grep -E "^(samples per|estimated|time: (plan|render))"; }
# Softer shadows: the shadow of the ice ball on the wall, about the same time.
run fire-and-ice shadow-raytrace --method raytrace --antialias 2 --shadow-samples 1 --crop 20,240,200,100
run fire-and-ice shadow-cluster --method cluster --samples 3.3 --crop 20,240,200,100
# Less graininess: the light through the keyhole, about the same time.
run keyhole keyhole-raytrace --method raytrace --antialias 2 --shadow-samples 10
run keyhole keyhole-cluster --method cluster --samples 3.2
# Concentrating on important areas: where the samples went.
run fire-and-ice where --method cluster --samples 8 --aov samples,error
