"""Names of devices, tests, missions, channels and files stand in every page and figure as text."""

import io
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

import ins_eval
from ins_eval.results.growth_figure import draw_growth
from ins_eval.results.map_figure import draw_map
from ins_eval.study.report.page import render_page
from ins_eval.study.tables import columns as c
from pyhrg import compute_allan, diagnose_record
from pyhrg.bench.catalogue import PROCEDURES
from pyhrg.bench.reporting.result import PAGE, BenchResults, TestFailure
from pyhrg.common.cli import main
from pyhrg.common.pages.markup import make_choice, make_paragraph
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.report.page import build_page
from pyhrg.gap.static_record.report.allan_page import build_allan_page
from pyhrg.gap.static_record.report.page import build_page as build_record_page
from tests.elements import elements
from tests.ins_eval.position.conftest import write_diagnosis as write_diagnosis
from tests.ins_eval.results.cases import dataset
from tests.ins_eval.study.report.synthetic import MISSIONS, synthetic
from tests.pyhrg.gap.report.conftest import simulation as simulation
from tests.pyhrg.gap.report.conftest import with_gap as with_gap
from tests.pyhrg.gap.static_record.test_run import belief_file, imu_log

EVIL = "<img src=x onerror=alert(1)>\"'</script><!--&"
EVIL_FILE = "<img src=x onerror=alert(1)>"
Arguments = list[str | Path]
FORMULA = r"$\nonsense{$"


def make_bench_page(request: pytest.FixtureRequest, folder: Path) -> str:
    BenchResults(EVIL, [TestFailure(PROCEDURES[0], EVIL)], {}).write_page(folder)
    return (folder / PAGE).read_text()


def make_allan_page(request: pytest.FixtureRequest, folder: Path) -> str:
    noise = compute_allan(imu_log(folder / "imu.csv"))
    channels = [replace(n, channel=replace(n.channel, name=EVIL)) for n in noise.channels]
    return build_allan_page(replace(noise, source=EVIL, channels=channels, notes=[EVIL]))


def make_record_page(request: pytest.FixtureRequest, folder: Path) -> str:
    result = diagnose_record(imu_log(folder / "imu.csv"), belief_file(folder))
    channels = [replace(d, channel=replace(d.channel, name=EVIL)) for d in result.channel_diagnoses]
    return build_record_page(replace(result, source=EVIL, channel_diagnoses=channels))


def make_gap_page(request: pytest.FixtureRequest, folder: Path) -> str:
    result: CampaignDiagnosis = request.getfixturevalue("with_gap")
    tests = [replace(t, test=replace(t.test, id=EVIL)) for t in result.tests]
    where = [replace(w, test=EVIL) for w in result.diagnosis.where]
    causes = [replace(cause, effect=EVIL) for cause in result.diagnosis.causes]
    said = replace(
        result.diagnosis, device=EVIL, where=tuple(where), excluded=(EVIL,), causes=tuple(causes)
    )
    return build_page(replace(result, diagnosis=said, tests=tuple(tests)))


def make_position_page(request: pytest.FixtureRequest, folder: Path) -> str:
    diagnosed = request.getfixturevalue("write_diagnosis")(damping_anisotropy=4e-8)
    gaps = ins_eval.compute_position_gap(diagnosed, missions=["car"], hours=0.1, triads=20)
    return replace(gaps, missions=[replace(m, name=EVIL) for m in gaps.missions]).section.html


def make_study_page(request: pytest.FixtureRequest, folder: Path) -> str:
    result = synthetic(12)
    evil = dict.fromkeys(MISSIONS, EVIL)
    names = {c.MISSION: evil, c.CLASS: dict.fromkeys(MISSIONS.values(), EVIL)}
    return render_page(replace(result, table=result.table.replace(names)))


def make_pieces(request: pytest.FixtureRequest, folder: Path) -> str:
    return make_choice(EVIL, EVIL, {EVIL: EVIL}, EVIL) + make_paragraph(EVIL, EVIL)


@pytest.mark.parametrize(
    "make",
    [
        make_bench_page,
        make_allan_page,
        make_record_page,
        make_gap_page,
        make_position_page,
        make_study_page,
        make_pieces,
    ],
)
def test_markup_in_names_is_text(
    make: Callable[[pytest.FixtureRequest, Path], str],
    request: pytest.FixtureRequest,
    tmp_path: Path,
) -> None:
    text = make(request, tmp_path)
    found = elements(text)
    assert "&lt;img src=x" in text
    assert not [a for tag, a in found if a.get("src") == "x" or "onerror" in a]
    assert "<!--&" not in text


def write_log(folder: Path) -> Path:
    """An IMU's log whose name holds markup."""
    return imu_log(folder / "imu.csv").rename(folder / f"log {EVIL_FILE}.csv")


def bench(folder: Path) -> Arguments:
    device = folder / f"device {EVIL_FILE}.toml"
    device.write_text(f'name = "{EVIL_FILE}"\n')
    return ["bench", "amplitude-sweep", "--device", device]


def allan(folder: Path) -> Arguments:
    return ["allan", write_log(folder), "--trusted"]


def diagnose(folder: Path) -> Arguments:
    belief = belief_file(folder).rename(folder / f"belief {EVIL_FILE}.toml")
    return ["gap", "diagnose", write_log(folder), "--belief", belief, "--trusted"]


@pytest.mark.parametrize("make_arguments", [bench, allan, diagnose])
def test_markup_in_names_of_files_is_text(
    make_arguments: Callable[[Path], Arguments], tmp_path: Path
) -> None:
    arguments = [*make_arguments(tmp_path), "--out", tmp_path / "out"]
    assert main([str(argument) for argument in arguments]) == 0
    texts = [path.read_text() for path in (tmp_path / "out").rglob("*.html")]
    assert not any("<img src=x" in text for text in texts)
    assert any("&lt;img src=x" in text for text in texts)


@pytest.mark.parametrize(
    "draw",
    [
        lambda name: draw_map(dataset().assign_attrs(title=name)),
        lambda name: draw_growth(dataset().assign_attrs(title=name)),
    ],
    ids=["map", "growth"],
)
def test_a_name_is_no_formula(draw: Callable) -> None:
    draw(FORMULA).savefig(io.BytesIO())
