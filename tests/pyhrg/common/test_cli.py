"""The command `hrg` loads what is asked for, and no more."""

import subprocess
import sys

import pytest

TOLD = """
import sys
from fmu_build.cli import main
try:
    main({arguments!r})
except SystemExit:
    pass
print(sorted({{name.split(".")[0] for name in sys.modules}} & {{"ins_eval", "pyhrg"}}))
"""


@pytest.mark.parametrize(
    ("arguments", "loaded"),
    [
        (["build", "--help"], "[]"),
        (["bench", "--help"], "['pyhrg']"),
        (["--help"], "['ins_eval', 'pyhrg']"),
    ],
)
def test_a_command_loads_its_own_package_alone(arguments: list[str], loaded: str) -> None:
    code = TOLD.format(arguments=arguments)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[-1] == loaded
