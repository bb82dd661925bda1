#!/usr/bin/env bash
# The main job, from a fresh Debian 12 machine to a true result: installs what is missing, builds, and sweeps the
# variants over the paper's scene on PoCL and in the simulator.
#
#   scripts/demo.sh                      2^14 particles, a few minutes
#   scripts/demo.sh --particles 131072   the paper's size
#
# Other options go to `warpgrain sweep` as they are; later ones win.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target warpgrain
exec build/release/cli/warpgrain sweep --scene slit --particles 16384 --at-step 6000 --out out/demo "$@"
