"""From a campaign to its diagnosis: quantify, localise, attribute, close, verify."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import pandas as pd

from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.extras import require_extra
from pyhrg.common.files import stage_files
from pyhrg.common.progress import Progress, Show
from pyhrg.common.units import ARCSEC
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.gap.closing.closing import Closing, Residuals, close_gap
from pyhrg.gap.closing.equation.closed_file import CLOSED_FILES, write_closed_files
from pyhrg.gap.closing.equation.refinement import refine_terms
from pyhrg.gap.closing.origin import take_out_origins
from pyhrg.gap.closing.term_verification import verify_terms
from pyhrg.gap.closing.verification import compute_gap_figures
from pyhrg.gap.effects.catalogue import FULL_CATALOGUE, Catalogue
from pyhrg.gap.effects.design import build_design
from pyhrg.gap.evidence.attribution import Attribution, complete_noises, keep_nominal
from pyhrg.gap.evidence.rounds.iteration import attribute_gap
from pyhrg.gap.findings import diagnosis as diagnosis_file
from pyhrg.gap.findings import verdict as verdicts
from pyhrg.gap.findings.diagnosis import Diagnosis, Gap, Verdict, Worth
from pyhrg.gap.findings.faults import list_fault_causes, list_ripples, list_tolerated_faults
from pyhrg.gap.findings.localisation import locate_gap, measure_travels
from pyhrg.gap.findings.materiality import IMMATERIAL, measure_leftover
from pyhrg.gap.findings.quantity import measure_sizes
from pyhrg.gap.next_test.next_test import suggest_next_test
from pyhrg.gap.next_test.rivals import find_rivals
from pyhrg.gap.next_test.static_test import suggest_static_test
from pyhrg.gap.preparation import Preparation, prepare_campaign
from pyhrg.gap.replay.observations import CHANNELS, ObservedTest
from pyhrg.gap.replay.simulation import Simulation, load_simulation
from pyhrg.gap.whitening.campaign_noise import CampaignNoise
from pyhrg.gap.whitening.channel_noise import build_angle_noise
from pyhrg.records import campaign as campaigns
from pyhrg.records.campaign import Campaign
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


def diagnose(
    campaign: Campaign | Path | str,
    *,
    catalogue: Catalogue = FULL_CATALOGUE,
    bound: Worth = IMMATERIAL,
    simulation: Simulation | None = None,
    progress: Show = None,
) -> CampaignDiagnosis:
    """Diagnose a campaign: find what makes the gap between its records and the simulation.

    Args:
        campaign: a campaign or its folder. Held-out tests are never fitted to.
        catalogue: effects that may be named.
        bound: residuals of up to these sizes are immaterial.
        simulation: FMUs `HRG` and `HRGSlow`; by default they are built, or taken from the cache.
        progress: True prints each step to standard error; a function is called with it.

    Raises:
        CampaignError, LogError: no test of the folder can be used, or a log can't be.
        GyroError: the FMU refuses the nominal values.
        HrgError: the nominal values are no gyro's; the FMUs can't be built, or the extra `build` is
            not installed; a bound is negative or not finite.
    """
    report = Progress(progress).say
    require_extra("build")  # closed.fmu is built, and an FMU for each set of terms
    if not all(0 <= limit < math.inf for limit in bound.sizes):
        raise HrgError(f"bound: found {bound}, expected numbers from 0 on")
    if not isinstance(campaign, Campaign):
        campaign = campaigns.read_campaign(Path(campaign), any_sign=True)
    catalogue = catalogue.with_tolerances(campaign.tolerances)
    simulation = simulation or load_simulation(report)
    prepared = prepare_campaign(campaign, simulation, catalogue.noises)
    fitted = [test for test in prepared.tests if not test.test.is_holdout]
    attribution = attribute_gap(simulation, prepared.quantized_device, fitted, catalogue, report)
    attribution = refine_terms(simulation, attribution, catalogue.noises)
    attribution = complete_noises(attribution, catalogue.noises, prepared.quantization)
    report("closing, verifying, and looking for the next test")
    closing, gap = _close(simulation, attribution, prepared.tests)
    if gap.is_wider or (gap.is_wider_held_out and attribution.leaves_excess):
        attribution = keep_nominal(simulation, attribution)
        closing, gap = _close(simulation, attribution, prepared.tests)
    summary = _summarize(
        campaign.device, simulation, catalogue, attribution, prepared, closing, gap, bound
    )
    return CampaignDiagnosis(
        summary,
        attribution,
        prepared.nominal,
        closing.device,
        tuple(prepared.tests),
        closing.before,
        closing.after,
    )


def _close(
    simulation: Simulation, attribution: Attribution, tests: Sequence[ObservedTest]
) -> tuple[Closing, Gap]:
    """Simulate the identified gyro with its terms."""
    closing = close_gap(simulation, attribution, tests)
    closing = verify_terms(simulation, attribution, tests, closing)
    closing = take_out_origins(simulation, closing, tests, attribution.channel_noise)
    stages = (closing.before, closing.after)
    before, after = ([residuals["gyro_angle"] for residuals in stage] for stage in stages)
    return closing, compute_gap_figures(tests, before, after, attribution.noise.noise)


def _summarize(
    device: str,
    simulation: Simulation,
    catalogue: Catalogue,
    attribution: Attribution,
    prepared: Preparation,
    closing: Closing,
    gap: Gap,
    bound: Worth,
) -> Diagnosis:
    features = verdicts.check_residuals(attribution)
    leftover = measure_leftover(attribution, gap)
    faults = (*prepared.faults, *list_ripples(attribution.ranking.best))
    verdict, causes, unknown_probability = verdicts.reach_verdict(
        attribution,
        catalogue.effects,
        list_fault_causes(faults),
        features,
        leftover.exceeds(bound),
        gap.is_wider_held_out,
    )
    stated = build_angle_noise(prepared.nominal)
    stated_noise = replace(attribution.channel_noise, angle=stated)
    count = len(attribution.parts)
    return Diagnosis(
        device,
        verdict,
        tuple(sorted(causes, key=lambda cause: cause.is_within(bound))),
        unknown_probability,
        where=locate_gap(
            build_design(attribution.parts, stated_noise), measure_travels(attribution.parts)
        ),
        sizes=measure_sizes(
            attribution.parts, closing.before[:count], closing.after[:count], stated_noise
        ),
        gap=gap,
        next_test=suggest_next_test(
            simulation, attribution, find_rivals(attribution, catalogue.effects)
        )
        or suggest_static_test(attribution.noise, stated),
        unnamed=verdicts.list_unnamed(attribution, features),
        excluded=prepared.sentences,
        settled=attribution.settled,
        within_tolerance=(
            *verdicts.list_known_values(attribution),
            *list_tolerated_faults(faults),
        ),
        left=leftover,
        bound=bound,
        terms=closing.terms,
    )
