#!/usr/bin/env bash
# Measures the trade of speed against accuracy of the shipped scenes: docs/trade/make.sh [SCENE...], after a build.
# BUDGET=seconds for each scene (90). Keeps the page, the charts and the figures; not the reference, which is large.
# At the end docs/trade/summary.csv has a line for each error that both methods were measured at, of all scenes: what may be
# said of them in a sentence (docs/trade.md, "summary.csv").
set -euo pipefail
cd "$(dirname "$0")/../.."
jar=target/enlightenment.jar
[ -f "$jar" ] || { echo "there is no $jar: mvn -q -B -DskipTests package" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [ $# -eq 0 ]; then
  for file in scenes/*.json; do set -- "$@" "$(basename "$file" .json)"; done
fi
for scene in "$@"; do
  # Half the scene's width and height: the page has five pictures in it.
  size=$(java -jar "$jar" inspect "scenes/$scene.json" | sed -nE 's/^size: +([0-9]+)x([0-9]+)$/\1 \2/p')
  read -r width height <<< "$size"
  echo "== $scene, $((width / 2))x$((height / 2))"
  # In a folder of the same name, so that the commands on the page hold.
  java -jar "$jar" trade "scenes/$scene.json" -o "$work/$scene" --size "$((width / 2))x$((height / 2))" \
    --budget "${BUDGET:-90}" --progress plain --sweep shadowSamples=1..64
  mkdir -p "docs/trade/$scene"
  # The page names the folder it was made in: name one that a reader can make.
  sed "s#$work/#out/#g" "$work/$scene/index.html" > "docs/trade/$scene/index.html"
  for file in trade.csv trade.json summary.csv measured.txt settings.txt; do cp "$work/$scene/$file" "docs/trade/$scene/"; done
  cp "$work/$scene"/*.svg "docs/trade/$scene/"
  cp "$work/$scene"/error-over-time.png "docs/trade/$scene/"
done
{
  head -n 1 "docs/trade/$1/summary.csv" | sed 's/^/scene,/'
  for file in docs/trade/*/summary.csv; do
    sed "1d; s/^/$(basename "$(dirname "$file")"),/" "$file"
  done
} > docs/trade/summary.csv
# scene, error, light points (the scene's own or the best of several), how many times as long the first takes, both sides
cut -d, -f1-6,7,12,13,14,20 docs/trade/summary.csv
