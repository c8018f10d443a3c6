"""result.json: what is written is read back; what is damaged is refused by its key."""

import json
from pathlib import Path
from typing import Any

import pytest

from pyhrg.bench.reporting.document import read_document
from pyhrg.common.errors import HrgError
from tests.fuzzing.results import OUTCOME, write_bench_result

KEY = "bias_stability_deg_per_h"


def spoil(folder: Path, keys: tuple[str, ...], value: Any) -> Path:
    """Write a result in which a value is another, or missing where it is None."""
    write_bench_result(folder)
    path = folder / "test" / "result.json"
    document = table = json.loads(path.read_text())
    for key in keys[:-1]:
        table = table[int(key) if isinstance(table, list) else key]
    table[keys[-1]] = value
    if value is None:
        del table[keys[-1]]
    path.write_text(json.dumps(document))
    return path


def test_what_is_written_is_read(tmp_path: Path) -> None:
    write_bench_result(tmp_path)
    outcome, limits = read_document(tmp_path / "test" / "result.json")
    assert repr(outcome) == repr(OUTCOME)
    assert limits == {KEY: 0.01}


@pytest.mark.parametrize(
    ("keys", "value", "message"),
    [
        (("warnings",), None, "warnings: found no such key"),
        (("warnings",), [1], r"warnings: found \[1\], expected a list of texts"),
        (("tables", "0", "header"), "run", "header: found 'run', expected a list of texts"),
        (("tables", "0", "rows"), [["1"]], r"rows: found \['1'\], expected rows of 2 texts"),
        (("findings", KEY, "interval_95"), [1], r"interval_95: found \[1\], expected \[low, high"),
        (("findings", KEY, "interval_95"), [1, "2"], "interval_95: found '2', expected a number"),
        (("findings", KEY, "value"), "much", "value: found 'much', expected a number"),
        (("findings", KEY, "n"), 1.5, "n: found 1.5, expected a whole number"),
        (("findings", KEY, "name"), "random walk", f"expected that of {KEY}"),
        (("specification", KEY, "at_most"), None, "at_most: found no such key, expected a number"),
    ],
    ids=lambda value: ".".join(value) if isinstance(value, tuple) else None,
)
def test_a_damaged_result_is_refused(
    keys: tuple[str, ...], value: Any, message: str, tmp_path: Path
) -> None:
    with pytest.raises(HrgError, match=rf"result\.json: .*{message}"):
        read_document(spoil(tmp_path, keys, value))
