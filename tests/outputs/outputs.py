#!/usr/bin/env python3
"""Shows that a change leaves every output of the program as it was. README.md says how."""

import argparse
import json
import pathlib
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback

sys.dont_write_bytecode = True

import comparison  # noqa: E402
from areas import AREAS  # noqa: E402
from collection import Collection  # noqa: E402


def chosen_areas(options):
    if options.only:
        return options.only.split(",")
    return [name for name, area in AREAS.items()
            if (area.quick or not options.quick) and (options.shared or not area.needs_shared)]


def temporary_folder():
    """In memory where there is such a place: checkpoints come quickest there."""
    memory = pathlib.Path("/dev/shm")
    return tempfile.mkdtemp(prefix="toile-outputs-", dir=memory if memory.is_dir() else None)


def children_s():
    """Seconds of the processor that the program has used."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def collect_area(name, options, keep):
    """The outputs of one area; False in the second place when its collection broke off."""
    work = pathlib.Path(temporary_folder())
    collection = Collection(options.program, work, options.shared, keep)
    began, used = time.monotonic(), children_s()
    try:
        AREAS[name].collect(collection)
        whole = True
    except Exception:
        traceback.print_exc()
        whole = False
    finally:
        collection.end()
        shutil.rmtree(work, ignore_errors=True)
    outputs = {f"{name}/{key}": entry for key, entry in collection.recorder.outputs.items()}
    print(f"{name:14} {len(outputs):4} outputs  {time.monotonic() - began:6.1f} s, "
          f"{children_s() - used:6.1f} s of the processor" + ("" if whole else "  BROKEN OFF"), flush=True)
    return outputs, whole


def collect(options):
    areas = chosen_areas(options)
    for name in areas:
        if name not in AREAS:
            print(f"There is no area {name}; there are {', '.join(AREAS)}", file=sys.stderr)
            return 2
        if AREAS[name].needs_shared and not options.shared:
            print(f"The area {name} needs --shared", file=sys.stderr)
            return 2
    manifest = {"areas": areas, "broken_off": [], "outputs": {}}
    for name in areas:
        keep = options.keep and options.keep / name
        if keep:
            keep.mkdir(parents=True, exist_ok=True)
        outputs, whole = collect_area(name, options, keep)
        manifest["outputs"].update(outputs)
        if not whole:
            manifest["broken_off"].append(name)
    options.out.write_text(json.dumps(manifest, indent=1) + "\n")
    print(f"{len(manifest['outputs'])} outputs in {options.out}")
    return 1 if manifest["broken_off"] else 0


def compare(options):
    before, after = (json.loads(path.read_text()) for path in (options.before, options.after))
    skipped = comparison.not_compared(before, after)
    if skipped:
        print(f"NOT COMPARED, since only one of the manifests has them: {', '.join(skipped)}")
    lines = comparison.broken_off(before, after) + comparison.differences(before, after)
    for line in lines:
        print(line)
    areas = [area for area in before["areas"] if area in after["areas"]]
    compared = sum(len(comparison.outputs_of(before, area)) for area in areas)
    print(f"{len(lines)} differences in {compared} outputs of {len(areas)} areas")
    return 1 if lines or compared == 0 else 0


def existing(text):
    path = pathlib.Path(text).resolve()
    if not path.exists():
        raise argparse.ArgumentTypeError(f"there is no {path}")
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    verbs = parser.add_subparsers(required=True)
    verb = verbs.add_parser("collect", help="run everything with a program and keep the hashes of what it gives")
    verb.add_argument("--program", type=existing, required=True)
    verb.add_argument("--out", type=pathlib.Path, required=True, help="the manifest to write")
    verb.add_argument("--shared", type=existing,
                      help="the folder of reference data from outside (the one with garmentcode, freesewing, bodies)")
    verb.add_argument("--quick", action="store_true", help="leave out the long areas")
    verb.add_argument("--only", help="areas, with commas between them: " + ", ".join(AREAS))
    verb.add_argument("--keep", type=pathlib.Path, help="also keep the masked outputs here, to diff them")
    verb.set_defaults(run=collect)
    verb = verbs.add_parser("compare", help="print each difference of two manifests; exit code 1 if there is any")
    verb.add_argument("before", type=pathlib.Path)
    verb.add_argument("after", type=pathlib.Path)
    verb.set_defaults(run=compare)
    options = parser.parse_args()
    # An ordered end like any other, so that services are ended and folders removed.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    return options.run(options)


if __name__ == "__main__":
    sys.exit(main())
