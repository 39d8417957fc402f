#!/usr/bin/env bash
# From a fresh clone to a first result: bash examples/quickstart.sh
#
# Installs the Debian packages that are missing, builds the program carom, breaks a rack of pool balls, and makes a page that
# plays it.
# An existing build/release is used as it is: a second run builds only what has changed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source src/cmake/packages.sh

need_packages "${build_packages[@]}"

if [[ ! -f build/release/build.ninja ]]; then
  cmake --preset release -DCAROM_BUILD_APP=ON -DCAROM_BUILD_TESTS=OFF
fi
cmake --build --preset release --parallel "$(nproc)" --target carom_program

echo
echo "carom run examples/break_shot/scene.toml --out out/break_shot"
build/release/carom run examples/break_shot/scene.toml --out out/break_shot
echo
if build/release/carom view examples/break_shot --out out/break_shot/break_shot.html > /dev/null; then
  echo "See it: open $PWD/out/break_shot/break_shot.html in a browser."
fi
echo "Every collision is a line of out/break_shot/events.csv. The program is build/release/carom; try: build/release/carom --help"
