"""The bench's front door: list its tests, run one or several, on a simulated gyro or on records."""

import difflib
import math
import shutil
from collections.abc import Mapping, Sequence
from dataclasses import replace
from numbers import Integral, Real
from pathlib import Path

import pandas as pd

from pyhrg.bench import catalogue
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import Procedure, evaluate_tests
from pyhrg.bench.reporting.progress import BenchProgress
from pyhrg.bench.reporting.result import (
    PAGE,
    RESULT,
    BenchResults,
    TestFailure,
    TestResult,
    check_folder,
    read_result,
)
from pyhrg.bench.source import Source, open_records, prepare_simulation
from pyhrg.bench.store import Store
from pyhrg.common.arguments import check_seed, choose_workers
from pyhrg.common.errors import HrgError, quote
from pyhrg.common.files import check_page
from pyhrg.common.made_by import check_identity
from pyhrg.common.progress import Show
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign

LOGS_TO_RESUME = ".records"
"""Folder within the output folder. It holds the logs that are done until the run is over, so that
the same call goes on after an interruption."""


def list_tests() -> pd.DataFrame:
    """All tests in the order of a full bench: `name`, `group`, `title`, `reads` (the kinds of
    campaign tests that it evaluates) and `plan` (keywords of `run_test` that change its plan)."""
    rows = [
        (p.name, p.group, p.title, ", ".join(p.kinds), ", ".join(o.name for o in p.options))
        for p in catalogue.PROCEDURES
    ]
    return pd.DataFrame(rows, columns=["name", "group", "title", "reads", "plan"])


def run_test(
    name: str,
    device: Device | str | Path | None = None,
    *,
    campaign: Campaign | str | Path | None = None,
    fmu: str | Path | None = None,
    seed: int = 1,
    workers: int | None = None,
    out: str | Path | None = None,
    force: bool = False,
    progress: Show = None,
    **plan: float | None,
) -> TestResult:
    """Run one test of the bench, on a simulated gyro or on records, and return its result.

    Args:
        name: name of the test, see `list_tests`.
        device: gyro to simulate: a device, the name of a ready one or a device file (TOML); the
            ready device `typical` if None.
        campaign: records to evaluate instead of a simulation: a campaign or its folder.
        fmu: file of an FMU of a class of one's own that is or holds an `HRG`, such as `closed.fmu`
            of a diagnosis; it gets the parameters of `device`.
        seed: seed of all random numbers of the simulation, 0 to 2^63 - 1; the same seed gives the
            same bytes on any number of workers.
        workers: number of power-ons that are simulated at the same time; all cores if None.
        out: output folder for the test's own folder and `report.html`, which shows all tests in
            `out`. None writes nothing.
        force: whether results of another device, seed or version in `out` may be replaced.
        progress: True shows a bar and lines on standard error; a function gets each line.
        plan: options of the test's plan, see `list_tests`; None leaves the default.

    Raises:
        HrgError: an argument that can't be used, or records that can't give the result; the message
            says which, what was found and what was expected.
        OSError: the output folder can't be written.
    """
    return run_tests(
        [name],
        device,
        campaign=campaign,
        fmu=fmu,
        seed=seed,
        workers=workers,
        out=out,
        force=force,
        progress=progress,
        **plan,
    )[name]


def run_tests(
    names: Sequence[str] | str | None = None,
    device: Device | str | Path | None = None,
    *,
    campaign: Campaign | str | Path | None = None,
    fmu: str | Path | None = None,
    seed: int = 1,
    workers: int | None = None,
    out: str | Path | None = None,
    force: bool = False,
    progress: Show = None,
    **plan: float | None,
) -> BenchResults:
    """Run several tests of one gyro; the result has the paper's Table 1 as well.

    Args:
        names: names of the tests. None runs all, or, with a campaign, those that it has records
            for.
        device, campaign, fmu, seed, workers, out, force, progress: see `run_test`.
        plan: see `run_test`; allowed with a single test only.

    Raises:
        HrgError: see `run_test`. If several tests run, a test without figures is listed as a
            failure and the others go on; an error is raised when none gives figures.
        OSError: the output folder can't be written.
    """
    procedures = _choose_procedures(names)
    changes = {name: value for name, value in plan.items() if value is not None}
    _check_gyro(device, campaign, fmu)
    check_seed(seed)
    choose_workers(workers)
    _check_plan(changes, procedures, campaign is not None)
    folder = None if out is None else Path(out)
    if folder is not None:
        _check_places(folder, procedures)
    with BenchProgress(progress) as counter:
        if campaign is not None:
            source = open_records(campaign, procedures)
        else:
            store = None if folder is None else Store(folder / LOGS_TO_RESUME)
            source = prepare_simulation(
                procedures, device, seed, workers, store, counter, changes, fmu
            )
        if folder is not None and not force:
            check_page(folder, bool(_read_kept(folder, source)))
        counter.expect(len(source.procedures))
        try:
            with source.store:
                attempts = [_attempt(source, p, folder, counter) for p in source.procedures]
        except KeyboardInterrupt:
            raise KeyboardInterrupt(f"interrupted; {source.resumption}") from None
    results = BenchResults(source.subject, attempts, source.limits)
    if not results.results:
        reasons = "; ".join(f"{name}: {reason}" for name, reason in results.failures.items())
        raise BenchError(f"no test gave figures; {reasons}")
    if folder is not None:
        _write_page(folder, source, results, force)
    return results


