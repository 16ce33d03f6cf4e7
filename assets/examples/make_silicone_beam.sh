#!/usr/bin/env bash
# Makes the traces of assets/examples/silicone_beam again.
#
# No inverse crime: the data come from quadratic tetrahedra of 7 mm (thirteen times as many unknowns) and steps of 1.25 ms, while the default model of the folder
# uses hexahedra of 7 mm and steps of 5 ms. True values: E = 270 kPa, damping time 2.4 ms; noise 0.1 mm per coordinate, some samples
# occluded. The noise is drawn by awk's srand(seed), so another awk gives other traces of the same quality.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
myoloop=${1:-$here/../../build/bin/myoloop}
folder=$here/silicone_beam
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trials="gravity_release side_pluck tip_weight"
markers=$(awk '/^\[markers.rest_m\]/ {on = 1; next} /^\[/ {on = 0} on && NF {print $1}' "$folder/experiment.toml")

# Traces that only give the sampling times: 0.8 s at 100 Hz.
cp "$folder/experiment.toml" "$work/"
for trial in $trials; do
    awk -v names="$markers" 'BEGIN {
        n = split(names, name, /[ \n]+/); printf "time_s"
        for (i = 1; i <= n; ++i) printf ",%s_x_m,%s_y_m,%s_z_m", name[i], name[i], name[i]
        print ""
        for (k = 0; k <= 80; ++k) { printf "%.4f", k / 100; for (i = 1; i <= 3 * n; ++i) printf ",0"; print "" } }' > "$work/$trial.csv"
done

"$myoloop" simulate "$work" --out "$work/truth" --element tet10 --resolution 0.007 --dt 0.00125 \
    --set material.youngs_modulus_Pa=2.7e5 --set material.damping_s=0.0024

seed=20
for trial in $trials; do
    seed=$((seed + 1))
    awk -F, -v OFS=, -v seed="$seed" -v sigma=1e-4 '
        function noise() { return sigma * sqrt(-2 * log(1 - rand())) * cos(6.283185307179586 * rand()) }
        NR == 1 { srand(seed); print; next }
        {
            for (i = 2; i <= NF; i += 3) {
                gone = rand() < 0.01 || gap[i]-- > 0
                if (gone && !(gap[i] > 0)) gap[i] = int(4 * rand())
                for (j = i; j < i + 3; ++j) $j = gone ? "nan" : sprintf("%.6f", $j + noise())
            }
            print
        }' "$work/truth/$trial.csv" > "$folder/$trial.csv"
done
