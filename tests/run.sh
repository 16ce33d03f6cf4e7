#!/usr/bin/env bash
# Installs what is missing, builds everything, and runs all tests in one run of ctest: the style of the sources, the
# tests of the Release build, and those of the numerical modules once more with assertions and sanitizers. Ends with
# ctest's summary, whose exit code is the verdict, and the number of GoogleTest's tests behind it.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
release=$root/build
sanitize=$root/build-sanitize
both=$root/build-both
jobs=2

# The modules that handle raw memory: kernels, matrices, readers of meshes, traces and laws. Without long simulations,
# what is built on them, and the Monte Carlo tests of statistics; the workbench has tests/random_input.sh.
sanitized=(base solver toml law mesh fem material fibre model measurement report)

export OPENBLAS_NUM_THREADS=1
# Leaks are errors: of the libraries that the subset links (VTK's readers, CHOLMOD), none leaks; Mesa's are named in
# tests/ui.
export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1
export UBSAN_OPTIONS=print_stacktrace=1

phases=()
phase() {   # phase NAME COMMAND...: runs the command and keeps the minutes it took
  local name=$1 start=$SECONDS
  shift
  echo "== $name"
  "$@"
  phases+=("$(awk -v s=$((SECONDS - start)) -v n="$name" 'BEGIN { printf "%-32s %5.1f min", n, s / 60 }')")
}

build_release() {
  bash "$root/app/configure.sh" "$release" -DCMAKE_BUILD_TYPE=Release
  cmake --build "$release" -j "$jobs"
}

build_sanitized() {
  # Not Debug: oneTBB then defines a macro for those who link it, and no other module could share the precompiled
  # header.
  bash "$root/app/configure.sh" "$sanitize" -DCMAKE_BUILD_TYPE=Sanitized -DMYOLOOP_SANITIZE=ON \
    -DMYOLOOP_TESTS="$(IFS=";"; echo "${sanitized[*]}")"
  cmake --build "$sanitize" -j "$jobs" --target myoloop-tetgen "${sanitized[@]/#/test_}"
}

phase "Packages" bash "$root/app/install_packages.sh" --tests
phase "Build, Release" build_release
phase "Build, sanitizers (subset)" build_sanitized

# One ctest over both builds: their test names differ by the prefix "sanitize.".
mkdir -p "$both"
printf 'subdirs("%s" "%s")\n' "$release" "$sanitize" >"$both/CTestTestfile.cmake"
# The style of the sources is one more test: first, and alone, since it uses all processors.
printf 'add_test(style bash "%s")\nset_tests_properties(style PROPERTIES COST 1000 PROCESSORS %s TIMEOUT 600)\n' \
  "$root/tests/style.sh" "$jobs" >>"$both/CTestTestfile.cmake"

echo "== Minutes"
printf '%s\n' "${phases[@]}"
echo "== Tests"
verdict=0
ctest --test-dir "$both" --parallel "$jobs" --output-on-failure --no-tests=error || verdict=$?

# A test of ctest holds many: what became of each is in the log.
echo "== Single tests"
awk '/\[ RUN      \] / { ++begun }
     match($0, /\[ +(OK|FAILED|SKIPPED) +\] .*\([0-9]+ ms\)$/) { split(substr($0, RSTART), words); ++ended[words[2]] }
     END {
       printf "%d begun: %d passed, %d failed, %d skipped, %d not ended\n", begun, ended["OK"], ended["FAILED"],
         ended["SKIPPED"], begun - ended["OK"] - ended["FAILED"] - ended["SKIPPED"]
     }' "$both/Testing/Temporary/LastTest.log"
exit "$verdict"
