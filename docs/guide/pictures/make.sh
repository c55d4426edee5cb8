#!/usr/bin/env bash
# Renders the pictures of the guide: docs/guide/pictures/make.sh, after a build.
set -euo pipefail
cd "$(dirname "$0")/../../.."
here=docs/guide/pictures
render() { java -jar target/enlightenment.jar render "$1" -o "$here/$2.png" --progress none "${@:3}"; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
java -jar target/enlightenment.jar new "$work/first" > "$work/said"
render "$work/first.json" first --size 640x360 --method cluster --samples 64
render "$here/example.json" example --method cluster --samples 64
render "$here/lens.json" lens --size 480x270 --samples 128
render "$here/swatches.json" swatches --samples 128
render "$here/panorama.json" panorama --size 400x200 --samples 64 --method cluster
# The same picture with few samples, and by an error that is asked for.
render "$here/example.json" grainy --size 240x135 --samples 2
render "$here/example.json" smooth --size 240x135 --error 0.01
