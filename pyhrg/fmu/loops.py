"""A compiled loop (numba) over the functions of an FMU's library.

It sets inputs, does communication steps and gets outputs without leaving compiled code, and
without holding Python's lock.
"""

import ctypes
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numba
import numpy as np
from fmpy.fmi2 import fmi2OK

Loop = Callable[..., int]
"""Returns how many rows succeeded."""
_Functions = tuple[Any, Any, Any]
"""fmi2SetReal, fmi2GetReal and fmi2DoStep of a library, as compiled code calls them."""


@lru_cache(maxsize=4)
def compile_loop(library: str) -> Loop:
    """The loop over the functions of a library; all instances of the FMU share it."""
    return _make_record(_find_functions(library))


def _find_functions(library: str) -> _Functions:
    dll = ctypes.CDLL(library)
    status, handle, real = ctypes.c_int, ctypes.c_void_p, ctypes.c_double

    def find(name: str, *arguments: type) -> Any:
        pointer = ctypes.cast(getattr(dll, name), ctypes.c_void_p)
        return ctypes.CFUNCTYPE(status, *arguments)(pointer.value or 0)

    return (
        find("fmi2SetReal", handle, handle, ctypes.c_size_t, handle),
        find("fmi2GetReal", handle, handle, ctypes.c_size_t, handle),
        find("fmi2DoStep", handle, real, real, status),
    )


def _make_integrate(functions: _Functions) -> Callable[..., bool]:
    _, get_real, do_step = functions
    ok = fmi2OK

    @numba.njit(nogil=True)
    def integrate(
        component: Any, time: Any, step: Any, tick: Any, mean: Any, now: Any, sums: Any
    ) -> bool:
        """Do a step and add the integrals of outputs over it.

        A value that the electronics command at a tick holds from its start on; hence the weights
        (step + tick)/2 of the value before and (step - tick)/2 of the value after.
        """
        for k in range(len(mean)):
            sums[k] += now[k] * (step + tick) / 2
        if (
            do_step(component, time, step, 1) != ok
            or get_real(component, mean.ctypes, len(mean), now.ctypes) != ok
        ):
            return False
        for k in range(len(mean)):
            sums[k] += now[k] * (step - tick) / 2
        return True

    return integrate


def _make_record(functions: _Functions) -> Loop:
    set_real, get_real, _ = functions
    integrate = _make_integrate(functions)
    ok = fmi2OK

    @numba.njit(nogil=True)
    def record(
        component: Any,
        start: Any,
        step: Any,
        tick: Any,
        n_commands: Any,
        moving: Any,
        held: Any,
        end: Any,
        mean: Any,
        moving_values: Any,
        held_values: Any,
        is_new: Any,
        end_values: Any,
        mean_values: Any,
    ) -> int:
        """Fill rows of outputs at the end and outputs averaged; see `Gyro.record`.

        After component and start come a `Layout`, then `Rows`.
        """
        rows, steps = moving_values.shape[:2]
        now = np.empty(len(mean))
        if get_real(component, mean.ctypes, len(mean), now.ctypes) != ok:
            return 0
        # the last tick of a row goes by itself where it gets commands or ends an average
        ends_early = tick > 0.0 and n_commands + len(mean) > 0
        for i in range(rows):
            if set_real(component, held.ctypes, len(held), held_values[i].ctypes) != ok:
                return i
            for j in range(steps):
                time, rest = start + (i * steps + j) * step, step
                if (
                    set_real(component, moving.ctypes, len(moving), moving_values[i, j].ctypes)
                    != ok
                ):
                    return i
                last = ends_early and j == steps - 1
                while rest > 1.5 * tick > 0.0 and (last or is_new[i]):
                    part = tick if is_new[i] else rest - tick
                    if not integrate(component, time, part, tick, mean, now, mean_values[i]):
                        return i
                    time, rest = time + part, rest - part
                coming = held_values[i + 1]
                if last and set_real(component, held.ctypes, n_commands, coming.ctypes) != ok:
                    return i
                if not integrate(component, time, rest, tick, mean, now, mean_values[i]):
                    return i
            for k in range(len(mean)):
                mean_values[i, k] /= steps * step
            if get_real(component, end.ctypes, len(end), end_values[i].ctypes) != ok:
                return i
        return rows

    return record
