#!/bin/bash
# Hangs each fabric that a maker names as a circle skirt, a tablecloth and a T-shirt, and draws them side by
# side: build/fabrics/NAME.jpg. Results stay in build/fabrics; what is there already
# is not draped again. With names only those. All of it takes some fifteen
# minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/build.sh
build_preset release toile make_sample_pictures
toile=build/release/toile
shapes="circle-skirt tablecloth tshirt"
names=${*:-$("$toile" fabric list | cut -d' ' -f1 | grep -v -e '^wang-' -e '^feng-')}
for name in $names; do
  for shape in $shapes; do
    out=build/fabrics/$name/$shape
    [ -f "$out/front.png" ] && continue
    echo "== $name as $shape"
    mkdir -p "$out"
    # All of the fabric, but for the T-shirt's neckband: stretched to its length no woven cloth would close.
    python3 - "samples/$shape" "$name" <<'PYTHON'
import json, sys
folder, name = sys.argv[1:]
project = json.load(open(f"{folder}/project.json"))
project["settings"]["particle_distance_mm"] = {"circle-skirt": 22, "tablecloth": 20, "tshirt": 15}[folder[8:]]
project["fabrics"] = [{"id": "cloth", "like": name}] + [f for f in project["fabrics"] if f["id"] == "rib"]
project["settings"]["max_time_s"] = 5  # creeping on would change no picture
project["fabric"] = "cloth"
json.dump(project, open(f"{folder}/of-{name}.json", "w"))
PYTHON
    "$toile" drape "samples/$shape/of-$name.json" --out "$out" --size 720x900 >"$out/drape.log" || tail -n 3 "$out/drape.log"
    rm -f "samples/$shape/of-$name.json"
  done
done

for name in $names; do
  build/release/make_sample_pictures --row "build/fabrics/$name" "build/fabrics/$name.jpg" $shapes
done
