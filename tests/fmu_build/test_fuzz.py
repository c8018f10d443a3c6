"""Random calls under the sanitizers: nothing crashes, leaks or changes what it should not.

`benchmarks/fuzz.py` runs millions of them.
"""

from pathlib import Path

import pytest

from tests.fmu_build import native

CALLS = 150_000


@pytest.mark.parametrize("fmi", [2, 3])
def test_random_calls_are_answered_as_the_standard_says(tmp_path: Path, fmi: int) -> None:
    """What the fuzzer checks after each call is in `fuzz.c`."""
    said = native.run([native.fuzzer(tmp_path, fmi), "1", str(CALLS)])
    calls, illegal, failed = (int(word.split()[0]) for word in said.split(", "))
    assert calls >= CALLS
    assert illegal > calls / 4
    assert failed > 0
