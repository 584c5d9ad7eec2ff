#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the Debian packages that the project builds with and those given as arguments, where they are missing. Needs root
# or sudo only if one is. Usage: bash .ci/packages.sh [PACKAGE...]
set -euo pipefail

packages=(
  g++ cmake ninja-build pkg-config ccache
  libglm-dev                                  # culler
  libcgal-dev                                 # oracle
  libosmesa6-dev libpng-dev zlib1g-dev libassimp-dev libdraco-dev libmeshoptimizer-dev libxxhash-dev libjs-dygraphs libfreetype-dev fonts-dejavu-core  # render
  libcli11-dev nlohmann-json3-dev libfmt-dev  # the command
  libopenmpi-dev openmpi-bin libsodium-dev    # several processes (mpirun), and parts that they keep
  libbenchmark-dev libhwy-dev                 # the kernel's benchmark
  libgtest-dev patch python3 valgrind gltfpack  # tests
  python3-dev python3-numpy pybind11-dev python3-pip python3-setuptools python3-wheel  # python
  "$@"
)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "packages are missing and there is no sudo: run as root" >&2; exit 2; }
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
