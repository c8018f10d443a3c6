"""README's Python example of the navigator runs as it stands there."""

from pathlib import Path

import pytest

TEXT = (Path(__file__).parents[2] / "README.md").read_text()


def test_example(capsys: pytest.CaptureFixture[str]) -> None:
    section = TEXT.split("## The navigator")[1]
    exec(section.split("```python\n")[1].split("```")[0], {})
    north, east, down = map(float, capsys.readouterr().out.strip(" []\n").split())
    assert 1 < abs(north) + abs(east) < 1000
    assert abs(down) < 1e-6
