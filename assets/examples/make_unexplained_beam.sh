#!/usr/bin/env bash
# Makes the experiment of assets/examples/unexplained_beam again: the last of the 204 cases of `myoloop validate --seed
# 1`.
#
# The study simulates with other cells, a finer mesh, smaller steps and another scheme than those who are to explain the
# data. What it hid is told in the case's truth.json: a drag that grows with the square of the speed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
myoloop=${1:-$here/../../build/bin/myoloop}
folder=$here/unexplained_beam
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$myoloop" study --seed 1 --cases 204 --share 204/204 --out "$work"
cp "$work"/cases/case_0203/*.csv "$folder/"
awk '/^name = "case/ {
        print "# Made by assets/examples/make_unexplained_beam.sh."
        print "name = \"Unexplained beam\""
        print "description = \"Let go, loaded and pulled, this beam does not move as its model says. Diagnose finds what the model lacks.\""
        next
    } {print}' "$work/cases/case_0203/experiment.toml" > "$folder/experiment.toml"
