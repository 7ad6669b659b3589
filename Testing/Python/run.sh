#!/bin/sh
# Runs a test with the Python of an environment, if it has been made, else with another.
#   sh run.sh ENVIRONMENT PYTHON TEST
if [ -e "$1/made-of" ]; then
  exec "$1/bin/python" "$3"
fi
exec "$2" "$3"
