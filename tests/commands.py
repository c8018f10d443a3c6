"""Commands of `hrg` with little work, run in this process; their workers are processes."""

from pathlib import Path

import pytest

from ins_eval.study import study_file
from pyhrg.common.cli import main

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
COMMANDS = {
    "validate": "validate --triads 6 --hours 0.1 --seed 1 --workers 1 --out {out}",
    "study": "study --workers 1 --out {out}",
    "study challenge": "study challenge --seed 1 --workers 1 --out {out}",
    "bench": "bench amplitude-sweep --seed 1 --workers 1 --out {out}",
    "gap challenge": "gap challenge --none 1 --single 0 --pairs 0 --outside 0 --data short "
    "--seed 1 --workers 1 --out {out}",
}
"""Arguments of `hrg` by name; {out} is the output folder."""


def run_here(name: str, out: Path, folder: Path, patch: pytest.MonkeyPatch) -> int:
    """Status of a command that writes into `out`, in a folder where the smallest study stands in
    for `small`, which takes minutes."""
    (folder / "small.toml").write_text(STUDY)
    patch.chdir(folder)
    patch.setattr(study_file, "_FOLDER", Path())
    return main([word.format(out=out) for word in COMMANDS[name].split()])
