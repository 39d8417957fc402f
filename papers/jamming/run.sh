#!/bin/sh
# The packing fraction at which growing spheres jam, against the literature: run.sh [CAROM] [COUNT] [RATE...]
#   CAROM  the program, default "carom"
#   COUNT  spheres, default 10000
#   RATE   of the radius over the thermal speed sqrt(kT/m), default 0.1 0.03 0.01
# Exit status 1 if a packing of a rate from 0.01 to 0.03 lies outside 0.634..0.64 by more than 0.005.
set -eu
carom=${1:-carom}
count=${2:-10000}
shift $(($# < 2 ? $# : 2))
[ $# -gt 0 ] || set -- 0.1 0.03 0.01
here=$(cd "$(dirname "$0")" && pwd)
status=0
echo "| growth / thermal speed | packing fraction | reduced pressure | collisions a ball | energy error | seconds |"
echo "|---|---|---|---|---|---|"
for rate; do
  "$carom" run "$here/scene.toml" --json --quiet --set gas.0.count="$count" --set gas.0.radius_growth="$rate" \
    --set run.rescale_every=$((5 * count)) |
    python3 -c '
import json, sys
rate, count = float(sys.argv[1]), int(sys.argv[2])
run = json.load(sys.stdin)
phi, z, events = run["growth"]["packing_fraction"], run["growth"]["reduced_pressure"], run["events"]["ball_ball"]
print("| %g | %.5f | %.3g | %.0f | %.1e | %.0f |"
      % (rate, phi, z, 2 * events / count, run["energy"]["relative_error"], run["seconds"]), flush=True)
sys.exit(1 if 0.01 <= rate <= 0.03 and not 0.629 <= phi <= 0.645 else 0)' "$rate" "$count" || status=1
done
exit $status
