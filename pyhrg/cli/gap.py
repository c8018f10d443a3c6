"""`hrg gap`: where simulation and a gyro's records part, and which effect does it."""

import argparse
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from fmu_build.binaries.platforms import BuildError
from fmu_build.equations.translate import TranslationError
from pyhrg import records
from pyhrg.cli import challenge
from pyhrg.common.errors import HrgError
from pyhrg.device import device_file
from pyhrg.fmu import GyroError
from pyhrg.gap import static_record
from pyhrg.gap.closing import prediction
from pyhrg.gap.closing.closing import believed_device, with_causes
from pyhrg.gap.diagnose import Diagnosed, diagnosed
from pyhrg.gap.effects.catalogue import WHOLE
from pyhrg.gap.findings import diagnosis
from pyhrg.gap.replay.models import simulation
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.report.folder import keep, keep_with_report
from pyhrg.records import LogError
from pyhrg.records import campaign as campaigns
from pyhrg.records.imu.log import LogError as ImuLogError

HELP = "where simulation and a gyro's records part, and why"

REFUSALS = (
    campaigns.CampaignError,
    device_file.DeviceError,
    diagnosis.DiagnosisError,
    static_record.BeliefError,
    static_record.RecordError,
    ImuLogError,
    LogError,
    GyroError,
    TranslationError,
    BuildError,
)
"""What the user can mend."""


def add_options(parser: argparse.ArgumentParser) -> None:
    tasks = parser.add_subparsers(dest="task", metavar="TASK", required=True)
    diagnose = tasks.add_parser("diagnose", help="find what makes the gap")
    diagnose.add_argument(
        "source",
        type=Path,
        metavar="PATH",
        help="folder of a campaign, or a file: the static record of any IMU",
    )
    diagnose.add_argument(
        "--belief",
        type=Path,
        metavar="FILE",
        help="noise that is believed of a static record, TOML",
    )
    diagnose.add_argument(
        "--trusted",
        action="store_true",
        help="take units and axes of a static record as stated, though gravity or Earth's rate "
        "in it contradict them",
    )
    diagnose.add_argument("--out", type=Path, required=True, metavar="DIR", help="output folder")
    diagnose.set_defaults(do=_diagnose)
    predict = tasks.add_parser("predict", help="the closed simulation's answer to a log's inputs")
    predict.add_argument("diagnosis", type=Path, metavar="DIAGNOSIS", help="a diagnosis.json")
    predict.add_argument("log", type=Path, metavar="LOG", help="a log, CSV")
    predict.add_argument("--campaign", type=Path, required=True, metavar="DIR")
    predict.add_argument("--out", type=Path, required=True, metavar="FILE", help="CSV to write")
    predict.set_defaults(do=_predict)
    challenge.add_parser(tasks)
    tasks.choices[challenge.NAME].set_defaults(do=_challenge)


def run(options: argparse.Namespace) -> None:
    try:
        options.do(options)
    except REFUSALS as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"{error.filename or options.out}: {error.strerror}") from error


def _diagnose(options: argparse.Namespace) -> None:
    if not options.source.exists():
        raise HrgError(f"{options.source}: no such folder or file")
    if options.source.is_dir() == (options.belief is not None):
        expected = "no --belief for a campaign, one for a static record"
        raise HrgError(f"{options.source}: expected {expected}")
    if options.belief is not None:
        result = static_record.diagnose(
            options.source, options.belief, options.out, options.trusted
        )
        print("\n".join(said_of_record(result)))
        return
    found = diagnosed(campaigns.read(options.source), simulation(_say), say=_say)
    keep_with_report(found, options.out, _say)
    print(summary(found))


def said_of_record(result: static_record.RecordDiagnosis) -> list[str]:
    """Its verdicts, for the terminal."""
    lines = [f"{result.source}: {result.verdict.replace('_', ' ')}"]
    for channel in result.channels:
        causes = ", ".join(f"{c.term.effect} {c.probability:.3f}" for c in channel.causes)
        words = channel.verdict.replace("_", " ")
        lines.append(f"  {channel.channel.name}: {words}{': ' if causes else ''}{causes}")
    return lines


def _challenge(options: argparse.Namespace) -> None:
    challenge.run(options, challenged)


def challenged(folder: Path, out: Path, without: Sequence[str]) -> None:
    """Diagnose a campaign of a challenge with some effects out of the catalogue."""
    campaign, catalogue = campaigns.read(folder), WHOLE.without(without)
    keep(diagnosed(campaign, _simulation_of_process(), catalogue), out)


@cache
def _simulation_of_process() -> Simulation:
    return simulation(_say)


def _predict(options: argparse.Namespace) -> None:
    campaign = campaigns.read(options.campaign)
    believed = believed_device(campaign)
    closed = with_causes(believed, diagnosis.causes_of(options.diagnosis, campaign.device))
    read = records.read(options.log, latitude=campaign.site.latitude)
    log, notes = prediction.with_whole_inputs(read, believed)
    for note in notes:
        _say(note)
    angle = prediction.predicted(simulation(_say), believed, closed, log)
    prediction.write(log, angle, options.out)


def summary(found: Diagnosed) -> str:
    """A diagnosis in lines, for the terminal."""
    said = found.diagnosis
    lines = [f"{said.device}: {said.verdict.replace('_', ' ')}"]
    for cause in said.causes:
        values = ", ".join(f"{name} {value:.4g}" for name, value in cause.parameters.items())
        lines.append(f"  {cause.effect}: {cause.probability:.3f}  {values}")
        if cause.equivalents:
            lines.append(f"    or {', '.join(cause.equivalents)}")
    lines.append(f"  outside the catalogue: {said.unknown_probability:.3f}")
    lines += [f"  {caveat}" for caveat in said.caveats]
    for words, figure in (
        ("fit", said.gap.fit_angle_arcsec),
        ("held out", said.gap.holdout_angle_arcsec),
    ):
        if figure is not None:
            lines.append(
                f"  angle, {words}: {figure.before:.3g} -> {figure.after:.3g} arcsec; "
                f"noise alone {figure.floor:.3g} "
                f"({figure.floor_95[0]:.3g} to {figure.floor_95[1]:.3g})"
            )
    if said.next_test is not None:
        test = said.next_test
        lines.append(f"  next: {test.kind}, {test.hours:g} h - {test.why}")
    return "\n".join(lines)


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)
