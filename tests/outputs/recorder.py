"""What was collected: one entry for each output, as a manifest of hashes and, on demand, as files to look into."""

import hashlib
import re

import masks


class Recorder:
    def __init__(self, keep=None):
        self.outputs = {}
        self.keep = keep

    def bytes(self, name, data):
        """An output that must be the same to the last byte."""
        self._add(name, data, {})

    def text(self, name, data, ids=None, more=()):
        """An output with the fields of masks.TEXT in it; `ids` are the service's that it came from."""
        data, seen = masks.masked(data, [*masks.TEXT, *more, *([ids] if ids else [])])
        self._add(name, data, seen)

    def file(self, name, path, **how):
        """A file of the program's: texts by their ending, all else byte for byte."""
        if not path.is_file():
            self._add(name, b"there is no such file", {})
        elif path.suffix == ".json":
            self.text(name, path.read_bytes(), **how)
        else:
            self.bytes(name, path.read_bytes())

    def folder(self, name, path):
        """Every file in a folder, and which ones there are."""
        files = sorted(p for p in path.rglob("*") if p.is_file())
        listing = "\n".join(str(p.relative_to(path)) for p in files)
        self.bytes(f"{name}/files", listing.encode())
        for file in files:
            self.file(f"{name}/{file.relative_to(path)}", file)

    def _add(self, name, data, seen):
        if name in self.outputs:
            raise ValueError(f"two outputs are called {name}")
        self.outputs[name] = {"sha256": hashlib.sha256(data).hexdigest(), "bytes": len(data)}
        if seen:
            self.outputs[name]["masked"] = dict(sorted(seen.items()))
        if self.keep:
            # Flat, since one output's name may be another's folder.
            (self.keep / re.sub(r"[^-+.\w]", "_", name)).write_bytes(data)
