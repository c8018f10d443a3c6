"""A study's folder: whose it is, what is kept in it, what is refused."""

import fcntl
import json
import os
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from distributed import LocalCluster

from ins_eval.study.run import block, workers
from ins_eval.study.run.block import Arrays, BlockWork, Identity, identify_study
from ins_eval.study.run.folder import StudyFolder
from ins_eval.study.run.run import Cluster, run_experiment
from ins_eval.study.run.workers import DASHBOARD_ADDRESS
from ins_eval.study.specification import Study
from pyhrg.common.caches.files import read_cached
from pyhrg.common.errors import HrgError
from pyhrg.common.made_by import find_difference
from tests.ins_eval.study import cases
from tests.ins_eval.study.run.cheap import CHEAP, conclude, made
from tests.ins_eval.study.run.processes import contents

STUDY = cases.study()
NOWHERE = Cluster("tcp://127.0.0.1:1")
"""No scheduler is there."""


@pytest.fixture(scope="module")
def cluster() -> Iterator[Cluster]:
    with LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        processes=False,
        host="127.0.0.1",
        protocol="tcp",
        dashboard_address=DASHBOARD_ADDRESS,
    ) as local:
        yield Cluster(local.scheduler_address)


@pytest.fixture
def complete(tmp_path: Path, cluster: Cluster) -> Path:
    """The folder of a study that is complete."""
    out = tmp_path / "out"
    run_experiment(STUDY, out, CHEAP, cluster)
    return out


@pytest.fixture
def begun(tmp_path: Path) -> StudyFolder:
    """The folder of a study of which all blocks but the last are kept."""
    own = identify_study(STUDY)
    folder = StudyFolder(tmp_path / "out", own)
    folder.path.mkdir()
    (folder.path / "identity.json").write_text(own.text)
    for number in range(block.count_blocks(STUDY) - 1):
        folder.keep(number, BlockWork(STUDY, own, made)(number))
    return folder


def fails(study: Study, triads: range) -> Arrays:
    raise AssertionError(f"{triads} done")


def test_all_triads_are_there_in_order_and_blocks_are_not(complete: Path) -> None:
    assert set(contents(complete)) == {"identity.json", *CHEAP.files}
    assert (complete / "triads.txt").read_text() == " ".join(map(str, range(STUDY.triads)))


def test_complete_study_is_not_done_again(complete: Path) -> None:
    before, told = contents(complete), list[tuple[int, int]]()
    run_experiment(
        STUDY, complete, replace(CHEAP, compute=fails), NOWHERE, lambda *now: told.append(now)
    )
    assert contents(complete) == before
    assert told == [(STUDY.triads, STUDY.triads)]


def test_kept_blocks_are_not_done_again(begun: StudyFolder, cluster: Cluster) -> None:
    told = list[tuple[int, int]]()
    run_experiment(STUDY, begun.path, CHEAP, cluster, lambda *now: told.append(now))
    assert told == [(74, 75), (75, 75)]


@pytest.mark.parametrize("damage", [lambda b: b[:500], lambda b: b[:400] + b"?" + b[401:]])
def test_damaged_block_is_done_again(begun: StudyFolder, cluster: Cluster, damage: object) -> None:
    assert callable(damage)
    path = begun.block(1)
    path.write_bytes(damage(path.read_bytes()))
    told = list[tuple[int, int]]()
    run_experiment(STUDY, begun.path, CHEAP, cluster, lambda *now: told.append(now))
    assert sorted(told[:1]) == [(72, 75)]
    assert told[-1] == (75, 75)
    assert len(told) == 3


def test_block_of_another_number_or_study_is_none(begun: StudyFolder) -> None:
    file = read_cached(begun.block(1))
    assert file is not None
    assert block.unpack_block(file, begun.identity, 1)
    assert block.unpack_block(file, begun.identity, 2) is None
    assert block.unpack_block(file, identify_study(cases.study(seed=4)), 1) is None


def test_what_fails_keeps_what_was_done(begun: StudyFolder, cluster: Cluster) -> None:
    before = contents(begun.path)
    with pytest.raises(AssertionError, match=r"range\(74, 75\) done"):
        run_experiment(STUDY, begun.path, replace(CHEAP, compute=fails), cluster)
    assert contents(begun.path) == before


def test_results_appear_together_or_not_at_all(begun: StudyFolder, cluster: Cluster) -> None:
    def breaks_off(study: Study, arrays: Arrays, folder: Path) -> None:
        conclude(study, arrays, folder)
        raise RuntimeError("no score")

    with pytest.raises(RuntimeError, match="no score"):
        run_experiment(STUDY, begun.path, replace(CHEAP, conclude=breaks_off), cluster)
    assert not set(contents(begun.path)) & set(CHEAP.files)
    assert begun.load_block(3) is not None


