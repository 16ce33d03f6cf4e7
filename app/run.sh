#!/usr/bin/env bash
# Installs what is missing, builds Myoloop and opens it on a bundled example. Without a display it calibrates the
# example and draws the picture instead. Use: run.sh [--headless]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
build=$root/build

headless=false
[[ -z ${DISPLAY:-} && -z ${WAYLAND_DISPLAY:-} ]] && headless=true
for argument in "$@"; do
  case "$argument" in
    --headless) headless=true ;;
    *) echo "run.sh: unknown argument $argument (known: --headless)" >&2; exit 2 ;;
  esac
done

bash "$root/app/install_packages.sh"
bash "$root/app/configure.sh" "$build" -DCMAKE_BUILD_TYPE=Release
cmake --build "$build" --target myoloop myoloop-tetgen

# Threads of the linear algebra library would only get in the way of ours.
export OPENBLAS_NUM_THREADS=1
program=$build/bin/myoloop
example=$root/assets/examples/silicone_beam
if [[ ! -d $example ]]; then
  example=$(find "$root/assets/examples" -mindepth 2 -maxdepth 2 -name experiment.toml -printf '%h\n' |
    sort | head -n 1)
fi
if ! $headless; then
  exec "$program" "$example"
fi

out=$root/out/$(basename -- "$example")
"$program" calibrate "$example" --out "$out"
"$program" screenshot "$example" --calibrate --out "$out/overlay.png"
echo
echo "Report:  $out/report.html"
echo "Picture: $out/overlay.png"
