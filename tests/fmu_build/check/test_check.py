"""`hrg check`: no finding in our FMUs; what fails or differs is one, what is missing is skipped."""

import json
import os
import re
import subprocess
import sys
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import pytest

from fmu_build.binaries.platforms import PLATFORMS
from fmu_build.bundle import build_fmu
from fmu_build.check import importer, importers
from fmu_build.check.archive import open_fmu
from fmu_build.check.experiment import Experiment, FailedError, plan_experiment
from fmu_build.check.fmu_checks import run_checks
from fmu_build.check.importer import Importer
from fmu_build.check.importers import IMPORTERS
from fmu_build.check.runs import find_disagreements
from fmu_build.roots import ROOTS
from tests.fmu_build.check.tampering import damaged, description, removed, tampered


def checked(path: Path, *options: str, **environment: str) -> subprocess.CompletedProcess[str]:
    command = [str(Path(sys.executable).parent / "hrg"), "check", str(path), *options]
    return subprocess.run(
        command, capture_output=True, text=True, check=False, env={**os.environ, **environment}
    )


def planned(path: Path) -> Experiment:
    found = plan_experiment(open_fmu(path))
    assert found is not None
    return found


@lru_cache
def check_delivered(name: str, fmi: int) -> subprocess.CompletedProcess[str]:
    """Check an FMU as it is delivered: for every platform that the standard has a folder for."""
    platforms = [p.name for p in PLATFORMS.values() if fmi == 3 or p.fmi2_folder]
    return checked(build_fmu(name, fmi=fmi, platforms=platforms))


NEEDS = {"Ecos": [pytest.mark.needs("libtbb12")], "fmi-sim": [pytest.mark.needs("fmi-sim")]}


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", ROOTS)
def test_our_fmus_have_no_finding(name: str, fmi: int) -> None:
    run = check_delivered(name, fmi)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "\n0 findings in " in run.stdout


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", ROOTS)
@pytest.mark.parametrize(
    "importer",
    [pytest.param(i, marks=NEEDS.get(i.name, []), id=i.name) for i in IMPORTERS],
)
def test_every_importer_runs_our_fmus(importer: Importer, name: str, fmi: int) -> None:
    lines = check_delivered(name, fmi).stdout.splitlines()
    is_asked = f"FMI {fmi}.0" in importer.standards
    start = f"{'ok' if is_asked else '-':6}{importer.name} {importer.find_version()} runs it"
    assert any(line.startswith(start) for line in lines), lines
    if is_asked and importer.name != "FMPy":  # another one is needed to compare
        (compared,) = [line for line in lines if "importers see equal numbers" in line]
        assert compared.startswith("ok    ")
        assert importer.name in compared


def test_a_finding_gives_status_1(tmp_path: Path) -> None:
    copy = tampered(build_fmu(), tmp_path, description('stepSize="[^"]*"', 'stepSize="0"'))
    run = checked(copy)
    assert run.returncode == 1
    assert "FOUND the default experiment can be run\n      stepSize is 0" in run.stdout


def test_a_program_reads_the_findings(tmp_path: Path) -> None:
    copy = tampered(build_fmu(), tmp_path, description('stepSize="[^"]*"', 'stepSize="0"'))
    run = checked(copy, "--json")
    assert run.returncode == 1
    read = json.loads(run.stdout)
    found = {check["name"]: check["findings"] for check in read["checks"] if check["findings"]}
    assert found["the default experiment can be run"][0].startswith("stepSize is 0")


def test_unusable_input_gives_status_2(tmp_path: Path) -> None:
    run = checked(tmp_path / "nowhere.fmu")
    assert run.returncode == 2
    assert "nowhere.fmu: can't be read: No such file" in run.stderr


def test_a_missing_importer_is_skipped_and_says_how_to_install_it() -> None:
    run = checked(build_fmu(), PATH=os.defpath)
    assert run.returncode == 0
    assert "SKIPPED fmi-sim runs it\n      fmi-sim is missing: " in run.stdout
    assert "cargo install fmi-sim" in run.stdout


