#!/usr/bin/env bash
# Makes the pictures of docs/notes/cluster-sampler.md: docs/notes/cluster-pictures/make.sh, after a build.
set -euo pipefail
cd "$(dirname "$0")/../../.."
out=docs/notes/cluster-pictures
run() { java -jar target/enlightenment.jar render "scenes/$1.json" -o "$out/$2.png" --progress none --stats "${@:3}" | grep -E "^(samples per|estimated|time: (plan|render))"; }
# Softer shadows: the shadow of the ice ball on the wall, about the same time.
run fire-and-ice shadow-raytrace --method raytrace --antialias 2 --shadow-samples 1 --crop 20,240,200,100
run fire-and-ice shadow-cluster --method cluster --samples 3.3 --crop 20,240,200,100
# Less graininess: the light through the keyhole, about the same time.
run keyhole keyhole-raytrace --method raytrace --samples 8 --shadow-samples 10
run keyhole keyhole-cluster --method cluster --samples 4.6
# Concentrating on important areas: where the samples went.
run fire-and-ice where --method cluster --samples 8 --aov samples,error
# The pair of the README: the right half of both keyhole pictures, four times as bright. Needs Python with Pillow.
python3 - "$out" <<'P'
import sys
from PIL import Image
folder = sys.argv[1] + "/"
pair = Image.new("RGB", (670, 310), (255, 255, 255))
for i, name in enumerate(("keyhole-raytrace.png", "keyhole-cluster.png")):
    part = Image.open(folder + name).convert("RGB").crop((430, 20, 760, 330))
    pair.paste(part.point(lambda v: min(255, 4 * v)), (340 * i, 0))
pair.save(folder + "keyhole-pair.png")
P
