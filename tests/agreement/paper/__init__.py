"""The paper, claim by claim: every figure of docs/paper.md is computed here.

Xu, Liang, Qiu, Fan, Niu: Research on testing method of rate-integrating hemispherical resonator
gyroscope. Navigation Positioning and Timing 11(2), 2024, doi 10.19306/j.cnki.2095-8110.2024.02.001.

One file a subject, each with `figures() -> dict[str, float]`; a name ends in its unit.
"""
