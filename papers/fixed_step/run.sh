#!/bin/sh
# What a time step costs, all of it: run.sh [CAROM] [--quick]
#   CAROM    the program, default "carom"
#   --quick  fewer phases, seeds and steps, no figures; the CSV files go to out/
# Prints the tables, writes the CSV files beside this script and draws the figures from them (gnuplot, package gnuplot-nox).
# Exit status 1 if a check of one of the parts fails; the parts name theirs.
set -eu
carom=${1:-carom}
[ "$carom" = --quick ] && carom=carom && set -- carom --quick
here=$(cd "$(dirname "$0")" && pwd)
status=0
for part in miss drop break_shot rows gas pile; do
  printf '\n## %s\n\n' "$part"
  python3 "$here/$part.py" "$carom" ${2:+"$2"} || { status=1; echo "$part: failed"; }
done
[ "${2:-}" = --quick ] || (cd "$here" && gnuplot figures.gp)
exit $status
