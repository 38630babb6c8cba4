#!/bin/bash
# Drafts the samples anew (toile sample), drapes them, and draws their pictures: samples/NAME, and the contact
# sheet docs/samples.jpg. Results stay in build/samples. With names only those; the sheet is of all that are
# in build/samples.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/build.sh
build_preset release toile make_sample_pictures
toile=build/release/toile
all=$("$toile" sample | cut -d' ' -f1)
for name in ${@:-$all}; do
  echo "== $name"
  "$toile" sample "$name" --out "samples/$name"
  "$toile" drape "samples/$name/project.json" --out "build/samples/$name" --size 720x900
done
build/release/make_sample_pictures build/samples samples docs/samples.jpg $all
