"""`hrg bench` from the command line, with short tests in the place of the real ones."""

import json
import re
from html.parser import HTMLParser
from importlib.metadata import version
from pathlib import Path

import pytest

from tests.pyhrg.bench.quick import PROCEDURES, RUNS
from tests.pyhrg.cli.bench_runs import contents, device, hrg

VOID = {"meta", "img"}


pytestmark = pytest.mark.usefixtures("short_tests")


class Page(HTMLParser):
    """Open elements, images and the text of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.images: list[dict[str, str | None]] = []
        self.text = ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "img":
            self.images.append(dict(attrs))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


def test_files_are_what_the_command_promises(done: Path) -> None:
    positions = {f"positions_{n + 1}.csv.gz" for n in range(RUNS)}
    fixed = {f"fixed_{n + 1}.csv.gz" for n in range(RUNS)}
    both = {"result.json", "campaign.json", "figure.png"}
    assert set(contents(done)) == {
        "report.html",
        *(f"fixed-position/{name}" for name in both | fixed),
        *(f"full-circumference/{name}" for name in both | positions),
    }


def test_result_reads_back(done: Path) -> None:
    document = json.loads((done / "full-circumference" / "result.json").read_text())
    assert document["schema"] == "hrg-bench/1"
    assert document["made_by"]["hrg"] == version("hrg")
    assert document["seed"] == 7
    assert document["device"] == "typical"
    assert re.fullmatch(r"[0-9a-f]{32}", document["device_sha256"])
    stability = document["findings"]["bias_stability_deg_per_h"]
    low, high = stability["interval_95"]
    assert low < stability["value"] < high
    assert stability["n"] == RUNS
    assert all(name.endswith("_deg_per_h") for name in document["findings"])
    assert {"mean", "cos4", "sin4"} <= set(document["values_si"]["bias_map"])


def test_page_is_well_formed_and_stands_alone(done: Path) -> None:
    text = (done / "report.html").read_text()
    page = Page(text)
    assert page.open == []
    for image in page.images:
        assert (done / str(image["src"])).read_bytes().startswith(b"\x89PNG")
        assert str(image["alt"]).startswith("Figure: Bias ")
    assert len(page.images) == 2
    assert str(done.parent) not in text
    assert "typical, simulated with seed 7" in page.text
    for procedure in PROCEDURES:
        assert procedure.title in page.text


def test_same_seed_same_bytes_on_any_number_of_workers(done: Path, tmp_path: Path) -> None:
    assert hrg("all", "--out", tmp_path, "--seed", 7, "--workers", 3) == 0
    assert contents(tmp_path) == contents(done)


def test_a_test_gives_the_same_alone_and_among_all(done: Path, tmp_path: Path) -> None:
    assert hrg("fixed-position", "--out", tmp_path, "--seed", 7) == 0
    again = {name: data for name, data in contents(tmp_path).items() if "/" in name}
    assert again == {k: v for k, v in contents(done).items() if k.startswith("fixed-position/")}


def test_another_seed_gives_other_numbers(done: Path, tmp_path: Path) -> None:
    assert hrg("fixed-position", "--out", tmp_path, "--seed", 8) == 0
    name = "fixed-position/fixed_1.csv.gz"
    assert contents(tmp_path)[name] != contents(done)[name]


def test_results_of_other_tests_stay(tmp_path: Path) -> None:
    assert hrg("full-circumference", "--out", tmp_path) == 0
    (tmp_path / "notes.txt").write_text("mine")
    before = contents(tmp_path)
    assert hrg("fixed-position", "--out", tmp_path) == 0
    after = contents(tmp_path)
    assert {name for name in before if before[name] != after[name]} == {"report.html"}


def test_recorded_logs_give_what_the_simulated_ones_gave(done: Path, tmp_path: Path) -> None:
    """Through files: the same findings to the digits that logs are written with."""
    folder = done / "full-circumference"
    assert hrg("full-circumference", "--campaign", folder, "--out", tmp_path) == 0
    made, read = (
        json.loads((path / "full-circumference" / "result.json").read_text())
        for path in (done, tmp_path)
    )
    assert read["seed"] is None
    for name, finding in made["findings"].items():
        assert read["findings"][name]["value"] == pytest.approx(finding["value"], rel=1e-6)
    assert not (tmp_path / "full-circumference" / "campaign.json").exists()


def test_all_of_a_campaign_are_those_that_it_has_records_for(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert hrg("all", "--campaign", done / "fixed-position", "--out", tmp_path) == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["fixed-position", "report.html"]
    said = capsys.readouterr().out
    assert "typical, recorded" in said
    assert said.endswith(f"written to {tmp_path}: report.html, fixed-position\n")


def test_specification(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Judged in text, page and result; names that nothing has are said where all tests are done."""
    text = "[specification]\nbias_stability_deg_per_h = 1.0\nbias_stabilty_deg_h = 1.0\n"
    gyro = device(tmp_path, text)
    assert hrg("all", "--device", gyro, "--out", tmp_path / "out") == 0
    said = capsys.readouterr().out
    assert said.count("at most 1: meets") == len(PROCEDURES)
    hint = "bias_stabilty_deg_h: not judged, no test gave a figure of that name; the closest is "
    assert hint + "bias_stability_deg_per_h" in said
    assert "not judged" in (tmp_path / "out" / "report.html").read_text()
    document = json.loads((tmp_path / "out" / "fixed-position" / "result.json").read_text())
    expected = {"bias_stability_deg_per_h": {"at_most": 1.0, "verdict": "meets"}}
    assert document["specification"] == expected
    assert hrg("fixed-position", "--device", gyro, "--out", tmp_path / "out") == 0
    assert "not judged" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["qwertz"], "argument TEST: found 'qwertz', expected one of fixed-position, full-"),
        (["fixed-postion"], "argument TEST: found 'fixed-postion', expected fixed-position\n"),
        (
            ["fixed-position", "--seed", "-1"],
            "seed: found -1, expected a whole number from 0 to 2^63",
        ),
        (
            ["fixed-position", "--seed", "1.5"],
            "argument --seed: found '1.5', expected a whole number",
        ),
        (["fixed-position", "--seed", str(2**63)], "expected a whole number from 0 to 2^63 - 1"),
        (["fixed-position", "--workers", "0"], "workers: found 0, expected a whole number from 1"),
        (
            ["fixed-position", "--workers", "two"],
            "argument --workers: found 'two', expected a whole number",
        ),
        (
            ["fixed-position", "--device", "none.toml"],
            "none.toml: found no such file and no ready device of this name, expected a file or ",
        ),
        (["fixed-position", "--campaign", "none"], "none: found no such folder, expected"),
        (["fixed-position", "--device", "a", "--campaign", "b"], "not allowed with argument"),
        (["fixed-position", "--bogus"], "unrecognized arguments: --bogus"),
        (["fixed-position", "--devise=typical"], "bench: found --devise, expected --device\n"),
        ([], "the following arguments are required: TEST"),
    ],
)
def test_mistake_is_one_line_and_status_2(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str
) -> None:
    assert hrg(*arguments, "--out", tmp_path / "out") == 2
    error = capsys.readouterr().err
    assert message in error
    assert error.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("decay_time = 450", "gyro.toml: decay_time: found an unknown key, expected decay_time_s"),
        ("decay_time_s = -1", "gyro.toml: decay_time_s: found -1"),
        ("decay_time_s", "found what is no TOML"),
        ("[specification]\nbias_deg_per_h = 'low'", "specification.bias_deg_per_h: found 'low'"),
        ("[model]\n'no.such' = 1.0", "model.no.such: found an unknown key"),
    ],
)
def test_wrong_device_is_one_line_and_status_2(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, message: str
) -> None:
    out = tmp_path / "out"
    assert hrg("fixed-position", "--device", device(tmp_path, text), "--out", out) == 2
    error = [line for line in capsys.readouterr().err.splitlines() if line.startswith("hrg: ")]
    assert len(error) == 1
    assert message in error[0]
    assert not out.exists()


