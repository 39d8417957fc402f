#!/bin/sh
# Everything in README.md again: run.sh [CAROM] [--long]
#   CAROM    the program, default "carom"
#   --long   also ten disks through 32000 events
# Rewrites cost.csv and examples.csv. Exit status 1 if something is not proven that was.
set -u
carom=${1:-carom}
long=${2:-}
case $carom in */*) carom=$(cd "$(dirname "$carom")" && pwd)/$(basename "$carom") ;; esac
cd "$(dirname "$0")" || exit 2
status=0
python3 examples.py "$carom" > examples.csv || status=1
python3 cost.py "$carom" "$([ "$long" = --long ] && echo 32000 || echo 8000)" > cost.csv || status=1
cat examples.csv cost.csv
exit $status
