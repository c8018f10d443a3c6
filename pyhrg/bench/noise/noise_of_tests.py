"""Noise coefficients of all tests of one kind together."""

from dataclasses import dataclass

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import select_tests
from pyhrg.bench.readings.noise_records import NoiseRecord, find_noise_records, select_comparable
from pyhrg.noise.coefficients import NoiseCoefficients
from pyhrg.noise.fitting import fit_coefficients
from pyhrg.records.campaign import Campaign


@dataclass(frozen=True)
class Noise:
    """What one state of the gyro has shown.

    records: that share the coefficients, at one interval.
    """

    records: tuple[NoiseRecord, ...]
    coefficients: NoiseCoefficients
    exclusions: tuple[str, ...]

    @property
    def n(self) -> int:
        """Number of angles."""
        return sum(record.n for record in self.records)

    @property
    def longest(self) -> NoiseRecord:
        """The record that shows most."""
        return max(self.records, key=lambda record: record.n)


def fit_noise_of_tests(campaign: Campaign, kind: str, turning: bool) -> Noise | None:
    """Coefficients of the tests of one kind together; None where there are none.

    `turning` chooses the stretches with virtual rotation, else those without.
    """
    tests = select_tests(campaign, kind)
    found = [record for test in tests for record in find_noise_records(test.log)]
    if not tests:
        return None
    wanted = [record for record in found if (record.rotation != 0) == turning]
    if not wanted:
        state = "with" if turning else "without"
        raise BenchError(
            f"{tests[0].log.source}: no stretch that is long enough is {state} virtual rotation"
        )
    records, exclusions = select_comparable(wanted)
    best = fit_coefficients([record.spectrum for record in records], records[0].interval)
    return Noise(tuple(records), best, exclusions)
