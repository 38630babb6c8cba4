"""The program under test, run as people run it: in a folder of its own, with relative paths."""

import subprocess

LONGEST_S = 300


class Program:
    def __init__(self, path, folder, recorder):
        self.path = path
        self.folder = folder
        self.recorder = recorder

    def run(self, *arguments):
        """Exit code (negative: the signal that ended it), stdout, stderr."""
        done = subprocess.run([self.path, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=LONGEST_S)
        return done.returncode, done.stdout, done.stderr

    def record(self, name, *arguments, ids=None):
        """Runs and records what it said and its exit code as one output; the exit code."""
        code, out, err = self.run(*arguments)
        said = b"exit code %d\n--- stdout\n%s--- stderr\n%s" % (code, out, err)
        self.recorder.text(name, said, ids=ids)
        return code
