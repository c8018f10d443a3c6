"""The closed simulation's answer to the inputs of a log."""

from pathlib import Path
from typing import Protocol

import numpy as np
import pandas as pd

from pyhrg import records
from pyhrg.common.arrays import Array
from pyhrg.common.files import write_whole
from pyhrg.common.progress import Progress, Show
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.device.device import Device
from pyhrg.gap.closing.closing import read_identified_device
from pyhrg.gap.closing.equation.closed_fmu import load_closed_fmu, put_terms
from pyhrg.gap.findings.diagnosis import Diagnosis, DiagnosisError
from pyhrg.gap.findings.diagnosis_reader import read_diagnosis
from pyhrg.gap.replay.inputs.inputs import has_start_angle
from pyhrg.gap.replay.observations import observe_test
from pyhrg.gap.replay.reading_noise import estimate_reading_noise
from pyhrg.gap.replay.sampled import replay_sampled
from pyhrg.gap.replay.simulation import Simulation, load_simulation
from pyhrg.gap.soundness import build_nominal_device
from pyhrg.gap.soundness.glitches import mend_inputs
from pyhrg.gap.soundness.inputs import complete_inputs
from pyhrg.gap.soundness.interruption import mend_drive
from pyhrg.gap.soundness.mounting import mend_mounting
from pyhrg.gap.soundness.origin import mend_origin
from pyhrg.records import Log, LogError
from pyhrg.records import campaign as campaigns
from pyhrg.records.campaign import Campaign, Test

COLUMNS = ("time_s", "gyro_angle_deg", "residual_arcsec")


class _HoldsDiagnosis(Protocol):
    """What `pyhrg.gap.diagnose.diagnose` gives."""

    @property
    def diagnosis(self) -> Diagnosis: ...


def predict(
    diagnosis: _HoldsDiagnosis | Diagnosis | Path | str,
    log: Log | Path | str,
    campaign: Campaign | Path | str,
    *,
    simulation: Simulation | None = None,
    progress: Show = None,
) -> pd.DataFrame:
    """Predict the output angle of the identified device for the inputs of a log.

    Inputs that the recorder lost are filled in as in a diagnosis. If the diagnosis proposes terms,
    the FMU of the gyro with these terms is run.

    Args:
        diagnosis: of the campaign: a `CampaignDiagnosis`, its `diagnosis`, or the path of its
            `diagnosis.json`.
        log: a log or its file.
        campaign: the campaign or its folder; its nominal values state the nominal gyro.
        simulation: FMUs `HRG` and `HRGSlow`; by default they are built, or taken from the cache.
        progress: True prints each step to standard error; a function is called with it.

    Returns:
        n rows, as in the log: `time_s`, `gyro_angle_deg`, and `residual_arcsec`, the recorded angle
        less the predicted one. `attrs["units"]` has their units. `attrs["notes"]` has a sentence on
        each input that was filled in, cut or assumed.

    Raises:
        DiagnosisError: the file is no diagnosis, or that of another gyro.
        CampaignError: the folder is no campaign.
        LogError: the log can't be used, or its inputs can't be determined.
        GyroError: the FMU refuses the identified device.
        HrgError: the nominal values are no gyro's, or the FMU with terms can't be built.
    """
    report = Progress(progress).say
    campaign = (
        campaign if isinstance(campaign, Campaign) else campaigns.read_campaign(Path(campaign))
    )
    nominal = build_nominal_device(campaign)
    findings = _read(diagnosis, campaign.device)
    identified = read_identified_device(nominal, findings)
    if not isinstance(log, Log):
        log = records.read_log(Path(log), latitude_deg=campaign.site.latitude_deg, any_sign=True)
    log, notes = _repair_inputs(log, nominal, findings)
    for note in notes:
        report(note)
    noise = estimate_reading_noise([log]).encoder.value
    test = observe_test(Test("prediction", "manoeuvre", "holdout", log), nominal, noise)
    if findings.terms:
        fmu = load_closed_fmu(identified, findings.terms)
        answers = replay_sampled(fmu, put_terms(identified, findings.terms), test.inputs)
    else:
        answers = (simulation or load_simulation(report)).simulate(identified, test)
    return _tabulate(log, answers["gyro_angle"], notes)


def _tabulate(log: Log, predicted: Array, notes: list[str]) -> pd.DataFrame:
    residual = (log.gyro_angle - predicted) / ARCSEC
    columns = (log.time, predicted / DEG, residual)
    table = pd.DataFrame(dict(zip(COLUMNS, columns, strict=True)))
    table.attrs = {"units": dict(zip(COLUMNS, ("s", "deg", "arcsec"), strict=True)), "notes": notes}
    return table


def _read(diagnosis: _HoldsDiagnosis | Diagnosis | Path | str, device: str) -> Diagnosis:
    source = "diagnosis"
    if isinstance(diagnosis, Path | str):
        source, diagnosis = str(diagnosis), read_diagnosis(diagnosis)
    elif not isinstance(diagnosis, Diagnosis):
        diagnosis = diagnosis.diagnosis
    if diagnosis.device != device:
        raise DiagnosisError(
            f"{source}: device: found {diagnosis.device!r}, expected {device!r} as in the campaign"
        )
    return diagnosis


def write_prediction(prediction: pd.DataFrame, path: Path) -> None:
    """Write a prediction as CSV with its columns.

    Raises:
        OSError: the folder can't be written.
    """
    columns = (prediction[name] for name in COLUMNS)
    rows = (f"{time:.15g},{a:.12g},{r:.6g}\n" for time, a, r in zip(*columns, strict=True))
    write_whole(path, (f"{','.join(COLUMNS)}\n" + "".join(rows)).encode())


def describe_prediction(prediction: pd.DataFrame) -> str:
    """How far the record is from the prediction, in a sentence. The mean difference is the zero of
    the output, which a diagnosis estimates for each log."""
    residual = prediction["residual_arcsec"].dropna()
    mean = float(residual.mean())
    departure = residual - mean
    rms, largest = float(np.sqrt((departure**2).mean())), float(departure.abs().max())
    return (
        f"record less prediction: {rms:.3g} arcsec rms about the mean, {largest:.3g} arcsec at "
        f"most ({len(residual)} rows); the mean of {mean:.6g} arcsec is the output's zero, which a "
        "diagnosis takes out of each log"
    )


def _repair_inputs(log: Log, nominal: Device, diagnosis: Diagnosis) -> tuple[Log, list[str]]:
    """A log whose inputs can be replayed, and a sentence on each thing that was turned, filled in,
    cut or assumed: the same as in a diagnosis."""
    log, turned = mend_mounting(log, [p for cause in diagnosis.causes for p in cause.parameters])
    log, mended = mend_inputs(log)
    log, _, filled = complete_inputs(log, nominal)
    log, counted = mend_origin(log, nominal)
    log, interrupted = mend_drive(log, nominal)
    if not has_start_angle(log):
        raise LogError(
            f"{log.source}: no row with gyro_angle_deg and wave_angle_deg; expected one, which "
            "gives the start angle"
        )
    return log, [*turned, *mended, *filled, *counted, *interrupted]
