"""The navigator's own error and speed, side by side with pyins: `python -m benchmarks.navigation`.

Error-free increments, height clamped. Prints the largest horizontal error, once a minute, and the
attitude error at the end, of steps of 2, 3 and 4 samples; and samples per second on one core.
"""

import argparse
from collections.abc import Callable

import numpy as np

from benchmarks.navigation import peer, speed
from benchmarks.navigation.motions import Flight, coning, static, weaving
from benchmarks.navigation.weave import Weave
from ins_eval.common.state import Track
from ins_eval.navigation.coefficients import SAMPLES_PER_STEP
from pyhrg.common.units import DEG_PER_H

HOUR = 3600
RATES = (10, 20, 40, 80)
"""Of increments, Hz."""
FLIGHTS: tuple[Callable[[], Flight], ...] = (
    lambda: weaving(Weave(), HOUR, 100),
    lambda: weaving(Weave(), HOUR, 200),
    lambda: weaving(Weave(speed=200.0), 600, 100),
    lambda: static(HOUR, 100),
    lambda: static(24 * HOUR, 20),
    lambda: coning(np.deg2rad(1.0), 2.0, HOUR, 100),
)


def figures(flight: Flight, track: Track) -> tuple[float, float]:
    """Largest horizontal error, m; attitude error at the end over its time, rad/s."""
    error = flight.error(track)
    horizontal = np.hypot(error.position[:, 0], error.position[:, 1])
    return float(np.max(horizontal)), float(np.linalg.norm(error.attitude[-1]) / error.time[-1])


def compare(flight: Flight) -> None:
    """Print one flight's errors, navigator by navigator."""
    print(f"\n{flight.name}")
    flown = {f"{n} samples": flight.flown(n) for n in SAMPLES_PER_STEP}
    if strapdown := peer.peer():
        flown["pyins"] = peer.flown(strapdown, flight)
    for name, track in flown.items():
        metres, drift = figures(flight, track)
        print(f"  {name:<12}{1e3 * metres:14.4g} mm {drift / DEG_PER_H:12.2e} deg/h", flush=True)


def orders() -> None:
    """Print how the error falls with the step, on a weave of 20 min."""
    print("\nlargest horizontal error, mm   " + "".join(f"{rate:>9} Hz" for rate in RATES))
    errors = []
    for rate in RATES:
        flight = weaving(Weave(), 1200, rate)
        errors.append([1e3 * figures(flight, flight.flown(n))[0] for n in SAMPLES_PER_STEP])
    for n, found in zip(SAMPLES_PER_STEP, np.array(errors).T, strict=True):
        order = -np.polyfit(np.log(RATES), np.log(found), 1)[0]
        print(f"  {n} samples, order {order:.1f}         " + "".join(f"{x:12.3g}" for x in found))


def throughput() -> None:
    """Print samples per second, and what a first call costs."""
    flight = weaving(Weave(), HOUR, 100)
    strapdown = peer.peer()
    pyins = speed.peers(strapdown, flight) if strapdown else np.nan
    print("\nmillion samples/s   end to end   bare loop   end to end over bare loop   over pyins's")
    for n in SAMPLES_PER_STEP:
        ours, bare = speed.end_to_end(flight, n), speed.bare_loop(flight, n)
        ratios = f"{ours / bare:14.2f} {ours / pyins:25.1f}"
        print(f"  {n} samples      {ours / 1e6:12.1f} {bare / 1e6:12.1f} {ratios}", flush=True)
    print(f"  pyins          {pyins / 1e6:12.2f}")
    imported, called = speed.first_call()
    print(f"fresh process, compiled code on disk: import {imported:.2f} s, call {called:.2f} s")


def main() -> None:
    """Errors, then speed."""
    argparse.ArgumentParser(
        description=__doc__, prog="python -m benchmarks.navigation"
    ).parse_args()
    if not peer.peer():
        print("no pyins here: pip install git+https://github.com/nmayorov/pyins")
    for flight in FLIGHTS:
        compare(flight())
    orders()
    throughput()


if __name__ == "__main__":
    main()
