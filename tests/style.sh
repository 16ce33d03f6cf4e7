#!/usr/bin/env bash
# Checks the layout of all C++ files with clang-format, and the files that differ from a commit with clang-tidy.
# Use: style.sh [--all | --since COMMIT] [--fix]
#   --since COMMIT  clang-tidy for the files changed since it (default: the parent of HEAD)
#   --all           clang-tidy for every file (an hour of one core)
#   --fix           rewrites the layout instead of checking it
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
cd "$root"

since=HEAD~1
all=false
checks=(--checks=-clang-analyzer-*)   # the analyzer takes as long as all other checks; --all runs it
fix=false
most_files=10   # in one call without --all: below two minutes on two cores
while (($#)); do
  case "$1" in
    --all) all=true; checks=() ;;
    --fix) fix=true ;;
    --since) since=$2; shift ;;
    *) echo "style.sh: unknown argument $1 (known: --all, --since COMMIT, --fix)" >&2; exit 2 ;;
  esac
  shift
done

tool() {
  command -v "$1-14" || command -v "$1" || { echo "style.sh: $1 is missing (Debian: $1-14)" >&2; exit 1; }
}
format=$(tool clang-format)
tidy=$(tool clang-tidy)

mapfile -t sources < <(git ls-files '*.cpp' '*.hpp')
if $fix; then
  printf '%s\0' "${sources[@]}" | xargs -0 -P "$(nproc)" -n 50 "$format" -i
else
  printf '%s\0' "${sources[@]}" | xargs -0 -P "$(nproc)" -n 50 "$format" --dry-run -Werror
fi
echo "layout: ${#sources[@]} files"

if $all; then
  mapfile -t checked < <(git ls-files 'core/*.cpp' 'ui/*.cpp' 'app/*.cpp')
elif git rev-parse --quiet --verify "$since^{commit}" >/dev/null; then
  mapfile -t checked < <(git diff --name-only --diff-filter=AMR "$since" -- 'core/*.cpp' 'ui/*.cpp' 'app/*.cpp')
else
  checked=()   # a shallow clone
fi
if ! $all && ((${#checked[@]} > most_files)); then
  echo "clang-tidy: ${#checked[@]} files changed, the first $most_files are checked (all: --all)"
  checked=("${checked[@]:0:$most_files}")
fi
if ((${#checked[@]})); then
  includes=(-Icore -Iui -Iapp -Ibuild/app)
  for folder in /usr/include/eigen3 /usr/include/suitesparse /usr/include/vtk-9.1 /usr/include/imgui /usr/include/stb \
                /usr/include/freetype2; do
    includes+=(-isystem "$folder")
  done
  printf '%s\0' "${checked[@]}" | xargs -0 -P "$(nproc)" -n 1 -I{} "$tidy" --quiet ${checks[@]+"${checks[@]}"} {} -- \
    -std=c++20 -DMYOLOOP_VERSION=\"\" "${includes[@]}" -Wno-everything
fi
echo "clang-tidy: ${#checked[@]} files"
