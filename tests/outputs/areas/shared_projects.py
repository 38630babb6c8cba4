"""Projects of the reference data's patterns and bodies: made, looked at, arranged."""

from .shared_patterns import specifications

DRAWN = {"freesewing/penelope-cisFemaleAdult34.aama.dxf": "makehuman-female-average.obj",
         "freesewing/teagan-cisFemaleAdult34.plain-r12.dxf": "makehuman-female-average.obj",
         "freesewing/titan-cisMaleAdult38.aama.dxf": "makehuman-male-average.obj",
         "garmentcode/pants.dxf": "garmentcode-mean_all.obj"}


def collect(c):
    for path in specifications(c.shared):
        make(c, path.stem.removesuffix("_specification"), path, "garmentcode-mean_all.obj", ["matrix"])
    for pattern, body in DRAWN.items():
        path = c.shared / pattern
        make(c, f"drawn_{path.name.split('.')[0]}", path, body, ["matrix", "box"])


def make(c, name, pattern, body, forms):
    project = f"{name}/project.json"
    c.run(f"{name} new", "project", "new", "--pattern", pattern, "--body", c.shared / "bodies" / body,
          "--accept-seams", "0.5", "--out", project)
    c.recorder.file(f"{name} project.json", c.folder / project)
    c.run(f"{name} check", "check", project, "--json")
    for form in forms:
        arranged = f"{name}/{form}.json"
        c.run(f"{name} arrange {form}", "project", "arrange", project, "--out", arranged, "--as", form, "--json")
        c.recorder.file(f"{name} arranged {form}.json", c.folder / arranged)
