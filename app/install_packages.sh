#!/usr/bin/env bash
# Installs the Debian packages that Myoloop needs and that are missing. Does nothing, and needs no rights, when all are
# there. Use: install_packages.sh [--tests]      (--tests: also what the tests of window and style need)
set -euo pipefail

packages=(
  build-essential clang lld cmake ninja-build pkg-config git
  libeigen3-dev libboost-dev libsuitesparse-dev libopenblas0-serial libmetis-dev libceres-dev libnlopt-dev libtbb-dev
  libvtk9-dev libtet1.5-dev libcgal-dev
  libimgui-dev libglfw3-dev libosmesa6-dev libgl-dev libstb-dev libfreetype-dev
  fonts-inter fonts-dejavu-core fonts-font-awesome
  libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libspdlog-dev
  # CMake looks for what the tests need whenever it configures the project.
  libgtest-dev libgmock-dev libbenchmark-dev libx11-dev
)
for argument in "$@"; do
  case "$argument" in
    --tests) packages+=(xvfb xdotool imagemagick x11-utils libgl1-mesa-dri clang-format-14 clang-tidy-14
                          libclang-rt-dev) ;;
    *) echo "install_packages.sh: unknown argument $argument (known: --tests)" >&2; exit 2 ;;
  esac
done

if ! command -v dpkg-query >/dev/null; then
  echo "install_packages.sh: this is no Debian system; install by hand what CMake asks for." >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then exit 0; fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "install_packages.sh: packages are missing and installing them needs root; run:" \
      "apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

# env: sudo drops variables.
install_missing() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}
echo "Installing ${#missing[@]} packages: ${missing[*]}"
if ! install_missing; then
  echo "Installing failed; trying once more in 10 s." >&2
  sleep 10
  install_missing || { echo "install_packages.sh: apt-get could not install: ${missing[*]}" >&2; exit 1; }
fi
