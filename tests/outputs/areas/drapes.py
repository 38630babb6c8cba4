"""`toile drape` with all that it leaves."""

import garments


def collect(c):
    sample = f"{c.sample()}/project.json"
    drape(c, "skirt", sample, "--size", "320x400")
    drape(c, "notions", c.notions(), "--size", "64x80")
    garments.write_napkin(c, "napkin")
    drape(c, "napkin", "napkin/project.json", "--size", "128x96", "--json")
    textured = garments.napkin()
    textured["pieces"][0]["texture"] = {"image": "cloth/checks.png", "scale_mm": 40, "angle": 30, "offset": [5, 7]}
    garments.write_napkin(c, "textured", textured)
    c.write("textured/cloth/checks.png", garments.checks_png())
    drape(c, "textured", "textured/project.json", "--size", "128x160")
    falling = garments.napkin(mode="dynamic", max_time_s=0.6, air={"wind_m_s": [1, 0, 0]})
    falling["bodies"][0]["restitution"] = 0.5
    garments.write_napkin(c, "falling", falling)
    drape(c, "falling", "falling/project.json", "--no-stills")
    garments.write_napkin(c, "unsettled", garments.napkin(max_time_s=0.02))
    drape(c, "unsettled", "unsettled/project.json", "--no-stills", "--json")
    garments.write_napkin(c, "tabard", garments.tabard(sew_time_s=0.3, max_time_s=1))
    drape(c, "tabard", "tabard/project.json", "--no-stills")
    garments.write_napkin(c, "stalled", garments.too_narrow())
    drape(c, "stalled", "stalled/project.json", "--no-stills", "--json")
    c.run("every fifth frame", "drape", "napkin/project.json", "--out", "fifth", "--no-stills", "--trace",
          "fifth.trace", "--trace-every", "5")
    c.recorder.file("fifth.trace", c.folder / "fifth.trace")


def drape(c, name, project, *options):
    out = f"out/{name}"
    c.run(f"{name}", "drape", project, "--out", out, "--check-data", "--trace", f"{name}.trace", *options)
    c.recorder.folder(f"{name} left", c.folder / out)
    c.recorder.file(f"{name}.trace", c.folder / f"{name}.trace")
