"""An interrupted run resumes from logs that were made under the same circumstances only."""

import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.bench import catalogue
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.position import fixed_position
from pyhrg.bench.session import LOGS_TO_RESUME
from pyhrg.bench.store import Store
from pyhrg.common.cli import main
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from tests.pyhrg.bench.cases import slow_bench
from tests.pyhrg.bench.quick import LONG, LONG_TEST

ROOT = Path(__file__).parents[3]
PATIENCE = 10.0
"""Longest time that an interruption may take, s: a fraction of one on a machine that is not busy
with other things."""


def start_run(out: Path) -> "subprocess.Popen[str]":
    arguments = ["bench", "long", "--seed", "5", "--workers", "2", "--out", str(out)]
    return subprocess.Popen(
        [sys.executable, "-m", "tests.pyhrg.bench.quick", *arguments],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def list_logs(out: Path) -> set[str]:
    return {path.name for path in (out / LOGS_TO_RESUME).glob("*.npz")}


def read_files(folder: Path) -> dict[str, bytes]:
    files = (path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def test_interrupted_run_goes_on_to_the_same_bytes(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    out, whole = tmp_path / "out", tmp_path / "whole"
    with start_run(out) as run:
        while not list_logs(out) and run.poll() is None:
            time.sleep(0.02)
        run.send_signal(signal.SIGINT)
        begun = time.monotonic()
        said = run.communicate(timeout=60)
    assert time.monotonic() - begun < PATIENCE
    assert run.returncode == 130
    assert said[0] == ""
    assert said[1].endswith("hrg: interrupted; the same command goes on from here\n")
    before = list_logs(out)
    assert set(read_files(out)) == {f"{LOGS_TO_RESUME}/{name}" for name in before}
    monkeypatch.setattr(catalogue, "PROCEDURES", (LONG_TEST,))
    made = count_simulated(monkeypatch)
    assert main(["bench", "long", "--seed", "5", "--out", str(out)]) == 0
    assert len(made) == LONG - len(before)
    assert main(["bench", "long", "--seed", "5", "--out", str(whole)]) == 0
    assert read_files(out) == read_files(whole)
    assert not (out / LOGS_TO_RESUME).exists()


def count_simulated(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Ids of the power-ons that are simulated from now on."""
    made: list[str] = []
    simulate = Bench._simulate

    def recorded(bench: Bench, power_ons: Sequence[PowerOn]) -> object:
        made.extend(power_on.id for power_on in power_ons)
        return simulate(bench, power_ons)

    monkeypatch.setattr(Bench, "_simulate", recorded)
    return made


@pytest.fixture
def kept_bench(slow_fmu: GyroFmu, tmp_path: Path) -> Bench:
    """A bench that keeps its logs, and has kept one."""
    store = Store(tmp_path / LOGS_TO_RESUME)
    store.folder.mkdir()
    bench = replace(slow_bench(slow_fmu, TYPICAL), store=store)
    bench.run([power_on(bench)])
    return bench


def power_on(bench: Bench, segments: int = 1) -> PowerOn:
    return fixed_position.make_power_ons(bench, 1, segments)[0]


def test_same_circumstances_are_not_simulated_again(
    kept_bench: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    again = power_on(kept_bench)
    fresh = replace(kept_bench, store=None).log(again).log
    made = count_simulated(monkeypatch)
    log = kept_bench.log(again).log
    assert made == []
    assert log.source == fresh.source
    for name, values in vars(fresh).items():
        assert np.array_equal(getattr(log, name), values, equal_nan=isinstance(values, np.ndarray))


@pytest.mark.parametrize(
    "changes",
    [
        {"seed": 2},
        {"step": 0.05},
        {"device": replace(TYPICAL, decay_time=451.0)},
        {"device": replace(TYPICAL, model={"resonator.material.duffing": 0.0})},
    ],
    ids=["seed", "step", "device", "model"],
)
def test_another_bench_is_simulated(
    kept_bench: Bench, monkeypatch: pytest.MonkeyPatch, changes: dict[str, object]
) -> None:
    made = count_simulated(monkeypatch)
    replace(kept_bench, **changes).log(power_on(kept_bench))
    assert made == ["fixed_1"]


def test_another_model_is_simulated(
    kept_bench: Bench, fmu: GyroFmu, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = count_simulated(monkeypatch)
    replace(kept_bench, fmu=fmu).log(power_on(kept_bench))
    assert made == ["fixed_1"]


def test_another_power_on_is_simulated(kept_bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another programme, down to one command of one row; another start angle; another name."""
    first = power_on(kept_bench)
    turned = kept_bench.programme().attitude(0.0).rest(120.0).command(axis_up=1e-9).rest(10.0)
    others = [
        power_on(kept_bench, segments=2),
        replace(first, programme=turned),
        replace(first, start_angle=0.1),
        replace(first, id="fixed_2"),
    ]
    made = count_simulated(monkeypatch)
    for other in others:
        kept_bench.log(other)
    assert len(made) == len(others)


def test_spoilt_log_is_made_again(kept_bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    assert kept_bench.store
    (file,) = kept_bench.store.folder.iterdir()
    file.write_bytes(file.read_bytes()[:1000])
    made = count_simulated(monkeypatch)
    kept_bench.log(power_on(kept_bench))
    assert made == ["fixed_1"]


def test_run_that_ends_leaves_nothing(slow_fmu: GyroFmu, tmp_path: Path) -> None:
    store = Store(tmp_path / LOGS_TO_RESUME)
    with store.open():
        bench = replace(slow_bench(slow_fmu, TYPICAL), store=store)
        bench.run([power_on(bench)])
        assert [path.suffix for path in store.folder.iterdir()] == [".npz"]
    assert list(tmp_path.iterdir()) == []


def test_run_that_made_nothing_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), Store(tmp_path / LOGS_TO_RESUME).open():
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []
