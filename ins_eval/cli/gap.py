"""`hrg gap`: the gap between a gyro's records and its simulation, and its causes."""

import argparse
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import ins_eval
import pyhrg
from pyhrg.cli import challenge
from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_folder

if TYPE_CHECKING:
    from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
    from pyhrg.gap.report.sections import Section

HELP = "find the causes of the gap between a gyro's records and its simulation"


def add_options(parser: argparse.ArgumentParser) -> None:
    tasks = parser.add_subparsers(dest="task", metavar="TASK", required=True)
    parser = tasks.add_parser(
        "diagnose", help="find the causes of the gap", description="Find the causes of the gap."
    )
    add = parser.add_argument
    add("source", type=Path, metavar="PATH", help="folder of a campaign, or static record of any "
        "IMU")  # fmt: skip
    add("--belief", type=Path, metavar="FILE", help="expected noise of the sensors of a static "
        "record (TOML)")  # fmt: skip
    add("--trusted", action="store_true", help="take units and axes of a static record as stated, "
        "even if gravity or Earth's rate contradicts them")  # fmt: skip
    add("--bound", type=float, nargs=3, metavar=("ARCSEC", "DEG_H", "SHARE"), help="sizes below "
        "which an unexplained residual does not matter: rms of the output angle, mean rate, and "
        "rms of another channel over its scale (default 0.1 1e-4 1e-3)")  # fmt: skip
    add("--out", type=Path, required=True, metavar="DIR", help="output folder")
    parser.set_defaults(run_task=_diagnose)
    parser = tasks.add_parser(
        "predict", help="compare a log with the simulation of the identified gyro"
    )
    add = parser.add_argument
    add("diagnosis", type=Path, metavar="DIAGNOSIS", help="a diagnosis.json")
    add("log", type=Path, metavar="LOG", help="a log, CSV")
    add("--campaign", type=Path, required=True, metavar="DIR", help="campaign of the diagnosis")
    add("--out", type=Path, required=True, metavar="FILE", help="CSV to write")
    parser.set_defaults(run_task=_predict)
    parser = tasks.add_parser("challenge", help=challenge.HELP, description=challenge.HELP)
    challenge.add_options(parser)
    parser.set_defaults(run_task=challenge.run)


def run(options: argparse.Namespace) -> None:
    options.run_task(options)


def _diagnose(options: argparse.Namespace) -> None:
    check_output_folder(options.out)
    if not options.source.exists():
        raise HrgError(f"{options.source}: no such folder or file")
    is_record = not options.source.is_dir()
    if is_record and options.belief is None:
        raise HrgError(f"{options.source}: found no --belief, expected one for a static record")
    if is_record and options.bound:
        raise HrgError(f"{options.source}: found --bound, which is for campaigns")
    if is_record:
        record, belief = options.source, options.belief
        result = pyhrg.diagnose_record(record, belief, trusted=options.trusted, out=options.out)
        print(result.summary)
        _print_place(options.out)
        return
    if options.belief is not None or options.trusted:
        given = "--trusted" if options.belief is None else "--belief"
        raise HrgError(f"{options.source}: found {given}, which is for static records")
    _diagnose_campaign(options)


def _diagnose_campaign(options: argparse.Namespace) -> None:
    from pyhrg.gap.findings.diagnosis import Worth
    from pyhrg.gap.findings.materiality import IMMATERIAL
    from pyhrg.gap.report.page import write_report
    from pyhrg.gap.report.sections import make_section
    from pyhrg.gap.report.verdict import summarize_diagnosis

    bound = Worth(*options.bound) if options.bound else IMMATERIAL
    result = pyhrg.diagnose(options.source, bound=bound, progress=not options.quiet)
    section = partial(make_position_section, result, not options.quiet)
    position = make_section("position", section)
    write_report(result, options.out, [position])
    print(summarize_diagnosis(result))
    _print_place(options.out)


def _print_place(out: Path) -> None:
    print(f"\nwritten to {out}; to read, open {out / 'report.html'} in a browser")


def make_position_section(diagnosis: "CampaignDiagnosis", progress: bool = True) -> "Section":
    """The section on the position error of a diagnosis, in the default missions.

    The diagnosis goes through its files, so that `hrg position` on them gives the same bytes.
    """
    with TemporaryDirectory() as folder:
        diagnosis.write(folder)
        return ins_eval.compute_position_gap(folder, progress=progress).section


def _predict(options: argparse.Namespace) -> None:
    from pyhrg.gap.closing.prediction import describe_prediction, write_prediction

    check_output_folder(options.out.parent)
    table = pyhrg.predict(
        options.diagnosis, options.log, options.campaign, progress=not options.quiet
    )
    write_prediction(table, options.out)
    print(describe_prediction(table))
    print(f"written to {options.out}")
