#!/bin/sh
# Builds the reference of the public classes, as pages for a browser; a warning of Doxygen is an error.
#   sh docs/reference.sh [FOLDER]     default build/reference
set -eu
cd "$(dirname "$0")/.."
folder=${1:-${VTKTERRAIN_BUILD_DIR:-build}/reference}
sh Module/packages.sh doxygen
rm -rf "$folder"
mkdir -p "$folder"
{
  cat docs/Doxyfile
  echo "OUTPUT_DIRECTORY = $folder"
} | doxygen -
echo "$folder/html/index.html"
