"""What strangers hand to the program: the text of each error, and its exit code."""

import copy
import json

import garments
import meshes


def collect(c):
    for name, document in bad_documents().items():
        refuse(c, name, garments.write_napkin(c, name.replace(" ", "_"), document))
    for name, drawing in bad_drawings().items():
        folder = name.replace(" ", "_")
        project = garments.write_napkin(c, folder, garments.cut_napkin())
        if drawing is not None:
            c.write(f"{folder}/cut.dxf", drawing)
            c.run(f"import {name}", "pattern", "import", f"{folder}/cut.dxf")
        refuse(c, name, project)
    for name, mesh in bad_meshes().items():
        folder = name.replace(" ", "_")
        project = garments.write_napkin(c, folder)
        c.write(f"{folder}/post.obj", mesh)
        refuse(c, name, project)
    collect_arguments(c)


def refuse(c, name, project):
    c.run(f"drape {name}", "drape", project, "--out", "out", "--no-stills")
    c.run(f"check {name} json", "check", project, "--json")


def bad_documents():
    """Name to document: the napkin with one fault each."""
    good = garments.napkin()
    found = {"no json": "Dear Sir or Madam,", "json cut off": json.dumps(good)[:200],
             "json too deep": '{"toile": 1, "x": ' + "[" * 1000}

    def with_fault(name, change):
        document = copy.deepcopy(good)
        change(document)
        found[name] = document

    def seam_to(piece, edge):
        return {"id": "s", "a": [{"piece": "napkin", "edge": "east"}], "b": [{"piece": piece, "edge": edge}]}

    with_fault("unknown key", lambda d: d.update(saems=d.pop("seams")))
    with_fault("other version", lambda d: d.update(toile=2))
    with_fault("no pieces", lambda d: d.pop("pieces"))
    with_fault("open outline", lambda d: set_in(d["pieces"][0]["outline"], [3, "points"],
                                               [[0, 300], [0, 7]]))
    with_fault("crossing outline", lambda d: set_in(d["pieces"][0]["outline"], [2, "points"],
                                                    [[300, 300], [150, -100], [0, 300]]))
    with_fault("seam to no piece", lambda d: d["seams"].append(seam_to("sleeve", "west")))
    with_fault("seam to no edge", lambda d: d["seams"].append(seam_to("napkin", "wset")))
    with_fault("no such fabric", lambda d: d["pieces"][0].update(fabric="silk"))
    with_fault("no such body file", lambda d: d["bodies"][0].update(file="pots.obj"))
    with_fault("path out of the folder", lambda d: d["bodies"][0].update(file="../../../etc/passwd"))
    with_fault("no number", lambda d: d["settings"].update(particle_distance_mm="fine"))
    with_fault("out of range", lambda d: d["settings"].update(particle_distance_mm=-1))
    with_fault("too large for its triangles", lambda d: d["pieces"].__setitem__(0, garments.square(
        "napkin", 90000, d["pieces"][0]["placement"])))
    with_fault("two of one id", lambda d: d["pieces"].append(d["pieces"][0]))
    with_fault("within the body", lambda d: set_in(d["pieces"][0], ["placement", "rigid", "translation"],
                                                   [-0.15, 0.25, 0.15]))
    with_fault("picture missing", lambda d: d["pieces"][0].update(texture={"image": "none.png", "scale_mm": 40}))
    with_fault("picture of text", lambda d: d["pieces"][0].update(texture={"image": "post.obj", "scale_mm": 40}))
    return found


def set_in(tree, path, value):
    for key in path[:-1]:
        tree = tree[key]
    tree[path[-1]] = value


def bad_drawings():
    good = garments.dxf()
    return {
        "no drawing": None,
        "drawing of text": "Dear Sir or Madam,\nplease find attached my best regards.\n",
        "drawing cut off": good[:len(good) // 2],
        "open drawing": garments.dxf(closed=0),
        "flat drawing": garments.dxf("10\n0\n20\n0\n10\n100\n20\n0\n10\n200\n20\n0\n10\n100\n20\n0\n"),
        "crossing drawing": garments.dxf("10\n0\n20\n0\n10\n100\n20\n100\n10\n150\n20\n0\n10\n0\n20\n100\n"),
        "empty drawing": "",
    }


def bad_meshes():
    good = meshes.as_obj(meshes.POST)
    return {"empty mesh": "", "mesh of text": "Dear Sir or Madam,", "mesh of nan": good.replace("0.5", "nan"),
            "mesh of inf": good.replace("0.5", "inf", 1), "mesh cut off": good[:60]}


def collect_arguments(c):
    garments.write_napkin(c, "good")
    c.write("figure.obj", meshes.as_obj(meshes.POST))
    project = "good/project.json"
    for name, arguments in {
        "no verb": [],
        "unknown verb": ["sew"],
        "no project": ["check"],
        "project that is not there": ["check", "none.json"],
        "a folder as a project": ["check", "good"],
        "out within a file": ["drape", project, "--out", "good/post.obj/out"],
        "size of no picture": ["drape", project, "--out", "out", "--size", "9x9"],
        "trace-every without trace": ["drape", project, "--out", "out", "--trace-every", "2"],
        "preset that is not there": ["body", "make", "--preset", "xxl", "--out", "b.obj"],
        "a waist that nobody has": ["body", "make", "--waist", "300", "--out", "b.obj"],
        "measures of a post": ["body", "measure", "figure.obj"],
        "measures of nothing": ["body", "measure", "none.obj", "--json"],
        "unit of no ruler": ["pattern", "import", "x.dxf", "--unit", "ell"],
        "no pattern": ["project", "new", "--pattern", "none.dxf", "--body", "figure.obj", "--out", "p.json"],
        "no body": ["project", "new", "--pattern", "good/project.json", "--body", "none.obj", "--out", "p.json"],
        "a document as a pattern": ["project", "new", "--pattern", project, "--body", "figure.obj", "--out", "p.json"],
        "arrange around a post": ["project", "arrange", project],
        "arrange as a sphere": ["project", "arrange", project, "--as", "sphere"],
        "serve beyond the loopback": ["serve", "--address", "0.0.0.0", "--port", "0", "--data", "data"],
        "submit to nobody": ["submit", project, "--server", "http://127.0.0.1:1"],
        "submit to no address": ["submit", project, "--server", "ftp://x"],
        "submit to nobody json": ["submit", project, "--server", "http://127.0.0.1:1", "--json"],
    }.items():
        c.run(name, *arguments)
