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
for options in -O2 "-O2 -fno-tree-slp-vectorize"; do
  # shellcheck disable=SC2086
  "${CXX:-g++}" $options "$folder/round.cxx" -o "$folder/round"
  echo "$options: $("$folder/round")"
done
