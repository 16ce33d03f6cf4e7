#!/usr/bin/env bash
# Makes the traces and signals of assets/examples/soft_arm again.
#
# No inverse crime: the data come from quadratic tetrahedra and steps of 1.25 ms. True values: E = 160 kPa, damping time
# 4 ms; noise 0.1 mm per coordinate, some samples occluded. The signal of the trial reach is used here and not kept: it
# falls to 0.82 within half a second, rises to 1.06 and ends at 0.9.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/traces.sh"
myoloop=${1:-$here/../../build/bin/myoloop}
folder=$here/soft_arm
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trials="lift sway reach"

printf 'time_s,upper\n0.05,1\n0.25,0.82\n0.6,0.82\n0.75,1\n' > "$folder/lift_signal.csv"
awk 'BEGIN { print "time_s,upper"; for (k = 0; k <= 50; ++k) printf "%.2f,%.5f\n", 0.02 * k, 1 - 0.08 * sin(6.283185307179586 * 1.6 * 0.02 * k) }' > "$folder/sway_signal.csv"
printf 'time_s,upper\n0.1,1\n0.45,0.82\n0.7,1.06\n0.9,0.9\n' > "$work/reach_signal.csv"
cp "$folder"/*_signal.csv "$work/"
awk '{ print } /^trace = "reach.csv"/ { print "actuation = \"reach_signal.csv\"" }' "$folder/experiment.toml" > "$work/experiment.toml"
for trial in $trials; do empty_trace "$work/$trial.csv" "$folder/experiment.toml" 100 100; done
"$myoloop" simulate "$work" --out "$work/truth" --element tet10 --resolution 0.0075 --dt 0.00125 \
    --set material.youngs_modulus_Pa=1.6e5 --set material.damping_s=0.004
seed=30
for trial in $trials; do
    seed=$((seed + 1))
    as_recorded "$seed" 1e-4 < "$work/truth/$trial.csv" > "$folder/$trial.csv"
done
