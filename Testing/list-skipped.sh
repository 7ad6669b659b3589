#!/bin/sh
# What the last run of ctest skipped, and why: reasons, each with its tests.
#   sh Testing/list-skipped.sh BUILD_DIR
set -eu
awk '
  function note(name, reason) {
    if (!((name, reason) in seen)) {
      seen[name, reason] = 1
      if (!(reason in tests)) { order[++reasons] = reason }
      tests[reason] = tests[reason] " " name
      ++counts[reason]
      ++count
    }
  }
  /^[0-9]+\/[0-9]+ Testing: / { test = $3 }
  # GoogleTest: file:line: Skipped, the words, [  SKIPPED ] Suite.Name (0 ms)
  / Skipped$/ { getline; words = $0 ~ /^\[/ ? "no reason given" : $0 }
  /^\[  SKIPPED \] [^ ]+ \(/ { note(test ~ /-/ ? $4 substr(test, index(test, "-")) : $4, words) }
  # programs and scripts
  /^Skipped: / { note(test, substr($0, 10)) }
  END {
    if (count) { print "Skipped, in part or in whole:" }
    for (i = 1; i <= reasons; ++i) {
      print "- " order[i] " (" counts[order[i]] "):" tests[order[i]]
    }
  }
' "$1/Testing/Temporary/LastTest.log" | fold -s -w 118
