"""Bench results as text."""

from pyhrg.bench.bias_test import BiasTest
from pyhrg.units import DEG_PER_H


def bias_table(fixed: BiasTest, circumference: BiasTest) -> str:
    """Both tests side by side, deg/h, in the layout of the paper's Table 2."""
    lines = [
        "Bias, deg/h     fixed position          full circumference",
        "run           mean      std. dev.       mean      std. dev.",
    ]
    for number, (old, new) in enumerate(zip(fixed.runs, circumference.runs, strict=True), 1):
        lines.append(f"{number:3}     {_pair(old.mean, old.deviation)}    {_pair(new.mean, new.deviation)}")
    lines.append(f"bias stability       {_single(fixed.stability)}               {_single(circumference.stability)}")
    lines.append(f"bias repeatability   {_single(fixed.repeatability)}               {_single(circumference.repeatability)}")
    return "\n".join(lines)


def _pair(mean: float, deviation: float) -> str:
    return f"{mean / DEG_PER_H:+10.5f}  {_single(deviation)}"


def _single(value: float) -> str:
    return f"{value / DEG_PER_H:10.5f}"
