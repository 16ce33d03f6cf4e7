# What the recipes of the bundled examples have in common; to be sourced.

# empty_trace FILE EXPERIMENT SAMPLES RATE: a trace that only gives the sampling times; its markers stay at their places
# at rest.
empty_trace() {
    awk -v samples="$3" -v rate="$4" '
        /^\[/ { on = $0 ~ /^\[markers.rest_m\]/; next }
        on && NF {
            name = $1; sub(/^[^[]*\[/, ""); sub(/\].*/, ""); gsub(/ /, "")
            head = head "," name "_x_m," name "_y_m," name "_z_m"; row = row "," $0
        }
        END {
            print "time_s" head
            for (k = 0; k <= samples; ++k) printf "%.4f%s\n", k / rate, row
        }' "$2" > "$1"
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
