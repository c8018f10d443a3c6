"""Tables of variables for the documentation."""

from collections.abc import Iterable, Sequence
from html import escape

from fmu_build.archive.units import DISPLAY_UNITS
from fmu_build.equations.scalars import Scalar


def format_parameter_tables(listed: Sequence[Scalar]) -> str:
    """One table a component, in the order of declaration; the model's own parameters first."""
    components: dict[str, list[Scalar]] = {"": []}
    for scalar in listed:
        if scalar.causality == "parameter":
            components.setdefault(scalar.name.rpartition(".")[0], []).append(scalar)
    return "\n".join(
        (f"<h3><code>{escape(name)}</code></h3>\n" if name else "") + format_variable_table(members)
        for name, members in components.items()
        if members
    )


def format_variable_table(listed: Iterable[Scalar]) -> str:
    """Columns that stay empty are left out."""
    rows = [_cells(scalar) for scalar in listed]
    heads = ("Name", "Meaning", "Unit", "Default", "Range")
    used = [column for column in range(len(heads)) if any(row[column] for row in rows)]
    lines = ["".join(f"<td>{row[c]}</td>" for c in used) for row in rows]
    head = "".join(f"<th>{heads[c]}</th>" for c in used)
    body = "\n".join(f"<tr>{line}</tr>" for line in (head, *lines))
    return f'<div class="wide"><table>\n{body}\n</table></div>' if rows else ""


def _cells(scalar: Scalar) -> tuple[str, ...]:
    given = scalar.attributes
    unit, shown = given.get("unit", ""), given.get("displayUnit", "")
    limits = [_number(given[key]) if key in given else "" for key in ("min", "max")]
    low, high = limits
    range_text = f"from {low}" if low else f"up to {high}" if high else ""
    range_text = f"{low} to {high}" if all(limits) else range_text
    starts = given.get("start", "").split()
    default = ", ".join(_number(start) for start in starts)
    if shown and any(float(start) for start in starts):
        factor, offset = DISPLAY_UNITS[unit, shown]
        values = ", ".join(f"{factor * float(start) + offset:.6g}" for start in starts)
        default += f' <span class="small">({values} {escape(shown)})</span>'
    size = f"[{scalar.count}]" if scalar.count > 1 else ""
    return (
        f"<code>{escape(scalar.name.rpartition('.')[2])}{size}</code>",
        escape(given.get("description", "")),
        escape(unit) + (f' <span class="small">({escape(shown)})</span>' if shown else ""),
        default,
        range_text,
    )


def _number(text: str) -> str:
    value = float(text)
    digits = f"{value:.0e}" if abs(value) >= 1e4 and value % 1e4 == 0 else f"{value:.10g}"
    return digits.replace("e+0", "e").replace("e-0", "e-").replace("-", "−")
