"""`toile pattern`: DXF files in and out."""

import garments


def collect(c):
    sample = c.sample()
    c.write("square.dxf", garments.dxf())
    for name, path in {"skirt": f"{sample}/skirt.dxf", "square": "square.dxf"}.items():
        c.run(f"import {name} text", "pattern", "import", path)
        c.run(f"import {name} json", "pattern", "import", path, "--json")
        for unit in ("mm", "cm", "inch"):
            c.run(f"import {name} {unit}", "pattern", "import", path, "--unit", unit, "--json")
    garments.write_napkin(c, "tabard", garments.tabard())
    projects = {"skirt": f"{sample}/project.json", "notions": c.notions(), "tabard": "tabard/project.json"}
    for name, path in projects.items():
        c.run(f"export {name} text", "pattern", "export", path, "--out", f"{name}.dxf")
        c.recorder.file(f"{name}.dxf", c.folder / f"{name}.dxf")
        c.run(f"export {name} json", "pattern", "export", path, "--out", f"{name}-again.dxf", "--json")
        c.run(f"import exported {name}", "pattern", "import", f"{name}.dxf", "--json")
