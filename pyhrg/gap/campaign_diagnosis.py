"""What a diagnosis gives: causes, residuals, a picture, and files."""

import math
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import pandas as pd

from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import stage_files
from pyhrg.common.units import ARCSEC
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.gap.closing.closing import Residuals
from pyhrg.gap.closing.equation.closed_file import CLOSED_FILES, write_closed_files
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.findings import diagnosis as diagnosis_file
from pyhrg.gap.findings.diagnosis import Diagnosis, Verdict
from pyhrg.gap.replay.observations import CHANNELS, ObservedTest
from pyhrg.gap.whitening.campaign_noise import CampaignNoise
from pyhrg.records.columns import BY_FIELD

if TYPE_CHECKING:
    from matplotlib.axes import Axes  # slow, and needed by `plot` alone

BEFORE_FILE, AFTER_FILE = "before.toml", "after.toml"
"""Device files of the nominal and of the identified device."""
COLORS = {"before": "C1", "after": "C0"}
"""Colors of matplotlib for the residual at each stage, those of the page."""
FILES = (BEFORE_FILE, AFTER_FILE, *CLOSED_FILES, diagnosis_file.FILE)


@dataclass(frozen=True)
class CampaignDiagnosis:
    """The diagnosis of a campaign, with the residuals and simulations that it rests on.

    diagnosis: content of `diagnosis.json`.
    attribution: result of the search among effects and noises.
    nominal: the device as the campaign states it.
    identified: the nominal device with the causes put in.
    tests: all tests that were used, held-out ones last.
    before, after: residuals of each test with the nominal, and with the identified and its terms.
    """

    diagnosis: Diagnosis
    attribution: Attribution
    nominal: Device
    identified: Device
    tests: tuple[ObservedTest, ...]
    before: tuple[Residuals, ...]
    after: tuple[Residuals, ...]

    __repr__ = describe_briefly

    @property
    def verdict(self) -> Verdict:
        """`no_gap`, `explained`, `ambiguous` or `unexplained`."""
        return self.diagnosis.verdict

    @property
    def causes(self) -> pd.DataFrame:
        """Causes as a table: one row for each parameter of each cause.

        Columns: effect, probability, parameter (its name ends with its unit), value, low_95,
        high_95, equivalents (tuple of effects that are confounded with it), makes_arcsec and
        makes_deg_h (`Worth` of the cause; NaN of a noise or a fault in the rows).
        """
        rows = [
            (
                *(c.effect, c.probability, name, value, *c.interval_95[name], c.equivalents),
                *(c.worth.sizes[:2] if c.worth else (math.nan, math.nan)),
            )
            for c in self.diagnosis.causes
            for name, value in c.parameters.items()
        ]
        columns = ("effect", "probability", "parameter", "value", "low_95", "high_95")
        return pd.DataFrame(rows, columns=[*columns, "equivalents", "makes_arcsec", "makes_deg_h"])

    @property
    def noise(self) -> CampaignNoise:
        """Noise of all channels under the most probable hypothesis."""
        return self.attribution.channel_noise

    def residuals(self, test_id: str) -> pd.DataFrame:
        """Residuals of one test, record less simulation, before and after closing.

        Returns:
            n rows: `time_s`, and for each channel `<channel>_before_<unit>` and
            `<channel>_after_<unit>`; NaN where record and simulation are not compared.
            `attrs["units"]` has the unit of each column.

        Raises:
            HrgError: no such test was used.
        """
        ids = [test.test.id for test in self.tests]
        if test_id not in ids:
            raise HrgError(f"test_id: found {test_id!r}, expected one of {', '.join(ids)}")
        index = ids.index(test_id)
        columns, units = {"time_s": self.tests[index].log.time}, {"time_s": "s"}
        for channel in CHANNELS:
            unit, factor = BY_FIELD[channel].unit, BY_FIELD[channel].factor
            if channel == "gyro_angle":
                unit, factor = "arcsec", ARCSEC
            for stage, residuals in (("before", self.before), ("after", self.after)):
                name = f"{channel}_{stage}_{unit}" if unit else f"{channel}_{stage}"
                columns[name], units[name] = residuals[index][channel] / factor, unit
        table = pd.DataFrame(columns)
        table.attrs["units"] = units
        return table

    def plot(self, test_id: str | None = None, axes: "Axes | None" = None) -> "Axes":
        """Draw the output-angle residual of one test before and after closing.

        Args:
            test_id: of the test; by default the last one, which is held out if any is.
            axes: to draw on; by default those of a new figure.

        Raises:
            HrgError: no such test was used.
        """
        test_id = self.tests[-1].test.id if test_id is None else test_id
        table = self.residuals(test_id)
        if axes is None:
            axes = import_module("matplotlib.pyplot").subplots()[1]  # slow, and needed here alone
        for stage in ("before", "after"):
            values = table[f"gyro_angle_{stage}_arcsec"]
            axes.plot(table["time_s"], values, COLORS[stage], label=stage, lw=0.8)
        axes.set(title=test_id, xlabel="time, s", ylabel="residual of the output angle, arcsec")
        axes.legend()
        return axes

    def write(self, folder: Path | str) -> None:
        """Write `diagnosis.json`, `before.toml`, `after.toml`, and `closed.mo` and `closed.fmu` of
        the identified gyro with its terms: all of them or none.

        Raises:
            HrgError: the FMU can't be built.
            OSError: the folder can't be written.
        """
        with stage_files(Path(folder), FILES) as aside:
            self.write_files(aside)

    def write_files(self, folder: Path) -> None:
        """Write the files of `write` one after the other into a folder that exists."""
        for device, file in ((self.nominal, BEFORE_FILE), (self.identified, AFTER_FILE)):
            device_file.write(replace(device, name=self.diagnosis.device), folder / file)
        write_closed_files(self.identified, self.diagnosis, folder)
        diagnosis_file.write(self.diagnosis, folder)
