"""What a viewer of a drape gets, byte by byte."""

import json
import struct

import garments
import meshes
import websocket

TOPOLOGY, KEY, DELTA = 1, 2, 3
ATTEMPTS = 30


def collect(c):
    service = c.serve("data", "--no-sample", "--workers", "1")
    post = {"post.obj": service.upload("body", "post.obj", meshes.as_obj(meshes.POST).encode())}
    there = c.folder / c.sample()
    files = {"skirt.dxf": service.upload("dxf", "skirt.dxf", (there / "skirt.dxf").read_bytes()),
             "body.obj": service.upload("body", "body.obj", (there / "body.obj").read_bytes())}
    skirt = c.sample_document()
    skirt["settings"]["max_time_s"] = 1.3
    inside = garments.napkin()
    inside["pieces"][0]["placement"]["rigid"]["translation"] = [-0.15, 0.25, 0.15]
    blocker = service.make(garments.napkin(particle_distance_mm=6, settle_speed_mm_s=0.001, max_time_s=60), post)
    # Fine and short: frames that are long in the making are seldom missed.
    napkin = garments.napkin(particle_distance_mm=8, max_time_s=0.6)
    projects = {"napkin": service.make(napkin, post), "skirt": service.make(skirt, files),
                "refused": service.make(inside, post)}
    for name, project in projects.items():
        record(c, service, name, *whole_stream(service, blocker, project))
    collect_nonsense(c, service, blocker, projects["napkin"])


def whole_stream(service, blocker, project):
    """Texts, topologies, frames and the close of a drape. A viewer that the machine kept from reading gets the newest
    frame instead of all, which is right, and later ones as keys. So drapes are watched until each frame was seen in the
    form in which it comes to those who miss none."""
    job, viewer = queued_with_viewer(service, blocker, project)
    texts, topologies, frames, close = read_all(viewer)
    service.wait_for(job)
    seen = {form_of(frame): frame for frame in frames}
    last = form_of(frames[-1])[0] if frames else 0
    wanted = [(seq, KEY if seq % 30 == 1 else DELTA) for seq in range(1, last + 1)]
    for _ in range(ATTEMPTS):
        if all(form in seen for form in wanted):
            return texts, topologies, [seen[form] for form in wanted], close
        look_again(service, blocker, project, last, seen)
    raise RuntimeError(f"not every frame was seen in {ATTEMPTS} drapes: the machine is too busy")


def look_again(service, blocker, project, last, seen):
    """Another drape of the project, up to its last frame; its pictures are not waited for."""
    job, viewer = queued_with_viewer(service, blocker, project)
    for kind, data in viewer.messages():
        if kind != websocket.BINARY or data[3] == TOPOLOGY:
            continue
        if seen.setdefault(form_of(data), data) != data:
            raise RuntimeError(f"two drapes of the same project differ in frame {form_of(data)}")
        if form_of(data)[0] == last:
            break
    viewer.close()
    service.ask("POST", f"/api/v1/jobs/{job}/cancel")
    service.wait_for(job)


def form_of(frame):
    """Its number, and whether it stands by itself."""
    return struct.unpack_from("<I", frame, 8)[0], frame[3]


def read_all(viewer):
    texts, topologies, frames, close = [], [], [], b""
    for kind, data in viewer.messages():
        if kind == websocket.TEXT:
            texts.append(data)
        elif kind == websocket.CLOSE:
            close = data
        else:
            (topologies if data[3] == TOPOLOGY else frames).append(data)
    viewer.close()
    return texts, topologies, frames, close


def queued_with_viewer(service, blocker, project):
    """A job that could not begin before its viewer was there, since another held the only worker."""
    holding = service.submit(blocker)
    service.wait_for(holding, ("running",))
    job = service.submit(project)
    viewer = websocket.WebSocket(service.port, f"/api/v1/jobs/{job}/stream")
    viewer.send(websocket.TEXT, b'{"type": "resume"}')  # refused, since it is not paused; the stream goes on
    service.ask("POST", f"/api/v1/jobs/{holding}/cancel")
    return job, viewer


def record(c, service, name, texts, topologies, frames, close):
    for kind in ("job", "error", "ended"):
        told = b"\n".join(text for text in texts if json.loads(text)["type"] == kind)
        c.recorder.text(f"{name} {kind}", told, ids=service.ids)
    # Which moments are told depends on the clock; what there is to tell of each does not.
    keys = {tuple(told) for told in map(json.loads, texts) if told["type"] == "progress"}
    c.recorder.bytes(f"{name} progress has", repr(sorted(keys)).encode())
    for kind, messages in (("topologies", topologies), ("frames", frames)):
        c.recorder.bytes(f"{name} {kind}", b"".join(struct.pack("<I", len(data)) + data for data in messages))
    c.recorder.bytes(f"{name} close", close)


def collect_nonsense(c, service, blocker, project):
    job = service.submit(project)
    for name, kind, data in [("no command", websocket.TEXT, b'{"type": "dance"}'),
                             ("no json", websocket.TEXT, b"hello"), ("binary", websocket.BINARY, b"\0")]:
        viewer = websocket.WebSocket(service.port, f"/api/v1/jobs/{job}/stream")
        viewer.send(kind, data)
        c.recorder.bytes(f"close after {name}", [data for kind, data in viewer.messages()][-1])
        viewer.close()
