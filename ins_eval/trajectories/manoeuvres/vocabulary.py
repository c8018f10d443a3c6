"""All manoeuvres and overlays by their `kind` in mission files."""

from ins_eval.trajectories.manoeuvres.coast import Coast
from ins_eval.trajectories.manoeuvres.manoeuvre import Manoeuvre
from ins_eval.trajectories.manoeuvres.overlays import Hills, Overlay, Sway
from ins_eval.trajectories.manoeuvres.straights import Accelerate, Rest, Roll, Straight, Turntable
from ins_eval.trajectories.manoeuvres.turns import (
    CoordinatedTurn,
    FigureEight,
    STurn,
    Turn,
    UTurn,
    Weave,
)
from ins_eval.trajectories.manoeuvres.vertical import Boost, Climb, Pitch

MANOEUVRES: dict[str, type[Manoeuvre]] = {
    "rest": Rest,
    "straight": Straight,
    "accelerate": Accelerate,
    "turn": Turn,
    "coordinated-turn": CoordinatedTurn,
    "s-turn": STurn,
    "u-turn": UTurn,
    "figure-eight": FigureEight,
    "weave": Weave,
    "climb": Climb,
    "pitch": Pitch,
    "roll": Roll,
    "boost": Boost,
    "coast": Coast,
    "turntable": Turntable,
}
OVERLAYS: dict[str, type[Overlay]] = {"sway": Sway, "hills": Hills}
