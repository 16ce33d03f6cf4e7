#!/usr/bin/env bash
# Makes surface and trace of assets/examples/fish_tail again.
#
# The surface: elliptic sections along x, 120 mm long, the fin at its end. The trace comes from two muscles that the
# folder does not name: all that lies on the left (y > 2 mm) and on the right (y < -2 mm) between x = 10 and 75 mm,
# fibres along x, stiffness 200 kPa, antagonists; the left one's signal is 1 - 0.02 sin(2 pi 2 t), set in over the first
# half period. Quadratic tetrahedra, steps of 1.25 ms, noise 0.1 mm per coordinate.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/traces.sh"
myoloop=${1:-$here/../../build/bin/myoloop}
folder=$here/fish_tail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk '
    function height(x) { return x < 95 ? 20 - 13 * x / 95 : 7 + 13 * (x - 95) / 25 }   # half of it, mm
    function thickness(x) { return 1.6 + 7.4 * (1 - x / 120) }
    function point(i, j,   x, angle) {
        x = 120 * i / rings; angle = 6.283185307179586 * j / around
        return sprintf("%.3f %.3f %.3f", x, thickness(x) * cos(angle), height(x) * sin(angle))
    }
    function facet(a, b, c) { print "facet normal 0 0 0\nouter loop\nvertex " a "\nvertex " b "\nvertex " c "\nendloop\nendfacet" }
    BEGIN {
        rings = 24; around = 20; print "solid tail"
        for (i = 0; i < rings; ++i) for (j = 0; j < around; ++j) {
            facet(point(i, j), point(i + 1, (j + 1) % around), point(i + 1, j)); facet(point(i, j), point(i, (j + 1) % around), point(i + 1, (j + 1) % around))
        }
        for (j = 0; j < around; ++j) { facet("0.000 0.000 0.000", point(0, (j + 1) % around), point(0, j)); facet("120.000 0.000 0.000", point(rings, j), point(rings, (j + 1) % around)) }
        print "endsolid tail"
    }' > "$folder/tail.stl"

cp "$folder/tail.stl" "$work/"
awk 'BEGIN { print "time_s,left"; for (k = 0; k <= 50; ++k) { t = 0.02 * k; s = t < 0.25 ? t / 0.25 : 1; printf "%.2f,%.5f\n", t, 1 - 0.02 * s * sin(6.283185307179586 * 2 * t) } }' > "$work/beat_signal.csv"
{
    awk '{ print } /^trace = "beat.csv"/ { print "actuation = \"beat_signal.csv\"" }' "$folder/experiment.toml"
    printf '\n[[muscle]]\nname = "left"\nbox_m = [[0.01, 0.002, -0.03], [0.075, 0.03, 0.03]]\nfibre = [1.0, 0.0, 0.0]\nstiffness_Pa = 2.0e5\n'
    printf '\n[[muscle]]\nname = "right"\nbox_m = [[0.01, -0.03, -0.03], [0.075, -0.002, 0.03]]\nfibre = [1.0, 0.0, 0.0]\nstiffness_Pa = 2.0e5\nfollows = { muscle = "left", ratio = -1.0 }\n'
} > "$work/experiment.toml"
empty_trace "$work/beat.csv" "$folder/experiment.toml" 100 100
"$myoloop" simulate "$work" --out "$work/truth" --element tet10 --resolution 0.005 --dt 0.00125
as_recorded 41 1e-4 < "$work/truth/beat.csv" > "$folder/beat.csv"
