"""Small garments as project documents, and the DXF files and pictures that they name."""

import struct
import zlib

import meshes


def napkin(**settings):
    """A square of cloth over a post: the least garment. It needs post.obj beside it."""
    return {
        "toile": 1,
        "name": "Napkin",
        "pieces": [square("napkin", 300, {"rigid": {"translation": [-0.15, 0.52, 0.15], "rotation": [-90, 0, 0]}})],
        "fabrics": [COTTON],
        "seams": [],
        "bodies": [{"id": "post", "file": "post.obj", "unit": "m"}],
        "settings": {"particle_distance_mm": 25, "sew_time_s": 0, "max_time_s": 8, **settings},
    }


COTTON = {"id": "cotton", "areal_mass_g_m2": 150, "stretch_warp_n_m": 2000, "stretch_weft_n_m": 1500,
          "stretch_shear_n_m": 500, "bend_warp_un_m": 10, "bend_weft_un_m": 8, "bend_bias_un_m": 7,
          "thickness_mm": 0.4}


def square(name, side, placement):
    corners = [[0, 0], [side, 0], [side, side], [0, side]]
    edges = [{"id": edge, "points": [corners[i], corners[(i + 1) % 4]]}
             for i, edge in enumerate(("south", "east", "north", "west"))]
    return {"id": name, "outline": edges, "fabric": "cotton", "placement": placement}


def tabard(**settings):
    """Two squares sewn at their sides, before and behind the post: something to edit, with seams."""
    front = square("front", 300, {"rigid": {"translation": [-0.15, 0.3, 0.16]}})
    back = square("back", 300, {"rigid": {"translation": [0.15, 0.3, -0.16], "rotation": [0, 180, 0]}})
    front["notches"] = [{"at": [150, 300], "depth_mm": 4}]
    front["lines"] = [{"id": "middle", "points": [[150, 50], [150, 250]], "drawn": True}]
    front["holes"] = [[{"id": "eye", "points": [[60, 60], [60, 90], [90, 90], [90, 60], [60, 60]]}]]
    document = napkin(**settings)
    document.update(name="Tabard", pieces=[front, back])
    document["fabrics"] = [COTTON, {**COTTON, "id": "felt", "areal_mass_g_m2": 300, "thickness_mm": 1}]
    document["seams"] = [
        {"id": "right", "a": [{"piece": "front", "edge": "east"}], "b": [{"piece": "back", "edge": "west"}]},
        {"id": "left", "a": [{"piece": "front", "edge": "west"}], "b": [{"piece": "back", "edge": "east"}]},
    ]
    return document


def too_narrow():
    """The tabard around the post, not above it, where its seams cannot close: the drape stalls."""
    document = tabard(sew_time_s=0.2)
    for piece in document["pieces"]:
        piece["placement"]["rigid"]["translation"][1] = 0.1
    return document


SQUARE = "10\n0\n20\n0\n10\n100\n20\n0\n10\n100\n20\n100\n10\n0\n20\n100\n"


def dxf(vertices=SQUARE, closed=1):
    """A drawing of one piece named FRONT, a 100 mm square."""
    return ("0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nFRONT\n90\n4\n70\n" + str(closed) + "\n" + vertices +
            "0\nTEXT\n8\nFRONT\n10\n50\n20\n50\n40\n5\n1\nFRONT\n0\nENDSEC\n0\nEOF\n")


def cut_napkin():
    """The napkin cut from cut.dxf."""
    document = napkin()
    piece = document["pieces"][0]
    del piece["outline"]
    piece["from"] = {"dxf": "cut.dxf", "piece": "FRONT", "units": "mm"}
    return document


def checks_png(cells=8, pixels=4):
    """A chequered picture, red and white."""
    side = cells * pixels
    rows = b""
    for y in range(side):
        rows += b"\0" + b"".join(b"\xc0\x20\x20" if (x // pixels + y // pixels) % 2 else b"\xff\xff\xff"
                                 for x in range(side))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    # Stored, not deflated: the bytes then do not depend on the library's version.
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 0)) + chunk(b"IEND", b""))


def write_napkin(collection, folder, document=None):
    """A project with its post in a folder; the document's path."""
    collection.write(f"{folder}/post.obj", meshes.as_obj(meshes.POST))
    collection.write(f"{folder}/project.json", document or napkin())
    return f"{folder}/project.json"
