"""`hrg bench all`, on a typical gyro that is soon warm and on a recorded campaign: every procedure,
end to end."""

import json
import math
from dataclasses import replace
from pathlib import Path

import pytest

from pyhrg.bench.catalogue import PROCEDURES
from pyhrg.bench.reporting.parameter_system import TABLE_1
from pyhrg.common.cli import main
from pyhrg.device import device_file
from pyhrg.device.ready_devices import TYPICAL


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("bench")
    device = folder / "gyro.toml"
    device_file.write(replace(TYPICAL, thermal_lag=30.0), device)
    assert main(["bench", "all", "--device", str(device), "--out", str(folder / "out")]) == 0
    return folder / "out"


def findings(out: Path, procedure: str) -> dict[str, dict[str, object]]:
    document = json.loads((out / procedure / "result.json").read_text())
    return dict(document["findings"])


def test_every_procedure_gives_figures_and_a_picture(out: Path) -> None:
    for procedure in PROCEDURES:
        assert findings(out, procedure.name), procedure.name
        assert (out / procedure.name / "figure.png").is_file(), procedure.name


def test_every_interval_holds_its_figure(out: Path) -> None:
    for procedure in PROCEDURES:
        for name, finding in findings(out, procedure.name).items():
            low, high = finding["interval_95"]  # type: ignore[misc]
            if None not in (low, high, finding["value"]):
                slack = 1e-9 * max(abs(low), abs(high))
                assert low - slack <= finding["value"] <= high + slack, (procedure.name, name)


def test_every_row_of_table_1_has_its_figure(out: Path) -> None:
    page = (out / "report.html").read_text()
    for row in TABLE_1:
        assert row.printed in page
        if row.procedure:
            keys = findings(out, row.procedure)
            prefix = row.finding.replace(" ", "_").replace("-", "_")
            found = [f["value"] for key, f in keys.items() if key.startswith(prefix)]
            assert found, row.term
            assert all(value is None or math.isfinite(value) for value in found), row.term  # type: ignore[arg-type]
            assert found[0] is not None, row.term


def test_recorded_campaign(recorded_campaign: Path, tmp_path: Path) -> None:
    """Those procedures that it has records for, none without figures."""
    assert main(["bench", "all", "--campaign", str(recorded_campaign), "--out", str(tmp_path)]) == 0
    done = {path.parent.name for path in tmp_path.glob("*/result.json")}
    assert {"full-circumference", "scale-factor-angle", "ring-down", "tumble"} <= done
    assert "No figures" not in (tmp_path / "report.html").read_text()
