"""`hrg parking`: what it buys to start level gyros' patterns where their maps say."""

import argparse
import sys

from fmu_build.cli import Command, UserError
from ins_eval.parking import report, study
from ins_eval.staging import staging
from ins_eval.validation import options as shared
from ins_eval.validation.mission import Mission


def _add_options(parser: argparse.ArgumentParser) -> None:
    shared.add_options(parser, out="hrg-parking", triads=12)


def _run(options: argparse.Namespace) -> None:
    seed, triads = shared.seed_and_triads(options)
    flown = shared.chosen_mission(options)
    try:
        with staging(options.out, report.FILES) as folder:
            result = _compared(seed, triads, flown)
            report.write(result, folder)
    except OSError as error:
        raise UserError(f"can't write {options.out}: {error.strerror}") from error
    print(report.summary(result))
    print(f"\nwritten to {options.out}: {', '.join(report.FILES)}")


def _compared(seed: int, triads: int, flown: Mission) -> study.Comparison:
    fmu = shared.present_fmu()
    print(f"simulating {flown.name} for {flown.hours:g} h", file=sys.stderr)
    with shared.gyro_minutes(study.work(triads, flown), "flights") as done:
        return study.compare(fmu, flown, triads, seed, done=done)


PARKING = Command(
    "start level gyros' patterns where their maps say the error is least, and fly what it buys",
    _add_options,
    _run,
)
