"""`toile project`: made of a pattern and a body, and arranged."""


def collect(c):
    sample = c.sample()
    files = ("--pattern", f"{sample}/skirt.dxf", "--body", f"{sample}/body.obj")
    c.run("new without seams", "project", "new", *files, "--out", "plain/project.json")
    c.run("new with seams", "project", "new", *files, "--accept-seams", "0.5", "--out", "sewn/project.json")
    c.run("new json", "project", "new", *files, "--accept-seams", "0.5", "--out", "json/project.json", "--json")
    for made in ("plain", "sewn", "json"):
        c.recorder.folder(f"new {made}", c.folder / made)
    project = "sewn/project.json"
    for form in ("matrix", "box"):
        c.run(f"arrange {form}", "project", "arrange", project, "--out", f"sewn/{form}.json", "--as", form)
        c.run(f"arrange {form} json", "project", "arrange", project, "--out", f"sewn/again.json", "--as", form,
              "--json")
        c.recorder.file(f"arranged {form}.json", c.folder / f"sewn/{form}.json")
        c.run(f"check arranged {form}", "check", f"sewn/{form}.json", "--json")
    c.run("arrange in place", "project", "arrange", project)
    c.recorder.file("arranged in place.json", c.folder / project)
