#!/bin/sh
# Guess:   float x = a.x, y = a.y; then x - b.x in double: the rounding to float is in the result.
# Happens: GCC puts the two numbers into one vector and leaves the rounding out; with
#          -fno-tree-slp-vectorize, or through a function that is not inlined, it is there.
# Where:   whoever asks by how much points of 32 bits are off is told 0.
# Seen:    GCC 12.2.0 of Debian 12 with -O2, 2026-11-30: prints 0 and 0 where 0.0125 and -0.2 are right.
#          clang 16 (CXX=clang++-16) is right.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/round.cxx" <<'END'
#include <cstdio>
struct Pair { double x, y; };
__attribute__((noinline)) Pair Round(Pair a, Pair from)
{
  float x = a.x, y = a.y;
  return { x - from.x, y - from.y };
}
int main()
{
  const Pair place{ 399970.3, 5200010.7 };
  const Pair moved = Round(place, place);
  std::printf("%.4f %.4f\n", moved.x, moved.y);
}
END
"${CXX:-g++}" --version | head -n 1
# Prints what a build with some options says, and sees whether it is what was seen.
status=0
expect()
{
  # shellcheck disable=SC2086 # several options
  "${CXX:-g++}" $2 "$folder/round.cxx" -o "$folder/round"
  said=$("$folder/round")
  echo "$2: $said"
  [ "$said" = "$1" ] || status=1
}
expect "0.0000 0.0000" "-O2"
expect "0.0125 -0.2000" "-O2 -fno-tree-slp-vectorize"
[ "$status" = 0 ] && echo "as described" || echo "CHANGED: the header of this file is out of date"
exit "$status"