def test_no_test_of_what_the_campaign_has(
    done: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    campaign = done / "fixed-position"
    assert hrg("full-circumference", "--campaign", campaign, "--out", tmp_path / "out") == 2
    assert "no test of kind positions; the campaign has static" in capsys.readouterr().err
    index = json.loads((campaign / "campaign.json").read_text())
    (tmp_path / "campaign.json").write_text(json.dumps(index | {"tests": []}))
    assert hrg("all", "--campaign", tmp_path, "--out", tmp_path / "out") == 2
    assert "no test evaluates a campaign that has no tests" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_folder_that_cannot_be_written_is_found_before_the_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("in the way")
    for out in ("file", "file/below"):
        assert hrg("fixed-position", "--out", tmp_path / out) == 2
        assert capsys.readouterr().err == f"hrg: {tmp_path / 'file'}: it is no folder\n"
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_what_is_no_result_is_not_replaced(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "fixed-position").mkdir()
    (tmp_path / "fixed-position" / "thesis.tex").write_text("mine")
    assert hrg("all", "--out", tmp_path) == 2
    assert "fixed-position: found what is no result of a bench test" in capsys.readouterr().err
    (tmp_path / "other" / "report.html").mkdir(parents=True)
    assert hrg("all", "--out", tmp_path / "other") == 2
    assert "report.html is a folder" in capsys.readouterr().err
    assert contents(tmp_path) == {"fixed-position/thesis.tex": b"mine"}


def test_progress_in_a_log_file_is_lines(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert hrg("all", "--out", tmp_path) == 0
    lines = capsys.readouterr().err.splitlines()
    assert "\r" not in "".join(lines)
    assert [line.partition(", ")[0] for line in lines if "power-on" in line] == [
        f"{procedure.name}: {RUNS} power-ons" for procedure in PROCEDURES
    ]


def test_help_lists_the_tests(capsys: pytest.CaptureFixture[str]) -> None:
    assert hrg("--help") == 0
    said = capsys.readouterr().out
    for procedure in PROCEDURES:
        assert f"{procedure.name:<18}  {procedure.title}" in said
