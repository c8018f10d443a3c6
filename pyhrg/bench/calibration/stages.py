"""Several measurements of one gyro within a campaign, distinguished by the kind of their tests."""

import zlib
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test


def label_stage(tests: Sequence[Test], stage: str) -> list[Test]:
    """Tests under the name of a stage: kind and id carry it."""
    return [
        replace(
            test,
            id=f"{test.id}_{stage}",
            kind=f"{test.kind}_{stage}",
            recording=replace(test.log, source=f"{test.log.source}_{stage}"),
        )
        for test in tests
    ]


def select_stage(campaign: Campaign, stage: str) -> Campaign | None:
    """The tests of a stage alone, under their plain kinds; None where there are none."""
    suffix = f"_{stage}"
    found = [
        replace(test, kind=test.kind.removesuffix(suffix))
        for test in campaign.tests
        if test.kind.endswith(suffix)
    ]
    return replace(campaign, tests=tuple(found)) if found else None


def stage_bench(bench: Bench, device: Device, stage: str) -> Bench:
    """The bench with another gyro on it, or the same one set otherwise, and noise of its own."""
    key = zlib.crc32(stage.encode())
    (seed,) = np.random.SeedSequence(bench.seed, spawn_key=(key,)).generate_state(1)
    return replace(bench, device=device, seed=int(seed) % 2**31)
