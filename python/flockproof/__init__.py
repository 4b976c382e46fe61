"""Exact, certified and simulated checks of what is claimed about flocking, and the machinery behind them.

Numbers in: int, Fraction, Decimal and str are exact; a float is the exact value of that double, and results say so.
Numbers out: Fraction, or :class:`Enclosure`. Wrong arguments are ValueError or TypeError with the sentence of the
command line; long work stops on Ctrl-C.
"""

from ._extras import require
from ._fit import Fit, fit
from ._flock import Flock, Run, Settlement, Switch
from ._ledger import Claim, Claims, Controls, Entry, Evidence, Ledger, Text, explain, ledger, verify
from ._native import __version__
from ._numbers import Enclosure, ExactMatrix, Undecided, exact
from ._patterns import Pattern, Patterns, pattern
from ._platoon import Platoon, Response
from ._queries import (
    Eigenvalue,
    Ergodicity,
    Peak,
    Prefix,
    Resonance,
    Spectrum,
    Stabiliser,
    Theorem1,
    ergodicity,
    peak,
    resonance,
    spectrum,
    system_peak,
)
from ._questions import Answer, Campaign, Failure, Invariant, Member, Table, check, fuzz, graphs, invariants, sweep
from ._runs import Event, Simulation, Tracks, simulate, tracks
from ._signatures import readable as _readable
from ._systems import Check, Reach, reach
from .law import Law

__all__ = [
    "Answer",
    "Campaign",
    "Check",
    "Claim",
    "Claims",
    "Controls",
    "Eigenvalue",
    "Enclosure",
    "Entry",
    "Ergodicity",
    "Event",
    "Evidence",
    "ExactMatrix",
    "Failure",
    "Fit",
    "Flock",
    "Invariant",
    "Law",
    "Ledger",
    "Member",
    "Pattern",
    "Patterns",
    "Peak",
    "Platoon",
    "Prefix",
    "Reach",
    "Resonance",
    "Response",
    "Run",
    "Settlement",
    "Simulation",
    "Spectrum",
    "Stabiliser",
    "Switch",
    "Table",
    "Text",
    "Theorem1",
    "Tracks",
    "Undecided",
    "__version__",
    "check",
    "ergodicity",
    "exact",
    "explain",
    "fit",
    "fuzz",
    "graphs",
    "invariants",
    "ledger",
    "pattern",
    "peak",
    "reach",
    "require",
    "resonance",
    "simulate",
    "spectrum",
    "sweep",
    "system_peak",
    "tracks",
    "verify",
]

_readable(globals(), [name for name in __all__ if name != "__version__"])
