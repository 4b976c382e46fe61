"""Exact flocks: step them, or decide what becomes of them."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._numbers import (
    Enclosure,
    ExactMatrix,
    Known,
    Number,
    exact,
    exact_matrix,
    float_seen,
    fraction_text,
    holds_floats,
    number_text,
)
from ._progress import Progress, callback
from ._shown import Shown, table

Pair = tuple[int, int]


@dataclass(frozen=True)
class Switch(Shown):
    """A change of the network: the first time with the new one, and the edges (birds from 1) that came and went."""

    t: int
    gained: tuple[Pair, ...]
    lost: tuple[Pair, ...]

    def __repr__(self) -> str:
        edges = [f"+{i}-{j}" for i, j in self.gained] + [f"-{i}-{j}" for i, j in self.lost]
        return f"t = {_shortened(self.t)}: {' '.join(edges)}"

    def _cells(self) -> list[str]:
        return [_shortened(self.t), *(", ".join(f"{i}–{j}" for i, j in pairs) for pairs in (self.gained, self.lost))]

    def _repr_html_(self) -> str:
        return table(_SWITCH, [self._cells()])


#: The head of a table of switches.
_SWITCH = ("t", "gained", "lost")


def _shortened(t: int) -> str:
    if abs(t) < 10**40:
        return str(t)
    # str() of very long integers is slow and limited.
    digits = int((t.bit_length() - 1) * 0.30102999566398114) + 1
    return f"about 10^{digits - 1}"


@dataclass(frozen=True)
class Settlement(Shown):
    """What becomes of a flock.

    Attributes
    ----------
    switches : tuple of Switch
        Every change of the network, in order; times are integers of any length.
    flocks : tuple of tuples of int
        The connected components after the last switch, birds from 1.
    edges : tuple of pairs
        The network after the last switch.
    steady_from : int or None
        The time from which the network never changes again, where that is proved.
    ending : str
        ``steady``, ``alternating`` (with ``period``), ``beyond`` (with ``next_pairs`` and ``log2_steps``: the next
        contact comes at a time whose digits cannot be written down) or ``undecided``.
    why, declaration : str
        The reason in words; what was run.
    """

    switches: tuple[Switch, ...]
    flocks: tuple[tuple[int, ...], ...]
    edges: tuple[Pair, ...]
    steady_from: int | None
    ending: str
    why: str
    declaration: str
    period: int | None = None
    next_pairs: tuple[Pair, ...] = ()
    log2_steps: Enclosure | None = None
    from_floats: tuple[str, ...] = ()

    def __repr__(self) -> str:
        end = f"steady from t = {_shortened(self.steady_from)} on" if self.steady_from is not None else self.ending
        return _text("Settlement", self.switches, self.flocks, end, self.why, self.from_floats)

    def _repr_html_(self) -> str:
        return _html(self.switches, self.flocks, self.why)


@dataclass(frozen=True)
class Run(Shown):
    """A flock after some steps.

    Attributes
    ----------
    switches, flocks, edges, why, declaration
        As in :class:`Settlement`, up to the time ``until``.
    until : int
        The last time.
    positions, velocities : tuple of tuples of Fraction, or None
        x(until) and v(until + 1), exact; None for model K, whose positions are not rational.
    denominator_bits : int
        Length of the common denominator of the state, which is not reduced.
    footprint : array of bool or None
        Where P(until) ... P(``from_``) is positive.
    stabilisers : tuple of (time, members)
    decay : tuple of (t, tau_1, tau_2 squared)
        With ``products=True``, at ``from_``, ``from_ + 1``, ``from_ + 3``, ..
    """

    switches: tuple[Switch, ...]
    flocks: tuple[tuple[int, ...], ...]
    edges: tuple[Pair, ...]
    until: int
    why: str
    declaration: str
    denominator_bits: int
    positions: tuple[tuple[Fraction, ...], ...] | None = field(default=None)
    velocities: tuple[tuple[Fraction, ...], ...] | None = field(default=None)
    footprint: Any = field(default=None, compare=False)
    stabilisers: tuple[tuple[int, tuple[int, ...]], ...] = ()
    decay: tuple[tuple[int, Fraction, Fraction], ...] = ()
    from_floats: tuple[str, ...] = ()

    #: Never known from steps alone.
    steady_from: None = field(default=None, init=False)

    def __repr__(self) -> str:
        return _text("Run", self.switches, self.flocks, f"until t = {self.until}", self.why, self.from_floats)

    def _repr_html_(self) -> str:
        return _html(self.switches, self.flocks, self.why)


def _text(
    kind: str,
    switches: Sequence[Switch],
    flocks: Sequence[Sequence[int]],
    end: str,
    why: str,
    floats: Sequence[str],
) -> str:
    shown = [f"  {switch}" for switch in switches[:12]]
    more = [f"  .. {len(switches) - 12} more"] if len(switches) > 12 else []
    birds = " ".join(str(list(flock)) for flock in flocks)
    head = f"{kind}: {len(switches)} switches, {end}"
    return "\n".join([head, *shown, *more, f"  flocks {birds}", f"  {why}", *(f"  {sentence}" for sentence in floats)])


def _html(switches: Sequence[Switch], flocks: Sequence[Sequence[int]], why: str) -> str:
    from html import escape

    shown = table(_SWITCH, [switch._cells() for switch in switches[:50]])
    birds = " ".join(escape(str(list(flock))) for flock in flocks)
    return f"{shown}<p>flocks {birds}<br>{escape(why)}</p>"


class Flock(Shown):
    """A flock of the averaging models of Chazelle, with exact initial conditions.

    Parameters
    ----------
    positions
        x(0): one row for each bird, or a number for each bird of a flock on the line; the unit is the distance within
        which birds are linked, that of time one step.
    velocities
        v(1), of the same shape (model D).
    model
        ``"D"``: velocities are averaged, in any dimension. ``"K"``: headings in the plane are averaged, at one speed.
    weights
        Model D: ``"lazy"`` (c_i = 2/(3 d_i)), ``"vicsek"`` (c_i = 1/(d_i + 1)) or a number c_i for each bird.
    hysteresis
        ``"none"``, ``"paper"`` (n^(-n^4)) or a number.
    control
        Model D: a matrix that multiplies the stacked velocities in every step (equation 1.2).
    speed, headings, kappa
        Model K: the speed, the headings and what is added to each of them in every step, in radians (equation 1.1).

    Raises
    ------
    ValueError, TypeError
        What is no flock, with the field at fault.

    Notes
    -----
    Numbers are exact; a float is the exact value of that double, and results say so. Objects do not change: ``run``
    and ``settle`` start from the beginning each time. Chazelle, *Natural algorithms* (2009), sections 1 to 3;
    ``notes/settling.md``.

    Examples
    --------
    >>> flock = Flock([0, "5/2"], ["1/8", 0])
    >>> end = flock.settle()
    >>> end.switches[0].t, end.flocks
    (12, ((1,), (2,)))
    """

    __slots__ = ("_text", "birds", "declaration", "from_floats")
    birds: int
    declaration: str
    from_floats: tuple[str, ...]
    _text: str

    def __init__(
        self,
        positions: Any,
        velocities: Any = None,
        model: str = "D",
        weights: str | Sequence[Number] | None = None,
        hysteresis: Number = "none",
        *,
        control: Any = None,
        speed: Number | None = None,
        headings: Sequence[Number] | None = None,
        kappa: Sequence[Number] | None = None,
        ids: Sequence[object] | None = None,
    ) -> None:
        fields: dict[str, Any] = {"model": model, "positions": _rows(positions, "positions")}
        if velocities is not None:
            fields["velocities"] = _rows(velocities, "velocities")
        if weights is not None or model == "D":
            chosen = "lazy" if weights is None else weights
            fields["weights"] = chosen if isinstance(chosen, str) else {"c": _list(chosen, "weights")}
        fields["hysteresis"] = number_text(hysteresis, "hysteresis")
        if control is not None:
            matrix = exact_matrix(control, "control")
            fields["control"] = [[fraction_text(x) for x in row] for row in matrix]
        if speed is not None:
            fields["speed"] = number_text(speed, "speed")
        if headings is not None:
            fields["headings"] = _list(headings, "headings")
        if kappa is not None:
            fields["kappa"] = _list(kappa, "kappa")
        if ids is not None:
            fields["ids"] = [str(name) for name in ids]
        given = {
            "positions": positions,
            "velocities": velocities,
            "weights": weights,
            "hysteresis": hysteresis,
            "control": control,
            "speed": speed,
            "headings": headings,
            "kappa": kappa,
        }
        self._read(
            _json(fields),
            tuple(f"{n} holds floats, which stand for their exact values" for n, v in given.items() if _floats(v)),
        )

    def _read(self, text: str, from_floats: tuple[str, ...]) -> None:
        declaration, birds = _native.flock_check(text)
        for sentence in from_floats:
            float_seen(sentence)
        for name, value in (
            ("_text", text),
            ("declaration", declaration),
            ("birds", birds),
            ("from_floats", from_floats),
        ):
            object.__setattr__(self, name, value)

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Flock:
        """The flock of a JSON file of the command line.

        Raises
        ------
        ValueError
            What is no flock, with the file and the field at fault.
        OSError
            A file that cannot be read.
        """
        flock: Flock = _refused(path, lambda: cls.from_json(Path(path).read_text(encoding="utf-8-sig")))
        return flock

    @classmethod
    def from_json(cls, text: str) -> Flock:
        """The flock of a JSON text as the command line reads it.

        Raises
        ------
        ValueError
            What is no flock, with the field at fault.
        """
        self = cls.__new__(cls)
        self._read(text, ())
        return self

    def to_json(self) -> str:
        """The flock as a text that the command line reads."""
        return self._text

    def settle(self, steps: int | None = None, switches: int | None = None, progress: Progress = None) -> Settlement:
        """Find every switch by exact jumps and decide whether the network can ever change again (model D without
        control).

        Parameters
        ----------
        steps, switches
            Exact steps on one network, and switches, before giving up.
        progress
            Called with (stage, done, total), or True.

        Returns
        -------
        Settlement
            Every switch, at times of any size.

        Raises
        ------
        ValueError, TypeError
            A flock of model K or with control, whose end is not decided; limits that are no counts.

        Notes
        -----
        How, and why it is right: ``notes/settling.md``.
        """
        found = _native.flock_settle(self._text, steps, switches, callback(progress))
        pairs, log2_steps = found["next"] or ((), None)
        return Settlement(
            _switches(found["switches"]),
            _tuples(found["flocks"]),
            _pairs(found["edges"]),
            found["steady_from"],
            found["ending"],
            found["why"],
            found["declaration"],
            found["period"],
            _pairs(pairs),
            None if log2_steps is None else Enclosure._of(log2_steps, bool(self.from_floats)),
            self.from_floats,
        )

    def run(
        self, until: int, *, from_: int = 1, products: bool = False, state: bool = True, progress: Progress = None
    ) -> Run:
        """Step the flock, exactly for model D.

        Parameters
        ----------
        until
            The last time.
        from_, products
            Footprints and stabilisers are of the products from this time on; with ``products`` their ergodicity
            coefficients too.
        state
            Whether the exact positions and velocities are wanted; their numbers grow with the time.
        progress
            Called with (stage, done, total), or True.

        Returns
        -------
        Run
            Switches, network and state at the last time.

        Raises
        ------
        ValueError, TypeError
            Times that are no counts; ``from_`` beyond ``until``.
        """
        found = _native.flock_run(self._text, until, from_, bool(products), bool(state), callback(progress))
        known = bool(self.from_floats)
        positions, velocities = found["state"] or (None, None)
        return Run(
            _switches(found["switches"]),
            _tuples(found["flocks"]),
            _pairs(found["edges"]),
            found["until"],
            found["why"],
            found["declaration"],
            found["denominator_bits"],
            _fractions(positions, known),
            _fractions(velocities, known),
            None if found["footprint"] is None else _footprint(found["footprint"]),
            tuple((time, tuple(members)) for time, members in found["stabilisers"]),
            tuple((t, _known(tau_1, known), _known(square, known)) for t, tau_1, square in found["decay"]),
            self.from_floats,
        )

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a flock does not change")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Flock):
            return NotImplemented
        return _canonical(self._text) == _canonical(other._text)

    def __hash__(self) -> int:
        return hash(_canonical(self._text))

    def __reduce__(self) -> tuple[Any, ...]:
        return (_flock, (self._text, self.from_floats))

    def __copy__(self) -> Flock:
        return self

    def __deepcopy__(self, memo: Any) -> Flock:
        return self

    def __repr__(self) -> str:
        return "\n  ".join([f"Flock of {self.birds} birds", *self.declaration.split("\n"), *self.from_floats])

    def _repr_html_(self) -> str:
        from html import escape

        return f"<b>Flock of {self.birds} birds</b><br>{escape(self.declaration).replace(chr(10), '<br>')}"


def _flock(text: str, from_floats: tuple[str, ...]) -> Flock:
    flock = Flock.__new__(Flock)
    flock._read(text, from_floats)
    return flock


def _canonical(text: str) -> str:
    """A flock as a text in which equal numbers are written alike."""

    def alike(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: alike(x) for key, x in value.items()}
        if isinstance(value, list):
            return [alike(x) for x in value]
        try:
            return fraction_text(exact(value)) if isinstance(value, (str, int, Decimal)) else value
        except ValueError:
            return value

    fields = {"hysteresis": "none"} | json.loads(text, parse_float=Decimal)
    return json.dumps({key: x if key == "ids" else alike(x) for key, x in fields.items()}, sort_keys=True)


def _refused(path: str | os.PathLike[str], read: Any) -> Any:
    try:
        return read()
    except UnicodeDecodeError:
        raise ValueError(f"{os.fspath(path)}: it is not a text file (UTF-8)") from None
    except ValueError as error:
        raise ValueError(f"{os.fspath(path)}: {error}") from None


def _json(fields: dict[str, Any]) -> str:
    try:
        return json.dumps(fields)
    except (TypeError, ValueError):
        raise TypeError(f"model should be a text, but it is `{str(fields['model'])[:60]}`") from None


def _floats(value: object) -> bool:
    return (
        value is not None
        and not isinstance(value, str)
        and ((isinstance(value, ExactMatrix) and bool(value.from_floats)) or holds_floats(value))
    )


def _list(values: Any, name: str) -> list[str]:
    if isinstance(values, (str, bytes, dict)) or not hasattr(values, "__iter__"):
        raise TypeError(f"{name} should be a list of numbers, but it is `{str(values)[:60]}`")
    values = values.tolist() if isinstance(values, np.ndarray) else values
    return [number_text(x, f"{name}, entry {k}") for k, x in enumerate(values, 1)]


def _rows(values: Any, name: str) -> list[list[str]]:
    """One list of texts for each bird."""
    if isinstance(values, np.ndarray):
        if values.ndim not in (1, 2):
            raise ValueError(f"{name} should have 1 or 2 dimensions, not {values.ndim}")
        values = values.tolist()
    if isinstance(values, (str, bytes, dict)) or not hasattr(values, "__iter__"):
        raise TypeError(
            f"{name} should be a list with one list of coordinates for each bird, but it is `{str(values)[:60]}`"
        )
    rows = []
    for i, row in enumerate(values, 1):
        one = isinstance(row, (str, bytes)) or not hasattr(row, "__iter__")
        coordinates = [row] if one else list(row)
        rows.append([number_text(x, f"{name}, bird {i}, {k}") for k, x in enumerate(coordinates, 1)])
    return rows


def _switches(found: Any) -> tuple[Switch, ...]:
    return tuple(Switch(t, _pairs(gained), _pairs(lost)) for t, gained, lost in found)


def _pairs(found: Any) -> tuple[Pair, ...]:
    return tuple((i, j) for i, j in found)


def _tuples(found: Any) -> tuple[tuple[int, ...], ...]:
    return tuple(tuple(members) for members in found)


def _known(ratio: tuple[int, int], has_float: bool) -> Known:
    return Known(ratio[0], ratio[1], has_float)


def _fractions(rows: Any, known: bool) -> tuple[tuple[Fraction, ...], ...] | None:
    return None if rows is None else tuple(tuple(_known(x, known) for x in row) for row in rows)


def _footprint(text: str) -> npt.NDArray[np.bool_]:
    found = np.array([[c == "1" for c in row] for row in text.split()], dtype=bool)
    found.flags.writeable = False
    return found
