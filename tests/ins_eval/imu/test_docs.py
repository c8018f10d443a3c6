"""docs/imus.md names what there is."""

import re
from pathlib import Path

from ins_eval.imu import specification
from pyhrg.records.imu import log

TEXT = (Path(__file__).parents[3] / "docs" / "imus.md").read_text()
NAMED = set(re.findall(r"`([^`\n]+)`", TEXT))


def test_every_key_is_documented() -> None:
    keys = specification.error_keys(specification.GYROS + specification.ACCELEROMETERS)
    assert set(keys) <= NAMED


def test_every_column_and_ready_imu_is_documented() -> None:
    quantities = log.GYROS + log.ACCELEROMETERS
    assert {quantity.column("x") for quantity in quantities} | {log.TIME} <= NAMED
    assert set(specification.list_imus()) <= NAMED


def test_the_example_is_read(tmp_path: Path) -> None:
    (tmp_path / "imu.toml").write_text(TEXT.split("```toml\n")[1].split("```")[0])
    read = specification.read_imu(tmp_path / "imu.toml")
    assert read.interval == 1 / 200
