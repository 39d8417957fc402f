#!/bin/sh
# Z of hard spheres, and the pressure of hard disks, against the literature: run.sh [--long] [CAROM] [EVENTS]
#   --long  4000 spheres instead of 1000, 10^8 collisions if EVENTS is not given; then disks, ten times as many
#   CAROM   the program, default "carom"
#   EVENTS  collisions at each density, a tenth of them before measuring begins; default 10000000
# Exit status 1 if a value is off by more than 3 standard errors and what the literature leaves open, from 10^7 collisions of
# spheres on if it is off by more than 5e-4, and from 10^8 of disks on if by more than 1e-3.
set -eu
long=no
if [ "${1:-}" = --long ]; then
  long=yes
  shift
fi
carom=${1:-carom}
if [ $long = yes ]; then events=${2:-100000000} balls=4000; else events=${2:-10000000} balls=1000; fi
here=$(cd "$(dirname "$0")" && pwd)
status=0

# measure SCENE BALLS ETA EVENTS LABEL FACTOR LITERATURE OPEN TOLERANCE FROM: one row; FACTOR turns Z into what the literature
# gives, OPEN is its relative error, and from FROM collisions on TOLERANCE is asked for.
measure() {
  "$carom" run "$here/$1" --json --quiet --set gas.0.count="$2" --set gas.0.packing_fraction="$3" --events "$4" \
    --set observe.after.events=$(($4 / 10)) |
    python3 -c '
import json, sys
label, (factor, expected, doubt, tolerance, start), events = sys.argv[1], map(float, sys.argv[2:7]), int(sys.argv[7])
run = json.load(sys.stdin)
z, rate = (run["observed"]["pressure"][k] for k in ("Z", "Z_rate"))
value, error = factor * z["value"], factor * z["error"]
off = value / expected - 1
print("| %s | %.6g | %.2g | %.6g | %.6g | %+.1e | %.2g |"
      % (label, value, error, factor * rate["value"], expected, off, run["collisions_per_second"]), flush=True)
good = abs(value - expected) < 3 * error + doubt * expected and (events < start or abs(off) < tolerance)
sys.exit(0 if good else 1)' "$5" "$6" "$7" "$8" "$9" "${10}" "$4" || status=1
}

echo "| rho | Z measured | error | Z from rates | Z literature | relative difference | collisions/s |"
echo "|---|---|---|---|---|---|---|"
while read -r rho literature; do
  eta=$(awk "BEGIN { printf \"%.17g\", atan2(0, -1) * $rho / 6 }")
  measure scene.toml $balls "$eta" "$events" "$rho" 1 "$literature" 1e-4 5e-4 1e7
done <<TABLE
0.10 1.23972
0.30 1.96823
0.50 3.26936
0.60 4.29485
0.75 6.65467
TABLE
[ $long = yes ] || exit $status

# Up to 0.20 the virial series, Z [ClisbyMcCoy2006]; beyond, beta P sigma^2 = 4 eta Z / pi of 870 disks in a square [Li2022].
echo
echo "| eta | measured | error | from rates | literature | relative difference | collisions/s |"
echo "|---|---|---|---|---|---|---|"
while read -r eta quantity disks literature doubt; do
  if [ "$quantity" = Z ]; then factor=1; else factor=$(awk "BEGIN { printf \"%.17g\", 4 * $eta / atan2(0, -1) }"); fi
  measure disks.toml "$disks" "$eta" $((10 * events)) "$eta ($quantity)" "$factor" "$literature" "$doubt" 1e-3 1e8
done <<TABLE
0.05 Z 4000 1.108388 2e-4
0.10 Z 4000 1.236144 2e-4
0.20 Z 4000 1.570365 2e-4
0.67 P 870 7.986779 1e-5
0.68 P 870 8.513249 1e-5
TABLE
exit $status
