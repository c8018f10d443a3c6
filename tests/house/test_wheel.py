"""The wheel: what runs where it is installed without compilers and without Dask."""

import os
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SHIPPED = ("fmu_build", "pyhrg", "ins_eval", "modelica")
BUILD = """
import sys
import build_backend
from fmu_build import bundle
from fmu_build.binaries.platforms import find_host_platform

bundle.list_platforms = lambda fmi: [find_host_platform()]
build_backend.build_wheel(sys.argv[1])
"""
"""Makes the wheel for this machine alone; its FMUs' libraries come from the user's cache."""
RUN = """
import sys
for library in ("ziglang", "rumoca", "dask", "distributed"):
    sys.modules[library] = None
from pyhrg.common.cli import main
sys.exit(main(sys.argv[1:]))
"""
Run = Callable[..., subprocess.CompletedProcess[str]]


def _run_python(
    code: str, *arguments: object, folder: Path, path: Path
) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", code, *map(str, arguments)]
    environment = {**os.environ, "PYTHONPATH": str(path)}
    return subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of these sources, as it is installed."""
    checkout, wheels, site = (tmp_path_factory.mktemp(name) for name in ("co", "wheels", "site"))
    for name in SHIPPED:
        shutil.copytree(ROOT / name, checkout / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("build_backend.py", "pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, checkout)
    run = _run_python(BUILD, wheels, folder=checkout, path=checkout)
    assert run.returncode == 0, run.stderr
    assert not (checkout / "fmu_build" / "prebuilt").exists()
    with zipfile.ZipFile(next(wheels.iterdir())) as wheel:
        wheel.extractall(site)
    return site


@pytest.fixture
def run(installed: Path, tmp_path: Path) -> Run:
    """`hrg` of the wheel, where neither compilers nor Dask can be imported."""
    return lambda *arguments: _run_python(RUN, *arguments, folder=tmp_path, path=installed)


def test_it_installs_three_packages_and_the_modelica_as_data(installed: Path) -> None:
    names = {path.name for path in installed.iterdir() if path.suffix != ".dist-info"}
    assert names == {"fmu_build", "ins_eval", "pyhrg"}
    assert (installed / "fmu_build" / "modelica" / "HRG" / "package.mo").is_file()


def test_its_code_has_the_digest_of_the_checkout(installed: Path) -> None:
    code = "from pyhrg.common.made_by import list_versions as v; print(v()['code'])"
    runs = [_run_python(code, folder=path, path=path) for path in (installed, ROOT)]
    assert runs[0].stdout == runs[1].stdout != ""


@pytest.mark.parametrize("model", ["HRG", "HRGCarrier", "HRGSlow"])
def test_its_fmus_are_those_that_the_checkout_builds(
    installed: Path, run: Run, tmp_path: Path, model: str
) -> None:
    built = run("build", "--model", model)
    assert built.returncode == 0, built.stderr
    code = "import sys, fmu_build; print(fmu_build.build_fmu(sys.argv[1]))"
    own = _run_python(code, model, folder=ROOT, path=ROOT)
    assert (tmp_path / f"{model}.fmu").read_bytes() == Path(own.stdout.strip()).read_bytes()


@pytest.mark.parametrize(
    "command",
    [
        ("bench", "threshold"),
        ("nav", "--trajectory", "static-table", "--imu", "typical-hrg", "--hours", "0.05"),
    ],
    ids=lambda command: command[0],
)
def test_bench_and_navigator_run(run: Run, command: tuple[str, ...]) -> None:
    ended = run(*command)
    assert ended.returncode == 0, ended.stderr


@pytest.mark.parametrize(
    ("command", "library", "extra"),
    [
        (("build", "--fmi", "3"), "ziglang", "build"),
        (("gap", "diagnose", ".", "--out", "found"), "rumoca", "build"),
        (("gap", "challenge", "--out", "challenge"), "rumoca", "build"),
        (("validate", "--triads", "36"), "dask", "cluster"),
    ],
    ids=lambda value: value[0] if isinstance(value, tuple) else value,
)
def test_what_needs_an_extra_names_it_at_once(
    run: Run, command: tuple[str, ...], library: str, extra: str
) -> None:
    ended = run(*command)
    assert (ended.returncode, ended.stdout) == (2, "")
    (line,) = ended.stderr.splitlines()
    assert line.startswith(f"hrg: {library} is not installed, expected to ")
    assert line.endswith(f": python3 -m pip install 'hrg[{extra}]'")
