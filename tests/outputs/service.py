"""`toile serve` as a child, and requests to it."""

import http.client
import json
import signal
import subprocess
import time

from masks import Ids

STARTS_WITHIN_S = 60
ANSWERS_WITHIN_S = 120


class Answer:
    def __init__(self, response):
        self.status = response.status
        # The date is the clock's; the length goes with masked fields, and the body itself is compared.
        self.headers = sorted((name, value) for name, value in response.getheaders()
                              if name.lower() not in ("date", "content-length"))
        self.body = response.read()

    @property
    def json(self):
        return json.loads(self.body)

    def as_bytes(self):
        head = "".join(f"{name}: {value}\n" for name, value in self.headers)
        return f"{self.status}\n{head}\n".encode() + self.body


class Service:
    def __init__(self, program, folder, data, options):
        self.ids = Ids()
        self.log = open(folder / "service.log", "ab")
        self.child = subprocess.Popen(
            [program, "serve", "--port", "0", "--data", data, *options], cwd=folder, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=self.log)
        self.greeting = self.child.stdout.readline()
        if b"http://" not in self.greeting:
            raise RuntimeError(f"the service did not start: {(folder / 'service.log').read_text()}")
        self.port = int(self.greeting.split(b"http://")[1].split(b"/")[0].split(b":")[1])
        self.url = f"http://127.0.0.1:{self.port}"

    def ask(self, method, target, body=None, headers=None):
        """`body`: bytes as they are, anything else as JSON."""
        headers = dict(headers or {})
        if body is not None and not isinstance(body, bytes):
            body = json.dumps(body).encode()
            headers.setdefault("Content-Type", "application/json")
        elif body is not None:
            headers.setdefault("Content-Type", "application/octet-stream")
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=ANSWERS_WITHIN_S)
        try:
            connection.request(method, target, body, headers)
            return Answer(connection.getresponse())
        finally:
            connection.close()

    def upload(self, kind, name, data):
        """The id of a file that is kept."""
        return self.ask("POST", f"/api/v1/assets?kind={kind}&name={name}", data).json["id"]

    def make(self, document, files):
        """The id of a project that is made."""
        return self.ask("POST", "/api/v1/projects", {"document": document, "files": files}).json["id"]

    def submit(self, project):
        """The id of a job."""
        return self.ask("POST", "/api/v1/jobs", {"project_id": project}).json["id"]

    def job(self, job):
        return self.ask("GET", f"/api/v1/jobs/{job}").json

    def wait_for(self, job, states=("succeeded", "failed", "cancelled")):
        """Until the job is in one of these states; the job."""
        while (found := self.job(job))["state"] not in states:
            time.sleep(0.02)
        return found

    def stop(self):
        """In good order; the exit code."""
        self.child.send_signal(signal.SIGTERM)
        self.rest = self.child.stdout.read()
        return self.child.wait()

    def kill(self):
        if self.child.poll() is None:
            self.child.kill()
            self.child.wait()
        self.child.stdout.close()
        self.log.close()
