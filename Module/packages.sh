#!/bin/sh
# Installs those Debian packages that the module needs and that are missing; does nothing, quickly, if
# none is.
#   sh Module/packages.sh [PACKAGE...]     the packages named are needed too
set -eu

needed="
  cmake
  g++
  libcli11-dev
  libegl-dev
  libegl1
  libgdal-dev
  libgeographiclib-dev
  libgl1-mesa-dri
  libglm-dev
  libgtest-dev
  libosmesa6
  libvtk9-dev
  ninja-build
"

if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
  echo "No apt here: what these Debian packages hold must be there already:" $needed "$@" >&2
  exit 0
fi

installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' $needed "$@" 2>/dev/null |
  sed -n 's/ installed$//p')
missing=""
for package in $needed "$@"; do
  printf '%s\n' "$installed" | grep -qxF -e "$package" || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=""
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null 2>&1; then
    echo "Missing packages, and neither root nor sudo to install them:$missing" >&2
    exit 1
  fi
  as_root="sudo"
fi

# Lists of packages are fetched where apt has none yet, or where they have become too old to install from.
install_missing()
{
  $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet=2 --no-install-recommends -o Dpkg::Use-Pty=0 $missing
}
has_candidates()
{
  for package in $missing; do
    apt-cache policy "$package" | grep -q '^  Candidate: [^(]' || return 1
  done
}

echo "Installing Debian packages:$missing"
if has_candidates && install_missing >/dev/null 2>&1; then
  exit 0
fi
$as_root apt-get update --quiet=2
install_missing >/dev/null
