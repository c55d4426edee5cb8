#!/usr/bin/env bash
# Measures speed against accuracy for the shipped scenes: docs/notes/trade/make.sh [SCENE...], after a build.
# BUDGET=seconds for each scene (45 for each method, at least 90). METHODS=raytrace,cluster: only these (all that can render the scene).
# With --evaluate as the first argument nothing is measured: pages, charts and tables are made again from the runs kept here.
#
# The repository keeps what the rest is made from: runs (trade.csv), figures of the reference (measured.txt),
# settings, summary, and the chart of error over time. The page index.html and all other charts and tables lie beside them,
# ignored by git; references and pictures are not kept.
# At the end docs/notes/trade/summary.csv has a line for each method and error that several methods were measured at (docs/guide/trade.md, "summary.csv").
set -euo pipefail
cd "$(dirname "$0")/../../.."
jar=target/enlightenment.jar
[ -f "$jar" ] || { echo "there is no $jar: mvn -q -B -DskipTests package" >&2; exit 1; }
evaluate=
if [ "${1:-}" = --evaluate ]; then
  evaluate=yes
  shift
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [ $# -eq 0 ]; then
  for file in scenes/*.json; do
    name=$(basename "$file" .json)
    # Evaluated is what was measured.
    if [ -z "$evaluate" ] || [ -f "docs/notes/trade/$name/trade.csv" ]; then set -- "$@" "$name"; fi
  done
fi
for scene in "$@"; do
  kept="docs/notes/trade/$scene"
  # Half the scene's width and height: the page has five pictures in it.
  size=$(java -jar "$jar" inspect "scenes/$scene.json" | sed -nE 's/^size: +([0-9]+)x([0-9]+)$/\1 \2/p')
  read -r width height <<< "$size"
  # In a folder of the same name, so that the commands on the page hold.
  folder="$work/$scene"
  mkdir -p "$folder" "$kept"
  options=(--size "$((width / 2))x$((height / 2))")
  # With physical shading there are no light samples to choose.
  grep -q '"model": *"physical"' "scenes/$scene.json" || options+=(--sweep shadowSamples=1..64)
  if [ -n "$evaluate" ]; then
    [ -f "$kept/trade.csv" ] || { echo "$kept holds no measurement" >&2; exit 1; }
    for file in trade.csv measured.txt settings.txt; do
      if [ -f "$kept/$file" ]; then cp "$kept/$file" "$folder/"; fi
    done
    # The number of threads is the fifth column of the runs.
    options+=(--threads "$(sed -n 2p "$kept/trade.csv" | cut -d, -f5)" --evaluate)
    # The methods are in the second column, in the order in which they began.
    options+=(--methods "$(sed 1d "$kept/trade.csv" | cut -d, -f2 | awk '!seen[$0]++' | paste -sd,)")
  else
    options+=(--progress plain)
    if [ -n "${BUDGET:-}" ]; then options+=(--budget "$BUDGET"); fi
    if [ -n "${METHODS:-}" ]; then options+=(--methods "$METHODS"); fi
  fi
  echo "== $scene, $((width / 2))x$((height / 2))"
  java -jar "$jar" trade "scenes/$scene.json" -o "$folder" "${options[@]}"
  # The page names the folder it was made in: name one that a reader can make.
  sed "s#$work/#out/#g" "$folder/index.html" > "$kept/index.html"
  cp "$folder"/*.svg "$folder"/*.csv "$folder/trade.json" "$folder/measured.txt" "$kept/"
  if [ -f "$folder/settings.txt" ]; then cp "$folder/settings.txt" "$kept/"; fi
done
{
  head -n 1 "docs/notes/trade/$1/summary.csv" | sed 's/^/scene,/'
  for file in docs/notes/trade/*/summary.csv; do
    sed "1d; s/^/$(basename "$(dirname "$file")"),/" "$file"
  done
} > docs/notes/trade/summary.csv
# scene, error, light samples (the scene's own or the best of several), method, times as long as the fastest, light samples, seconds, how known
cut -d, -f1,2,4-7,9,13 docs/notes/trade/summary.csv