def test_leftovers_of_a_killed_command_are_removed(complete: Path, cluster: Cluster) -> None:
    before = contents(complete)
    leftover = complete / ".files.abcdefgh.partial"
    leftover.mkdir()
    (leftover / "draws.json").write_text("[")
    (complete / "draws.json").unlink()
    (complete / "blocks").mkdir()
    (complete / "blocks" / ".000001.npz.abcdefgh.partial").write_text("half")
    run_experiment(STUDY, complete, CHEAP, cluster)
    assert contents(complete) == before
    assert not leftover.exists()


def refused(out: Path, study: Study, message: str) -> None:
    before = contents(out)
    with pytest.raises(HrgError, match=re.escape(f"{out}{message}")):
        run_experiment(study, out, CHEAP, NOWHERE)
    assert contents(out) == before


@pytest.mark.parametrize(
    ("study", "message"),
    [
        (cases.study(seed=4), "another study: seed: found 3, expected 4; choose another folder"),
        (cases.study(triads=80), "another study: triads: found 75, expected 80"),
        (
            replace(STUDY, missions=(STUDY.missions[0], cases.planned("sea"))),
            "another study: missions[1].name: found 'ship', expected 'sea'",
        ),
        (
            replace(STUDY, missions=(replace(STUDY.missions[0], content=b"x"), STUDY.missions[1])),
            "another study: missions[0].content: found 'sha256 e3b0c44",
        ),
    ],
    ids=["seed", "triads", "mission", "content"],
)
def test_folder_of_another_study_is_refused(complete: Path, study: Study, message: str) -> None:
    refused(complete, study, f"/identity.json: {message}")


@pytest.mark.parametrize("key", ["hrg", "code", "numpy"])
def test_folder_of_another_version_is_refused(complete: Path, key: str) -> None:
    file = complete / "identity.json"
    found = json.loads(file.read_text())
    found["made_by"][key] = "0"
    file.write_text(json.dumps(found))
    message = f"/identity.json: a study of another version: {key}: found 0, expected "
    refused(complete, STUDY, message)


@pytest.mark.parametrize("text", ["{", "[]", "{}"])
def test_spoilt_identity_is_refused(complete: Path, text: str) -> None:
    (complete / "identity.json").write_text(text)
    refused(complete, STUDY, "/identity.json: ")


def test_folder_of_something_else_is_refused(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    refused(tmp_path, STUDY, ": found thesis.tex, expected an empty folder or a study's")


def test_one_command_at_a_time(complete: Path) -> None:
    handle = os.open(complete, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX)
        refused(complete, STUDY, ": found another command at work there")
    finally:
        os.close(handle)


def test_absent_scheduler_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "ARRIVAL_TIMEOUT", 0.2)
    with pytest.raises(HrgError, match="1: found no scheduler, expected one"):
        run_experiment(STUDY, tmp_path, CHEAP, NOWHERE)


def test_address_that_is_none_is_told(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="here: found no address, expected tcp://HOST:PORT"):
        run_experiment(STUDY, tmp_path, CHEAP, Cluster("here"))


def test_worker_of_another_version_refuses() -> None:
    own = identify_study(STUDY)
    other = Identity(own.study, {**own.made_by, "code": "0"})
    message = f"a worker of another version: code: found {own.made_by['code']}, expected 0"
    with pytest.raises(HrgError, match=message):
        BlockWork(STUDY, other, made)(0)


def test_arrays_of_a_few_blocks_alone_are_joined() -> None:
    blocks: list[Arrays] = [
        {"a": np.array([1])},
        {"a": np.array([2]), "b": np.array([3])},
        {"b": np.array([4])},
    ]
    joined = block.join_blocks(blocks)
    assert {name: values.tolist() for name, values in joined.items()} == {"a": [1, 2], "b": [3, 4]}


def test_blocks_hold_all_triads_once() -> None:
    """Many for many workers, none larger than a kill may cost."""
    for triads in (2, 15, 16, 75, 80, 1000):
        study = cases.study(triads=triads)
        blocks = [block.list_triads(study, number) for number in range(block.count_blocks(study))]
        assert [triad for each in blocks for triad in each] == list(range(triads))
        assert max(map(len, blocks)) <= block.LARGEST_BLOCK
        assert len(blocks) >= min(triads, 10)


def test_difference_names_the_first_key() -> None:
    assert find_difference({"a": [1, {"b": 2}]}, {"a": [1, {"b": 2}]}) is None
    assert find_difference({"a": [1, {"b": 2}]}, {"a": [1, {"b": 3}]}) == ("a[1].b", 2, 3)
    assert find_difference({"a": [1]}, {"a": [1, 2]}) == ("a", [1], [1, 2])
    assert find_difference({}, {"c": 1}) == ("c", None, 1)
