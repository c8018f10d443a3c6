"""Instances share nothing: many in threads give what each gives alone."""

import concurrent.futures
from pathlib import Path

from tests.fmu_build.importer import Importer

GYROS = 8
THREADS = 4


def _started(folder: Path, seed: int) -> Importer:
    noise = {"noise.pickOff": 1e-6, "noise.angleRandomWalk": 3e-5}
    return Importer(folder).begin({"seed": seed, "startAngle": 0.1 * seed, **noise})


def _flown(gyro: Importer, seed: int) -> list[list[float]]:
    """Steps and saved states; the calls let other threads run meanwhile."""
    result = []
    for step in range(20):
        gyro.set({"angularRate": 0.1 * ((seed + step) % 5)})
        gyro.slave.doStep(step * 0.25, 0.25)
        if step % 5 == 0:
            gyro.restore(gyro.save())
        result.append(gyro.every())
    return result


def test_threads_do_not_matter(folder: Path) -> None:
    alone = [_started(folder, seed) for seed in range(GYROS)]
    expected = [_flown(gyro, seed) for seed, gyro in enumerate(alone)]
    together = [_started(folder, seed) for seed in range(GYROS)]
    with concurrent.futures.ThreadPoolExecutor(THREADS) as pool:
        assert list(pool.map(_flown, together, range(GYROS))) == expected
    assert expected[0] != expected[1]
    for gyro in (*alone, *together):
        gyro.free()
