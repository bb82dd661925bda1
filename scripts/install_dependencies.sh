#!/usr/bin/env bash
# Installs what is missing to build, test and run warpgrain on Debian 12, and the packages that are named. Asks apt only when
# something is missing.
set -euo pipefail

packages=(
  g++ cmake ninja-build git ccache
  llvm-15-dev clang-15 libclc-15 libclc-15-dev
  libboost-context-dev libeigen3-dev nlohmann-json3-dev libcli11-dev libfmt-dev
  ocl-icd-opencl-dev opencl-c-headers opencl-clhpp-headers pocl-opencl-icd
  libgtest-dev libgmock-dev libbenchmark-dev libmpfr-dev
  python3-jsonschema
  "$@"
)
# The charts of report pages; without npm, or a registry, pages have their tables alone.
pages="$(dirname "$0")/../reports/html"
if ! cmp -s "$pages/package-lock.json" "$pages/node_modules/.installed" && command -v npm >/dev/null; then
  if npm ci --prefix "$pages" --no-audit --no-fund --silent; then
    cp "$pages/package-lock.json" "$pages/node_modules/.installed"
  else
    echo "no ECharts from npm: pages of reports will have no charts" >&2
  fi
fi

missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
echo "installing: ${missing[*]}" >&2
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
