"""Reference results of `HRG.Validation`, one table a model.

A change of the library that moves a result by more than `DRIFT` of its scale is seen; where it is
meant, `python -m tests.agreement.reference_results` writes the tables anew. The kernel computes the
same bits on every platform, so that the tolerance is for a change in the order of operations alone.
"""

import csv
from collections.abc import Sequence
from pathlib import Path

from fmu_build.bundle import find_modelica_library
from pyhrg.common.files import write_whole
from tests.agreement.claims import CLAIMS, Result, demonstrations

DRIFT = 1e-6
"""Largest change of a result, relative to its scale."""
COLUMNS = ("start_angle_rad", "measured", "expected", "scale")


def reference_path(name: str) -> Path:
    """Table of a model, by its full name."""
    folder = find_modelica_library() / "Resources" / "ReferenceResults"
    return folder / f"{name.replace('.', '_')}.csv"


def read(name: str) -> list[Result]:
    """Reference results of a model.

    Raises:
        OSError: there is no such table.
    """
    with reference_path(name).open(newline="") as file:
        lines = (line for line in file if not line.startswith("#"))
        return [Result(*(float(row[c]) for c in COLUMNS)) for row in csv.DictReader(lines)]


def table(name: str, stop_time: float, results: Sequence[Result]) -> str:
    """Text of a model's table."""
    lines = [
        f"# {name} at {stop_time:g} s, SI; compared within {DRIFT:g} of the scale",
        "# rebuilt by: python -m tests.agreement.reference_results",
        ",".join(COLUMNS),
    ]
    for r in results:
        values = (r.start_angle, r.measured, r.expected, r.scale)
        lines.append(",".join(f"{value:.10g}" for value in values))
    return "\n".join([*lines, ""])


def main() -> None:
    """Write all tables anew."""
    reference_path("").parent.mkdir(parents=True, exist_ok=True)
    for path in reference_path("").parent.glob("*.csv"):
        path.unlink()
    with demonstrations(CLAIMS) as running:
        for claim in CLAIMS:
            results = running[claim.name].result().shown
            write_whole(
                reference_path(claim.name), table(claim.name, claim.stop_time, results).encode()
            )


if __name__ == "__main__":
    main()
