"""The FMU of a gyro, ready to be switched on as often as asked."""

import hashlib
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TypeVar

import numpy as np

from pyhrg.common.caches.files import find_cache_folder
from pyhrg.common.files import write_whole
from pyhrg.common.reading.files import read_bytes
from pyhrg.common.reading.limits import LOG_BYTES
from pyhrg.fmu.archive import Archive
from pyhrg.fmu.gyro import Gyro
from pyhrg.fmu.instance import Instance

Item = TypeVar("Item")
Result = TypeVar("Result")
_LOADING = threading.Lock()
"""FMPy changes the working directory while it loads a library."""


class GyroFmu(Archive):
    """An FMU of the gyro, extracted and ready to be instantiated, from any thread.

    Attributes:
        stop: event that another thread sets to end every drive under way with `GyroError`.
    """

    def __init__(self, path: Path) -> None:
        """Read the description and extract the archive beside it, once."""
        super().__init__(path)
        self.stop: threading.Event | None = None
        self._prepared = False
        self._idle: list[Instance] = []

    def power_on(self, parameters: Mapping[str, float], seed: int, start_angle: float) -> Gyro:
        """Start a gyro.

        Args:
            parameters: values by name, SI (`Device.fmu_parameters`).
            seed: seed of all the gyro's noise, 0 to 2^31 - 1.
            start_angle: pattern angle at power-on, rad.

        Raises:
            GyroError: a value that the FMU refuses.
        """
        # instances are kept because FMPy takes long to look up a library's functions
        with _LOADING:
            instance = self._idle.pop() if self._idle else Instance(self)
        instance.set_up({**parameters, "startAngle": start_angle, "seed": seed})
        return Gyro(instance, self._give_back, self._is_stopped)

    def prepare(self) -> None:
        """Compile the loops now: in the main thread, so that an interruption ends it at once."""
        if not self._prepared:
            with self.power_on({}, seed=0, start_angle=0.0) as gyro:
                rest, on = np.zeros((1, 1)), np.ones(1)
                gyro.record({"angularRate": rest}, {"driveOn": on}, 0.01, ["gyroAngle"], ["valid"])
            self._prepared = True

    def map(
        self,
        work: Callable[[Item], Result],
        items: Sequence[Item],
        workers: int,
        report: Callable[[int], object] = lambda done: None,
    ) -> list[Result]:
        """Results of work with gyros of this FMU on several threads, in the order of the items.

        A failure or an interruption sets `stop`; `report` is called with the number of results,
        after each.
        """
        self.prepare()
        self.stop = threading.Event()
        results = []
        with ThreadPoolExecutor(workers) as pool:
            try:
                for result in pool.map(work, items):
                    results.append(result)
                    report(len(results))
            except BaseException:
                self.stop.set()
                raise
            finally:
                self.stop = None
        return results

    def _give_back(self, instance: Instance) -> None:
        with _LOADING:
            self._idle.append(instance)

    def _is_stopped(self) -> bool:
        return self.stop is not None and self.stop.is_set()


def load_own_fmu(file: Path) -> GyroFmu:
    """The FMU of a user's file, by way of the user's cache: it is extracted beside itself."""
    data = read_bytes(file, LOG_BYTES)
    path = find_cache_folder() / f"{hashlib.sha256(data).hexdigest()[:16]}-own" / file.name
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, data)
    return GyroFmu(path)
