#!/usr/bin/env bash
# The main job, from a fresh Debian 12 machine to a true result: installs what is missing, builds, and sweeps the
# variants over the paper's scene on PoCL and in the simulator.
#
#   scripts/demo.sh                      2^14 particles, a few minutes
#   scripts/demo.sh --particles 131072   the paper's size
#
# Counts are those of the PTX, so that they are the same on every machine (`--weights auto` takes the machine code of ptxas
# where it is installed). Other options go to `warpgrain sweep` as they are; later ones win. More variants: `--axis search=all`.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target warpgrain
exec build/release/cli/warpgrain sweep --scene slit --particles 16384 --at-step 6000 --axis contact=simple,branchy \
  --axis order=unsorted,cell --axis precision=fp32,fp64 --axis model=full --weights ptx --out out/demo "$@"
