#!/bin/sh
# Everything in README.md again: run.sh [CAROM] [--long]
#   CAROM    the program, default "carom"
#   --long   also one run of 10^9 collisions and the mass ratio 100^7
# Rewrites energy_error.csv, with --long long_run.csv, and energy_error.svg if gnuplot is there. Exit status 1 if a bound is broken.
set -u
carom=${1:-carom}
long=${2:-}
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

energies() { python3 energy.py "$carom" >energy_error.csv; result=$?; cat energy_error.csv; return $result; }
one_long() { python3 long_run.py "$carom" >long_run.csv; result=$?; cat long_run.csv; return $result; }

part "Start of the clock" python3 offset.py "$carom"
part "Photon" python3 photon.py "$carom"
part "Collapse on a line" python3 collapse.py "$carom"
part "Collapse in the plane" python3 collapse_plane.py "$carom"
part "Bouncing ball" python3 bouncing.py "$carom"
part "Galperin" python3 galperin.py "$carom" "$([ "$long" = --long ] && echo 7 || echo 6)"
part "Energy error over seeds" energies
[ "$long" = --long ] && part "Energy error along one run" one_long
if command -v gnuplot >/dev/null; then gnuplot energy.gnuplot; fi
exit $status
