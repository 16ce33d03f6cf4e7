#!/usr/bin/env bash
# Makes surface and traces of assets/examples/tendon_tentacle again.
#
# The surface: a hanging frustum with twelve sides, 160 mm long, radius 11 mm at the clamp and 6 mm at the tip. No
# inverse crime: the traces come from quadratic tetrahedra of 3.5 mm, while the default model of the folder is coarser.
# True values: E = 300 kPa and an effect that the folder does not declare: tendon_friction of coefficient 0.25 at all
# guides. Every trial is a pose at rest, ten samples each; noise 0.2 mm per coordinate, some samples occluded.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/traces.sh"
myoloop=${1:-$here/../../build/bin/myoloop}
folder=$here/tendon_tentacle
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trials="left_1 left_2 left_4 right_1 right_3 both_2 left_3 right_4"

awk '
    function corner(i, ring) {
        angle = 6.283185307179586 * (i + 0.5) / 12
        return sprintf("%.5f %.5f %d", radius[ring] * cos(angle), radius[ring] * sin(angle), -160 * ring)
    }
    function facet(a, b, c) {
        print "facet normal 0 0 0\nouter loop\nvertex " a "\nvertex " b "\nvertex " c "\nendloop\nendfacet"
    }
    BEGIN {
        radius[0] = 11; radius[1] = 6
        print "solid tentacle"
        for (i = 0; i < 12; ++i) {
            facet(corner(i, 0), corner(i, 1), corner(i + 1, 1))
            facet(corner(i, 0), corner(i + 1, 1), corner(i + 1, 0))
            if (i > 0 && i < 11) {
                facet(corner(0, 0), corner(i, 0), corner(i + 1, 0))
                facet(corner(0, 1), corner(i + 1, 1), corner(i, 1))
            }
        }
        print "endsolid tentacle"
    }' > "$folder/body.stl"

cp "$folder"/experiment.toml "$folder"/body.stl "$work/"
sed -i '/^drive = /a friction = 0.25' "$work/experiment.toml"
for trial in $trials; do empty_trace "$work/$trial.csv" "$folder/experiment.toml" 9 100; done
"$myoloop" simulate "$work" --out "$work/truth" --element tet10 --resolution 0.0035 \
    --set material.youngs_modulus_Pa=3.0e5
seed=80
for trial in $trials; do
    seed=$((seed + 1))
    as_recorded "$seed" 2e-4 < "$work/truth/$trial.csv" > "$folder/$trial.csv"
done
