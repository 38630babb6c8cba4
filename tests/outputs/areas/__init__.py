"""The areas: each collects the outputs of one part of the program, in a folder of its own."""

from typing import Callable, NamedTuple

from . import (bad_input, bodies, checkpoints, checks, drapes, edits, help_texts, jobs, patterns, projects, routes,
               shared_bodies, shared_drapes, shared_patterns, shared_projects, streams)


class Area(NamedTuple):
    collect: Callable
    quick: bool = True
    needs_shared: bool = False


AREAS = {
    "help": Area(help_texts.collect),
    "checks": Area(checks.collect),
    "patterns": Area(patterns.collect),
    "projects": Area(projects.collect),
    "bodies": Area(bodies.collect),
    "drapes": Area(drapes.collect),
    "bad_input": Area(bad_input.collect),
    "routes": Area(routes.collect),
    "edits": Area(edits.collect),
    "jobs": Area(jobs.collect, quick=False),
    "streams": Area(streams.collect, quick=False),
    "checkpoints": Area(checkpoints.collect, quick=False),
    "shared_patterns": Area(shared_patterns.collect, quick=False, needs_shared=True),
    "shared_bodies": Area(shared_bodies.collect, needs_shared=True),
    "shared_projects": Area(shared_projects.collect, quick=False, needs_shared=True),
    "shared_drapes": Area(shared_drapes.collect, quick=False, needs_shared=True),
}
