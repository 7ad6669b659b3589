#!/bin/sh
# Prints the place that apt has Debian's packages from.
set -eu
apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | sed -n 1p
