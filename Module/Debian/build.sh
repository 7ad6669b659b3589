#!/usr/bin/env bash
# Builds the Debian packages, from the files that git has, and leaves them in DIR. Installs what it takes.
#   bash Module/Debian/build.sh DIR
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1"
dist=$(cd "$1" && pwd)
version=$(sed -n 's/^project(vtkTerrain VERSION \([0-9.]*\).*/\1/p' "$source_dir/CMakeLists.txt")

sh "$source_dir/Module/packages.sh" build-essential debhelper dh-python python3-dev python3-all
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/vtkterrain-$version
mkdir "$tree"
git -C "$source_dir" archive HEAD | tar -x -C "$tree"
tar -C "$work" -czf "$work/vtkterrain_$version.orig.tar.gz" "vtkterrain-$version"
cp -r "$source_dir/Module/Debian/debian" "$tree/"
sed -i "1s/(.*)/($version-1)/" "$tree/debian/changelog"
cd "$tree"
dpkg-buildpackage -us -uc -j"$(nproc)"
cp "$work"/*.deb "$work"/*.dsc "$work"/*.orig.tar.gz "$work"/*.debian.tar.* "$dist/"
