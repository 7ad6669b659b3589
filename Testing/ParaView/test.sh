#!/bin/sh
# Builds the plugin for a ParaView that is there, and runs its tests: test.sh PVBATCH
# Skips where there is none, or one without headers.
set -eu
if [ ! -x "$1" ]; then
  echo "Skipped: no ParaView; VTKTERRAIN_PVBATCH names one, Testing/ParaView/run.sh unpacks one"
  exit 77
fi
prefix=$(dirname "$(dirname "$(readlink -f "$1")")")
if [ -z "$(find "$prefix"/lib* -name paraview-config.cmake)" ]; then
  echo "Skipped: the ParaView below $prefix has no headers (Debian: paraview-dev)"
  exit 77
fi
exec sh "$(dirname "$0")/run.sh" "$prefix"
