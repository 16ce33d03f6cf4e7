#!/usr/bin/env bash
# Checks the layout of all C++ files with clang-format, and files with clang-tidy. Ends with status 1 at a finding.
# Use: style.sh [--all | --since COMMIT] [--fix]
#   --since COMMIT  clang-tidy for the files changed since it (default: the parent of HEAD)
#   --all           clang-tidy for every file, by the batches of the build folder (most of an hour of one core)
#   --fix           rewrites the layout instead of checking it
# Without history (a shallow clone, an export) no file counts as changed, and the layout alone is checked.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
cd "$root"

since=HEAD~1
all=false
fix=false
build=build
most_files=5   # in one call without --all: below a minute on two cores
while (($#)); do
  case "$1" in
    --all) all=true ;;
    --fix) fix=true ;;
    --since)
      (($# > 1)) || { echo "style.sh: --since needs a commit" >&2; exit 2; }
      since=$2
      shift
      ;;
    *) echo "style.sh: unknown argument $1 (known: --all, --since COMMIT, --fix)" >&2; exit 2 ;;
  esac
  shift
done

tool() {
  command -v "$1-14" || command -v "$1" || { echo "style.sh: $1 is missing (Debian: $1-14)" >&2; exit 1; }
}
format=$(tool clang-format)
tidy=$(tool clang-tidy)
has_history=false
if [[ $(git rev-parse --show-toplevel 2>/dev/null) == "$root" ]]; then has_history=true; fi

files() {   # C++ files of the project, with or without git
  find app core tests ui -type f \( -name '*.cpp' -o -name '*.hpp' \) | sort
}
in_parallel() { xargs -r -0 -P "$(nproc)" "$@"; }

status=0
mapfile -t sources < <(files)
if $fix; then
  printf '%s\0' "${sources[@]}" | in_parallel -n 50 "$format" -i
else
  printf '%s\0' "${sources[@]}" | in_parallel -n 50 "$format" --dry-run -Werror || status=1
fi
echo "layout: ${#sources[@]} files"

# clang-tidy sees unused using-declarations in the main file only, not in the files of a batch.
unused_using() {
  awk '
    function report() {
      for (name in declared) if (seen[name] < 2) {
        print file ": error: using-declaration of " name " is not used"
        found = 1
      }
      delete declared; delete seen; file = FILENAME
    }
    FNR == 1 { report() }
    /^ *using ([A-Za-z_0-9]+::)+[A-Za-z_0-9]+;$/ { name = $0; sub(/.*::/, "", name); sub(/;$/, "", name); declared[name] }
    { count = split($0, words, /[^A-Za-z_0-9]+/); for (i = 1; i <= count; ++i) ++seen[words[i]] }
    END { report(); exit found }' "$@"
}
mapfile -t units < <(files | grep '\.cpp$')
unused_using "${units[@]}" || status=1

checked=()
options=(--checks=-clang-analyzer-*)   # the analyzer takes as long as all other checks; --all runs it
if $all; then
  # A batch parses the libraries' headers once for 40 files.
  mapfile -t checked < <(find "$build"/{app,core,ui} -path '*/Unity/*.cxx' 2>/dev/null | sort)
  ((${#checked[@]})) || { echo "style.sh: --all needs a configured build folder (cmake --preset release)" >&2; exit 1; }
  mapfile -t outside < <(comm -23 <(printf '%s\n' "${units[@]}" | grep -v '^tests/') \
                                  <(cat "${checked[@]}" | sed -nE "s|^#include \"$root/(.*)\"\$|\\1|p" | sort))
  checked+=("${outside[@]}")
  options=(--checks=-bugprone-suspicious-include)   # a batch includes .cpp files
elif $has_history && git rev-parse --quiet --verify "$since^{commit}" >/dev/null; then
  changed() { git diff --name-only --diff-filter=AMR "$since" -- "core/*.$1" "ui/*.$1" "app/*.$1"; }
  mapfile -t checked < <(changed cpp)
  # Findings in headers that did not change belong to --all.
  options+=(--header-filter="(^|/)($(changed hpp | paste -s -d '|'))\$")
else
  echo "clang-tidy: no commit $since here, so no file counts as changed"
fi
if ! $all && ((${#checked[@]} > most_files)); then
  echo "clang-tidy: ${#checked[@]} files changed, the first $most_files are checked (all: --all)"
  checked=("${checked[@]:0:$most_files}")
fi
if ((${#checked[@]})); then
  includes=(-Icore -Iui -Iapp -I"$build/app")
  for folder in /usr/include/eigen3 /usr/include/suitesparse /usr/include/vtk-9.1 /usr/include/imgui /usr/include/stb \
                /usr/include/freetype2; do
    includes+=(-isystem "$folder")
  done
  printf '%s\0' "${checked[@]}" | in_parallel -I{} "$tidy" --quiet "${options[@]}" {} -- \
    -std=c++20 -DMYOLOOP_VERSION=\"\" -DTETLIBRARY "${includes[@]}" -Wno-everything || status=1
fi
echo "clang-tidy: ${#checked[@]} $($all && echo batches || echo files)"
exit "$status"
