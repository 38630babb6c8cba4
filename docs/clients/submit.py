#!/usr/bin/env python3
"""submit.py SERVER FOLDER OUT: has FOLDER's project.json draped, waits, and brings every result to OUT."""
import json, os, sys, time, urllib.parse, urllib.request
server, folder, out = sys.argv[1:4]
def ask(path, body=None, kind="application/json", key=None):
    headers = {"Content-Type": kind, "Authorization": "Bearer " + os.environ.get("TOILE_TOKEN", "none"), **({"Idempotency-Key": key} if key else {})}
    return urllib.request.urlopen(urllib.request.Request(server + "/api/v1" + path, body, headers)).read()
document = json.load(open(os.path.join(folder, "project.json"), encoding="utf-8"))
named = {("dxf", p["from"]["dxf"]) for p in document["pieces"] if "from" in p} | {("body", b["file"]) for b in document["bodies"] if "file" in b} | {("image", p["texture"]["image"]) for p in document["pieces"] if "texture" in p}
files = {name: json.loads(ask(f"/assets?kind={kind}&name={urllib.parse.quote(name)}", open(os.path.join(folder, name), "rb").read(), "application/octet-stream"))["id"] for kind, name in named}
project = json.loads(ask("/projects", json.dumps({"document": document, "files": files}).encode(), key=str(time.time_ns())))["id"]
job = json.loads(ask("/jobs", json.dumps({"project_id": project}).encode(), key=project))
while job["state"] in ("queued", "running", "paused"): time.sleep(0.5); job = json.loads(ask("/jobs/" + job["id"]))
os.makedirs(out, exist_ok=True)
for name in job["results"]: open(os.path.join(out, name), "wb").write(ask(f"/jobs/{job['id']}/results/{name}"))
print(job["state"], job["reason"]); sys.exit(0 if job["state"] == "succeeded" and job["report"]["settled"] else 3)
