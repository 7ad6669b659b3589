#!/bin/sh
# Installs those Debian packages that the module needs and that are missing; does nothing, quickly, if
# none is.
#   sh Module/packages.sh [PACKAGE...]     the packages named are needed too
set -eu

needed="
  cmake
  g++
  libbenchmark-dev
  libcli11-dev
  libegl-dev
  libegl1
  libgdal-dev
  libgeographiclib-dev
  libgl1-mesa-dri
  libglm-dev
  libgtest-dev
  libvtk9-dev
  ninja-build
  nlohmann-json3-dev
  python3-numpy
  python3-vtk9
"
# Installed where there is one: Mesa 25.1 has dropped OSMesa, and with it the package.
optional="
  libosmesa6
"

if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
  echo "No apt here: what these Debian packages hold must be there already:" $needed "$@" >&2
  exit 0
fi

installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' $needed $optional "$@" 2>/dev/null |
  sed -n 's/ installed$//p')
is_installed()
{
  printf '%s\n' "$installed" | grep -qxF -e "$1"
}
is_available()
{
  apt-cache policy "$1" | grep -q '^  Candidate: [^(]'
}
are_available()
{
  for package in "$@"; do
    is_available "$package" || return 1
  done
}
missing=""
for package in $needed "$@"; do
  is_installed "$package" || missing="$missing $package"
done

as_root=""
[ "$(id -u)" -eq 0 ] || as_root="sudo"
install_missing()
{
  $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet=2 --no-install-recommends -o Dpkg::Use-Pty=0 $missing
}

check_rights()
{
  if [ -n "$as_root" ] && ! command -v sudo >/dev/null 2>&1; then
    echo "Missing packages, and neither root nor sudo to install them:$missing" >&2
    exit 1
  fi
}

updated=false
if ! are_available $missing; then
  check_rights
  $as_root apt-get update --quiet=2 # apt has no lists of packages yet
  updated=true
fi
for package in $optional; do
  if ! is_installed "$package" && is_available "$package"; then
    missing="$missing $package"
  fi
done
[ -n "$missing" ] || exit 0

check_rights
echo "Installing Debian packages:$missing"
if ! $updated && install_missing >/dev/null 2>&1; then
  exit 0
fi
$updated || $as_root apt-get update --quiet=2 # the lists may be too old to install from
install_missing >/dev/null
