"""Diagnoses of a recorded campaign whose nominal values or site are stated wrong, one at a time.

    python benchmarks/misstated.py FOLDER

A line has what is wrong, the verdict, the causes with their values, the terms, the residual of the
held-out tests and the processor time. Each cause should be the value that is wrong, with its true
value, beside what the campaign's own truth names.
"""

import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG, HZ
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.replay.simulation import load_simulation
from pyhrg.records.campaign import Campaign, read_campaign

Misstate = Callable[[Campaign], Campaign]
FREQUENCY_ERROR = 50.0
"""Hz."""


def scale(factor: float, *names: str) -> Misstate:
    return lambda c: state(c, **{name: factor * c.nominal[name] for name in names})


def add(name: str, amount: float) -> Misstate:
    return lambda c: state(c, **{name: c.nominal[name] + amount})


def zero(name: str) -> Misstate:
    return lambda c: state(c, **{name: 0.0})


def drop(*names: str) -> Misstate:
    return lambda c: replace(c, nominal={n: v for n, v in c.nominal.items() if n not in names})


def state(campaign: Campaign, **values: float) -> Campaign:
    return replace(campaign, nominal={**campaign.nominal, **values})


def move_site(campaign: Campaign) -> Campaign:
    site = campaign.site
    return replace(campaign, site=replace(site, latitude=site.latitude + 5 * DEG))


def misstate_frequency(campaign: Campaign) -> Campaign:
    """What the logs state counts from the nominal frequency."""
    tests = []
    for test in campaign.tests:
        offset = test.log.frequency_offset - FREQUENCY_ERROR * HZ
        tests.append(replace(test, recording=replace(test.log, frequency_offset=offset)))
    return replace(add("frequency_Hz", FREQUENCY_ERROR)(campaign), tests=tuple(tests))


LOOPS = ("amplitude_loop_rad_s", "quadrature_loop_rad_s", "phase_loop_rad_s")
NOISES = ("angle_random_walk_deg_sqrt_h", "angle_white_noise_arcsec")
MISSTATED: dict[str, Misstate] = {
    "nothing": lambda c: c,
    "decay time 12 % high": scale(1.12, "decay_time_s"),
    "frequency 50 Hz high": misstate_frequency,
    "all loops 30 % fast": scale(1.3, *LOOPS),
    "frequency's temperature coefficient 10 % high": scale(
        1.1, "frequency_temperature_coefficient_per_K"
    ),
    "decay time's temperature coefficient zero": zero("decay_time_temperature_coefficient_per_K"),
    "thermal lag twice as long": scale(2.0, "thermal_lag_s"),
    "damping anisotropy zero": zero("damping_anisotropy_per_s"),
    "frequency split not stated": drop("frequency_split_Hz", "stiffness_axis_deg"),
    "stiffness axis 30 deg off": add("stiffness_axis_deg", 30.0),
    "amplitude 5 % high": scale(1.05, "amplitude"),
    "angle random walk a tenth": scale(0.1, NOISES[0]),
    "white noise a tenth": scale(0.1, NOISES[1]),
    "no noise stated": drop(*NOISES),
    "reference temperature 5 K high": add("reference_temperature_degC", 5.0),
    "latitude 5 deg north": move_site,
    "angular gain 0.5 % high": scale(1.005, "coriolis_factor"),
}


def main(folder: Path) -> None:
    campaign, simulation = read_campaign(folder), load_simulation()
    for words, misstate in MISSTATED.items():
        begin = time.process_time()
        try:
            found = diagnose(misstate(campaign), simulation=simulation).diagnosis
        except HrgError as error:
            print(f"{words}: refused: {error}", flush=True)
            continue
        seconds = time.process_time() - begin
        causes = (f"{name} = {v:.6g}" for c in found.causes for name, v in c.parameters.items())
        terms = (f"{term.place} {term.function}" for term in found.terms)
        gap = found.gap.holdout_angle_arcsec
        held_out = f"{gap.before:.3g} -> {gap.after:.3g} arcsec" if gap else "none held out"
        named = "; ".join([*causes, *terms]) or "-"
        print(f"{words}: {found.verdict}; {named}; {held_out}; {seconds:.0f} s", flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
