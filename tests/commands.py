"""Commands of `hrg` with little work, as processes that can be killed."""

import subprocess
import sys
from pathlib import Path
from typing import Any

PLAN = """\
fixed_runs = 2
positions = 16
segments = 1
fixed_segments = 2
periods = 1
"""
STUDY = f"""\
seed = 1
triads = 8
training = 2
interval_percent = 50
hours = 0.1
calibrations = ["mean"]
missions = [{{ name = "car", class = "car" }}]

[calibration]
runs = 1
{PLAN}
[bench]
runs = 2
{PLAN}"""
"""The smallest study that is scored."""
RUN = """\
import signal, sys
from pyhrg.common.cli import main
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs ignore it
sys.exit(main())"""
SHORT_STUDY = f"""\
from pathlib import Path
from ins_eval.study import study_file
study_file._FOLDER = Path()
{RUN}"""
"""`hrg` with that study in place of `small`, which takes minutes."""
SHORT_BENCH = f"""\
from pyhrg.bench import catalogue
names = [procedure.name for procedure in catalogue.PROCEDURES]
first, last = names.index("range"), names.index("calibration")
catalogue.PROCEDURES = catalogue.PROCEDURES[first:last]
{RUN}"""
"""`hrg` with the bench's short tests alone; all of them take minutes."""
COMMANDS = {
    "validate": "validate --triads 6 --hours 0.1 --seed 1 --workers 1 --out {out}",
    "study": "study --workers 1 --out {out}",
    "study challenge": "study challenge --seed 1 --workers 1 --out {out}",
    "bench": "bench amplitude-sweep --seed 1 --workers 1 --out {out}",
    "bench all": "bench all --seed 1 --workers 1 --out {out}",
    "gap challenge": "gap challenge --none 1 --single 0 --pairs 0 --outside 0 --data short "
    "--seed 1 --workers 1 --out {out}",
    "build": "build --out {out}/HRG.fmu",
}
"""Arguments of `hrg` by name; {out} is the output folder."""
CODE = {
    **dict.fromkeys(("validate", "study", "study challenge"), SHORT_STUDY),
    "bench all": SHORT_BENCH,
}
"""What runs, where it is not `hrg` as it is."""


def start(name: str, out: Path, folder: Path, **options: Any) -> "subprocess.Popen[str]":
    """Start a command that writes into `out` in a folder where the study's file is put; options are
    those of `Popen`."""
    (folder / "small.toml").write_text(STUDY)
    code = CODE.get(name, RUN)
    arguments = [word.format(out=out) for word in COMMANDS[name].split()]
    return subprocess.Popen(
        [sys.executable, "-c", code, *arguments],
        cwd=folder,
        text=True,
        start_new_session=True,
        **options,
    )
