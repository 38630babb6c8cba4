"""Edits of a project over HTTP: every kind of them, undone and done again."""

import garments
import meshes

HERE = {"If-Match": "*"}


def on(edit, piece, **rest):
    return {"edit": edit, "piece": piece, **rest}


# One step each; those after them count on what they left.
STEPS = {
    "move_point": [on("move_point", "front", edge="south", point=1, to=[310, -5])],
    "bend_edge": [on("bend_edge", "front", edge="south", curve=0, handle1=[100, -20], handle2=[200, -20])],
    "move_handle": [on("move_handle", "front", edge="south", curve=0, handle=1, to=[110, -30])],
    "insert_point": [on("insert_point", "front", edge="north", at=0.25)],
    "delete_point": [on("delete_point", "front", edge="north", point=1)],
    "split_edge": [on("split_edge", "front", edge="east", at=0.4, id="upper")],
    "join_edges": [on("join_edges", "front", edge="east", next="upper")],
    "straighten_edge": [on("straighten_edge", "front", edge="south")],
    "set_edge_length": [on("set_edge_length", "back", edge="south", length_mm=280, keep="middle")],
    "mirror_piece": [on("mirror_piece", "back")],
    "rotate_grain": [on("rotate_grain", "front", angle=30)],
    "add_line": [on("add_line", "front", id="crease", points=[[20, 200], [120, 200]])],
    "remove_line": [on("remove_line", "front", line="middle")],
    "add_notch": [on("add_notch", "front", edge="west", at=0.3, depth_mm=5)],
    "move_notch": [on("move_notch", "front", notch=0, edge="north", at=0.7)],
    "remove_notch": [on("remove_notch", "front", notch=1)],
    "add_dart": [on("add_dart", "front", edge="north", at=0.5, width_mm=20, depth_mm=60, id="dart")],
    "add_inner_dart": [{"edit": "add_inner_dart", "piece": "back", "from": [100, 60], "to": [100, 220],
                        "width_mm": 15, "id": "waist_dart"}],
    "rename_edge": [on("rename_edge", "front", edge="south", to="hem")],
    "remove_dart": [{"edit": "remove_dart", "seam": "waist_dart"}],
    "add_hole": [on("add_hole", "front", edges=[
        {"id": "hole", "points": [[200, 60], [240, 60], [240, 100], [200, 100], [200, 60]]}])],
    "remove_hole": [on("remove_hole", "front", edge="eye")],
    "move_piece": [on("move_piece", "back", by=[400, 10])],
    "rename_piece": [on("rename_piece", "front", to="apron")],
    "duplicate_piece": [on("duplicate_piece", "apron", id="pocket", by=[0, 500], mirrored=True)],
    "delete_piece": [on("delete_piece", "pocket")],
    "remove_seam": [{"edit": "remove_seam", "seam": "left"}],
    "add_seam": [{"edit": "add_seam", "id": "new", "a": [{"piece": "apron", "edge": "west"}],
                  "b": [{"piece": "back", "edge": "east", "from": 0.1, "to": 0.9}]}],
    "reverse_seam": [{"edit": "reverse_seam", "seam": "new"}],
    "set_fabric": [on("set_fabric", "back", fabric="felt")],
    "set_physical": [on("set_physical", "apron", physical={"thickness_mm": 0.8, "particle_distance_mm": 10})],
    "restore": [{"edit": "restore", "seams": {"at": 0, "remove": 1}}],
    "two at once": [on("rotate_grain", "apron", angle=-30), on("move_piece", "apron", by=[1, 2])],
}

REFUSED = {
    "of no piece": [on("mirror_piece", "sleeve")],
    "of no kind": [on("crumple", "apron")],
    "the second of two": [on("rotate_grain", "apron", angle=5), on("delete_piece", "sleeve")],
    "of an outline that would cross": [on("move_point", "apron", edge="hem", point=0, to=[500, 500])],
    "out of range": [on("rotate_grain", "apron", angle=1000)],
}


def collect(c):
    service = c.serve("data", "--no-sample")
    post = service.upload("body", "post.obj", meshes.as_obj(meshes.POST).encode())
    picture = service.upload("image", "checks.png", garments.checks_png())
    project = service.make(garments.tabard(), {"post.obj": post})
    there = f"/api/v1/projects/{project}"

    def ask(name, method, target, body=None, headers=None):
        answer = service.ask(method, there + target, body, headers)
        c.recorder.text(name, answer.as_bytes(), ids=service.ids)
        return answer

    for name, edits in STEPS.items():
        ask(name, "POST", "/edits", {"edits": edits}, HERE)
    texture = [on("set_texture", "apron", texture={"image": "checks.png", "scale_mm": 60, "angle": 45})]
    ask("set_texture", "POST", "/edits", {"edits": texture, "files": {"checks.png": picture}}, HERE)
    for name, edits in REFUSED.items():
        ask(f"refused {name}", "POST", "/edits", {"edits": edits}, HERE)
    ask("refused without a revision", "POST", "/edits", {"edits": []})
    ask("refused of another revision", "POST", "/edits", {"edits": []}, {"If-Match": '"1"'})
    ask("pieces", "GET", "/pieces")
    ask("history", "GET", "/edits")
    ask("history by pages", "GET", "/edits?limit=5")
    for step in range(6):
        ask(f"undo {step}", "POST", "/undo", None, HERE)
    for step in range(3):
        ask(f"redo {step}", "POST", "/redo", None, HERE)
    ask("after undo and redo", "GET", "")
    ask("an edit after an undo", "POST", "/edits", {"edits": [on("rotate_grain", "apron", angle=1)]}, HERE)
    ask("nothing to redo", "POST", "/redo", None, HERE)
    while service.ask("POST", there + "/undo", None, HERE).status == 200:
        pass
    ask("after every undo", "GET", "")
    ask("nothing to undo", "POST", "/undo", None, HERE)
    ask("history at the end", "GET", "/edits?limit=100")
