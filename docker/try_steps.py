#!/usr/bin/env python3
"""Runs the steps of docker/Dockerfile without a container engine.

Each stage is a folder with a bare Debian 12 (debootstrap), changed by the stage's own lines: WORKDIR, COPY, RUN, USER,
ENTRYPOINT, HEALTHCHECK. The last stage's ENTRYPOINT is then started in it and must answer /healthz as healthy within a
minute, and its HEALTHCHECK must say so.
RUN lines get what an engine's build on this host would be given: its proxies, its npm registry and the certificate
authorities that it trusts. None of that stays in a stage.
Needs root and debootstrap; makes everything under the folder given (default build/docker) and unmounts what it mounts.
"""

import contextlib
import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
START_SECONDS = 60
AUTHORITIES = "/run/host-authorities.crt"  # in a stage, while a RUN line runs


def host_authorities():
    """The host's bundle of certificate authorities, or None."""
    named = [os.environ.get(name) for name in ("NODE_EXTRA_CA_CERTS", "SSL_CERT_FILE", "CURL_CA_BUNDLE")]
    known = [*named, npm_setting("cafile"), "/etc/ssl/certs/ca-certificates.crt"]
    return next((Path(path) for path in known if path and Path(path).is_file()), None)


def npm_setting(name):
    """As npm on this host has it; empty without npm or when it is not set."""
    if not shutil.which("npm"):
        return ""
    value = subprocess.run(["npm", "config", "get", name], capture_output=True, text=True, cwd="/").stdout.strip()
    return "" if value in ("null", "undefined") else value


def host_settings():
    """Environment of the RUN lines."""
    names = ("http_proxy", "https_proxy", "no_proxy", "all_proxy")
    settings = {name: os.environ[name] for lower in names for name in (lower, lower.upper()) if name in os.environ}
    if registry := npm_setting("registry"):
        settings["NPM_CONFIG_REGISTRY"] = registry
    if host_authorities():
        settings |= dict.fromkeys(("NODE_EXTRA_CA_CERTS", "SSL_CERT_FILE", "CURL_CA_BUNDLE"), AUTHORITIES)
    return settings


def steps(dockerfile):
    """(instruction, rest) of every line, continuations joined, comments left out."""
    pending = ""
    for line in dockerfile.read_text().splitlines():
        if not pending and (not line.strip() or line.lstrip().startswith("#")):
            continue
        pending += line.rstrip("\\")
        if line.endswith("\\"):
            continue
        instruction, rest = pending.split(None, 1)
        yield instruction, rest.strip()
        pending = ""


class Stage:
    """A folder that stands for an image."""

    def __init__(self, folder, base):
        self.folder, self.workdir, self.user, self.entrypoint, self.health = folder, "/", "root", None, None
        if folder.exists():
            for name in ("dev", "proc"):  # of a run that was killed: what is mounted must not be removed with it
                while os.path.ismount(folder / name):
                    subprocess.run(["umount", "--lazy", folder / name], check=True)
            shutil.rmtree(folder)
        subprocess.run(["cp", "-a", "--reflink=auto", base, folder], check=True)
        for name in ("/etc/resolv.conf", "/etc/hosts"):
            shutil.copy(name, str(folder) + name)

    def inside(self, path):
        return self.folder / path.lstrip("/")

    @contextlib.contextmanager
    def mounted(self):
        with contextlib.ExitStack() as undo:
            for name in ("proc", "dev"):
                subprocess.run(["mount", "--bind", "/" + name, self.inside(name)], check=True)
                undo.callback(subprocess.run, ["umount", "--lazy", self.inside(name)], check=True)
            yield

    @contextlib.contextmanager
    def host_trusted(self):
        """What the host trusts is trusted within, by programs that look where host_settings() says."""
        bundle, place = host_authorities(), self.inside(AUTHORITIES)
        if bundle:
            shutil.copy(bundle, place)
        try:
            yield
        finally:
            place.unlink(missing_ok=True)

    def command(self, argv):
        as_user = ["--userspec", self.user] if self.user != "root" else []
        entry = "cd " + shlex.quote(self.workdir) + " && exec " + shlex.join(argv)
        environment = {"PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
                       "HOME": "/root" if self.user == "root" else self.workdir, "DEBIAN_FRONTEND": "noninteractive"}
        return ["chroot", *as_user, str(self.folder), "/bin/sh", "-c", entry], environment

    def run(self, line):
        argv, environment = self.command(["/bin/sh", "-c", line])
        with self.mounted(), self.host_trusted():
            subprocess.run(argv, env=environment | host_settings(), check=True)

    def copy(self, words, stages):
        source_root = ROOT
        if words[0].startswith("--from="):
            source_root = stages[words.pop(0).removeprefix("--from=")].folder
        target = self.inside(words[-1])
        for word in words[:-1]:
            source = source_root / word.lstrip("/")
            if source.is_dir():
                ignored = shutil.ignore_patterns("node_modules", "dist") if source_root == ROOT else None
                shutil.copytree(source, target, dirs_exist_ok=True, symlinks=True, ignore=ignored)
            else:
                place = target / source.name if words[-1].endswith("/") else target
                place.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(source, place)


