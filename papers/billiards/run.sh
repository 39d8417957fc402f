#!/bin/sh
# Everything in README.md again: run.sh [CAROM] [--long]
#   CAROM    the program, default "carom"
#   --long   more collisions, as the heads of the scripts say
# Prints the tables and draws the pictures (gnuplot, package gnuplot-nox). Exit status 1 if a bound is broken.
set -u
carom=${1:-carom}
long=$([ "${2:-}" = --long ] && echo --long)
times=$([ -n "$long" ] && echo 10 || echo 1)
case $carom in */*) carom=$(cd "$(dirname "$carom")" && pwd)/$(basename "$carom") ;; esac
cd "$(dirname "$0")" || exit 2
status=0

part() {
  echo "
## $1
"
  shift
  python3 "$@" || { status=1; echo "FAILED: $*"; }
}

part "Orbits in closed form" integrable.py "$carom" $long
part "Mean free paths" paths.py "$carom" $long
part "The pinball's escape rate" pinball.py "$carom" $long
part "Lorentz gas: exponents" exponents.py "$carom" $long
part "Lorentz gas: diffusion" diffusion.py "$carom" $long
part "Stadium, Sinai's billiard, finite times" chaos.py "$carom" $long
part "Hard disks" hard_disks.py "$carom" "$((4000 * times))"
part "Boundary maps" portraits.py "$carom" $long
part "Walls that move" fermi.py "$carom" $long
part "The wedge under gravity" wedge.py "$carom" $long
part "Joints" joints.py "$carom" $long
exit $status
