#!/bin/sh
# Runs a command with a display of its own, which never resets: with-display.sh COMMAND...
set -eu
if ! command -v Xvfb >/dev/null 2>&1; then
  echo "Skipped: no Xvfb (Debian: xvfb)" >&2
  exit 77
fi
folder=$(mktemp -d)
mkfifo "$folder/display"
Xvfb -displayfd 3 -noreset -nolisten tcp -screen 0 1024x768x24 3>"$folder/display" 2>"$folder/log" &
server=$!
trap 'kill "$server"; rm -rf "$folder"' EXIT
read -r number <"$folder/display"
DISPLAY=:$number "$@"
