"""Where the records of a run come from: a simulated gyro, or a campaign."""

import difflib
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

from fmu_build.bundle import build_fmu
from pyhrg.bench.bench import NAMELESS, Bench
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting.progress import BenchProgress
from pyhrg.bench.store import Store
from pyhrg.common.arguments import choose_workers
from pyhrg.common.errors import HrgError
from pyhrg.common.made_by import digest_value, list_versions
from pyhrg.device import device_file, ready_devices
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu, load_own_fmu
from pyhrg.records import Log
from pyhrg.records import campaign as campaigns
from pyhrg.records.campaign import Campaign, Test
from pyhrg.records.missing_inputs import add_missing_inputs, turns

DEFAULT_DEVICE = "typical"
"""Ready device that is simulated where no other is named."""


@dataclass(frozen=True)
class Source:
    """Where the records of a run come from.

    Attributes:
        name: name of the gyro.
        subject: the gyro, and where its records come from; heads the report.
        procedures: tests that there are records for.
        get_records: function that gives the campaign that a procedure evaluates.
        device: the simulated gyro, or the nominal device of the campaign.
        resumption: what happens when an interrupted run is started again.
        seed: seed of the simulation; None where the records are not simulated.
        limits: the specification's, by the findings' keys.
        store: store of logs, open during the run.
        fmu: name and digest of the FMU where it is the user's.
    """

    name: str
    subject: str
    procedures: Sequence[Procedure]
    get_records: Callable[[Procedure], Campaign]
    device: Device
    resumption: str
    seed: int | None = None
    limits: Mapping[str, float] = field(default_factory=dict)
    store: AbstractContextManager[object] = field(default_factory=nullcontext)
    fmu: str = ""

    @cached_property
    def identity(self) -> dict[str, Any]:
        """Device, digest of its parameters, seed and versions, by keys of result.json."""
        return {
            "made_by": list_versions(),
            "device": self.name,
            "device_sha256": digest_value((self.device, self.fmu) if self.fmu else self.device),
            "seed": self.seed,
        }


def prepare_simulation(
    procedures: Sequence[Procedure],
    device: Device | str | Path | None,
    seed: int,
    workers: int | None,
    store: Store | None,
    progress: BenchProgress,
    plan: Mapping[str, float],
    fmu_file: Path | str | None = None,
) -> Source:
    """A source that simulates a gyro on the virtual bench.

    The device is a gyro, the name of a ready device or a device file; `plan` has keywords of the
    only procedure's `record`. An FMU in a file is simulated in all tests, with the device's
    parameters put into it.
    """
    if isinstance(device, Device):
        gyro, place = device, device.name
    else:
        gyro, place = (
            ready_devices.load_device(DEFAULT_DEVICE if device is None else device),
            str(device),
        )
    if fmu_file is not None:
        fmus = dict.fromkeys({p.model for p in procedures}, load_own_fmu(Path(fmu_file)))
    else:
        fmus = _load_fmus(procedures, progress.say)
    _check_model_names(gyro, fmus, place)
    threads = choose_workers(workers)

    name = gyro.name or NAMELESS
    name += "" if fmu_file is None else f" in {Path(fmu_file).name}"

    def simulate_campaign(procedure: Procedure) -> Campaign:
        fmu = fmus[procedure.model]
        bench = Bench(fmu, gyro, seed, procedure.step, threads, store, progress.add_power_on)
        return bench.campaign(procedure.record(bench, **plan))

    return Source(
        name=name,
        fmu="" if fmu_file is None else fmus[procedures[0].model].folder.name,
        subject=f"{name}, simulated with seed {seed}",
        procedures=procedures,
        get_records=simulate_campaign,
        device=gyro,
        resumption="the same command goes on from here" if store else "nothing was kept",
        seed=seed,
        limits=gyro.specification,
        store=store.open() if store else nullcontext(),
    )


def open_records(campaign: Campaign | str | Path, procedures: Sequence[Procedure]) -> Source:
    """A campaign and, of several procedures, those that it has a kind of test for."""
    records = campaign if isinstance(campaign, Campaign) else campaigns.read_campaign(campaign)
    able = [p for p in procedures if records.of_kind(*p.kinds)]
    if len(procedures) > 1 and not able:
        kinds = ", ".join(sorted({test.kind for test in records.tests})) or "no tests"
        raise BenchError(f"{records.device}: no test evaluates a campaign that has {kinds}")
    device = replace(device_file.from_table(records.nominal, records.device), site=records.site)
    tests = (
        replace(test, recording=partial(_complete_log, test, device)) for test in records.tests
    )
    completed = replace(records, tests=tuple(tests))
    return Source(
        name=records.device,
        subject=f"{records.device}, recorded",
        procedures=able if len(procedures) > 1 else procedures,
        get_records=lambda procedure: completed,
        device=device,
        resumption="the same command begins again",
    )


def _complete_log(test: Test, device: Device) -> Log:
    """A test's log with the inputs that it lacks as at rest, and a note that says which.

    The table's angle stays missing where the gyro shows that the table turned.
    """
    without = ("table_angle",) if turns(test.log) else ()
    log, notes = add_missing_inputs(test.log, device, without)
    return replace(log, exclusions=(*log.exclusions, *notes))


def _load_fmus(procedures: Sequence[Procedure], say: Callable[[str], None]) -> dict[str, GyroFmu]:
    """The procedures' FMUs by model, built where the cache has none."""

    def load(model: str) -> GyroFmu:
        return GyroFmu(build_fmu(model, progress=lambda step: say(f"FMU {model}: {step}")))

    return {model: load(model) for model in sorted({p.model for p in procedures})}


def _check_model_names(device: Device, fmus: Mapping[str, GyroFmu], source: str) -> None:
    """Refuse a device whose table [model] has a name that is a variable of none of the FMUs."""
    known = {name for fmu in fmus.values() for name in fmu.references}
    for name in device.model:
        if name not in known:
            close = difflib.get_close_matches(name, known, n=1)
            expected = f", expected model.{close[0]}" if close else ""
            raise HrgError(f"{source}: model.{name}: found an unknown key{expected}")
