"""Drapes by the service: submitted over HTTP and by `toile submit`, with every result."""

import garments
import meshes


def collect(c):
    service = c.serve("data", "--no-sample", "--workers", "1")
    there = c.folder / c.sample()
    files = {"skirt.dxf": service.upload("dxf", "skirt.dxf", (there / "skirt.dxf").read_bytes()),
             "body.obj": service.upload("body", "body.obj", (there / "body.obj").read_bytes())}
    skirt = service.make(c.sample_document(), files)
    post = {"post.obj": service.upload("body", "post.obj", meshes.as_obj(meshes.POST).encode())}
    napkin = service.make(garments.napkin(), post)
    inside = garments.napkin()
    inside["pieces"][0]["placement"]["rigid"]["translation"] = [-0.15, 0.25, 0.15]
    refused = service.make(inside, post)
    stalled = service.make(garments.too_narrow(), post)
    for name, project in {"skirt": skirt, "napkin": napkin, "stalled": stalled, "refused": refused}.items():
        collect_job(c, service, name, project)
    collect_paused(c, service, napkin)
    record(c, service, "jobs", "GET", "/api/v1/jobs")
    collect_submit(c, service)


def record(c, service, name, *request):
    answer = service.ask(*request)
    c.recorder.text(name, answer.as_bytes(), ids=service.ids)
    return answer


def collect_job(c, service, name, project):
    job = service.submit(project)
    service.wait_for(job)
    there = f"/api/v1/jobs/{job}"
    record(c, service, f"{name} job", "GET", there)
    listed = record(c, service, f"{name} results", "GET", there + "/results").json["results"]
    for result in listed:
        answer = service.ask("GET", result["href"])
        if result["name"].endswith(".json"):
            c.recorder.text(f"{name} {result['name']}", answer.body)
        else:
            c.recorder.bytes(f"{name} {result['name']}", answer.body)
    record(c, service, f"{name} no such result", "GET", there + "/results/none.obj")
    record(c, service, f"{name} body", "GET", there + "/body")
    for wish in ("pause", "resume", "cancel"):
        record(c, service, f"{name} {wish} after its end", "POST", f"{there}/{wish}")


def collect_paused(c, service, project):
    """One that waits while another is under way can be paused, resumed and cancelled."""
    long = service.make(garments.napkin(particle_distance_mm=6, settle_speed_mm_s=0.001, max_time_s=60),
                        service.ask("GET", f"/api/v1/projects/{project}").json["files"])
    blocker = service.submit(long)
    service.wait_for(blocker, ("running",))
    waiting, given_up = service.submit(project), service.submit(project)
    for wish in ("resume", "pause", "pause", "resume"):
        answer = service.ask("POST", f"/api/v1/jobs/{waiting}/{wish}")
        name = f"{wish} a waiting job"
        again = " again" if name in c.recorder.outputs else ""
        c.recorder.text(name + again, answer.as_bytes(), ids=service.ids)
    record(c, service, "cancel a waiting job", "POST", f"/api/v1/jobs/{given_up}/cancel")
    service.ask("POST", f"/api/v1/jobs/{blocker}/cancel")
    service.wait_for(waiting)
    c.recorder.bytes("final.obj of the one that waited",
                     service.ask("GET", f"/api/v1/jobs/{waiting}/results/final.obj").body)


def collect_submit(c, service):
    textured = garments.napkin()
    textured["pieces"][0]["texture"] = {"image": "checks.png", "scale_mm": 40}
    garments.write_napkin(c, "textured", textured)
    c.write("textured/checks.png", garments.checks_png())
    to = ("--server", service.url)
    c.run("submit and watch", "submit", "textured/project.json", *to, "--watch", "--out", "out", ids=service.ids)
    c.recorder.folder("submit left", c.folder / "out")
    garments.write_napkin(c, "unsettled", garments.napkin(max_time_s=0.02))
    c.run("submit unsettled json", "submit", "unsettled/project.json", *to, "--watch", "--json", ids=service.ids)
    broken = garments.napkin()
    broken["pieces"][0]["outline"][3]["points"][1] = [0, 7]
    garments.write_napkin(c, "broken", broken)
    c.run("submit broken", "submit", "broken/project.json", *to, "--watch", ids=service.ids)
    c.run("submit", "submit", "unsettled/project.json", *to, ids=service.ids)
    c.run("submit json", "submit", "unsettled/project.json", *to, "--json", ids=service.ids)
