"""`hrg validate`: the main job."""

import argparse
import sys

from fmu_build.cli import Command, UserError
from ins_eval.staging import staging
from ins_eval.validation import options as shared
from ins_eval.validation import report, study
from ins_eval.validation.mission import Mission


def _add_options(parser: argparse.ArgumentParser) -> None:
    shared.add_options(parser, out="hrg-validation", triads=20)


def _run(options: argparse.Namespace) -> None:
    seed, triads = shared.seed_and_triads(options)
    flown = shared.chosen_mission(options)
    try:
        with staging(options.out, report.FILES) as folder:
            result = _validated(seed, triads, flown)
            report.write(result, folder)
    except OSError as error:
        raise UserError(f"can't write {options.out}: {error.strerror}") from error
    print(report.summary(result))
    print(f"\nwritten to {options.out}: {', '.join(report.FILES)}")


def _validated(seed: int, triads: int, flown: Mission) -> study.Validation:
    fmu = shared.present_fmu()
    print(f"simulating {flown.name} for {flown.hours:g} h", file=sys.stderr)
    with shared.gyro_minutes(study.work(triads, flown), "bench, flights") as done:
        return study.validate(fmu, flown, triads, seed, done=done)


VALIDATE = Command(
    "bench one gyro, fly triads of its kind, and say which bench test told the truth",
    _add_options,
    _run,
)
