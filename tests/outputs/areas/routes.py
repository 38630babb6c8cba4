"""The service's routes, but for edits and jobs."""

import garments
import masks
import meshes

HERE = {"If-Match": "*"}


class Asking:
    """Requests whose answers are outputs."""

    def __init__(self, collection, service):
        self.recorder = collection.recorder
        self.service = service

    def __call__(self, name, method, target, body=None, headers=None, more=()):
        answer = self.service.ask(method, target, body, headers)
        self.recorder.text(name, answer.as_bytes(), ids=self.service.ids, more=more)
        return answer


def collect(c):
    c.write("page/index.html", "<!doctype html><title>A page</title>")
    service = c.serve("data", "--no-sample", "--web", "page", "--workers", "1")
    c.recorder.text("greeting", service.greeting)
    ask = Asking(c, service)
    sample = c.folder / c.sample()
    ids = collect_assets(ask, sample)
    project = collect_projects(ask, c.sample_document(), ids)
    collect_bodies(ask, f"/api/v1/projects/{project}", ids)
    collect_places(ask, f"/api/v1/projects/{project}")
    collect_ends(ask, f"/api/v1/projects/{project}")
    collect_refusals(ask, c.sample_document())
    collect_server(ask)
    code = service.stop()
    c.recorder.text("after a stop", b"exit code %d\n" % code + service.rest)


def collect_assets(ask, sample):
    """Every kind of file; their ids by name."""
    files = {"skirt.dxf": ("dxf", (sample / "skirt.dxf").read_bytes()),
             "body.obj": ("body", (sample / "body.obj").read_bytes()),
             "checks.png": ("image", garments.checks_png())}
    files.update((name, ("body", data if isinstance(data, bytes) else data.encode()))
                 for name, data in meshes.FILES.items())
    ids = {}
    for name, (kind, data) in files.items():
        made = ask(f"upload {name}", "POST", f"/api/v1/assets?kind={kind}&name={name}", data)
        if made.status == 201:
            ids[name] = made.json["id"]
    ask("upload again", "POST", "/api/v1/assets?kind=dxf&name=skirt.dxf", files["skirt.dxf"][1])
    ask("upload a body", "POST", "/api/v1/bodies?name=other.obj", files["post.obj"][1])
    ask("assets", "GET", "/api/v1/assets")
    ask("assets of a kind", "GET", "/api/v1/assets?kind=image")
    ask("bodies", "GET", "/api/v1/bodies")
    for name in ("skirt.dxf", "checks.png", "body.obj"):
        ask(f"asset {name}", "GET", f"/api/v1/assets/{ids[name]}")
        ask(f"content of {name}", "GET", f"/api/v1/assets/{ids[name]}/content")
    ask("import", "POST", "/api/v1/imports", {"asset": ids["skirt.dxf"]})
    ask("import in inches", "POST", "/api/v1/imports", {"asset": ids["skirt.dxf"], "unit": "inch"})
    for name in ("body.obj", "post.obj", "torn.obj"):
        ask(f"figure of {name}", "GET", f"/api/v1/bodies/{ids[name]}/figure")
    ask("presets", "GET", "/api/v1/bodies/presets")
    made = ask("mannequin", "POST", "/api/v1/bodies/mannequins",
               {"mannequin": {"preset": "eu38", "waist_cm": 70, "triangles": 3000}, "name": "anna.obj"})
    ids["anna.obj"] = made.json["asset"]["id"]
    ask("content of the mannequin", "GET", f"/api/v1/assets/{ids['anna.obj']}/content")
    ask("mannequin that nobody is", "POST", "/api/v1/bodies/mannequins", {"mannequin": {"waist_cm": 240}})
    return ids


def collect_projects(ask, document, ids):
    """Made, shown, replaced and removed; the id of one that stays."""
    files = {name: ids[name] for name in ("skirt.dxf", "body.obj")}
    whole = {"document": document, "files": files}
    key = {"Idempotency-Key": "one-and-the-same"}
    made = ask("make a project", "POST", "/api/v1/projects", whole, key)
    project = made.json["id"]
    there = f"/api/v1/projects/{project}"
    ask("make it again", "POST", "/api/v1/projects", whole, key)
    ask("make another by its key", "POST", "/api/v1/projects", {**whole, "name": "Another"}, key)
    second = ask("make a named one", "POST", "/api/v1/projects", {**whole, "name": "Second"}).json["id"]
    ask("projects", "GET", "/api/v1/projects")
    page = ask("projects by pages", "GET", "/api/v1/projects?limit=1").json
    ask("the next page", "GET", f"/api/v1/projects?limit=1&cursor={page['next']}",
        more=[masks.Field("cursor", rb'"next": *"(?P<value>[^"]*)"')])
    ask("project", "GET", there)
    ask("project unchanged", "GET", there, None, {"If-None-Match": '"1"'})
    ask("replace", "PUT", there, {**whole, "name": "Replaced"}, {"If-Match": '"1"'})
    ask("replace another revision", "PUT", there, whole, {"If-Match": '"1"'})
    ask("replace without a revision", "PUT", there, whole)
    ask("remove", "DELETE", f"/api/v1/projects/{second}")
    ask("remove again", "DELETE", f"/api/v1/projects/{second}")
    ask("proposals", "GET", there + "/proposals")
    plain = {**document, "seams": []}
    bare = ask("make one without seams", "POST", "/api/v1/projects", {"document": plain, "files": files}).json["id"]
    ask("proposals for all", "GET", f"/api/v1/projects/{bare}/proposals")
    return project


