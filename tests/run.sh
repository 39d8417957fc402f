#!/usr/bin/env bash
# Builds carom and runs every test:      bash tests/run.sh
# The first stages under the sanitizers: bash tests/run.sh sanitize
#
# The first installs the Debian packages that are missing (src/cmake/packages.sh), builds the release preset with g++ and
# warnings as errors, and runs all of CTest. The second builds the tests of the stages that read input, solve, and own memory
# with the address and undefined-behaviour sanitizers, and runs them: the engine takes long to compile that way.
# Build folders (build/release, build/sanitize) are kept: a second run builds only what has changed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source src/cmake/packages.sh

need_packages "${build_packages[@]}" "${test_packages[@]}"
jobs=$(nproc)

run_all() {
  cmake --preset release -DCAROM_BUILD_APP=ON -DCAROM_BUILD_TESTS=ON -DCAROM_WARNINGS_AS_ERRORS=ON
  cmake --build --preset release --parallel "$jobs"
  ctest --preset release --parallel "$jobs"
}

run_sanitized() {
  local stage stages=(core solve scene world sim golden) targets=()
  for stage in "${stages[@]}"; do targets+=("tests/$stage/all"); done
  cmake --preset sanitize -DCAROM_WARNINGS_AS_ERRORS=ON
  cmake --build --preset sanitize --parallel "$jobs" --target "${targets[@]}"
  for stage in "${stages[@]}"; do
    echo "Sanitized: $stage"
    ctest --test-dir "build/sanitize/tests/$stage" --parallel "$jobs" --output-on-failure --no-tests=error
  done
}

case "${1:-all}" in
  all) run_all ;;
  sanitize) run_sanitized ;;
  *)
    echo "usage: bash tests/run.sh [sanitize]" >&2
    exit 2
    ;;
esac
echo "All tests passed in $((SECONDS / 60)) min $((SECONDS % 60)) s."
