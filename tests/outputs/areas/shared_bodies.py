"""The bodies of the reference data: scanned and drawn."""


def collect(c):
    service = c.serve("data", "--no-sample")
    for path in sorted((c.shared / "bodies").glob("*.obj")):
        c.run(f"measure {path.stem}", "body", "measure", path)
        c.run(f"measure {path.stem} json", "body", "measure", path, "--json")
        asset = service.upload("body", path.name, path.read_bytes())
        for target in ("", "/content"):
            answer = service.ask("GET", f"/api/v1/assets/{asset}{target}")
            c.recorder.text(f"asset {path.stem}{target}", answer.as_bytes(), ids=service.ids)
        answer = service.ask("GET", f"/api/v1/bodies/{asset}/figure")
        c.recorder.text(f"figure {path.stem}", answer.as_bytes(), ids=service.ids)
