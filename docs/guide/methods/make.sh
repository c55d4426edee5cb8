#!/usr/bin/env bash
# Makes the pictures and figures of docs/guide/methods.md: docs/guide/methods/make.sh [SCENE...], after a build.
# Each method renders each scene in the same time (TIME=10 seconds by the clock) with two threads; a long render with another seed
# (REFERENCE=200 seconds) is taken for the truth. About 15 minutes; on a busy machine all pictures get noisier alike, and the comparison holds.
#
# The repository keeps a picture for each scene and method, docs/guide/methods/SCENE-METHOD.png, and the figures, docs/guide/methods/figures.csv and .md:
# the page takes the table from the latter, by hand. References are not kept.
set -euo pipefail
cd "$(dirname "$0")/../../.."
jar=target/enlightenment.jar
[ -f "$jar" ] || { echo "there is no $jar: mvn -q -B -DskipTests package" >&2; exit 1; }
out=docs/guide/methods
methods=(raytrace cluster light bidirectional metropolis)
seconds=${TIME:-10}
long=${REFERENCE:-200}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ $# -gt 0 ] || set -- cornell-box caustics door-ajar
declare -A size=([cornell-box]=160x160 [caustics]=240x160 [door-ajar]=240x160)
# Whatever finds the light of a scene best makes its reference; where a method is biased, the check by another one shows it.
declare -A truth=([cornell-box]=cluster [caustics]=raytrace [door-ajar]=bidirectional)
declare -A check=([cornell-box]=raytrace [caustics]=bidirectional [door-ajar]=raytrace)
render() { # scene, method, seed, seconds, bits, file without extension
  java -jar "$jar" render "scenes/$1.json" --size "${size[$1]:-240x160}" --method "$2" --seed "$3" --time "$4" --threads 2 \
    --depth "$5" -o "$6.png" --report "$6.json" --progress none
}
# A number of a JSON file.
number() { sed -nE "s/.*\"$1\": ([-0-9.eE+]+),?\$/\1/p" "$2" | head -n 1; }
# Of a picture of eight bits: their rounding, (1/255)²/12, is not the method's error. References have sixteen.
rmse() {
  java -jar "$jar" compare "$1" "$2" --json > "$work/compare.json"
  awk -v e="$(number rmse "$work/compare.json")" 'BEGIN { v = e * e - 1 / (12 * 255 * 255); printf "%.6g", sqrt(v > 0 ? v : 0) }'
}

head="scene,method,samplesPerPixel,seconds,rmse,squaredErrorOfRaytraceByIts"
[ -f "$out/figures.csv" ] || echo "$head" > "$out/figures.csv"
for scene in "$@"; do
  best=${truth[$scene]:-raytrace}
  other=${check[$scene]:-bidirectional}
  echo "== $scene: reference by $best"
  render "$scene" "$best" 1000003 "$long" 16 "$work/$scene"
  render "$scene" "$other" 2000003 "$long" 8 "$work/$scene-check"
  : > "$work/lines.csv"
  base=
  for method in "${methods[@]}"; do
    render "$scene" "$method" 1 "$seconds" 8 "$work/$scene-$method"
    error=$(rmse "$work/$scene-$method.png" "$work/$scene.png")
    [ -n "$base" ] || base=$error
    ratio=$(awk -v a="$base" -v b="$error" 'BEGIN { printf "%.3g", a * a / (b * b) }')
    samples=$(number samplesPerPixel "$work/$scene-$method.json")
    # Of all phases, from the scene in memory to the finished picture.
    took=$(sed -nE 's/.*"wallSeconds": ([-0-9.eE+]+),?$/\1/p' "$work/$scene-$method.json" | awk '{ s += $1 } END { printf "%.2f", s }')
    echo "$scene,$method,$samples,$took,$error,$ratio" | tee -a "$work/lines.csv"
    cp "$work/$scene-$method.png" "$out/"
  done
  echo "$scene,reference by $best,$(number samplesPerPixel "$work/$scene.json"),,," >> "$work/lines.csv"
  echo "$scene,check of the reference by $other,,,$(rmse "$work/$scene-check.png" "$work/$scene.png")," >> "$work/lines.csv"
  # This scene's lines take the place of its old ones.
  { echo "$head"; sed 1d "$out/figures.csv" | awk -F, -v s="$scene" '$1 != s'; cat "$work/lines.csv"; } > "$work/figures.csv"
  mv "$work/figures.csv" "$out/figures.csv"
done
{
  echo "| scene | method | samples per pixel | RMSE, as shown | squared error, times less than \`raytrace\` |"
  echo "|---|---|---|---|---|"
  sed 1d "$out/figures.csv" | awk -F, '{
    printf "| %s | %s | %s | %s | %s |\n", $1 == last ? "" : $1, $2, $3 == "" ? "" : sprintf("%.0f", $3),
      $5 == "" ? "" : sprintf("%.4f", $5), $6 == "" ? "" : $6
    last = $1
  }'
} > "$out/figures.md"
cat "$out/figures.md"
