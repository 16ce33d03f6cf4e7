#!/usr/bin/env bash
# Makes surface and traces of assets/examples/softening_l again.
#
# The surface: an L, 80 mm down and 60 mm to the side, limbs 15 mm wide and 10 mm thick. No inverse crime: the traces
# come from quadratic tetrahedra of 2.5 mm, four or more through each limb, and steps of 1.25 ms, while the default
# model of the folder uses hexahedra. True values: E = 250 kPa, damping time 3 ms and an effect that the folder does
# not declare: stress_softening with damage_max = 0.3 and energy_scale_J_m3 = 100. Noise 0.1 mm per coordinate, some
# samples occluded.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/traces.sh"
myoloop=${1:-$here/../../build/bin/myoloop}
folder=$here/softening_l
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trials="release two_pulls side_weight"

awk '
    function corner(i, y) { return sprintf("%d %d %d", x[i], y, z[i]) }
    function facet(a, b, c) {
        print "facet normal 0 0 0\nouter loop\nvertex " a "\nvertex " b "\nvertex " c "\nendloop\nendfacet"
    }
    BEGIN {
        n = split("15 15 0 0 60 60", x, " "); split("-65 0 0 -80 -80 -65", z, " ")
        print "solid L"
        for (i = 1; i <= n; ++i) {
            j = i % n + 1
            facet(corner(i, 0), corner(j, 10), corner(j, 0))
            facet(corner(i, 0), corner(i, 10), corner(j, 10))
        }
        # Both sides of the L: a fan around its inner corner.
        for (k = 2; k < n; ++k) {
            facet(corner(1, 0), corner(k, 0), corner(k + 1, 0))
            facet(corner(1, 10), corner(k + 1, 10), corner(k, 10))
        }
        print "endsolid L"
    }' > "$folder/body.stl"

cp "$folder/experiment.toml" "$folder/body.stl" "$work/"
printf '\n[[effect]]\nid = "stress_softening"\ndamage_max = 0.3\nenergy_scale_J_m3 = 100.0\n' >> "$work/experiment.toml"
for trial in $trials; do
    empty_trace "$work/$trial.csv" "$folder/experiment.toml" 65 100
done
"$myoloop" simulate "$work" --out "$work/truth" --element tet10 --resolution 0.0025 --dt 0.00125 \
    --set material.youngs_modulus_Pa=2.5e5 --set material.damping_s=0.003
seed=50
for trial in $trials; do
    seed=$((seed + 1))
    as_recorded "$seed" 1e-4 < "$work/truth/$trial.csv" > "$folder/$trial.csv"
done
