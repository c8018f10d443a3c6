"""A compiled loop (numba) over the functions of an FMU's library.

It sets inputs, does communication steps and gets outputs without leaving compiled code, and
without holding Python's lock. It calls the functions by their addresses, so that one compilation,
cached on disk, serves all libraries.
"""

import ctypes
from functools import lru_cache
from typing import Any

import numpy as np
from fmpy.fmi2 import fmi2OK
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from pyhrg.common.caches.compiled import compile_loop

Addresses = tuple[int, int, int]
"""Addresses of fmi2SetReal, fmi2GetReal and fmi2DoStep."""


@lru_cache(maxsize=4)
def find_functions(library: str) -> Addresses:
    """Addresses of the functions in a library that `record` calls."""
    dll = ctypes.CDLL(library)

    def find(name: str) -> int:
        return ctypes.cast(getattr(dll, name), ctypes.c_void_p).value or 0

    return find("fmi2SetReal"), find("fmi2GetReal"), find("fmi2DoStep")


def _type_call(*arguments: Any) -> Any:
    """Type and code of a call of the C function at an address, the first value, with arguments of
    these types; it returns an int."""

    def generate(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        kinds = [context.get_value_type(kind) for kind in arguments]
        function = ir.FunctionType(ir.IntType(32), kinds).as_pointer()
        return builder.call(builder.inttoptr(values[0], function), values[1:])

    return types.int32(types.int64, *arguments), generate


def _type_reals(typing: Any, address: Any, gyro: Any, names: Any, count: Any, values: Any) -> Any:
    return _type_call(types.int64, types.int64, types.int64, types.int64)


def _type_step(typing: Any, address: Any, gyro: Any, time: Any, step: Any, last: Any) -> Any:
    return _type_call(types.int64, types.float64, types.float64, types.int32)


_call_on_reals: Any = intrinsic(_type_reals)
"""fmi2SetReal or fmi2GetReal at an address, arrays by their addresses."""
_call_do_step: Any = intrinsic(_type_step)
"""fmi2DoStep at an address."""


@compile_loop
def _call_reals(address: int, component: int, references: Any, values: Any) -> bool:
    """Set or get the variables of these references."""
    count = len(references)
    data = references.ctypes.data, values.ctypes.data
    return bool(_call_on_reals(address, component, data[0], count, data[1]) == fmi2OK)


@compile_loop
def _integrate(
    functions: Addresses,
    component: int,
    time: float,
    step: float,
    tick: float,
    mean: Any,
    now: Any,
    sums: Any,
) -> bool:
    """Do a step and add the integrals of outputs over it.

    A value that the electronics command at a tick holds from its start on; hence the weights
    (step + tick)/2 of the value before and (step - tick)/2 of the value after.
    """
    for k in range(len(mean)):
        sums[k] += now[k] * (step + tick) / 2
    if _call_do_step(functions[2], component, time, step, 1) != fmi2OK:
        return False
    if not _call_reals(functions[1], component, mean, now):
        return False
    for k in range(len(mean)):
        sums[k] += now[k] * (step - tick) / 2
    return True


@compile_loop
def record(
    functions: Addresses,
    component: int,
    start: float,
    step: float,
    tick: float,
    n_commands: int,
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
    """Fill rows of outputs at the end and outputs averaged; see `Gyro.record`. Returns how many
    rows succeeded.

    After functions, component and start come a `Layout`, then `Rows`.
    """
    set_real, get_real, _ = functions
    rows, steps = moving_values.shape[:2]
    now = np.empty(len(mean))
    if not _call_reals(get_real, component, mean, now):
        return 0
    # the last tick of a row goes by itself where it gets commands or ends an average
    ends_early = tick > 0.0 and n_commands + len(mean) > 0
    for i in range(rows):
        if not _call_reals(set_real, component, held, held_values[i]):
            return i
        for j in range(steps):
            time, rest = start + (i * steps + j) * step, step
            if not _call_reals(set_real, component, moving, moving_values[i, j]):
                return i
            last = ends_early and j == steps - 1
            while rest > 1.5 * tick > 0.0 and (last or is_new[i]):
                part = tick if is_new[i] else rest - tick
                if not _integrate(
                    functions, component, time, part, tick, mean, now, mean_values[i]
                ):
                    return i
                time, rest = time + part, rest - part
            commands = held[:n_commands]
            if last and not _call_reals(set_real, component, commands, held_values[i + 1]):
                return i
            if not _integrate(functions, component, time, rest, tick, mean, now, mean_values[i]):
                return i
        for k in range(len(mean)):
            mean_values[i, k] /= steps * step
        if not _call_reals(get_real, component, end, end_values[i]):
            return i
    return int(rows)
