"""The front door of the study's challenge: hand it out, score predictions.

A challenge is a study in the folder `sealed`, with its flown errors and our predictions, and the
folder `hand-out`, which has the bench records of the study's gyros and the digest of the former.
"""

import hashlib
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pandas as pd

from ins_eval.study.challenge.hand_out import INDEX, write_hand_out
from ins_eval.study.challenge.score_predictions import (
    ChallengeScores,
    read_predictions,
    score_predictions,
)
from ins_eval.study.run.run import Cluster, Progress
from ins_eval.study.run_study import make_experiment, run_to_result
from ins_eval.study.specification import TEST, Study
from ins_eval.study.study_data import read_study_data
from ins_eval.study.study_file import load_study
from ins_eval.study.tables import columns
from ins_eval.study.tables.columns import TABLE
from pyhrg.common.errors import HrgError
from pyhrg.common.files import replace_folder, write_whole
from pyhrg.common.reading.documents import read_json

SEALED, HAND_OUT = "sealed", "hand-out"
SCORES = "scores.csv"
PRESET = "small"
"""The ready study whose gyros and missions are handed out, without its lead case and conditions."""


def hand_out_challenge(
    out: Path | str,
    *,
    seed: int,
    study: Study | Path | str = PRESET,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Path:
    """Make a challenge: a folder to give away, whose path is returned, and the truth in `sealed`
    beside it.

    The study runs first, and goes on where it was interrupted.

    Args:
        seed: seed of all random numbers. Whoever knows it can compute the truth.
        study: a study, the name of one that comes with the package, or a file, with one
            calibration.
        workers, scheduler, progress: as in `run_study`.

    Raises:
        HrgError: a study with two calibrations; or as `run_study`.
        OSError: `out` can't be written.
    """
    chosen = study if isinstance(study, Study) else load_study(study)
    chosen = replace(chosen, seed=seed, lead=0, agreement=0, conditions=0)
    if len(chosen.calibrations) > 1:
        found = ", ".join(chosen.calibrations)
        raise HrgError(f"calibrations: found {found}, expected one in a challenge")
    sealed, folder = Path(out) / SEALED, Path(out) / HAND_OUT
    run_to_result(chosen, sealed, make_experiment(chosen), Cluster(scheduler, workers), progress)
    digest = _hash_truth(sealed)
    if not folder.exists():
        with replace_folder(folder) as aside:
            write_hand_out(chosen, read_study_data(sealed).table, digest, aside)
    _check_seal(folder, digest)
    return folder


def score_challenge(out: Path | str, predictions: Sequence[Path | str]) -> ChallengeScores:
    """Score predictions (CSV) beside ours, and write the scores to `SCORES` in the challenge's
    folder.

    Args:
        out: folder of a challenge that was handed out.
        predictions: files; the name of each is the predictor's.

    Raises:
        HrgError: a file that can't be used, by row and field; two of one name; or a truth that is
            not the one whose digest was handed out.
        OSError: `out` can't be written.
    """
    sealed = Path(out) / SEALED
    data = read_study_data(sealed)
    _check_seal(Path(out) / HAND_OUT, _hash_truth(sealed))
    judged = data.table[data.table[columns.ROLE] == TEST]
    flights = set(zip(judged[columns.TRIAD], judged[columns.MISSION], strict=True))
    outside: dict[str, pd.DataFrame] = {}
    for path in map(Path, predictions):
        if path.stem in outside:
            raise HrgError(f"{path}: found a second file {path.stem}, expected other names")
        outside[path.stem] = read_predictions(path, flights)
    seed, inside = data.about["seed"], data.about["interval_percent"] / 100
    scores = score_predictions(data.table, outside, seed, inside)
    write_whole(Path(out) / SCORES, scores.table.to_csv(index=False).encode())
    return scores


def _hash_truth(sealed: Path) -> str:
    return hashlib.sha256((sealed / TABLE).read_bytes()).hexdigest()


def _check_seal(folder: Path, digest: str) -> None:
    """Refuse a truth whose digest is not that of the index in a folder that was handed out."""
    published = read_json(folder / INDEX).get("sha256")
    if published != digest:
        raise HrgError(
            f"{folder / INDEX}: sha256: found {published}, expected the truth's {digest}"
        )
