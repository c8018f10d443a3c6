"""Several FMUs' sources in one program, each with its prefix: no name clashes, same bits."""

from pathlib import Path

import fmpy
import pytest

from fmu_build.binaries.platforms import COMPILER, FLAGS
from fmu_build.bundle import SHELLS, SOURCES, build_fmu, write_sources
from fmu_build.roots import ROOTS
from tests.fmu_build.c import native
from tests.fmu_build.importer import Importer

STEPS = 20
STANDARD = """#define fmi2PasteB(a, b) a##b
#define fmi2Paste(a, b) fmi2PasteB(a, b)
#define fmi2FullName(name) fmi2Paste(FMI2_FUNCTION_PREFIX, name)"""
"""Lines of the standard's header, which FMPy's copy has without the prefix."""


def _compile(folder: Path, root: str, fmi: int, prefix: str) -> list[Path]:
    """Objects of a model's sources and of its part of the program."""
    folder.mkdir()
    text = write_sources(native.flat(root), folder, fmi, ROOTS[root])
    (folder / "modelDescription.xml").write_text(text)
    description = fmpy.read_model_description(str(folder))
    references = {v.name: v.valueReference for v in description.modelVariables}
    token = description.guid or description.instantiationToken
    defined = [f"-DFMI{fmi}_FUNCTION_PREFIX={prefix}", f"-DFMI={fmi}", f'-DTOKEN="{token}"']
    defined += [f"-DRATE={references['angularRate']}"]
    defined += [f"-DGYRO_ANGLE={references['gyroAngle']}"]
    header = (native.HEADERS / "fmi2Functions.h").read_text()
    plain = "#define fmi2FullName(name) name"
    assert plain in header
    (folder / "fmi2Functions.h").write_text(header.replace(plain, STANDARD))
    flags = [*FLAGS, *defined, "-I.", f"-I{native.HEADERS}", f"-I{native.HERE}"]
    sources = [*SOURCES, SHELLS[fmi], str(native.HERE / "linked.c")]
    native.run([*COMPILER, *flags, "-c", *sources], cwd=folder)
    return sorted(folder.glob("*.o"))


def _turn(root: str, fmi: int, folder: Path) -> str:
    """Angle of the FMU by itself."""
    fmpy.extract(str(build_fmu(root, fmi=fmi)), str(folder))
    gyro = Importer(folder).begin({})
    for step in range(STEPS):
        gyro.set({"angularRate": 0.5})
        gyro.slave.doStep(0.1 * step, 0.1)
    (angle,) = gyro.get(["gyroAngle"])
    gyro.free()
    return angle.hex()


@pytest.mark.parametrize(
    "models",
    [(("HRG", 3), ("HRGSlow", 3)), (("HRG", 2), ("HRG", 3))],
    ids=str,
)
def test_two_models_in_one_program(tmp_path: Path, models: tuple[tuple[str, int], ...]) -> None:
    objects = [
        file
        for (root, fmi), prefix in zip(models, ("first_", "second_"), strict=True)
        for file in _compile(tmp_path / prefix, root, fmi, prefix)
    ]
    main = native.HERE / "linked.c"
    program = tmp_path / "linked"
    native.run([*COMPILER, *FLAGS, main, *objects, "-lm", "-o", program])
    angles = [float.fromhex(text).hex() for text in native.run([program]).split()]
    alone = [_turn(*model, tmp_path / f"fmu{i}") for i, model in enumerate(models)]
    assert angles == alone
