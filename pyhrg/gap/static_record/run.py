"""The diagnosis of a static record from file to result."""

from collections.abc import Mapping
from pathlib import Path

from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_page
from pyhrg.common.made_by import check_identity
from pyhrg.gap.static_record.allan import RESULT, RecordNoise, measure_noise
from pyhrg.gap.static_record.belief import Belief, read_beliefs
from pyhrg.gap.static_record.fit.diagnosis import diagnose_channel
from pyhrg.gap.static_record.fit.hypotheses import FALSE_ALARMS
from pyhrg.gap.static_record.record import StaticRecord, read_static_record
from pyhrg.gap.static_record.result import RecordDiagnosis
from pyhrg.gap.static_record.shared_motion import compute_shared_power


def diagnose_record(
    record: StaticRecord | Path | str,
    belief: Mapping[str, Belief] | Path | str,
    *,
    trusted: bool = False,
    out: Path | str | None = None,
    seed: int = 0,
) -> RecordDiagnosis:
    """Find the noise terms of a static record that exceed a belief (docs/methods/noise.md).

    Args:
        record: a record, or its file (`record.read_static_record`).
        belief: noise by channel (`gyro_x`) or by kind of sensor (`gyros`, `accelerometers`), or a
            TOML file of it (`belief.read_beliefs`).
        trusted: whether units and axes of a file are taken as stated, though gravity or Earth's
            rate in it contradict them.
        out: folder that `diagnosis.json`, `report.html` and `closed.toml` are written to.
        seed: of the importance samples.

    Raises:
        HrgError: the belief is wrong, or holds none of the record's sensors; the file can't be
            used.
        OSError: the folder can't be written.
    """
    beliefs = belief if isinstance(belief, Mapping) else read_beliefs(Path(belief))
    if not isinstance(record, StaticRecord):
        record = read_static_record(Path(record), trusted)
    result = _compare_with_beliefs(record, beliefs, seed)
    if out is not None:
        # the figures of the page load matplotlib
        from pyhrg.gap.static_record.report.page import write_record_report

        write_record_report(result, Path(out))
    return result


def compute_allan(
    record: Path | str,
    *,
    trusted: bool = False,
    out: Path | str | None = None,
    force: bool = False,
) -> RecordNoise:
    """Bias, Allan deviation and noise coefficients (IEEE Std 952) of a record at rest.

    Args:
        record: file of an IMU's log (docs/imus.md) or of a bench log (docs/records.md).
        trusted: as in `diagnose_record`.
        out: folder that `allan.json`, `allan.csv` and `report.html` are written to.
        force: whether the result of another record in `out` may be replaced.

    Raises:
        LogError, HrgError: the file can't be used; `out` holds the result of another record or
            another command's report.
        NoiseError: a channel has no noise.
        OSError: the folder can't be written.
    """
    noise = measure_noise(read_static_record(Path(record), trusted))
    if out is not None:
        from pyhrg.gap.static_record.report.allan_page import write_noise_report

        if not force:
            _check_place(Path(out), noise)
        write_noise_report(noise, Path(out))
    return noise


def _check_place(out: Path, noise: RecordNoise) -> None:
    """Refuse to replace the result of another record, or another command's report."""
    check_identity(out / RESULT, {key: noise.document[key] for key in ("source", "channels")})
    check_page(out, (out / RESULT).exists())


def _compare_with_beliefs(
    record: StaticRecord, beliefs: Mapping[str, Belief], seed: int
) -> RecordDiagnosis:
    """Diagnose the channels that have a belief. Each channel gets an equal part of the record's
    false-alarm rate."""
    belief_of = {c.name: beliefs.get(c.name, beliefs.get(c.kind.table)) for c in record.channels}
    known = {name: belief for name, belief in belief_of.items() if belief is not None}
    channels = [c for c in record.channels if c.name in known]
    if not channels:
        kinds = " and ".join(sorted({c.kind.table for c in record.channels}))
        raise HrgError(f"{record.source}: found a record of {kinds}, expected a belief of them")
    false_alarms = FALSE_ALARMS / len(channels)
    diagnoses = tuple(diagnose_channel(c, known[c.name], false_alarms, seed) for c in channels)
    shared = compute_shared_power([c.part(0, c.half) for c in record.channels])
    kept = [i for i, c in enumerate(record.channels) if c.name in known]
    skipped = [f"{c.name}: it has no belief" for c in record.channels if c.name not in known]
    return RecordDiagnosis(record.source, (*record.notes, *skipped), diagnoses, shared[kept], seed)
