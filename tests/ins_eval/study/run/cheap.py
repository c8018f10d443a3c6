"""`hrg` with a cheap experiment in place of the study's own, each of whose blocks asks for leave.

Run as a module, in a process of its own, so that it can be killed. Workers import it too: what the
command alone needs, and takes seconds to import, is imported there.
"""

import json
import os
import socket
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path

import numpy as np

from ins_eval.study.run.block import Arrays, count_block_triads
from ins_eval.study.run.run import Experiment
from ins_eval.study.specification import Study

GATE = "HRG_TEST_GATE"
"""Environment variable: port at which a test lets blocks through, one by one."""

CONCLUSION = "HRG_TEST_CONCLUSION"
"""Likewise: number with which the conclusion, half done, asks for leave."""


def ask(what: int) -> None:
    """At the gate, if there is one, and wait there."""
    if port := os.environ.get(GATE):
        with socket.create_connection(("127.0.0.1", int(port))) as test:
            test.sendall(f"{what} {os.getpid()}\n".encode())
            assert test.recv(1), "the test has gone"


def made(study: Study, triads: range) -> Arrays:
    ask(triads.start // count_block_triads(study))
    seeds = [np.random.SeedSequence(study.seed, spawn_key=(triad,)) for triad in triads]
    return {
        "triad": np.array(triads),
        "draw": np.array([np.random.default_rng(seed).normal(size=3) for seed in seeds]),
    }


def conclude(study: Study, arrays: Arrays, folder: Path) -> None:
    (folder / "triads.txt").write_text(" ".join(map(str, arrays["triad"])))
    if CONCLUSION in os.environ:
        ask(int(os.environ[CONCLUSION]))
    (folder / "draws.json").write_text(json.dumps(arrays["draw"].tolist()))


CHEAP = Experiment(made, conclude, ("triads.txt", "draws.json"))


def install() -> None:
    """Put the cheap experiment, which has no verdict, in the place of the study's."""
    from ins_eval.study import run_study

    run_study.make_experiment = lambda study: CHEAP
    run_study.StudyResult.verdict = "cheap"  # type: ignore[method-assign,assignment]


def announcing() -> None:
    """Say on stdout which block is kept, once it is."""
    from ins_eval.study.run.folder import StudyFolder

    keep = StudyFolder.keep

    def announced(folder: StudyFolder, number: int, file: bytes) -> None:
        keep(folder, number, file)
        print("kept", number, flush=True)

    StudyFolder.keep = announced  # type: ignore[method-assign]


def only_study(group: str) -> list[EntryPoint]:
    """Of the commands' entry points; the others take long to load."""
    return [entry for entry in entry_points(group=group) if entry.name == "study"]


if __name__ == "__main__":
    import sys

    from pyhrg.common import cli
    from tests.ins_eval.study.run import cheap

    cli.entry_points = only_study  # type: ignore[assignment]
    cheap.install()
    announcing()
    sys.exit(cli.main(sys.argv[1:]))
