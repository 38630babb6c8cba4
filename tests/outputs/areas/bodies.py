"""`toile body`, and bodies of every kind of file under a cloth."""

import garments
import meshes

FIGURES = {
    "default": [],
    "small": ["--sex", "female", "--height", "158", "--waist", "66", "--hip", "92", "--triangles", "2000"],
    "man": ["--preset", "m50", "--pose", "t", "--triangles", "5624"],
    "child": ["--preset", "child116", "--arm-angle", "35"],
    "all measures": ["--height", "172", "--bust", "94", "--underbust", "80", "--waist", "78", "--hip", "102",
                     "--neck", "35", "--shoulder-width", "38", "--upper-arm", "29", "--wrist", "16",
                     "--arm-length", "58", "--thigh", "58", "--calf", "37", "--inseam", "78"],
}


def collect(c):
    c.run("presets text", "body", "presets")
    c.run("presets json", "body", "presets", "--json")
    for name, measures in FIGURES.items():
        file = name.replace(" ", "_") + ".obj"
        c.run(f"make {name}", "body", "make", *measures, "--out", file)
        c.recorder.file(f"make {file}", c.folder / file)
        c.run(f"make {name} json", "body", "make", *measures, "--out", "again.obj", "--json")
        c.run(f"measure {name}", "body", "measure", file)
        c.run(f"measure {name} json", "body", "measure", file, "--json")
    c.run("measure the sample's", "body", "measure", c.sample() + "/body.obj", "--json")
    for file, data in meshes.FILES.items():
        collect_file(c, file, data)


def collect_file(c, file, data):
    """A mesh as the program reads and mends it: a drape that ends at once leaves it as body.obj."""
    document = garments.napkin(max_time_s=0.01)
    document["bodies"][0]["file"] = file
    folder = file.replace(".", "_")
    c.write(f"{folder}/{file}", data)
    c.write(f"{folder}/project.json", document)
    c.run(f"check {file}", "check", f"{folder}/project.json", "--json")
    c.run(f"measure {file}", "body", "measure", f"{folder}/{file}", "--json")
    c.run(f"under a cloth {file}", "drape", f"{folder}/project.json", "--out", f"{folder}/out", "--no-stills",
          "--check-data")
    c.recorder.file(f"{file} as body.obj", c.folder / folder / "out/body.obj")
