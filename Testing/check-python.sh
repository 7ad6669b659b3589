#!/bin/sh
# Lints the Python sources with the ruff of build/python-env (Testing/Python/venv.sh makes it); its rules
# are in pyproject.toml.
#   sh Testing/check-python.sh [BUILD_DIR]
set -eu
cd "$(dirname "$0")/.."
build_dir=${1:-${VTKTERRAIN_BUILD_DIR:-build}}
# shellcheck disable=SC2046 # file names here have no spaces
"$build_dir/python-env/bin/ruff" check --quiet --no-cache $(git ls-files '*.py')
