"""Commands, schedulers and workers in processes of their own, and a gate that blocks pass."""

import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from ins_eval.study.run import block
from ins_eval.study.run.run import Experiment
from ins_eval.study.specification import Study
from tests.ins_eval.study.run import cheap

ROOT = Path(__file__).parents[4]
PATIENCE = 60.0
"""With anything that must happen, s: a test that waits longer has failed."""


@dataclass(frozen=True)
class Visitor:
    """A worker that asks whether it may do a block."""

    number: int
    pid: int
    connection: socket.socket

    def pass_through(self) -> None:
        with self.connection:
            self.connection.sendall(b"\n")

    def kill(self) -> None:
        os.kill(self.pid, signal.SIGKILL)
        self.wait_until_gone()

    def wait_until_gone(self) -> None:
        with self.connection:
            assert self.connection.recv(1) == b""


class Gate:
    """Where blocks ask for leave; those in `environment` come here."""

    def __init__(self) -> None:
        self.server = socket.create_server(("127.0.0.1", 0))
        self.server.settimeout(PATIENCE)
        self.environment = {**os.environ, cheap.GATE: str(self.server.getsockname()[1])}

    def __enter__(self) -> "Gate":
        return self

    def __exit__(self, *_: object) -> None:
        self.server.close()

    def visitor(self) -> Visitor:
        """The next."""
        connection, _ = self.server.accept()
        connection.settimeout(PATIENCE)
        with connection.makefile() as lines:
            number, pid = map(int, lines.readline().split())
        return Visitor(number, pid, connection)

    def pass_all(self, count: int) -> list[int]:
        """Let so many through; their numbers."""
        numbers = []
        for _ in range(count):
            visitor = self.visitor()
            numbers.append(visitor.number)
            visitor.pass_through()
        return numbers

    def pass_until_ended(self, run: "subprocess.Popen[str]") -> list[int]:
        """Let all through until a command ends; their numbers."""
        numbers, deadline = [], time.monotonic() + PATIENCE
        self.server.settimeout(0.2)
        while run.poll() is None:
            assert time.monotonic() < deadline
            with suppress(TimeoutError):
                numbers += self.pass_all(1)
        self.server.settimeout(PATIENCE)
        return numbers


@contextmanager
def process(
    *arguments: str, environment: dict[str, str] | None = None
) -> Iterator["subprocess.Popen[str]"]:
    """Python with these arguments, in a process group of its own, killed at the end."""
    started = subprocess.Popen(
        [sys.executable, *arguments],
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    with started:
        try:
            yield started
        finally:
            started.kill()


@contextmanager
def study_command(
    file: Path, out: Path, *options: str, environment: dict[str, str] | None = None
) -> Iterator["subprocess.Popen[str]"]:
    """`hrg study` with the cheap experiment."""
    arguments = ("-m", "tests.ins_eval.study.run.cheap", "study", str(file), "--out", str(out))
    with process(*arguments, *options, environment=environment) as run:
        yield run


@contextmanager
def scheduler() -> Iterator[tuple["subprocess.Popen[str]", str]]:
    """A Dask scheduler, and its address."""
    arguments = ("-m", "dask", "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard")
    with process(*arguments) as run:
        assert run.stderr
        for line in run.stderr:
            if found := re.search(r"Scheduler at:\s+(tcp://\S+)", line):
                yield run, found[1]
                return
        raise AssertionError("the scheduler ended")


@contextmanager
def worker(address: str, environment: dict[str, str]) -> Iterator["subprocess.Popen[str]"]:
    """A Dask worker of one thread."""
    options = ("--nthreads", "1", "--no-nanny", "--no-dashboard")
    with process("-m", "dask", "worker", address, *options, environment=environment) as run:
        yield run


def said(run: "subprocess.Popen[str]") -> str:
    """The next line on stdout."""
    assert run.stdout
    return run.stdout.readline()


def contents(folder: Path) -> dict[str, bytes]:
    """Of all files, by name."""
    files = (path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def undisturbed(study: Study, experiment: Experiment, folder: Path) -> dict[str, bytes]:
    """What the study gives without workers or interruptions."""
    folder.mkdir()
    made = [
        experiment.compute(study, block.list_triads(study, n))
        for n in range(block.count_blocks(study))
    ]
    experiment.conclude(study, block.join_blocks(made), folder)
    (folder / "identity.json").write_text(block.identify_study(study).text)
    return contents(folder)
