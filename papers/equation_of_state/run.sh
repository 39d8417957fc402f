#!/bin/sh
# Z(rho) of hard spheres against the literature: run.sh [CAROM] [EVENTS]
#   CAROM   the program, default "carom"
#   EVENTS  collisions at each density, a tenth of them before measuring begins; default 10000000
# Exit status 1 if a value is off by more than 3 standard errors, or at 10^7 collisions by more than 5e-4.
set -eu
carom=${1:-carom}
events=${2:-10000000}
here=$(cd "$(dirname "$0")" && pwd)

echo "| rho | Z measured | error | Z from rates | Z literature | relative difference | collisions/s |"
echo "|---|---|---|---|---|---|---|"
status=0
while read -r rho literature; do
  eta=$(awk "BEGIN { printf \"%.17g\", atan2(0, -1) * $rho / 6 }")
  "$carom" run "$here/scene.toml" --json --quiet --set gas.0.packing_fraction="$eta" --events "$events" \
    --set observe.after.events=$((events / 10)) |
    python3 -c '
import json, sys
rho, expected, events = float(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3])
run = json.load(sys.stdin)
z, rate = (run["observed"]["pressure"][k] for k in ("Z", "Z_rate"))
off = z["value"] / expected - 1
print("| %.2f | %.5f | %.5f | %.5f | %.5f | %+.1e | %.2g |"
      % (rho, z["value"], z["error"], rate["value"], expected, off, run["collisions_per_second"]))
good = abs(z["value"] - expected) < 3 * z["error"] + 1e-4 * expected and (events < 10**7 or abs(off) < 5e-4)
sys.exit(0 if good else 1)' "$rho" "$literature" "$events" || status=1
done <<TABLE
0.10 1.23972
0.30 1.96823
0.50 3.26936
0.60 4.29485
0.75 6.65467
TABLE
exit $status
