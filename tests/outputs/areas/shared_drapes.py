"""Short drapes of the reference data's garments: long enough to sew, to weld and to fall."""

import json

GARMENTS = {"skirt_2panel": {}, "pants": {}, "tshirt": {}, "hoody": {}, "fitted_blouse_long": {},
            "random/random_1018": {}, "random/random_1056": {}}
SETTINGS = {"particle_distance_mm": 28, "time_step_s": 0.0005, "sew_time_s": 0.6, "max_time_s": 1.2}


def collect(c):
    for garment, settings in GARMENTS.items():
        name = garment.split("/")[-1]
        pattern = c.shared / "garmentcode" / f"{garment}_specification.json"
        c.run(f"{name} new", "project", "new", "--pattern", pattern, "--body",
              c.shared / "bodies/garmentcode-mean_all.obj", "--out", f"{name}/project.json")
        path = c.folder / name / "project.json"
        document = json.loads(path.read_text())
        document["settings"] = {**document.get("settings", {}), **SETTINGS, **settings}
        path.write_text(json.dumps(document))
        c.run(f"{name}", "drape", f"{name}/project.json", "--out", f"{name}/out", "--no-stills", "--check-data",
              "--trace", f"{name}/frames.trace")
        c.recorder.folder(f"{name} left", c.folder / name / "out")
        c.recorder.file(f"{name} frames.trace", c.folder / name / "frames.trace")
