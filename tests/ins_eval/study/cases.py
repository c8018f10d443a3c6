"""Studies of tests."""

from pathlib import Path

from ins_eval.study.specification import PlannedMission, Study


def planned(name: str) -> PlannedMission:
    return PlannedMission(
        name=name,
        mission_class=name,
        hours=1.0,
        file_name=f"{name}.toml",
        content=b"",
    )


def study(seed: int = 3, triads: int = 75) -> Study:
    """Blocks of two triads, the last of one; half of the triads are training triads."""
    return Study(
        seed=seed,
        triads=triads,
        training=max(1, triads // 2),
        missions=(planned("car"), planned("ship")),
    )


FILE = """\
seed = 3
triads = 75
training = 37
hours = 1
missions = [
  { name = "car", class = "car" },
  { name = "ship", class = "ship" },
]
"""


def study_file(folder: Path, *changes: tuple[str, str]) -> Path:
    """The study of `FILE`, with pieces of text exchanged."""
    text = FILE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = folder / "study.toml"
    path.write_text(text)
    return path
