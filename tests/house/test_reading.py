"""Files enter through `pyhrg.common.reading` alone."""

import ast
from pathlib import Path

from tests.house.test_shape import modules, tree

BOUNDARY = "pyhrg.common.reading"
PARSERS = (
    *("json.load", "json.loads", "tomllib.load", "tomllib.loads", "csv.reader", "csv.DictReader"),
    *("zipfile.ZipFile", "ET.parse", "ET.fromstring", "ET.XML", "pickle.load", "pickle.loads"),
    *("pd.read_csv", "pd.read_parquet", "pd.read_json", "pq.read_table", "pq.ParquetFile"),
    *("gzip.open", "gzip.decompress", "np.genfromtxt", "np.fromfile", "open", "yaml.safe_load"),
)
"""Calls that only the boundary makes."""
EXCEPTIONS = {
    "fmu_build.archive.packing": "zipfile.ZipFile",  # writes
    "fmu_build.check.fmi_sim": "zipfile.ZipFile",  # writes
    "fmu_build.archive.documentation.info_pages": "ET.fromstring",  # of our own library
    "fmu_build.check.importer": "pickle.load",  # of its parent process
    "ins_eval.study.run.block": "json.loads",  # of what it has just written
}
OWN_FILES = {
    "fmu_build.archive.documentation.document",
    "fmu_build.archive.documentation.info_pages",
    "fmu_build.archive.licences",
    "fmu_build.binaries.libraries",
    "fmu_build.binaries.platforms",
    "fmu_build.bundle",
    "fmu_build.equations.modelica",
    "ins_eval.mission_model.weights_cache",
    "ins_eval.study.challenge.challenge",
    "ins_eval.study.challenge.hand_out",
    "ins_eval.study.experiment",
    "ins_eval.system.player.trajectory_fmu",
    "ins_eval.system.system",
    "pyhrg.common.caches.compiled",
    "pyhrg.common.caches.files",
    "pyhrg.common.made_by",
    "pyhrg.common.pages.markup",
    "pyhrg.fmu.archive",
    "pyhrg.fmu.together",
    "pyhrg.gap.closing.equation.closed_file",
}
"""Modules that read files which this distribution or this process has made."""


def called(file: Path) -> set[str]:
    """Names of the functions that a file calls, as they are written; of methods the last part."""
    names = set()
    for node in ast.walk(tree(file)):
        if isinstance(node, ast.Call):
            name = ast.unparse(node.func)
            names |= {name, f".{name.rpartition('.')[2]}"} if "." in name else {name}
    return names


def outside() -> dict[str, Path]:
    """Modules that are not part of the boundary."""
    return {name: file for name, file in modules().items() if not name.startswith(BOUNDARY)}


def test_no_other_module_parses_files() -> None:
    found = {
        (name, call)
        for name, file in outside().items()
        for call in called(file) & set(PARSERS)
        if EXCEPTIONS.get(name) != call
    }
    assert found == set()


def test_no_other_module_reads_a_users_file() -> None:
    found = {
        name for name, file in outside().items() if called(file) & {".read_text", ".read_bytes"}
    }
    # `reading.files.read_bytes` is called by its name alone
    assert found == OWN_FILES


def test_every_exception_is_one() -> None:
    for name, call in EXCEPTIONS.items():
        assert call in called(modules()[name])
