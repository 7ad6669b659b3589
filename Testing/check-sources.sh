#!/bin/sh
# House rules that a machine can see, on the files git tracks. Prints every offence; fails if there is one.
set -eu
cd "$(dirname "$0")/.."
failed=0
offence()
{
  echo "$1" >&2
  failed=1
}

cxx=$(git ls-files '*.h' '*.cxx')
glsl=$(git ls-files '*.glsl')
python=$(git ls-files '*.py')
maximum_lines=600
maximum_function=60

# shellcheck disable=SC2086 # file names here have no spaces
clang-format-16 --dry-run -Werror $cxx || failed=1

for file in $cxx $glsl $python; do
  grep -q 'SPDX-License-Identifier: BSD-3-Clause' "$file" || offence "$file: no SPDX licence line"
  lines=$(wc -l <"$file")
  [ "$lines" -le "$maximum_lines" ] || offence "$file: $lines lines, at most $maximum_lines"
done
# From the line that begins with its type to the brace at its end.
# shellcheck disable=SC2086
long=$(awk -v most="$maximum_function" '
  FNR == 1 { head = 0; open = 0 }
  /^[A-Za-z_]/ { head = FNR }
  /^(namespace|struct|class|enum|union|extern)/ { head = 0 }
  /^\{$/ { open = head }
  /^\}/ {
    if (open && FNR - open + 1 > most) print FILENAME ":" open ": " FNR - open + 1 " lines, at most " most
    open = 0
    head = 0
  }' $cxx $glsl)
[ -z "$long" ] || offence "$long"
# Prose of the pages; tables, code and lines of links are as long as they are.
for file in $(git ls-files '*.md'); do
  if awk -v name="$file" '
    /^```/ { code = !code }
    !code && !/^\|/ && !/^!?\[/ && length($0) > 132 {
      print name ":" FNR ": " length($0) " columns, at most 132"
    }' "$file" | grep . >&2; then
    failed=1
  fi
done
# clang-format leaves comments alone, for it would run the rows of tables together, and shaders too.
# shellcheck disable=SC2086
! grep -nE '^.{101,}$' $cxx $glsl >&2 || offence "lines longer than 100 columns"
# shellcheck disable=SC2086
! grep -nE '^ *(\*|///?) .* \| \| ' $cxx >&2 || offence "rows of a table run together"
for file in $glsl; do
  ! LC_ALL=C grep -nP '[^\x00-\x7F]' "$file" >&2 || offence "$file: not ASCII"
  ! grep -n '__' "$file" >&2 || offence "$file: two underscores in a row are reserved in GLSL"
  case $(basename "$file") in
    vtkTerrain*.glsl) ;;
    *) offence "$file: shader files are called vtkTerrain<Concept>.glsl" ;;
  esac
done
# A function of shaders has a twin of its name in the files that its shader's opening comment names
# as twins, in a paragraph "Twins in src/core/: room/File.h ...", or a reason why it has none.
# The files that a shader names, with their .cxx.
twins_of()
{
  awk '!/^\/\// { exit } /^\/\/$/ { on = 0 } /^\/\/ Twins in src\/core\/:/ { on = 1 } on' "$1" |
    grep -oE '\b[a-z]+/[A-Za-z]+\.h\b' | while read -r header; do
    [ -f "src/core/$header" ] || echo "$1: no twin src/core/$header" >&2
    ls "src/core/$header" "src/core/${header%.h}.cxx" 2>/dev/null || true
  done
}
# Functions that files declare or define: a type comes before the name, and no call does.
functions_in()
{
  cat "$@" /dev/null |
    grep -E '^ *[A-Za-z][A-Za-z0-9_:<>, ]*[ &*>]([A-Za-z]+(<[A-Za-z, ]+>)?::)*[A-Z][A-Za-z0-9]*\(' |
    grep -vE '^ *(return|else|new|throw|case) ' | grep -oE '^[^(]*\(' | grep -oE '[A-Za-z0-9]+\($'
}
reasons=Testing/shaders-without-twin.txt
for file in $glsl; do
  # shellcheck disable=SC2046
  names=$(functions_in $(twins_of "$file") | sort -u)
  for function in $(sed -nE 's/^[a-z0-9A-Z]+ (terrain[A-Z][A-Za-z0-9]*)\(.*/\1/p' "$file" | sort -u); do
    name=${function#terrain}
    if printf '%s\n' "$names" | grep -qxF -e "$name(" -e "${name#Globe}("; then
      ! grep -qx "$function" "$reasons" || offence "$reasons: $function of $file has a twin"
    else
      grep -qx "$function" "$reasons" ||
        offence "$file: no function $name in the twins it names, nor in $reasons"
    fi
  done
done
for function in $(grep '^terrain' "$reasons"); do
  # shellcheck disable=SC2086
  grep -q "\b$function(" $glsl || offence "$reasons: no function $function"
done
# unittest's own end differs between Pythons where every test is skipped.
for file in $(git ls-files 'Testing/Python/TestPython*.py'); do
  grep -q '^    vtkTerrainTesting\.run()$' "$file" || offence "$file: does not end by vtkTerrainTesting.run()"
done
# src/ itself has the public classes, a pair of files each; all else is in rooms.
for file in $(git ls-files 'src/*.h' 'src/*.cxx' | grep -v '^src/.*/'); do
  case $file in
    *.h) pair=${file%.h}.cxx ;;
    *) pair=${file%.cxx}.h ;;
  esac
  [ -f "$pair" ] || offence "$file: no part of a pair; private files are in rooms"
done
# Who may include whom (docs/architecture.md): a room those of the line below it, and itself.
rooms_for()
{
  case $1 in
    core) echo core ;;
    data) echo core data ;;
    raster) echo core data raster ;;
    place) echo core data raster place vtkTerrainGeoid.h vtkTerrainGeoreference.h vtkTerrainReproject.h ;;
    windows) echo core windows ;;
    render) echo core data render vtkTerrainLook.h ;;
    parts) echo core data raster place render parts "$(cd src && echo vtk*.h)" ;;
    *) echo "src/$1 is no room that Testing/check-sources.sh knows" >&2 ;;
  esac
}
for file in $(git ls-files 'src/*/*.h' 'src/*/*.cxx'); do
  room=${file#src/}
  allowed=" $(rooms_for "${room%%/*}") "
  for included in $(sed -n 's/^ *# *include "\([^"]*\)".*/\1/p' "$file"); do
    case $included in
      vtkTerrain*.h)
        # made from shaders/, or a public class
        [ -f "shaders/${included%.h}.glsl" ] || part=$included ;;
      vtk*) [ "${room%%/*}" != core ] || part=$included ;;
      *) part=${included%%/*} ;;
    esac
    case $allowed in
      *" ${part:-core} "*) ;;
      *) offence "$file: its room may not include $included" ;;
    esac
    part=
  done
done
# Names (docs/architecture.md): functions begin with a capital; outside the tests constants of a file
# begin with k, those of a class as its members.
# shellcheck disable=SC2046
names=$(awk '
  FNR == 1 { head = "" }
  /^[A-Za-z_]/ { head = $0 }
  /^\{$/ {
    sub(/\(.*/, "", head)
    count = split(head, words, /[ *&]/)
    if (head !~ /^(namespace|struct|class|enum|union|extern)/ && words[count] ~ /^[a-z][A-Za-z0-9]*$/ &&
      words[count] !~ /^(main|vtk.*)$/) print FILENAME ": " words[count] "() begins with a capital"
  }
  /^(inline |static )*const(expr)? [^;(]*[={[]/ && !/^const char\* [A-Z]/ && FILENAME !~ /^Testing/ {
    name = $0
    sub(/ ?[={[].*/, "", name)
    sub(/.*[ *&]/, "", name)
    if (name !~ /^k[A-Z]/) print FILENAME ": " name " begins with k, as constants do"
  }
  /^  (inline )?static constexpr .* k[A-Z][A-Za-z]* *[={]/ && FILENAME ~ /\.h$/ && FILENAME !~ /^Testing/ {
    name = $0
    sub(/ *[={].*/, "", name)
    sub(/.*[ *&]/, "", name)
    print FILENAME ": " name " is a constant of a class, which begins like a member"
  }' $(git ls-files '*.h' '*.cxx'))
[ -z "$names" ] || offence "$names"
# Files include one another in no circle. A header and its .cxx count as one, and so do a class and
# the header of its private half (XxxInternals.h), which defines a class within it.
# shellcheck disable=SC2086
circles=$(echo "$cxx" | awk '
  function unit(file) {
    sub(/\.(h|cxx)$/, "", file)
    if (sub(/Internals$/, "", file)) sub(/.*\//, file ~ /OpenGL/ ? "src/vtk" : "src/vtkTerrain", file)
    return file
  }
  NR == FNR { known[$1] = 1; next }
  /^ *# *include "/ {
    split($0, part, "\"")
    folder = FILENAME
    sub(/[^\/]*$/, "", folder)
    count = split("src/ Examples/Programs/Common/ " folder, folders, " ")
    for (k = 1; k <= count; ++k)
      if ((folders[k] part[2]) in known && unit(folders[k] part[2]) != unit(FILENAME))
        print unit(FILENAME), unit(folders[k] part[2])
  }' - $cxx | tsort 2>&1 >/dev/null) || true
[ -z "$circles" ] || offence "these include one another in a circle:
$circles"
# Core's own rooms, in the order in which they stand on one another: none includes a later one.
core_rooms_for()
{
  case $1 in
    grid | files | colors) echo "$1" ;;
    surface | place | mesh | landscape) echo "grid $1" ;;
    rays) echo "grid surface $1" ;;
    strips) echo "grid files surface $1" ;;
    globe) echo "grid surface place rays $1" ;;
    *) echo "src/core/$1 is no room that Testing/check-sources.sh knows" >&2 ;;
  esac
}
for file in $(git ls-files 'src/core/*/*'); do
  room=${file#src/core/}
  allowed=" $(core_rooms_for "${room%%/*}") "
  for part in $(sed -n 's/^ *# *include "core\/\([^/"]*\)\/.*/\1/p' "$file" | sort -u); do
    case $allowed in
      *" $part "*) ;;
      *) offence "$file: its room may not include core/$part/" ;;
    esac
  done
done
part=
# Who exaggerates: a grid's geometry, and the frame of a round scene. Others ask these.
for file in $(git ls-files 'src/*.h' 'src/*.cxx' 'Module/ParaView/*.cxx' 'Examples/Programs/*.cxx'); do
  case $file in
    src/core/grid/Coordinates.h | src/core/place/SceneFrame.h) ;;
    *)
      ! grep -nE '[Ee]xaggeration(\(\))? +[*/] |[*/] +[A-Za-z.>-]*[Ee]xaggeration' "$file" |
        grep -vE '^[0-9]+: *(\*|//)' >&2 || offence "$file: only GridGeometry exaggerates" ;;
  esac
done
for file in $(git ls-files 'src/core/*'); do
  ! grep -nE '#include [<"](vtk|GL/|EGL/|gdal)' "$file" >&2 ||
    offence "$file: src/core/ includes neither VTK, OpenGL nor GDAL"
done
for file in $(git ls-files 'src/*.h' 'src/*.cxx'); do
  case $file in
    */Compatibility.h) ;;
    *) ! grep -nE '^ *# *if.*VTK_(MAJOR_|MINOR_)?VERSION' "$file" >&2 ||
      offence "$file: VTK versions are told apart in Compatibility.h alone" ;;
  esac
done
# shellcheck disable=SC2086
! grep -nE '\b(TODO|FIXME|XXX)\b' $cxx $glsl $python >&2 || offence "marks of unfinished work"
for file in $(git ls-files); do
  bytes=$(wc -c <"$file")
  [ "$bytes" -le 400000 ] || offence "$file: $bytes bytes, at most 400000"
done
# The README's code is that of the examples, which are run.
check_snippet()
{
  language=$1
  example=$2
  sed -n '/^```'"$language"'$/,/^```$/p' README.md | grep -v '^```' | sed 's/^ *//' | grep -v '^$' |
    while read -r line; do
      sed 's/^ *//' "$example" | grep -qxF -e "$line" || echo "README.md: not in $example: $line"
    done | grep . >&2 && failed=1
  return 0
}
check_snippet cpp Examples/Pipeline/main.cxx
check_snippet python Examples/Python/render.py
python3 Testing/Mutations/run.py build --check >&2 || offence "Testing/Mutations/mutations.ini: texts that are not there"
exit $failed
