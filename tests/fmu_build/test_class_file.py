"""A gyro of a Modelica file of one's own becomes an FMU."""

from pathlib import Path

import fmpy
import pytest

from fmu_build import BuildError, build_fmu
from pyhrg.common.errors import HrgError

TEXT = """model tilted "A gyro with a bias"
  extends HRG.Interfaces.PartialGyro;
  parameter HRG.Units.AngularVelocity bias = {bias!r} "Bias";
  HRG.Gyroscopes.HRGEnvelope gyro(
    seed = seed, startAngle = startAngle, startAmplitude = startAmplitude,
    angularRate = angularRate + bias,
    virtualRotation = virtualRotation, accelerationX = accelerationX,
    accelerationY = accelerationY, accelerationZ = accelerationZ,
    caseTemperature = caseTemperature, biasVoltage = biasVoltage, vibration = vibration,
    amplitudeSetpoint = amplitudeSetpoint, phaseOffset = phaseOffset, driveOn = driveOn) "Gyro";
equation
  gyroAngle = gyro.gyroAngle;
  gyroRate = gyro.gyroRate;
  patternAngle = gyro.patternAngle;
  amplitude = gyro.amplitude;
  quadrature = gyro.quadrature;
  amplitudeForce = gyro.amplitudeForce;
  quadratureForce = gyro.quadratureForce;
  frequencyOffset = gyro.frequencyOffset;
  valid = gyro.valid;
end tilted;
"""


def build(folder: Path, bias: float) -> Path:
    file = folder / "tilted.mo"
    file.write_text(TEXT.format(bias=bias))
    return build_fmu(class_file=file)


def test_each_text_has_an_fmu_of_its_own(tmp_path: Path) -> None:
    """The cache tells the files apart; the bias is the slope of the measured angle."""
    paths = [build(tmp_path, bias) for bias in (1e-3, 2e-3)]
    assert paths[0] != paths[1]
    for path, bias in zip(paths, (1e-3, 2e-3), strict=True):
        run = fmpy.simulate_fmu(str(path), stop_time=10, step_size=0.01, output=["gyroAngle"])
        assert run["gyroAngle"][-1] - run["gyroAngle"][-101] == pytest.approx(bias, rel=1e-3)


def test_a_file_is_compiled_alone(tmp_path: Path) -> None:
    """Another file of the folder holds a class of the same name."""
    (tmp_path / "other.mo").write_text("model tilted end tilted;")
    assert build(tmp_path, 3e-3).exists()


@pytest.mark.parametrize("name", ["missing.mo", "no-name.mo", "HRG.mo", "text.txt"])
def test_a_file_that_is_no_class_is_refused(tmp_path: Path, name: str) -> None:
    if name != "missing.mo":
        (tmp_path / name).write_text("model M end M;")
    with pytest.raises(BuildError, match=r"class file: .*expected"):
        build_fmu(class_file=tmp_path / name)


GYRO = 'model X "{description}" extends HRG.Gyroscopes.HRGEnvelope; {body} end X;'
TAKES_ALL_MEMORY = "Real a[1000000000]; equation a = ones(1000000000);"
LOOP = "Real p = q; Real q = p;"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "model X Real a = " + "(\n" * 100_000 + "1" + ")\n" * 100_000 + "; end X;",
            r"failed \(status -",
        ),
        (GYRO.format(description="", body=TAKES_ALL_MEMORY), "status -.*1 GiB"),
        (GYRO.format(description="", body=LOOP), "no gyro that the generator knows: algebraic"),
        (GYRO.format(description="", body="Real z = time;"), "with time is not supported"),
        (
            GYRO.format(description="", body='parameter String s = "";'),
            "s: a variable that is text",
        ),
        (GYRO.format(description="rings \a", body=""), r"found the character '\\x07'"),
        ("model X Real x(start = 1); equation der(x) = -x; end X;", "no sample clock"),
        ("\nmodel Y end Y;", "found the class Y, expected X"),
        (
            'model X "f(a.b = 1)"\n// g(a.b = 1)\n  M m(each\n a.b.c = 1 == 1); end X;',
            r"row 4: found .*a\.b\.c.*expected a\(b\(c = \.\.\.\)\)",
        ),
        (
            'model X "redeclare model A = B(c = 1)"\n M m(redeclare\n block A = B(c = 1)); end X;',
            r"row 2: found modifiers in a redeclaration of the class A.*block MyClass = B\(",
        ),
    ],
    ids=[
        "deep",
        "memory",
        "loop",
        "time",
        "text",
        "bell",
        "no gyro",
        "other name",
        "dots",
        "redeclared",
    ],
)
def test_a_class_that_cannot_be_built_is_refused(tmp_path: Path, text: str, message: str) -> None:
    """In one line, whatever the Modelica compiler does."""
    file = tmp_path / "X.mo"
    file.write_text(text)
    with pytest.raises(HrgError, match=message):
        build_fmu(class_file=file)
