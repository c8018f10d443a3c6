"""Many spoilt inputs; `benchmarks/fuzz.py` tries ten thousand."""

from itertools import islice

import pytest

from tests.fuzzing.cases import make_cases
from tests.fuzzing.runner import READ, Case, find_troubles, run_case
from tests.fuzzing.samples import SAMPLES, read_all

CASES = 150


@pytest.fixture(scope="module", autouse=True)
def _loaded() -> None:
    read_all()


@pytest.mark.parametrize("name", SAMPLES)
def test_a_right_input_is_read(name: str) -> None:
    sample = SAMPLES[name]
    outcome = run_case(Case(name, sample.write, sample.read))
    assert (outcome.status, outcome.trouble) == (READ, ""), outcome.message


def test_spoilt_inputs_are_read_or_refused_in_one_line() -> None:
    said: list[str] = []
    read, refused, wrong = find_troubles(islice(make_cases(1), CASES), said.append)
    assert wrong == 0, "\n".join(said)
    assert read > CASES // 20
    assert refused > CASES // 2


@pytest.mark.parametrize(
    ("read", "trouble"),
    [
        (lambda folder: 1 / 0, "a traceback"),
        (lambda folder: bytearray(b"x") * 2**31, "it takes 2"),
        (lambda folder: (folder / "left").touch(), "something was written"),
    ],
    ids=["traceback", "memory", "file"],
)
def test_trouble_is_found(read: object, trouble: str) -> None:
    """What the fuzzer looks for, done on purpose."""
    assert run_case(Case("", lambda folder: None, read)).trouble.startswith(trouble)  # type: ignore[arg-type]
