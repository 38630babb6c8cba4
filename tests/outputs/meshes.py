"""A post, 0.2 x 0.5 x 0.2 m, as a file of every kind that bodies come in."""

import base64
import json
import struct

CORNERS = [(-0.1, 0, -0.1), (0.1, 0, -0.1), (0.1, 0, 0.1), (-0.1, 0, 0.1),
           (-0.1, 0.5, -0.1), (0.1, 0.5, -0.1), (0.1, 0.5, 0.1), (-0.1, 0.5, 0.1)]
SIDES = [(0, 1, 2, 3), (7, 6, 5, 4), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]
POST = (CORNERS, SIDES)
# Without its lid, and with one side turned over.
TORN_POST = (CORNERS, [(0, 1, 2, 3), (7, 6, 5, 4), (5, 4, 0, 1), (1, 5, 6, 2), (2, 6, 7, 3)])


def triangles(mesh):
    corners, faces = mesh
    return [[corners[face[i]] for i in (0, k, k + 1)] for face in faces for k in range(1, len(face) - 1)]


def as_obj(mesh):
    corners, faces = mesh
    return "".join("v %g %g %g\n" % c for c in corners) + \
        "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def as_off(mesh):
    corners, faces = mesh
    return f"OFF\n{len(corners)} {len(faces)} 0\n" + "".join("%g %g %g\n" % c for c in corners) + \
        "".join(f"{len(face)} " + " ".join(map(str, face)) + "\n" for face in faces)


def as_ply(mesh):
    corners, faces = mesh
    return (f"ply\nformat ascii 1.0\nelement vertex {len(corners)}\nproperty float x\nproperty float y\n"
            f"property float z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n" +
            "".join("%g %g %g\n" % c for c in corners) +
            "".join(f"{len(face)} " + " ".join(map(str, face)) + "\n" for face in faces))


def as_stl(mesh):
    facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % c for c in triangle) +
                     "endloop\nendfacet\n" for triangle in triangles(mesh))
    return f"solid post\n{facets}endsolid post\n"


def as_binary_stl(mesh):
    facets = [struct.pack("<12fH", 0, 0, 0, *(x for corner in triangle for x in corner), 0)
              for triangle in triangles(mesh)]
    return b"post".ljust(80) + struct.pack("<I", len(facets)) + b"".join(facets)


def as_raw(mesh):
    return "post\n" + "".join(" ".join("%g" % x for corner in t for x in corner) + "\n" for t in triangles(mesh))


def gltf_parts(mesh):
    """The document without its buffer, and the buffer: positions, then indices."""
    corners, faces = mesh
    indices = [face[i] for face in faces for k in range(1, len(face) - 1) for i in (0, k, k + 1)]
    positions = struct.pack(f"<{3 * len(corners)}f", *(x for corner in corners for x in corner))
    data = positions + struct.pack(f"<{len(indices)}H", *indices)
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(positions)},
                        {"buffer": 0, "byteOffset": len(positions), "byteLength": len(data) - len(positions)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(corners), "type": "VEC3",
                       "min": [min(c[i] for c in corners) for i in range(3)],
                       "max": [max(c[i] for c in corners) for i in range(3)]},
                      {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}]}
    return document, data


def as_gltf(mesh):
    document, data = gltf_parts(mesh)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps({**document, "buffers": [{"byteLength": len(data), "uri": uri}]})


def as_glb(mesh):
    document, data = gltf_parts(mesh)
    text = json.dumps({**document, "buffers": [{"byteLength": len(data)}]}).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data)) +
            struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data)


FILES = {
    "post.obj": as_obj(POST), "post.off": as_off(POST), "post.ply": as_ply(POST), "post.stl": as_stl(POST),
    "binary.stl": as_binary_stl(POST), "post.raw": as_raw(POST), "post.gltf": as_gltf(POST),
    "post.glb": as_glb(POST), "torn.obj": as_obj(TORN_POST), "torn.ply": as_ply(TORN_POST),
}