def test_importers_that_can_not_be_loaded_are_skipped(tmp_path: Path) -> None:
    """With the comparison, when a single importer is left."""
    for package in ("ecospy", "libcosimpy"):
        (tmp_path / f"{package}.py").write_text("raise OSError('libnone.so: cannot open')")
    run = checked(build_fmu(), PATH="/nonexistent", PYTHONPATH=str(tmp_path))
    assert run.returncode == 0, run.stdout + run.stderr
    for name in ("Ecos", "libcosimpy"):
        reason = rf"{name} can't be loaded \(libnone\.so: cannot open\): pip install"
        assert re.search(rf"SKIPPED {name} \S+ runs it\n      {reason}", run.stdout)
    assert "SKIPPED importers see equal numbers" in run.stdout
    assert run.stdout.endswith("; 4 checks skipped\n")


def test_ci_installs_the_version_that_is_asked_for() -> None:
    script = (Path(__file__).parents[3] / ".ci" / "run").read_text()
    assert f"fmi_sim={importers.FMI_SIM_VERSION}\n" in script


@pytest.mark.parametrize("fmi", [2, 3])
def test_an_fmu_without_a_binary_for_this_machine_is_one_finding(tmp_path: Path, fmi: int) -> None:
    copy = tampered(build_fmu(fmi=fmi), tmp_path, removed("^binaries/"))
    (finding,) = [f for c in run_checks(open_fmu(copy)) for f in c.findings]
    assert finding.startswith("no binary for this machine: binaries/")


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_damaged_entry_is_one_finding(tmp_path: Path, fmi: int) -> None:
    copy = damaged(build_fmu(fmi=fmi), tmp_path, "documentation/index.html")
    (finding,) = [f for c in run_checks(open_fmu(copy)) for f in c.findings]
    assert finding.startswith("documentation/index.html in ")


def test_a_damaged_description_is_no_usable_input(tmp_path: Path) -> None:
    copy = damaged(build_fmu(), tmp_path, "modelDescription.xml")
    run = checked(copy)
    assert run.returncode == 2
    assert "found what is no intact entry" in run.stderr


def test_what_fmpy_finds_is_a_finding(tmp_path: Path) -> None:
    copy = tampered(build_fmu(), tmp_path, description('causality="output"', 'causality="ouput"'))
    findings = {c.name: c.findings for c in run_checks(open_fmu(copy))}
    assert any("ouput" in finding for finding in findings["FMPy validates it"])


def test_a_crash_is_a_failure_of_the_importer() -> None:
    """libcosimpy knows FMI 2.0 only, and is not asked to run others for this reason."""
    (libcosimpy,) = (i for i in IMPORTERS if i.name == "libcosimpy")
    with pytest.raises(FailedError, match="it crashed by signal"):
        libcosimpy.record(planned(build_fmu(fmi=3)))


def test_an_importer_that_hangs_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(importer, "TIMEOUT", 0.01)
    with pytest.raises(FailedError, match=r"no end within 0\.01 s"):
        IMPORTERS[0].record(planned(build_fmu()))


def test_a_last_bit_is_a_disagreement() -> None:
    run = replace(planned(build_fmu()), outputs={"y": 1}, steps=2, start=0.0, step=0.5)
    traces = {"A": {"y": [0.1, 0.2]}, "B": {"y": [0.1, 0.2 + 2**-55]}}
    assert list(find_disagreements(run, {"A": traces["A"], "C": traces["A"]})) == []
    (found,) = find_disagreements(run, traces)
    assert found == "y at 1 s: 0.2 in A, 0.20000000000000004 in B"


@pytest.mark.parametrize(
    ("values", "words"), [([0.1], "1 values"), ([0.1, float("nan")], "not finite")]
)
def test_too_few_values_or_none_are_found(values: list[float], words: str) -> None:
    run = replace(planned(build_fmu()), outputs={"y": 1}, steps=2)
    (found,) = find_disagreements(run, {"A": {"y": values}})
    assert words in found


def test_inputs_are_moved_within_their_limits() -> None:
    run = planned(build_fmu())
    assert run.inputs["angularRate"] == 1e-3
    assert run.inputs["driveOn"] == 1 - 1e-3
    assert run.step == 2.0**-7
