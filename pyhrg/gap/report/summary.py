"""The diagnosis as a few lines for the terminal."""

from pyhrg.gap.diagnose import CampaignDiagnosis
from pyhrg.gap.report.words import format_name


def summarize_diagnosis(result: CampaignDiagnosis) -> str:
    """Verdict, causes, reservations, angle residuals and the next test, a line each."""
    diagnosis = result.diagnosis
    lines = [f"{diagnosis.device}: {format_name(diagnosis.verdict)}"]
    for cause in diagnosis.causes:
        values = ", ".join(f"{name} {value:.4g}" for name, value in cause.parameters.items())
        lines.append(f"  {cause.effect}: probability {cause.probability:.3f}  {values}")
        if cause.equivalents:
            lines.append(f"    confounded with {', '.join(cause.equivalents)}")
    unknown = diagnosis.unknown_probability
    lines.append(f"  a cause outside the catalogue: probability {unknown:.3f}")
    lines += [f"  {caveat}" for caveat in diagnosis.caveats]
    gap = diagnosis.gap
    figures = (("fitted", gap.fit_angle_arcsec), ("held-out", gap.holdout_angle_arcsec))
    for role, figure in figures:
        if figure is not None:
            lines.append(
                f"  angle residual, {role} tests: {figure.before:.3g} -> {figure.after:.3g} arcsec;"
                f" noise floor {figure.floor:.3g} "
                f"({figure.floor_95[0]:.3g} to {figure.floor_95[1]:.3g})"
            )
    if diagnosis.next_test is not None:
        test = diagnosis.next_test
        lines.append(f"  next test: {test.kind}, {test.hours:g} h - {test.why}")
    return "\n".join(lines)
