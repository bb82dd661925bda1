#!/usr/bin/env bash
# What the constants of the cost model are fitted on: the launches of bench/cost/, counted and timed.
#
#   scripts/measure_cost.sh OUT [WARPGRAIN [MACHINE]]     on a machine with an NVIDIA GPU, clang and ptxas
#
# WARPGRAIN: the program, build/release/cli/warpgrain when left out. MACHINE: a machine file or name with a "cost"
# (hopper_h100); its numbers do not matter for what is counted. OUT holds cost.tar.xz afterwards: NAME.report.json,
# NAME.measured.json and, of a few launches twenty in a row, NAME.row.json. Then
#
#   tar -xJf OUT/cost.tar.xz -C FOLDER && build/release/bench/fit_cost_model MACHINE FOLDER --write MACHINE_FILE
#
# For the PTX to be the same on both sides launches are compiled once, by `profile --export` of the first of a kernel.
set -uo pipefail
cd "$(dirname "$0")/.." || exit

out=${1:?OUT}
warpgrain=$(realpath "${2:-build/release/cli/warpgrain}")
machine=${3:-hopper_h100}
in_a_row=(nothing-12-128 nothing-17-128 copy-17-128 multiply_adds-17-128 neighbours-long-17-128)
work=$(mktemp -d)
mkdir -p "$out" "$work"/{launches,results}
out=$(realpath "$out")
bench/cost/make_launches.py "$work/launches"
cd "$work/launches" || exit
"$warpgrain" profile nothing-12-128.sim --weights ptx --unchecked --quiet --json kernels.json || exit
failed=()
# shellcheck disable=SC2016 # expanded by the inner shell
printf '%s\n' *.sim | xargs -P "$(nproc)" -I{} bash -c '
  "$0" profile "$1" --machine "$2" --weights sass --unchecked --quiet --threads 1 --json "$3/${1%.sim}.report.json"' \
  "$warpgrain" {} "$machine" "$work/results"
for launch in *.sim; do
  [[ -f "$work/results/${launch%.sim}.report.json" ]] || failed+=("${launch%.sim}: profile")
done
sed -i '1s/.*/kernels.ptx/' ./*.sim
for launch in *.sim; do
  name=${launch%.sim}
  "$warpgrain" measure "$launch" --repeats 21 --quiet --json "$work/results/$name.measured.json" ||
    failed+=("$name: measure")
done
for name in "${in_a_row[@]}"; do
  "$warpgrain" measure "$name.sim" --repeats 21 --in-a-row 20 --quiet --json "$work/results/$name.row.json" ||
    failed+=("$name: in a row")
done
rm -f "$work"/results/*.ptx
for name in "${failed[@]+"${failed[@]}"}"; do
  echo "failed: $name"
  rm -f "$work/results/${name%%:*}".*
done
tar -C "$work/results" -cJf "$out/cost.tar.xz" .
ls -la "$out/cost.tar.xz"
rm -rf "$work"
((${#failed[@]} == 0))
