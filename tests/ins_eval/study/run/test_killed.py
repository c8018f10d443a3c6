"""Commands, workers and schedulers are killed; nothing finished is lost or done twice."""

import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from ins_eval.study import study_file
from ins_eval.study.run import block
from tests.ins_eval.study import cases
from tests.ins_eval.study.run import cheap
from tests.ins_eval.study.run.processes import (
    Gate,
    contents,
    said,
    scheduler,
    study_command,
    undisturbed,
    worker,
)

BLOCKS = block.count_blocks(cases.study())


@pytest.fixture
def gate() -> Iterator[Gate]:
    with Gate() as opened:
        yield opened


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return cases.study_file(tmp_path)


def test_killed_command_goes_on_from_what_it_kept(file: Path, tmp_path: Path, gate: Gate) -> None:
    """First a worker is killed, then the command, while blocks are under way on both workers."""
    out = tmp_path / "out"
    with study_command(file, out, "--workers", "2", environment=gate.environment) as run:
        first, second = gate.visitor(), gate.visitor()
        first.kill()
        second.pass_through()
        assert said(run) == f"kept {second.number}\n"
        orphans = [gate.visitor(), gate.visitor()]
        run.kill()
        for orphan in orphans:
            orphan.wait_until_gone()
    assert set(contents(out)) == {"identity.json", f"blocks/{second.number:06d}.npz"}
    with study_command(file, out, "--workers", "1", environment=gate.environment) as run:
        again = gate.pass_all(BLOCKS - 1)
        assert run.wait(60) == 0
    assert sorted([second.number, *again]) == list(range(BLOCKS))
    assert contents(out) == undisturbed(
        study_file.read_study(file), cheap.CHEAP, tmp_path / "undisturbed"
    )


def test_command_killed_in_its_conclusion_does_no_block_again(
    file: Path, tmp_path: Path, gate: Gate
) -> None:
    out, last = tmp_path / "out", BLOCKS
    environment = {**gate.environment, cheap.CONCLUSION: str(last)}
    with study_command(file, out, "--workers", "1", environment=environment) as run:
        gate.pass_all(BLOCKS)
        concluding = gate.visitor()
        assert concluding.number == last
        run.kill()
        concluding.wait_until_gone()
    assert not {"triads.txt", "draws.json"} & set(contents(out))
    with study_command(file, out, "--workers", "1", environment=environment) as run:
        assert gate.pass_all(1) == [last]
        assert run.wait(60) == 0
    assert contents(out) == undisturbed(
        study_file.read_study(file), cheap.CHEAP, tmp_path / "undisturbed"
    )


def test_terminated_command_says_how_to_go_on(file: Path, tmp_path: Path, gate: Gate) -> None:
    out = tmp_path / "out"
    with study_command(file, out, "--workers", "1", environment=gate.environment) as run:
        (first,) = gate.pass_all(1)
        assert said(run) == f"kept {first}\n"
        visitor = gate.visitor()
        run.terminate()
        errors = run.communicate(timeout=60)[1]
        visitor.wait_until_gone()
    assert run.returncode == 130
    assert errors.endswith("hrg: interrupted; the same command goes on from here\n"), errors
    assert set(contents(out)) == {"identity.json", f"blocks/{first:06d}.npz"}


def test_interrupted_command_says_how_to_go_on(file: Path, tmp_path: Path, gate: Gate) -> None:
    out = tmp_path / "out"
    with study_command(file, out, "--workers", "1", environment=gate.environment) as run:
        (first,) = gate.pass_all(1)
        assert said(run) == f"kept {first}\n"
        visitor = gate.visitor()
        os.killpg(run.pid, signal.SIGINT)  # as a terminal does: workers too
        errors = run.communicate(timeout=60)[1]
        visitor.wait_until_gone()
    assert run.returncode == 130
    assert errors.endswith("hrg: interrupted; the same command goes on from here\n"), errors
    assert "Traceback" not in errors
    assert "distributed" not in errors
    assert set(contents(out)) == {"identity.json", f"blocks/{first:06d}.npz"}


def test_cluster_that_loses_its_workers_goes_on(file: Path, tmp_path: Path, gate: Gate) -> None:
    """The only worker is killed within a block; others join."""
    out = tmp_path / "out"
    with (
        scheduler() as (_, address),
        worker(address, gate.environment),
        study_command(file, out, "--scheduler", address) as run,
    ):
        (first,) = gate.pass_all(1)
        assert said(run) == f"kept {first}\n"
        gate.visitor().kill()
        with worker(address, gate.environment), worker(address, gate.environment):
            passed = gate.pass_all(BLOCKS - 1)
            assert run.wait(60) == 0
    assert sorted([first, *passed]) == list(range(BLOCKS))
    assert contents(out) == undisturbed(
        study_file.read_study(file), cheap.CHEAP, tmp_path / "undisturbed"
    )


def test_killed_command_goes_on_with_the_same_cluster(
    file: Path, tmp_path: Path, gate: Gate
) -> None:
    """Blocks that the worker had begun for the killed command may be done again; none that was
    kept is."""
    out = tmp_path / "out"
    with scheduler() as (_, address), worker(address, gate.environment):
        with study_command(file, out, "--scheduler", address) as run:
            (first,) = gate.pass_all(1)
            assert said(run) == f"kept {first}\n"
            under_way = gate.visitor()
            run.kill()
        under_way.pass_through()
        with study_command(file, out, "--scheduler", address) as run:
            passed = gate.pass_until_ended(run)
        assert run.returncode == 0
    assert first not in passed
    assert set(passed) | {first, under_way.number} == set(range(BLOCKS))
    assert len(passed) <= BLOCKS + 1
    assert contents(out) == undisturbed(
        study_file.read_study(file), cheap.CHEAP, tmp_path / "undisturbed"
    )


def test_block_that_kills_its_workers_is_named(file: Path, tmp_path: Path, gate: Gate) -> None:
    environment = {**gate.environment, "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "0"}
    with study_command(file, tmp_path / "out", "--workers", "1", environment=environment) as run:
        visitor = gate.visitor()
        visitor.kill()
        errors = run.communicate(timeout=60)[1]
    assert run.returncode == 2
    assert f"hrg: block {visitor.number}: found its workers killed" in errors


def test_lost_scheduler_is_told(file: Path, tmp_path: Path, gate: Gate) -> None:
    environment = {**gate.environment, "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "1s"}
    out = tmp_path / "out"
    with (
        scheduler() as (lost, address),
        worker(address, gate.environment),
        study_command(file, out, "--scheduler", address, environment=environment) as run,
    ):
        (first,) = gate.pass_all(1)
        assert said(run) == f"kept {first}\n"
        with gate.visitor().connection:
            lost.kill()
            errors = run.communicate(timeout=60)[1]
    assert run.returncode == 2
    assert "the scheduler is gone; the same command goes on" in errors
    assert set(contents(out)) == {"identity.json", f"blocks/{first:06d}.npz"}
