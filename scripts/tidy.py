#!/usr/bin/env python3
"""Runs clang-tidy over the program's sources, each only when something that it reads has changed.

    cmake --preset tidy                     how each source is compiled by itself; nothing is built
    scripts/tidy.py build/tidy              all of core, proto/cpp and server: about an hour of a core
    scripts/tidy.py build/tidy core/mesh    the sources below a folder
    scripts/tidy.py build/tidy --last 16    the sixteen that changed last

A source that came out clean leaves a stamp under BUILD/stamps with a hash of itself, of every project header
that it includes, directly or by others, and of the settings, so that the second run is quick. Ends with code 1
when there are findings.
"""
import argparse
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ROOMS = ("core/", "proto/cpp/", "server/")


class Headers:
    """Which project files a source reads. They are included by their path from the root (tests/rules)."""

    def __init__(self):
        self.direct = {}  # file → what it names

    def named_in(self, path):
        if path not in self.direct:
            text = path.read_text() if path.exists() else ""
            self.direct[path] = [ROOT / name for name in re.findall(r'^#include "(.+)"', text, re.MULTILINE)]
        return self.direct[path]

    def of(self, name):
        found, due = set(), [ROOT / name]
        while due:
            for path in self.named_in(due.pop()):
                if path not in found:
                    found.add(path)
                    due.append(path)
        return found


def sources(build, folders):
    """(source relative to the root, its entry of the compilation database), each source once."""
    chosen = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = Path(entry["file"])
        if not path.is_relative_to(ROOT):
            continue
        name = path.relative_to(ROOT).as_posix()
        if name.startswith(ROOMS) and (not folders or name.startswith(tuple(folders))):
            chosen[name] = entry
    return chosen


def git(*arguments):
    """Lines of git's answer, none outside of a repository."""
    ran = subprocess.run(["git", "-C", str(ROOT), *arguments], capture_output=True, text=True)
    return ran.stdout.splitlines() if ran.returncode == 0 else []


def files_by_change():
    """The latest first: what is not committed, then back through the commits. A file may come again."""
    return (git("diff", "--name-only", "HEAD") + git("ls-files", "--others", "--exclude-standard") +
            git("log", "--name-only", "--format=", "--max-count=100"))


def changed_last(chosen, headers, most):
    """So many sources. A header counts as its own source, or else as one that includes it: it shows the findings."""
    last = []
    for name in files_by_change():
        if name.startswith(ROOMS) and name.endswith(".h"):
            users = [source for source in chosen if ROOT / name in headers.of(source)]
            own = name[:-2] + ".cpp"
            name = own if own in users else min(users, default=name)
        if name in chosen and name not in last:
            last.append(name)
        if len(last) == most:
            break
    return {name: chosen[name] for name in last}


def stamp_of(name, headers):
    digest = hashlib.sha256()
    reads = {ROOT / ".clang-tidy", ROOT / name, *headers.of(name)}
    for path in sorted(reads):
        digest.update(path.read_bytes() if path.exists() else b"")
    return f"{name.replace('/', '_')}.{digest.hexdigest()[:20]}"


def check(name, database, stamp):
    # Clang 14's analyzer does not follow coroutines: it takes the pointers in Boost's frames for uninitialised.
    fewer = ["--checks=-clang-analyzer-core.CallAndMessage"] if "co_await" in (ROOT / name).read_text() else []
    # The commands are GCC's, whose own warnings Clang does not know.
    ran = subprocess.run(["clang-tidy", "--quiet", "--warnings-as-errors=*", "-p", database, *fewer,
                          "--extra-arg=-Wno-unknown-warning-option", str(ROOT / name)], capture_output=True, text=True)
    if ran.returncode == 0:
        for old in stamp.parent.glob(f"{name.replace('/', '_')}.*"):
            old.unlink(missing_ok=True)
        stamp.touch()
    return name, ran.returncode, ran.stdout + (ran.stderr if ran.returncode and not ran.stdout else "")


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("build", type=lambda folder: Path(folder).resolve())
    asked.add_argument("folders", nargs="*")
    asked.add_argument("--last", type=int, metavar="COUNT")
    build, folders, last = vars(asked.parse_args()).values()
    kept = build / "stamps"
    kept.mkdir(exist_ok=True)
    chosen, headers = sources(build, folders), Headers()
    if last is not None:
        chosen = changed_last(chosen, headers, last)
    stamps = {name: kept / stamp_of(name, headers) for name in chosen}
    due = [name for name in sorted(chosen) if not stamps[name].exists()]
    faulty = 0
    with tempfile.TemporaryDirectory() as database, ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        Path(database, "compile_commands.json").write_text(json.dumps(list(chosen.values())))
        for name, code, told in pool.map(lambda n: check(n, database, stamps[n]), due):
            if code:
                faulty += 1
                print(f"-- {name}\n{told}", flush=True)
    print(f"{len(chosen)} sources, {len(due)} looked at, {faulty} with findings")
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
