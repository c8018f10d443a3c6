"""Tests done one after the other, on the virtual bench or on a campaign; results as folders."""

import shutil
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from fmu_build.bundle import built_fmu
from fmu_build.roots import ROOTS
from pyhrg.bench.bench import Bench
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting import parameter_system, report
from pyhrg.bench.reporting.page import PAGE, page
from pyhrg.bench.reporting.progress import Progress
from pyhrg.bench.reporting.report import Result, Results
from pyhrg.bench.store import Store
from pyhrg.common.files import replaced_folder, write_whole
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.fmu import GyroError, GyroFmu
from pyhrg.records import LogError
from pyhrg.records import campaign as campaigns
from pyhrg.records.campaign import Campaign

EXPORT = "device.toml"
KEPT = ".records"
"""Folder, within the output's, of logs to resume from."""


@dataclass(frozen=True)
class Source:
    """Where records come from.

    subject: the gyro, and how it is tested.
    procedures: that there are records for.
    records: the campaign that a procedure evaluates.
    device: that is tested, or what is believed of it.
    resumes: what the same command does after an interruption.
    seed: of the virtual bench.
    limits: the specification.
    kept: open while the tests are done.
    """

    subject: str
    procedures: Sequence[Procedure]
    records: Callable[[Procedure, Progress], Campaign]
    device: Device
    resumes: str
    seed: int | None = None
    limits: Mapping[str, float] = field(default_factory=dict)
    kept: AbstractContextManager[object] = field(default_factory=nullcontext)


def fmus(procedures: Sequence[Procedure], say: Callable[[str], None]) -> dict[str, GyroFmu]:
    """The procedures' FMUs by model, built where they aren't yet.

    Raises:
        TranslationError, BuildError, OSError.
    """
    models = sorted({procedure.model for procedure in procedures})
    return {
        model: GyroFmu(built_fmu(partial(_tell, say, model), root=ROOTS[model])) for model in models
    }


def _tell(say: Callable[[str], None], model: str, text: str) -> None:
    say(f"FMU {model}: {text}")


def simulated(
    procedures: Sequence[Procedure],
    gyros: Mapping[str, GyroFmu],
    device: Device,
    seed: int,
    workers: int,
    out: Path,
    options: Mapping[str, float],
) -> Source:
    """A gyro on the virtual bench; a log once made is kept until all is done.

    Options are those of the only procedure.
    """
    store = Store(out / KEPT)

    def records(procedure: Procedure, progress: Progress) -> Campaign:
        fmu = gyros[procedure.model]
        bench = Bench(fmu, device, seed, procedure.step, workers, store, progress.power_on)
        return bench.campaign(procedure.record(bench, **options))

    subject = f"{device.name or 'gyro without a name'}, simulated with seed {seed}"
    resumes = "the same command goes on from here"
    return Source(subject, procedures, records, device, resumes, seed, device.specification, store)


def recorded(campaign: Campaign, procedures: Sequence[Procedure]) -> Source:
    """A campaign that was brought home; of several procedures, those whose kind of test it has.

    Raises:
        BenchError: it has none.
        DeviceError: what is nominally believed of the gyro is no device.
    """
    able = [p for p in procedures if campaign.of_kind(*p.kinds)]
    if len(procedures) > 1 and not able:
        kinds = ", ".join(sorted({test.kind for test in campaign.tests})) or "no tests"
        raise BenchError(f"{campaign.device}: no test evaluates a campaign that has {kinds}")
    subject = f"{campaign.device}, recorded"
    resumes = "the same command begins again"
    chosen = able if len(procedures) > 1 else procedures
    device = device_file.from_table(campaign.nominal, campaign.device)
    return Source(subject, chosen, lambda procedure, progress: campaign, device, resumes)


def perform(source: Source, out: Path, progress: Progress) -> Results:
    """Do the tests; write a folder for each that gave figures, and a page of all.

    Raises:
        BenchError, LogError, GyroError: the only test could not be done, or none of several.
        OSError: the folder can't be written.
    """
    try:
        with source.kept:
            results = [_result(source, p, out, progress) for p in source.procedures]
    except KeyboardInterrupt:
        raise KeyboardInterrupt(f"interrupted; {source.resumes}") from None
    if not any(result.outcome for result in results):
        reasons = "; ".join(f"{r.procedure.name}: {r.reason}" for r in results)
        raise BenchError(f"no test gave figures; {reasons}")
    outcomes = [result.outcome for result in results if result.outcome]
    overview = parameter_system.table(outcomes) if len(results) > 1 else None
    done = Results(source.subject, tuple(results), source.limits, overview)
    write_whole(out / PAGE, page(done).encode())
    return done


def _result(source: Source, procedure: Procedure, out: Path, progress: Progress) -> Result:
    """What the records can't give is said, and ends a single test."""
    progress.begin(procedure.name)
    folder = out / procedure.name
    try:
        records = source.records(procedure, progress)
        outcome = procedure.evaluate(records)
    except (BenchError, LogError, GyroError) as error:
        if len(source.procedures) == 1:
            raise
        shutil.rmtree(folder, ignore_errors=True)
        progress.end()
        return Result(procedure, None, str(error))
    with replaced_folder(folder) as aside:
        report.write(procedure, outcome, source.seed, source.limits, aside)
        if source.seed is not None:
            campaigns.write(records, aside)
        if procedure.exported:
            device_file.write(procedure.exported(records, source.device), aside / EXPORT)
    progress.end()
    return Result(procedure, outcome)
