"""Candidate terms: basis functions of one coordinate in one channel, for causes without a name.

A term is a small block of columns over pattern angle, table angle, temperature and its rate, input
rate, specific force, amplitude or time (`coordinates.py`). In the output angle it is an error of
the angle itself, or a bias, whose integral is the column (docs/methods/effects.md, Eqs. 4 and 5).
Its columns stand in `term_columns.py` and `electrode_terms.py`.
"""

from dataclasses import dataclass
from functools import cache

from pyhrg.gap.replay.observations import CHANNEL_WORDS
from pyhrg.gap.soundness.fault import TABLE_RIPPLES, FaultKind

Family = tuple[str, str, str]
"""Channel, prefix and coordinate of terms that may stand for one cause."""
EACH_POWER_ON = "a value for each power-on"


@dataclass(frozen=True)
class CandidateTerm:
    """Identity of a block of columns of one channel.

    channel: a field of a log.
    coordinate: of the campaign format.
    function: which function of the coordinate it is, in words; before a colon, where it acts.
    harmonic: where the coordinate is an angle.
    """

    channel: str
    coordinate: str
    function: str
    harmonic: int | None = None

    @property
    def is_of_each_power_on(self) -> bool:
        """Whether every test has a size of its own; its one column then stands for another column
        of the design in each test."""
        return self.function.endswith(EACH_POWER_ON)

    @property
    def words(self) -> str:
        """Description for reports."""
        return f"{self.function} ({CHANNEL_WORDS[self.channel]})"

    @property
    def prefix(self) -> str:
        """Words before the function that say where the term acts, such as "pick-off"; empty where
        it acts in its channel."""
        prefix, colon, _ = self.function.partition(": ")
        return prefix if colon else ""

    @property
    def bare_function(self) -> str:
        """The function without the prefix."""
        return self.function.partition(": ")[2] or self.function

    @property
    def family(self) -> Family:
        """Terms that may stand for one cause with this one."""
        return self.channel, self.prefix, self.coordinate

    @property
    def second(self) -> str:
        """Words of the second function, where it is a product of two; else empty."""
        return self.function.partition(", times ")[2]

    @property
    def is_plain(self) -> bool:
        """Whether it is a function of one coordinate that is no angle, the same in all tests."""
        return self.harmonic is None and not (self.second or self.is_of_each_power_on)

    @property
    def is_curved(self) -> bool:
        """Whether the response is linear only where it is small. That to an encoder's error is: the
        pattern is where the gyro reads it."""
        return not (self.is_of_each_power_on or self.is_encoder_error)

    @property
    def is_reading_error(self) -> bool:
        """Whether the pattern is read, or the output put out, at a wrong angle."""
        return self.prefix in ("angle", "pick-off") and not self.is_encoder_error

    @property
    def is_encoder_error(self) -> bool:
        """Whether it is an angle by which the table's encoder and the gyro differ: the encoder is
        wrong, or the table between them twists under its load."""
        return self.prefix == "angle" and self.coordinate in ("table_angle", "acceleration")

    @property
    def fault(self) -> FaultKind | None:
        """The fault of the bench that it is: a ripple of the table, unseen by its encoder."""
        return TABLE_RIPPLES.get(self.harmonic or 0) if self.is_encoder_error else None


@cache
def make_term(
    channel: str, coordinate: str, function: str, harmonic: int | None = None, prefix: str = ""
) -> CandidateTerm:
    """A term whose prefix stands apart from its function."""
    words = f"{prefix}: {function}" if prefix else function
    return CandidateTerm(channel, coordinate, words, harmonic)
