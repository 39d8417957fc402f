#!/usr/bin/env bash
# Builds carom and runs every test: bash tests/run.sh
#
# 1. installs the Debian packages that are missing (src/cmake/packages.sh);
# 2. builds the release preset with g++ and warnings as errors, and runs all of CTest;
# 3. builds the first stages' tests with the address and undefined-behaviour sanitizers, and runs them.
# Build folders (build/release, build/sanitize) are kept: a second run builds only what has changed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source src/cmake/packages.sh

# Stages whose tests are run under the sanitizers: those that read input, solve, and own memory.
sanitized=(core solve scene world sim golden)

need_packages "${build_packages[@]}" "${test_packages[@]}"
jobs=$(nproc)

cmake --preset release -DCAROM_BUILD_APP=ON -DCAROM_BUILD_TESTS=ON -DCAROM_WARNINGS_AS_ERRORS=ON
cmake --build --preset release --parallel "$jobs"
ctest --preset release --parallel "$jobs"

cmake --preset sanitize -DCAROM_WARNINGS_AS_ERRORS=ON
targets=()
for stage in "${sanitized[@]}"; do
  if [[ -d build/sanitize/tests/$stage ]]; then targets+=("tests/$stage/all"); fi
done
cmake --build --preset sanitize --parallel "$jobs" --target "${targets[@]}"
for target in "${targets[@]}"; do
  echo "Sanitized: $target"
  ctest --test-dir "build/sanitize/${target%/all}" --parallel "$jobs" --output-on-failure --no-tests=error
done

echo "All tests passed in $((SECONDS / 60)) min $((SECONDS % 60)) s."
