#!/bin/sh
# Everything in README.md again: run.sh [CAROM] [--long]
#   CAROM    the program, default "carom"
#   --long   ten times the collisions
# Exit status 1 if a bound is broken.
set -u
carom=${1:-carom}
times=$([ "${2:-}" = --long ] && echo 10 || echo 1)
case $carom in */*) carom=$(cd "$(dirname "$carom")" && pwd)/$(basename "$carom") ;; esac
cd "$(dirname "$0")" || exit 2
status=0

part() {
  echo "
## $1
"
  shift
  "$@" || { status=1; echo "FAILED: $*"; }
}

part "Lorentz gas" python3 exponents.py "$carom" "$((1000000 * times))"
part "Hard disks" python3 hard_disks.py "$carom" "$((4000 * times))"
rm -rf results
exit $status
