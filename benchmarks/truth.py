"""Records of the challenge against the simulation of the gyro and the bench that made them.

    python benchmarks/truth.py [LEVEL [SEED [COUNT]]]

Draws campaigns with several effects (by default at the level good-lab, seed 1, 4 of them), puts
the true parameters into the simulation, and compares. A line has chi-square over rows of each
channel, and below it each test and channel beyond its noise by more than 5 standard deviations.
Such a test shows an error of the comparison, apart from any search.
"""

import math
import sys
from collections.abc import Iterator
from dataclasses import replace

from pyhrg.challenge.case import NOISE, Fmus, prepare_case
from pyhrg.challenge.roster import STRONGEST_SIGMAS, Settings
from pyhrg.gap.effects.catalogue import FULL_CATALOGUE
from pyhrg.gap.effects.linear_test import LinearTest, whiten_gyro_residual
from pyhrg.gap.effects.sensitivities import linearize_test
from pyhrg.gap.evidence.hypothesis import estimate_nominal_noise
from pyhrg.gap.preparation import prepare_campaign
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.replay.simulation import load_model, load_simulation

LIMIT = 5.0
"""Standard deviations of a chi-square beyond which a test is listed."""


def main(level: str = "good-lab", seed: str = "1", count: str = "4") -> None:
    simulation = load_simulation()
    fmus = Fmus(load_model("HRGCarrier"), simulation)
    settings = Settings({"several": int(count)}, int(seed), STRONGEST_SIGMAS, level, "full")
    for case in settings.list_cases():
        drawn = prepare_case(case, simulation)
        made = drawn.record_tests([(plan, fmus.of(plan)) for plan in drawn.plans], NOISE)
        campaign = drawn.make_campaign([test for test, _ in made])
        device, errors = drawn.state.device, drawn.laboratory.errors
        true = replace(device, **{name: getattr(device, name) + errors[name] for name in errors})
        tests = [
            test
            for test in prepare_campaign(campaign, simulation, FULL_CATALOGUE.noises).tests
            if not test.test.is_holdout
        ]
        parts = [
            linearize_test(simulation, true, true, test, simulation.simulate(true, test), {})
            for test in tests
        ]
        found = list(compare_channels(parts))
        totals = {name: [0.0, 0] for name in CHANNELS}
        for _, name, power, rows in found:
            totals[name] = [totals[name][0] + power, totals[name][1] + rows]
        shares = ", ".join(f"{n} {p / max(rows, 1):.2f}" for n, (p, rows) in totals.items())
        print(f"{case.name} ({', '.join(drawn.state.truth.effects)}): {shares}")
        for test, name, power, rows in found:
            if power - rows > LIMIT * math.sqrt(2 * rows):
                print(f"    {test} {name}: chi-square {power:.0f} in {rows} rows")
        sys.stdout.flush()


def compare_channels(parts: list[LinearTest]) -> Iterator[tuple[str, str, float, int]]:
    """Test, channel, chi-square and number of rows of each residual."""
    noise = estimate_nominal_noise(parts)
    for part in parts:
        for name in CHANNELS:
            white = whiten_gyro_residual(part, name, noise)
            yield part.test.test.id, name, float((white**2).sum()), len(white)


if __name__ == "__main__":
    main(*sys.argv[1:])
