"""`hrg schedule`: motions of a triad that are chosen by its gyros' maps, for a bench's results or
flown."""

import argparse
import json
from pathlib import Path

import ins_eval
from pyhrg.common.cli import collect_given
from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_folder
from pyhrg.common.progress import Progress

HELP = "choose by the gyros' maps where to park patterns and how to turn case or patterns"
CHOOSING = ("bench_drift", "start_angles_deg", "device")
FLYING = ("triads", "seed")
NO_BENCH = "no --bench, expected it beside this option"


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--trajectory", metavar="NAME|FILE", help="ready mission, mission (TOML) or recorded drive "
        "(CSV, may be gzipped); default car")  # fmt: skip
    add("--hours", type=float, help="duration of the mission (default 2)")
    add("--seed", type=int, help="seed of all random numbers (default 1)")
    add("--triads", type=int, help="number of triads to fly (default 12)")
    add("--bench", type=Path, nargs=3, metavar=("FORWARD", "RIGHT", "DOWN"), help="result.json of "
        "`hrg bench calibration` of each gyro of your triad: choose its schedules, fly "
        "none")  # fmt: skip
    add("--bench-drift", type=float, nargs=2, metavar=("DEG_H", "PPM"), help="with --bench: "
        "1-sigma of what a term of the maps of bias and scale factor changed since (default "
        "0)")  # fmt: skip
    add("--start-angles-deg", type=float, nargs=3, metavar=("FORWARD", "RIGHT", "DOWN"),
        help="with --bench: pattern angles at power-on (default unknown)")  # fmt: skip
    add("--device", metavar="NAME|FILE", help="with --bench: device whose noise and scatter of "
        "power-on angles count (default typical)")  # fmt: skip
    add("--json", action="store_true", help="with --bench: print an object instead of the summary")
    add("--out", type=Path, default=Path("hrg-schedule"), metavar="DIR", help="output folder of "
        "flights (default hrg-schedule)")  # fmt: skip


def run(options: argparse.Namespace) -> None:
    mission = collect_given(options, ("trajectory", "hours"))
    choosing, flying = collect_given(options, CHOOSING), collect_given(options, FLYING)
    for name in flying if options.bench else choosing:
        found = "--bench, expected none beside this option" if options.bench else NO_BENCH
        raise HrgError(f"--{name.replace('_', '-')}: found {found}")
    if options.bench:
        chosen = ins_eval.choose_schedules(options.bench, **mission, **choosing)
        print(json.dumps(chosen.document, indent=1) if options.json else chosen.summary)
        return
    check_output_folder(options.out)
    with Progress(not options.quiet, "schedules", "steps") as progress:
        comparison = ins_eval.compare_schedules(progress=progress.update, **mission, **flying)
    comparison.write(options.out)
    print(comparison.summary)
    print(f"\nwritten to {options.out}: {', '.join(comparison.files)}")
