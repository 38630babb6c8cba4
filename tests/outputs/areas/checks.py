"""`toile check`: what a project holds, and the look at its start."""

import garments


def collect(c):
    sample = c.sample()
    garments.write_napkin(c, "napkin")
    touching = garments.napkin()
    touching["pieces"][0]["placement"]["rigid"]["translation"][1] = 0.4999
    garments.write_napkin(c, "touching", touching)
    garments.write_napkin(c, "tabard", garments.tabard())
    projects = {"skirt": f"{sample}/project.json", "notions": c.notions()}
    projects.update((name, f"{name}/project.json") for name in ("napkin", "touching", "tabard"))
    for name, path in projects.items():
        c.run(f"{name} text", "check", path)
        c.run(f"{name} json", "check", path, "--json")
