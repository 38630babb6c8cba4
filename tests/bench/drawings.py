#!/usr/bin/env python3
"""Drapes drawings of garments on mannequins of their measures, from the DXF alone and with nothing chosen.

    python3 tests/bench/drawings.py [NAME...] [--drawings DIR] [--body OBJ] [--out DIR] [--limit SECONDS] [--jobs N]

A drawing is NAME.dxf; without --body with its truth NAME.json (tests/data/drawings/README.md), of which only sex and
measures are used. Writes what `toile` writes to OUT/NAME/drape, and a line for each to OUT/drawings.csv: exit code, whether it is
worn, CPU seconds, crossings, seams left open, pieces left out, and the first finding that says why.
"""

import argparse
import csv
import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COLUMNS = ["name", "exit", "worn", "cpu_s", "crossings", "open_seams", "left_out", "why"]


def body_arguments(truth: dict) -> list:
    body = truth["body"]
    return ["--sex", truth["sex"], "--height", str(body["height"]), "--bust", str(body["bust"]),
            "--waist", str(body["waist"]), "--hip", str(body["hip"])]


def run(command: list, log: Path, limit: int) -> int:
    """Exit code; negative where a signal ended it, as the limit of CPU seconds does."""
    with log.open("w") as out:
        return subprocess.run(["prlimit", f"--cpu={limit}", *[str(c) for c in command]], stdout=out,
                              stderr=subprocess.STDOUT, check=False).returncode


def why_of(report: dict) -> str:
    grave = [f for f in report.get("findings", []) if f.get("severity") != "note"]
    told = [f for f in grave if f.get("code", "").startswith("worn.")] or grave
    return f"{told[0]['code']}: {told[0]['message']}"[:120] if told else ""


def drape(name: str, args: argparse.Namespace) -> dict:
    here = args.out / name
    here.mkdir(parents=True, exist_ok=True)
    drawing = args.drawings / f"{name}.dxf"
    row = dict.fromkeys(COLUMNS, "")
    row["name"] = name
    body = args.body.resolve() if args.body else here / "body.obj"
    steps = [
        ("new", ["project", "new", "--pattern", drawing, "--body", body, "--out", here / "project.json"]),
        ("drape", ["drape", here / "project.json", "--out", here / "drape", "--threads", "1"]),
    ]
    if not args.body:
        truth = json.loads(drawing.with_suffix(".json").read_text())
        steps.insert(0, ("body", ["body", "make", *body_arguments(truth), "--out", body]))
    report = here / "drape" / "report.json"
    report.unlink(missing_ok=True)
    for step, command in steps:
        row["exit"] = run([args.toile, *command], here / f"{step}.log", args.limit)
        if row["exit"] != 0:
            break
    if report.exists():
        told = json.loads(report.read_text())
        worst = told["intersections"]["worst_frame"]
        row["worn"] = told.get("worn", "")
        row["cpu_s"] = round(told["cpu_s"], 1)
        row["crossings"] = worst["cloth_body"] + worst["cloth_cloth"]
        row["open_seams"] = len(told.get("open_seams", []))
        row["left_out"] = sum(f["code"] == "piece.left_out" for f in told["findings"])
        row["why"] = why_of(told)
    else:
        lines = (here / f"{step}.log").read_text().strip().splitlines()
        row["why"] = lines[-1][:120] if lines else step
    return row


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--drawings", type=Path, default=ROOT / "tests/data/drawings")
    parser.add_argument("--body", type=Path, help="one for all of them")
    parser.add_argument("--toile", type=Path, default=ROOT / "build/release/toile")
    parser.add_argument("--out", type=Path, default=ROOT / "out/drawings")
    parser.add_argument("--limit", type=int, default=150, help="CPU seconds of one drape")
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    names = args.names or sorted(f.stem for f in args.drawings.glob("*.dxf"))
    for name in names:
        wanted = [args.drawings / f"{name}.dxf"] + ([] if args.body else [args.drawings / f"{name}.json"])
        for file in wanted:
            if not file.exists():
                parser.error(f"there is no {file}; --drawings says where drawings lie, --body goes without measures")
    args.out.mkdir(parents=True, exist_ok=True)
    with (args.out / "drawings.csv").open("w", newline="") as file, ThreadPoolExecutor(args.jobs) as pool:
        table = csv.DictWriter(file, COLUMNS)
        table.writeheader()
        for row in pool.map(lambda name: drape(name, args), names):
            table.writerow(row)
            file.flush()
            print(*(f"{row[c]}" for c in COLUMNS), sep="\t", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
