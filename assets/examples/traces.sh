# What the recipes of the bundled examples have in common; to be sourced.

# Names of the markers of an experiment.
marker_names() {
    awk '/^\[markers.rest_m\]/ {on = 1; next} /^\[/ {on = 0} on && NF {print $1}' "$1"
}

# empty_trace FILE NAMES SAMPLES RATE: a trace that only gives the sampling times.
empty_trace() {
    awk -v names="$2" -v samples="$3" -v rate="$4" 'BEGIN {
        n = split(names, name, /[ \n]+/); printf "time_s"
        for (i = 1; i <= n; ++i) printf ",%s_x_m,%s_y_m,%s_z_m", name[i], name[i], name[i]
        print ""
        for (k = 0; k <= samples; ++k) { printf "%.4f", k / rate; for (i = 1; i <= 3 * n; ++i) printf ",0"; print "" } }' > "$1"
}

# as_recorded SEED SIGMA < exact > recorded: noise of SIGMA metres per coordinate, one sample in a hundred begins a gap
# of up to four. The noise is drawn by awk's srand(seed), so another awk gives other traces of the same quality.
as_recorded() {
    awk -F, -v OFS=, -v seed="$1" -v sigma="$2" '
        function noise() { return sigma * sqrt(-2 * log(1 - rand())) * cos(6.283185307179586 * rand()) }
        NR == 1 { srand(seed); print; next }
        {
            for (i = 2; i <= NF; i += 3) {
                gone = rand() < 0.01 || gap[i]-- > 0
                if (gone && !(gap[i] > 0)) gap[i] = int(4 * rand())
                for (j = i; j < i + 3; ++j) $j = gone ? "nan" : sprintf("%.6f", $j + noise())
            }
            print
        }'
}
