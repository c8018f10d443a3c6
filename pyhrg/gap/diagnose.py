"""From a campaign to its diagnosis: quantify, localise, attribute, close, verify."""

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.extras import require_extra
from pyhrg.common.progress import Progress, Show
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.closing.closing import Closing, close_gap
from pyhrg.gap.closing.equation.refinement import refine_terms
from pyhrg.gap.closing.origin import take_out_origins
from pyhrg.gap.closing.term_verification import verify_terms
from pyhrg.gap.closing.verification import compute_gap_figures
from pyhrg.gap.effects.catalogue import FULL_CATALOGUE, Catalogue
from pyhrg.gap.effects.design import build_design, remove_effects
from pyhrg.gap.evidence.attribution import Attribution, complete_noises, keep_nominal
from pyhrg.gap.evidence.rounds.iteration import attribute_gap
from pyhrg.gap.findings import verdict as verdicts
from pyhrg.gap.findings.diagnosis import Diagnosis, Gap, Worth
from pyhrg.gap.findings.faults import list_fault_causes, list_ripples, list_tolerated_faults
from pyhrg.gap.findings.localisation import locate_gap, measure_travels
from pyhrg.gap.findings.materiality import IMMATERIAL, measure_leftover
from pyhrg.gap.findings.quantity import measure_sizes
from pyhrg.gap.next_test.next_test import suggest_next_test
from pyhrg.gap.next_test.rivals import find_rivals
from pyhrg.gap.next_test.static_test import suggest_static_test
from pyhrg.gap.preparation import Preparation, prepare_campaign
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.simulation import Simulation, load_simulation
from pyhrg.gap.whitening.channel_noise import build_angle_noise
from pyhrg.records import campaign as campaigns
from pyhrg.records.campaign import Campaign


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
        attribution = complete_noises(attribution, catalogue.noises, prepared.quantization)
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
    beyond = remove_effects(
        build_design(attribution.parts, stated_noise), verdicts.list_tolerated_sizes(attribution)
    )
    return Diagnosis(
        device,
        verdict,
        tuple(sorted(causes, key=lambda cause: cause.is_within(bound))),
        unknown_probability,
        where=locate_gap(beyond, measure_travels(attribution.parts)),
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
