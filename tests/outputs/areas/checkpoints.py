"""Checkpoints as they lie on the disk, and a drape that is killed and goes on."""

import struct
import time

import garments
import meshes

MAGIC = b"TOILECP\n"
HEADER = len(MAGIC) + 4 + 32  # version, hash of the input
SEAL = 32  # hash of all before it
WANTED = (50, 500, 1500, 3500, 4500)  # substeps: at the start, while the seams close, and after
ATTEMPTS = 60


def collect(c):
    collect_bytes(c)
    collect_killed(c)


def steps_of(checkpoint):
    """The substep at which it was made: behind the phase (a byte) and the reason for the end (a text)."""
    at = HEADER + 1
    reason, = struct.unpack_from("<I", checkpoint, at)
    return struct.unpack_from("<i", checkpoint, at + 4 + reason)[0]


def without_times(checkpoint):
    """cpu_s and wall_s are the last fields; the seal is over them as well."""
    if not checkpoint.startswith(MAGIC):
        raise ValueError("this is no checkpoint")
    return checkpoint[:-SEAL - 16] + b"<cpu_s><wall_s><seal>"


def collect_bytes(c):
    """A service keeps checkpoints as often as it can; those of certain substeps are looked for until all were seen.
    Each drape shows some of them: which ones, the clock decides, but at a substep there is one right one."""
    service = c.serve("data", "--no-sample", "--workers", "1", "--checkpoint-every", "0")
    there = c.folder / c.sample()
    files = {"skirt.dxf": service.upload("dxf", "skirt.dxf", (there / "skirt.dxf").read_bytes()),
             "body.obj": service.upload("body", "body.obj", (there / "body.obj").read_bytes())}
    document = c.sample_document()
    document["settings"]["particle_distance_mm"] = 35
    project = service.make(document, files)
    seen = {}
    for _ in range(ATTEMPTS):
        watch_one(c, service, project, seen)
        if all(step in seen for step in WANTED):
            break
    else:
        raise RuntimeError(f"no checkpoint of substep {[s for s in WANTED if s not in seen]} was seen")
    for step in WANTED:
        c.recorder.bytes(f"at substep {step}", seen[step])
    service.stop()


def watch_one(c, service, project, seen):
    job = service.submit(project)
    path = c.folder / "data/checkpoints" / job
    last, ask_at = None, 0
    while True:
        try:
            checkpoint = path.read_bytes()
        except FileNotFoundError:
            checkpoint = last
        if checkpoint != last:
            last = checkpoint
            note(seen, checkpoint)
        if time.monotonic() > ask_at:
            if service.job(job)["state"] in ("succeeded", "failed", "cancelled"):
                return
            if last and steps_of(last) > max(WANTED):
                service.ask("POST", f"/api/v1/jobs/{job}/cancel")
            ask_at = time.monotonic() + 0.1
        time.sleep(0.0005)


def note(seen, checkpoint):
    step, kept = steps_of(checkpoint), without_times(checkpoint)
    if seen.setdefault(step, kept) != kept:
        raise RuntimeError(f"two drapes of the same project have different checkpoints at substep {step}")


def collect_killed(c):
    """Killed at its first checkpoints, twice, and stopped in good order once: the same bytes as without."""
    document = garments.napkin(particle_distance_mm=9, time_step_s=0.00025)
    garments.write_napkin(c, "napkin", document)
    c.run("undisturbed", "drape", "napkin/project.json", "--out", "undisturbed", "--check-data", "--no-stills")
    c.recorder.folder("undisturbed left", c.folder / "undisturbed")
    job = None
    for end in ("kill", "stop", "kill", None):
        service = c.serve("killed", "--no-sample", "--workers", "1", "--checkpoint-every", "0.1")
        if job is None:
            post = {"post.obj": service.upload("body", "post.obj", meshes.as_obj(meshes.POST).encode())}
            job = service.submit(service.make(document, post))
        if end:
            wait_for_newer(c.folder / "killed/checkpoints" / job, service, job)
            service.kill() if end == "kill" else service.stop()
    service.wait_for(job)
    for name in ("report.json", "final.obj", "final.glb", "rest.obj", "sewn.json"):
        left = service.ask("GET", f"/api/v1/jobs/{job}/results/{name}").body
        c.recorder.text(f"killed {name}", left, ids=service.ids)
        if name != "report.json" and left != (c.folder / "undisturbed" / name).read_bytes():
            raise RuntimeError(f"a drape that was killed left another {name} than one that was not")


def wait_for_newer(path, service, job):
    before = path.stat().st_mtime_ns if path.exists() else None
    while not path.exists() or path.stat().st_mtime_ns == before:
        if service.job(job)["state"] == "succeeded":
            raise RuntimeError("the drape was over before it could be killed")
        time.sleep(0.01)