def bare_debian(folder):
    """Made under another name first, so that half of one is never taken for the whole."""
    if not folder.exists():
        half = folder.with_suffix(".half")
        shutil.rmtree(half, ignore_errors=True)
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", half], check=True, stdout=subprocess.DEVNULL)
        half.rename(folder)
    return folder


def build(dockerfile, place):
    base = bare_debian(place / "base")
    stages, stage = {}, None
    for instruction, rest in steps(dockerfile):
        print(f"== {instruction} {rest[:100]}", flush=True)
        if instruction == "FROM":
            image, _, name = rest.split()
            if image != "debian:12-slim":  # minbase has less than it
                raise SystemExit(f"only debian:12-slim can stand as a base here, not {image}")
            stage = stages[name] = Stage(place / name, base)
        elif instruction == "WORKDIR":
            stage.workdir = rest
            stage.inside(rest).mkdir(parents=True, exist_ok=True)
        elif instruction == "COPY":
            stage.copy(shlex.split(rest), stages)
        elif instruction == "RUN":
            stage.run(rest)
        elif instruction == "USER":
            stage.user = rest
        elif instruction == "ENTRYPOINT":
            stage.entrypoint = json.loads(rest)
        elif instruction == "HEALTHCHECK":
            stage.health = json.loads(rest[rest.index("CMD ") + len("CMD "):])
        elif instruction == "EXPOSE":
            pass  # for people: nothing is published here
        else:
            raise SystemExit(f"docker/try_steps.py does not know the instruction {instruction}")
    return stage


def healthy(port):
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/healthz", timeout=2) as answer:
            return answer.status == 200
    except OSError:
        return False


def serve(stage):
    """Starts the entry point, waits until it is healthy, ends it."""
    port = stage.entrypoint[stage.entrypoint.index("--port") + 1]
    argv, environment = stage.command(stage.entrypoint)
    with stage.mounted():
        service = subprocess.Popen(argv, env=environment)
        try:
            deadline = time.monotonic() + START_SECONDS
            while time.monotonic() < deadline and service.poll() is None and not healthy(port):
                time.sleep(0.2)
            if service.poll() is not None or not healthy(port):
                raise SystemExit("the service did not become healthy")
            owner = os.stat(f"/proc/{service.pid}").st_uid
            if owner == 0:
                raise SystemExit("the service runs as root")
            check, surroundings = stage.command(stage.health)
            if subprocess.run(check, env=surroundings).returncode != 0:
                raise SystemExit("the health check does not find the service healthy")
            print(f"== healthy on port {port}, as user {owner}")
        finally:
            service.send_signal(signal.SIGTERM)
            service.wait(60)


if __name__ == "__main__":
    if os.geteuid() != 0 or not shutil.which("debootstrap"):
        raise SystemExit("docker/try_steps.py needs root and debootstrap")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended from outside"))  # so that it still unmounts
    where = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/docker").resolve()
    where.mkdir(parents=True, exist_ok=True)
    serve(build(ROOT / "docker/Dockerfile", where))
    print("== The Dockerfile's steps work")
