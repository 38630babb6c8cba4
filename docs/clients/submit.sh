#!/bin/sh -eu
# submit.sh SERVER FOLDER OUT: has FOLDER's project.json draped, waits, and brings the report and a still to OUT.
api=$1/api/v1 folder=$2 out=$3 auth="Authorization: Bearer ${TOILE_TOKEN:-none}"
ask() { curl -sS --fail-with-body --retry 5 --retry-all-errors -H "$auth" "$@"; }
up() { ask --data-binary "@$folder/$2" -H 'Content-Type: application/octet-stream' "$api/assets?kind=$1&name=$2" | jq -r .id; }
files=$(jq -r '(.pieces[].from.dxf // empty | "dxf " + .), (.bodies[].file // empty | "body " + .), (.pieces[].texture.image // empty | "image " + .)' "$folder/project.json" | sort -u |
  while read -r kind name; do printf '{"%s":"%s"}' "$name" "$(up "$kind" "$name")"; done | jq -s 'add // {}')
project=$(jq -n --slurpfile d "$folder/project.json" --argjson f "$files" '{document: $d[0], files: $f}' | ask -d @- -H 'Content-Type: application/json' -H "Idempotency-Key: $$-$(date +%s)" "$api/projects" | jq -r .id)
job=$(ask -d "{\"project_id\": \"$project\"}" -H 'Content-Type: application/json' -H "Idempotency-Key: $project" "$api/jobs" | jq -r .id)
while state=$(ask "$api/jobs/$job" | jq -r .state); case $state in queued | running | paused) ;; *) false ;; esac; do sleep 0.5; done
mkdir -p "$out" && for name in report.json front.png; do ask -o "$out/$name" "$api/jobs/$job/results/$name"; done
echo "$state" && [ "$(jq .settled "$out/report.json")" = true ]