def _check_gyro(device: object, campaign: object, fmu: object) -> None:
    """Refuse more than one gyro, and an FMU without the parameters that it gets."""
    if device is not None and campaign is not None:
        raise HrgError("device, campaign: found both, expected one gyro: simulated or recorded")
    if fmu is not None and device is None:
        raise HrgError("fmu: found no device beside it, expected the one whose parameters it gets")


def describe_readiness(campaign: Campaign) -> str:
    """Which tests of the bench give figures of a campaign, why others do not, and which kinds of
    records no test reads, in words."""
    able, unable = [], []
    for procedure in catalogue.PROCEDURES:
        if campaign.of_kind(*procedure.kinds):
            try:
                able.append(run_test(procedure.name, campaign=campaign).name)
            except HrgError as error:
                unable.append(f"  not {procedure.name}: {error}")
    lines = [f"the bench can run: {', '.join(able) or 'no test'}", *unable]
    read = sorted({kind for procedure in catalogue.PROCEDURES for kind in procedure.kinds})
    for test in campaign.tests:
        if test.kind not in read:
            close = difflib.get_close_matches(test.kind, read, n=1) or read
            expected = f"expected one such as {' or '.join(close)}"
            lines.append(f"  {test.id}: no bench test reads the kind {test.kind}; {expected}")
    return "\n".join(lines)


def _attempt(
    source: Source, procedure: Procedure, out: Path | None, progress: BenchProgress
) -> TestResult | TestFailure:
    """Result of one of the tests, written where there is an output folder."""
    progress.begin(procedure.name)
    try:
        records = source.get_records(procedure)
        outcome = evaluate_tests(procedure, records)
    except HrgError as error:
        if len(source.procedures) == 1:
            raise
        if out is not None:
            shutil.rmtree(out / procedure.name, ignore_errors=True)
        progress.end()
        return TestFailure(procedure, str(error))
    export = procedure.export(records, source.device) if procedure.export else None
    result = TestResult(procedure, outcome, records, source.identity, source.limits, export)
    if out is not None:
        result.write(out / procedure.name)
    progress.end()
    return result


def _read_kept(folder: Path, source: Source) -> list[TestResult]:
    """Results in an output folder; one of another device, seed or version is refused."""
    chosen = [p for p in catalogue.PROCEDURES if (folder / p.name / RESULT).is_file()]
    return [read_result(folder / p.name, p, source.identity) for p in chosen]


def _write_page(folder: Path, source: Source, results: BenchResults, force: bool) -> None:
    """Write report.html of all tests in the folder, without those of another run."""
    for procedure in catalogue.PROCEDURES if force else ():
        try:
            check_identity(folder / procedure.name / RESULT, source.identity)
        except HrgError:
            shutil.rmtree(folder / procedure.name)
    attempts = {result.name: result for result in _read_kept(folder, source)}
    done = {attempt.procedure.name: attempt for attempt in results.attempts}
    order = [procedure.name for procedure in catalogue.PROCEDURES]
    merged = sorted(({**attempts, **done}).items(), key=lambda item: order.index(item[0]))
    replace(results, attempts=[attempt for _, attempt in merged]).write_page(folder)


def _choose_procedures(names: Sequence[str] | str | None) -> Sequence[Procedure]:
    if names is None:
        return catalogue.PROCEDURES
    names = [names] if isinstance(names, str) else names
    by_name = {procedure.name: procedure for procedure in catalogue.PROCEDURES}
    for name in names:
        if name not in by_name:
            close = difflib.get_close_matches(name, by_name, n=1)
            raise HrgError(f"test: found {name!r}, expected {' or '.join(close) or list(by_name)}")
    if not names:
        raise HrgError("names: found no test, expected at least one, or None for all")
    return [by_name[name] for name in dict.fromkeys(names)]


def _check_plan(plan: Mapping[str, float], procedures: Sequence[Procedure], recorded: bool) -> None:
    """Refuse changes of a plan that no simulated test follows, and numbers of another kind."""
    kinds = {o.name: o.kind for o in procedures[0].options} if len(procedures) == 1 else {}
    for name, value in plan.items():
        owners = [p.name for p in catalogue.PROCEDURES if name in (o.name for o in p.options)]
        if recorded or name not in kinds:
            place = f"only with the simulated test {owners[0]}" if owners else "no such argument"
            raise HrgError(f"{name}: found {quote(value)}, expected {place}")
        if not isinstance(value, Integral if kinds[name] is int else Real):
            number = "a whole number" if kinds[name] is int else "a number"
            raise HrgError(f"{name}: found {quote(value)}, expected {number}")
        if not math.isfinite(value):
            raise HrgError(f"{name}: found {value:g}, expected a finite number")


def _check_places(out: Path, procedures: Sequence[Procedure]) -> None:
    """Refuse, before the work, an output folder that can't take the results."""
    above = next(path for path in (out, *out.absolute().parents) if path.exists())
    if not above.is_dir():
        raise HrgError(f"can't write {out}: {above} is no folder")
    if (out / PAGE).is_dir():
        raise HrgError(f"can't write {out}: {out / PAGE} is a folder")
    for procedure in procedures:
        check_folder(out / procedure.name)
