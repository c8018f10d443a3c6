"""Studies of tests."""

from pathlib import Path

from ins_eval.study.specification import PlannedMission, Study


def planned(name: str, half: str) -> PlannedMission:
    return PlannedMission(
        name=name,
        mission_class=name,
        half=half,
        hours=1.0,
        file_name=f"{name}.toml",
        content=b"",
    )


def study(seed: int = 3, triads: int = 75, cosimulated: int = 0) -> Study:
    """Fifteen blocks of five."""
    missions = (planned("car", "train"), planned("ship", "test"))
    return Study(seed=seed, triads=triads, cosimulated=cosimulated, missions=missions)


FILE = """\
seed = 3
triads = 75
hours = 1
missions = [
  { name = "car", class = "car", half = "train" },
  { name = "ship", class = "ship", half = "test" },
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
