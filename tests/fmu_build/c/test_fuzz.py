"""Random calls under the sanitizers: nothing crashes, leaks or changes what it should not.

`benchmarks/fuzz.py` runs millions of them.
"""

from pathlib import Path

import pytest

from tests.fmu_build.c import native

RUNS = [(2, "HRG", 8_000), (3, "HRG", 8_000), (3, "HRGSlow", 5_000), (3, "HRGCarrier", 1_000)]


@pytest.mark.needs("gcc with sanitizers")
@pytest.mark.parametrize(("fmi", "root", "calls"), RUNS)
def test_random_calls_are_answered_as_the_standard_says(
    tmp_path: Path, fmi: int, root: str, calls: int
) -> None:
    """What the fuzzer checks after each call is in `fuzz.c`."""
    said = native.run([native.fuzzer(tmp_path, fmi, root), "1", str(calls)])
    made, illegal, _ = (int(word.split()[0]) for word in said.split(", "))
    assert made >= calls
    assert illegal > calls / 4