def collect_bodies(ask, there, ids):
    ask("bodies of the project", "GET", there + "/bodies")
    ask("mesh of the bodies", "GET", there + "/body")
    body = there + "/bodies/body"
    ask("a mannequin instead", "PUT", body, {"mannequin": {"preset": "eu40", "hip_cm": 104}, "skin_offset_mm": 3}, HERE)
    ask("mesh of the mannequin", "GET", there + "/body")
    ask("move a landmark", "PUT", body + "/landmarks/waist_front", {"place": [0.0, 1.05, 0.2]}, HERE)
    ask("add a landmark", "PUT", body + "/landmarks/pocket", {"place": [0.15, 0.9, 0.1]}, HERE)
    ask("bodies with landmarks", "GET", there + "/bodies")
    ask("other measures", "PUT", body, {"mannequin": {"preset": "eu44", "height_cm": 175}}, HERE)
    ask("landmarks of other measures", "GET", there + "/bodies")
    ask("put a landmark back", "DELETE", body + "/landmarks/waist_front", None, HERE)
    ask("take a landmark away", "DELETE", body + "/landmarks/pocket", None, HERE)
    ask("take one away that is not there", "DELETE", body + "/landmarks/pocket", None, HERE)
    ask("a second body", "PUT", there + "/bodies/post", {"asset": ids["post.obj"], "unit": "m", "turn": 30}, HERE)
    ask("without the second body", "DELETE", there + "/bodies/post", None, HERE)
    ask("the file again", "PUT", body, {"asset": ids["body.obj"], "friction": 0.5}, HERE)


def collect_places(ask, there):
    ask("check", "GET", there + "/check")
    ask("start", "GET", there + "/start")
    ask("pieces", "GET", there + "/pieces")
    ask("place a piece", "POST", there + "/place",
        {"piece": "front", "part": "hips", "side": "front", "at_mm": [10, -200], "away_mm": 60, "turn": 10}, HERE)
    ask("place a piece wrapped", "POST", there + "/place",
        {"piece": "back", "part": "hips", "side": "back", "wrapped": True, "with_partner": True}, HERE)
    ask("place no piece", "POST", there + "/place", {"piece": "sleeve"}, HERE)
    ask("check of what was placed", "GET", there + "/check")
    ask("start of what was placed", "GET", there + "/start")
    ask("arrange", "POST", there + "/arrange", None, HERE)
    ask("check of what was arranged", "GET", there + "/check")
    ask("start of what was arranged", "GET", there + "/start")


def collect_ends(ask, there):
    """What the steps above left."""
    ask("project at the end", "GET", there)
    ask("history at the end", "GET", there + "/edits")


def collect_refusals(ask, document):
    ask("no such route", "GET", "/api/v1/nothing")
    ask("no such method", "DELETE", "/api/v1/projects")
    for kind, letter in (("projects", "p"), ("jobs", "j")):
        ask(f"no such one of {kind}", "GET", f"/api/v1/{kind}/{letter}_00000000000000000000")
        ask(f"no id of {kind}", "GET", f"/api/v1/{kind}/x")
    ask("no such asset", "GET", "/api/v1/assets/a_" + 32 * "0")
    ask("asset of no kind", "POST", "/api/v1/assets?kind=poem&name=x.txt", b"x")
    ask("asset of a bad name", "POST", "/api/v1/assets?kind=dxf&name=..%2Fx.dxf", b"x")
    ask("asset that is none", "POST", "/api/v1/assets?kind=dxf&name=x.dxf", b"Dear Sir or Madam,")
    ask("image that is none", "POST", "/api/v1/assets?kind=image&name=x.png", b"GIF89a")
    ask("body that is none", "POST", "/api/v1/bodies?name=x.obj", b"")
    ask("specification that is none", "POST", "/api/v1/assets?kind=specification&name=x.json", b"{}")
    ask("no json", "POST", "/api/v1/projects", b"{", {"Content-Type": "application/json"})
    ask("other content", "POST", "/api/v1/projects", b"{}", {"Content-Type": "text/plain"})
    ask("unknown key", "POST", "/api/v1/projects", {"documents": {}})
    ask("bad document", "POST", "/api/v1/projects", {"document": {**document, "toile": 2}, "files": {}})
    ask("document without files", "POST", "/api/v1/projects", {"document": document, "files": {}})
    ask("too large", "POST", "/api/v1/jobs", b" " * 300_000, {"Content-Type": "application/json"})
    ask("bad limit", "GET", "/api/v1/projects?limit=1000")
    ask("bad cursor", "GET", "/api/v1/projects?cursor=x")
    ask("foreign host", "GET", "/api/v1/projects", None, {"Host": "example.com"})
    ask("foreign origin", "POST", "/api/v1/jobs", {"project_id": "x"}, {"Origin": "http://example.com"})
    ask("job of no project", "POST", "/api/v1/jobs", {"project_id": "p_00000000000000000000"})
    ask("stream without a socket", "GET", "/api/v1/jobs/j_00000000000000000000/stream")


def collect_server(ask):
    ask("page", "GET", "/")
    ask("no such page", "GET", "/none.js")
    ask("healthz", "GET", "/healthz")
    ask("readyz", "GET", "/readyz")
    ask("metrics", "GET", "/metrics", more=masks.METRICS)
