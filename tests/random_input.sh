#!/usr/bin/env bash
# Random mouse and keyboard events to the workbench, with the address and undefined-behaviour sanitizers; leaks are
# errors. Use: random_input.sh [EVENTS]   (default 20000)
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
folder=$root/build-sanitize
export MYOLOOP_EVENTS=${1:-20000}
export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1 UBSAN_OPTIONS=print_stacktrace=1 OPENBLAS_NUM_THREADS=1
bash "$root/app/configure.sh" "$folder" -DCMAKE_BUILD_TYPE=Sanitized -DMYOLOOP_SANITIZE=ON
cmake --build "$folder" --target test_random_input
exec "$folder/bin/test_random_input"
