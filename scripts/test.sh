#!/usr/bin/env bash
# Builds what is needed and runs all tests. `scripts/test.sh PRESET` for another preset (debug, asan-ubsan, tsan).
set -euo pipefail
cd "$(dirname "$0")/.."
preset="${1:-release}"

scripts/install_dependencies.sh
# VTK's own reader, ParaView's, which the files of --vtk are held against: many packages that nothing waits for until the tests.
scripts/install_dependencies.sh python3-vtk9 &
cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$(nproc)"
wait "$!"
ctest --preset "$preset" --parallel "$(nproc)"
