"""The command `hrg` loads what is asked for, and no more."""

import subprocess
import sys

HEAVY = ("dask", "fmpy", "matplotlib", "numba", "numpy", "pandas", "scipy", "xarray")
CODE = """
import sys
{statement}
print(sorted(set(sys.modules) & set({heavy!r})))
"""
HELP = """
from pyhrg.common.cli import main
try:
    main(["--help"])
except SystemExit:
    pass
"""


def loaded_by(statement: str) -> str:
    code = CODE.format(statement=statement, heavy=HEAVY)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return run.stdout.splitlines()[-1]


def test_help_loads_nothing_heavy() -> None:
    assert loaded_by(HELP) == "[]"


def test_the_front_doors_load_nothing_heavy() -> None:
    assert loaded_by("import pyhrg, ins_eval") == "[]"
