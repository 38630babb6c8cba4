"""What an area works with: the program, a folder of its own, and where its outputs go."""

import json
import pathlib
import shutil

from program import Program
from recorder import Recorder
from service import Service

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Collection:
    def __init__(self, program, folder, shared, keep):
        self.folder = folder
        self.shared = shared
        self.recorder = Recorder(keep)
        self.program = Program(program, folder, self.recorder)
        self.services = []

    def run(self, name, *arguments, ids=None):
        return self.program.record(name, *arguments, ids=ids)

    def write(self, path, data):
        """A file in the working folder; JSON of what is neither text nor bytes."""
        path = self.folder / path
        path.parent.mkdir(parents=True, exist_ok=True)
        if not isinstance(data, (str, bytes)):
            data = json.dumps(data)
        path.write_bytes(data.encode() if isinstance(data, str) else data)
        return path

    def sample(self, folder="skirt"):
        """The sample's files in a folder of the working folder."""
        shutil.copytree(ROOT / "samples/skirt", self.folder / folder)
        return folder

    def sample_document(self):
        return json.loads((ROOT / "samples/skirt/project.json").read_text())

    def notions(self, folder="notions"):
        """A small garment with a button, elastic, a fold and a cushion; its document's name."""
        shutil.copytree(ROOT / "tests/data", self.folder / folder)
        return f"{folder}/notions.json"

    def serve(self, data="data", *options):
        """A running service; it is ended with the area at the latest."""
        service = Service(self.program.path, self.folder, data, options)
        self.services.append(service)
        return service

    def end(self):
        for service in self.services:
            service.kill()
