"""Diagnoses of campaigns whose truth is withheld, as a table.

    python benchmarks/withheld.py FOLDER... > table.csv

A line has a campaign, the verdict, the causes with their probabilities and parameters, the
probability of a cause outside the catalogue, the terms, the residual of the held-out tests' output
angle and its noise floor, and the next test. Nothing may be tuned to it.
"""

import csv
import sys
from pathlib import Path

from tqdm import tqdm

from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis
from pyhrg.gap.replay.simulation import load_simulation

COLUMNS = (
    "device",
    "verdict",
    "causes",
    "unknown_probability",
    "terms",
    "holdout_before_arcsec",
    "holdout_after_arcsec",
    "noise_floor_arcsec",
    "next_test",
)


def describe_cause(cause: Cause) -> str:
    values = (f"{name}={value:.5g}" for name, value in cause.parameters.items())
    return " ".join([cause.effect, f"p={cause.probability:.3f}", *values])


def list_values(diagnosis: Diagnosis) -> tuple[str, ...]:
    angle, test = diagnosis.gap.holdout_angle_arcsec, diagnosis.next_test
    figures = (angle.before, angle.after, angle.floor) if angle else ()
    return (
        diagnosis.device,
        diagnosis.verdict,
        "; ".join(map(describe_cause, diagnosis.causes)),
        f"{diagnosis.unknown_probability:.3f}",
        "; ".join(term.formula.text for term in diagnosis.terms),
        *(f"{figure:.3g}" for figure in figures),
        test.kind if test else "",
    )


def main(folders: list[Path]) -> None:
    simulation, writer = load_simulation(), csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(COLUMNS)
    for folder in tqdm(folders):
        writer.writerow(list_values(diagnose(folder, simulation=simulation).diagnosis))
        sys.stdout.flush()


if __name__ == "__main__":
    main([Path(each) for each in sys.argv[1:]])
