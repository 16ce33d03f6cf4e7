#!/usr/bin/env bash
# Makes surface and traces of assets/examples/pneumatic_finger again.
#
# The surface: a finger of 75 x 20 x 20 mm with a closed air chamber of 60 x 10 x 5 mm above its middle; the chamber's
# walls are a closed part that faces into the chamber. No inverse crime: the traces come from quadratic tetrahedra and
# steps of 1.25 ms, while the default model of the folder uses hexahedra. True values: E = 240 kPa, damping time 4 ms.
# Noise 0.1 mm per coordinate, some samples occluded.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/traces.sh"
myoloop=${1:-$here/../../build/bin/myoloop}
folder=$here/pneumatic_finger
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trials="valve_opens ramps pulses"

# box X0 X1 Y0 Y1 Z0 Z1 OUTWARD: twelve facets; OUTWARD = 0 faces into the box.
box() {
    awk -v x0="$1" -v x1="$2" -v y0="$3" -v y1="$4" -v z0="$5" -v z1="$6" -v outward="$7" '
        function corner(k) { return (k % 2 ? x1 : x0) " " (int(k / 2) % 2 ? y1 : y0) " " (k > 3 ? z1 : z0) }
        function facet(a, b, c) {
            print "facet normal 0 0 0\nouter loop\nvertex " corner(a)
            print "vertex " corner(outward ? b : c) "\nvertex " corner(outward ? c : b) "\nendloop\nendfacet"
        }
        BEGIN {
            n = split("0 2 3 1  4 5 7 6  0 1 5 4  2 6 7 3  0 4 6 2  1 3 7 5", k, " ")
            for (i = 1; i <= n; i += 4) { facet(k[i], k[i + 1], k[i + 2]); facet(k[i], k[i + 2], k[i + 3]) }
        }'
}
{ echo "solid finger"; box 0 75 0 20 0 20 1; box 7.5 67.5 5 15 10 15 0; echo "endsolid finger"; } > "$folder/body.stl"

awk 'BEGIN { print "time_s,chamber_Pa"; print "0,0"; print "0.05,0"; print "0.3,30000"; print "0.4,30000"
             print "0.5,10000"; print "0.7,10000" }' > "$folder/ramps_pressure.csv"
awk 'BEGIN { print "time_s,chamber_Pa"; print "0,0"; print "0.1,25000"; print "0.2,5000"; print "0.35,35000"
             print "0.4,35000"; print "0.5,0"; print "0.7,0" }' > "$folder/pulses_pressure.csv"

cp "$folder"/experiment.toml "$folder"/body.stl "$folder"/*_pressure.csv "$work/"
for trial in $trials; do
    empty_trace "$work/$trial.csv" "$folder/experiment.toml" 70 100
done
"$myoloop" simulate "$work" --out "$work/truth" --element tet10 --resolution 0.003 --dt 0.00125 \
    --set material.youngs_modulus_Pa=2.4e5 --set material.damping_s=0.004
seed=70
for trial in $trials; do
    seed=$((seed + 1))
    as_recorded "$seed" 1e-4 < "$work/truth/$trial.csv" > "$folder/$trial.csv"
done
