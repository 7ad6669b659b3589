#!/usr/bin/env bash
# What is done in a clean room, see run.sh.
#   bash inside.sh PYTHON ROOM WHEEL SOURCE PACKAGES
set -euo pipefail
python=$1 room=$2 wheel=$3 source_dir=$4 packages=$5
rm -rf "$room"
mkdir -p "$room/output"
cd "$room"
export PYTHONDONTWRITEBYTECODE=1 VTKTERRAIN_TEST_OUTPUT_DIR=$room/output
export VTKTERRAIN_BASELINE_DIR=$source_dir/Testing/Data/Baseline

for tool in cc gcc c++ g++ cmake; do
  [ "$room" != /room ] || ! command -v $tool || exit 1 # a bare machine has none
done

# As a new user: one command to install, one to draw.
begin=$(date +%s)
"$python" -m venv venv
export PATH=$room/venv/bin:$PATH
pip install -q --disable-pip-version-check "${wheel}[files]"
python "$source_dir/Examples/Python/render.py" "$source_dir/Examples/Places/heights.tif" render.png
echo "From nothing to the first picture: $(($(date +%s) - begin)) s"

# Without GDAL, what needs none works, and the reader names the remedy.
python -m venv without
without/bin/pip install -q --disable-pip-version-check "$wheel"
without/bin/python "$source_dir/Testing/Wheel/without_gdal.py"

pip install -q --disable-pip-version-check "${wheel}[browser]" $packages
[ "$room" != /room ] || bash "$source_dir/Testing/Wheel/refusals.sh" "$python" "$wheel" "$source_dir"
failed=0
for test in "$source_dir"/Testing/Python/TestPython*.py; do
  name=$(basename "$test" .py)
  status=0
  timeout 600 python "$test" >"output/$name.log" 2>&1 || status=$?
  case $status in
    0) echo "$name: $(grep -E '^Ran ' "output/$name.log")" ;;
    77) echo "$name: skipped" ;;
    *)
      failed=1
      echo "$name: failed"
      tail -40 "output/$name.log"
      ;;
  esac
done

python "$source_dir/Testing/Wheel/snippets.py" "$source_dir" output || failed=1
cp "$source_dir/Examples/Python/notebook.ipynb" "$source_dir/Examples/Places/heights.tif" .
jupyter nbconvert --to notebook --execute --output executed notebook.ipynb >output/notebook.log 2>&1 || {
  failed=1
  tail -20 output/notebook.log
}
exit $failed
