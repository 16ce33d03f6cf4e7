#!/usr/bin/env bash
# Draws the workbench's tasks with the program as it is built: the pictures of the README and of the manual. Use:
# make_gallery.sh [FOLDER]   default: this script's own folder. --all adds both themes and 200 % of every task, for
# inspection. ImageMagick's convert, if installed, reduces the pictures to 256 colours: a third of the size.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
myoloop=$(realpath "${MYOLOOP:-$here/../../build/bin/myoloop}")
examples=examples   # as seen from assets: pictures show no folder of anybody's
all=false
[[ ${1:-} == --all ]] && { all=true; shift; }
mkdir -p "${1:-$here}"
out=$(realpath "${1:-$here}")
cd "$here/.."

shot() {   # NAME ARGUMENTS...
    local name=$1
    shift
    draw "$name" "$@"
    $all || return 0
    draw "$name-light" "$@" --theme light
    draw "$name-200" "$@" --scale 200
    draw "$name-light-200" "$@" --theme light --scale 200
}
draw() {   # NAME ARGUMENTS...
    local picture=$out/$1.png
    shift
    "$myoloop" screenshot "$@" --quiet --out "$picture"
    if command -v convert > /dev/null; then
        convert "$picture" -strip -dither None -colors 256 "PNG8:$picture"
    fi
}

shot start
shot body "$examples/silicone_beam" --as-opened --time 0 --panel body
shot mesh "$examples/fish_tail" --as-opened --time 0 --panel mesh
shot material "$examples/silicone_beam" --as-opened --time 0 --panel material
shot fibres "$examples/soft_arm" --panel fibres,signals --trial lift --time 0.5
shot tendons "$examples/tendon_tentacle" --panel tendon,signals
shot chamber "$examples/pneumatic_finger" --panel chamber,signals
shot run "$examples/soft_arm" --panel run --trial lift --time 0.5 --field von_mises
shot measure "$examples/silicone_beam" --panel measure --time 0.2
shot import "$examples/silicone_beam" --as-opened --import "$examples/silicone_beam/side_pluck.csv" --time 0.2
shot fit "$examples/silicone_beam" --calibrate --panel fit,search --time 0.2
shot optimise "$examples/soft_arm" --optimize --trial reach --panel fit,signals --time 0.5
shot diagnose "$examples/unexplained_beam" --diagnose --panel verdict,diagnose --time 0.2
# This one shows where a report would go.
examples=$here/../examples
cd /
shot report "$examples/silicone_beam" --calibrate --panel report,jobs --time 0.2
