"""Every drawing of the reference data, but for two thirds of the random ones, which are all of one hand."""


def collect(c):
    for path in drawings(c.shared):
        c.run(str(path.relative_to(c.shared)), "pattern", "import", path, "--json")
    for path in specifications(c.shared):
        c.run(str(path.relative_to(c.shared)), "pattern", "import", path, "--json")


def drawings(shared):
    found = []
    for folder in ("dxf-cases", "freesewing", "freesewing/variants", "garmentcode"):
        found += sorted((shared / folder).glob("*.dxf"))
    return found + sorted((shared / "garmentcode/random").glob("*.dxf"))[::3]


def specifications(shared):
    return sorted((shared / "garmentcode").glob("*_specification.json")) + \
        sorted((shared / "garmentcode/random").glob("*_specification.json"))[::8]
