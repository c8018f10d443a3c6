"""A small challenge from its gyros to the scores of the examples; what gives the truth away."""

import hashlib
import json
import runpy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from ins_eval.study.challenge import challenge
from ins_eval.study.challenge.score_predictions import NAIVE
from ins_eval.study.conclusion import write_conclusion
from ins_eval.study.experiment import compute_block
from ins_eval.study.gyros.measured_gyro import MeasuredGyro, evaluate_campaigns
from ins_eval.study.specification import TRAIN, Study
from ins_eval.study.tables import columns as c
from pyhrg.common.cli import main
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H
from pyhrg.device import device_file
from pyhrg.records.campaign import read_campaign
from tests.ins_eval.study.challenge.examples import FOLDER, load_strong
from tests.ins_eval.study.test_experiment import PLAN, planned

SEED = 8419
STUDY = Study(
    seed=SEED,
    triads=4,
    training=2,
    missions=(replace(planned("car"), hours=0.1),),
    calibrations=("mean",),
    settings={"bench": PLAN, "calibration": {**PLAN, "runs": 1}},
)


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A challenge, whose study ran without workers."""
    folder: Path = tmp_path_factory.mktemp("challenge")

    def run(study: Study, sealed: Path, *_: object) -> None:
        sealed.mkdir()
        write_conclusion(study, compute_block(study, range(study.triads)), sealed)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(challenge, "run_to_result", run)
        challenge.hand_out_challenge(folder, seed=SEED, study=STUDY)
    return folder


@pytest.fixture(scope="module")
def table(out: Path) -> pd.DataFrame:
    return pd.read_parquet(out / "sealed" / "study.parquet")


@pytest.fixture(scope="module")
def benched(out: Path) -> dict[str, MeasuredGyro]:
    """What the records of each gyro say, by its folder in the hand-out."""
    return {
        f"gyros/{folder.name}": evaluate_campaigns(
            read_campaign(folder / "bench"), read_campaign(folder / "bench-warm")
        )
        for folder in (out / "hand-out" / "gyros").iterdir()
    }


def predict(out: Path, name: str, folder: Path) -> Path:
    """Predictions of an example, which sees the hand-out alone."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.argv", [name, str(out / "hand-out"), str(folder / f"{name}.csv")])
        runpy.run_path(str(FOLDER / f"{name}.py"), run_name="__main__")
    return folder / f"{name}.csv"


def test_records_give_the_bench_figures_of_the_study(
    out: Path, table: pd.DataFrame, benched: dict[str, MeasuredGyro]
) -> None:
    flights = pd.read_csv(out / "hand-out" / "flights.csv")
    assert flights["role"].tolist() == ["train"] * 6 + ["test"] * 6
    for row in flights.itertuples():
        measured = benched[str(row.gyro)]
        sealed = table[table[c.TRIAD] == row.triad].iloc[0]
        for found, column in (
            (measured.fixed_stability, c.GYROS_FIXED),
            (measured.circumference_stability, c.GYROS_CIRCUMFERENCE),
        ):
            expected = sealed[column]["xyz".index(str(row.axis))]
            assert found / DEG_PER_H == pytest.approx(expected, rel=1e-6)


def test_believed_gyro_knows_the_correction_alone(out: Path) -> None:
    device = device_file.read(out / "hand-out" / "gyros" / "0002-y" / "gyro.toml")
    assert device.bias_map.mean != 0
    assert device.bias_map == replace(type(device.bias_map)(), mean=device.bias_map.mean)
    assert (device.damping_anisotropy, device.pickoff_gain_mismatch) == (0, 0)
    assert device.bryan_factor_error == 0
    assert device.decay_time == float(f"{device.decay_time:.3g}")


def test_hand_out_holds_no_truth_and_no_seed(out: Path, table: pd.DataFrame) -> None:
    training = pd.read_csv(out / "hand-out" / "training.csv")
    assert training["triad"].tolist() == table[c.TRIAD][table[c.ROLE] == TRAIN].tolist() == [0, 1]
    texts = [
        path.read_text() for path in (out / "hand-out").rglob("*") if path.suffix != ".gz"
        and path.is_file()
    ]  # fmt: skip
    assert len(texts) > 4 * 3 * 3
    first_digits = [f"{error:.6f}"[:-3] for error in table[c.FLOWN_NORTH][table[c.ROLE] != TRAIN]]
    hidden = [SEED, *first_digits]
    assert not [value for value in hidden for text in texts if str(value) in text]
    assert any(f"{error:.6f}"[:-3] in text for error in training["flown_north_m"] for text in texts)


def test_truth_can_not_be_changed_afterwards(out: Path, tmp_path: Path) -> None:
    index = json.loads((out / "hand-out" / "challenge.json").read_text())
    sealed = (out / "sealed" / "study.parquet").read_bytes()
    assert index["sha256"] == hashlib.sha256(sealed).hexdigest()
    changed = tmp_path / "changed"
    (changed / "hand-out").mkdir(parents=True)
    (changed / "sealed").symlink_to(out / "sealed")
    (changed / "hand-out" / "challenge.json").write_text(json.dumps({**index, "sha256": "0"}))
    with pytest.raises(HrgError, match="sha256: found 0, expected the truth's"):
        challenge.score_challenge(changed, [])


def test_examples_are_scored_beside_ours(
    out: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The naive one is the scorer's own baseline, by another way."""
    files = [str(predict(out, name, tmp_path)) for name in ("naive", "strong")]
    assert main(["study", "challenge", "--out", str(out), "--predictions", *files]) == 0
    printed = capsys.readouterr().out
    scores = pd.read_csv(out / challenge.SCORES)
    for title in (NAIVE.title, *(p.title for p in c.PREDICTORS), "naive", "strong"):
        assert title in printed
        assert (scores["predictor"] == title).sum() == 2
    rows = scores.set_index(["mission_class", "predictor"]).loc["car"]
    values = rows.drop(columns=["n", "seed"])
    np.testing.assert_allclose(values.loc["naive"], values.loc[NAIVE.title], rtol=1e-9)
    assert rows["n"].unique().tolist() == [2]
    with pytest.raises(HrgError, match="found a second file naive, expected other names"):
        challenge.score_challenge(out, [files[0], files[0]])


def test_strong_example_fits_the_bias_map(out: Path, benched: dict[str, MeasuredGyro]) -> None:
    """Against the bench's own fit of the same records: within 10 % of the map's size. Turns of one
    period, as here, determine no scale factor's second harmonic."""
    for folder in (out / "hand-out" / "gyros").iterdir():
        found = load_strong().fit_maps(folder / "bench")[:9]
        expected = benched[f"gyros/{folder.name}"].fitted_map[:9]
        assert np.linalg.norm(found - expected) < 0.1 * np.linalg.norm(expected), folder.name


def test_two_calibrations_are_refused(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="calibrations: found mean, map, expected one"):
        challenge.hand_out_challenge(
            tmp_path, seed=1, study=replace(STUDY, calibrations=("mean", "map"))
        )


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["challenge"], "--seed: found none, expected one that nobody else knows"),
        (["challenge", "--seed", "1", "--predictions", "a.csv"], "--seed: found beside"),
        (["small", "--predictions", "a.csv"], "--predictions: expected with `hrg study challenge`"),
    ],
)
def test_options_that_do_not_go_together(
    options: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["study", *options, "--out", str(tmp_path / "out")]) == 2
    assert message in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
