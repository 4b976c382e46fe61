"""Platoons on a line, asymmetric and heterogeneous: peaks, responses, poles, and state-space models."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._extras import needed
from ._numbers import Enclosure, Number, floats_among
from ._queries import Eigenvalue, Peak, _listed, _peak
from ._shown import Shown, table, told

#: What is given of a platoon beside its gains.
_SIDES = ("ahead", "behind", "f_ahead", "f_behind", "g_ahead", "g_behind")

Numbers = Number | Iterable[Number] | None


@dataclass(frozen=True)
class Response(Shown):
    """The response of a car at one frequency.

    Attributes
    ----------
    car : int
    frequency : Fraction
        Angular frequency (rad/s).
    amplitude : Enclosure
        For an amplitude 1 of the leader.
    phase : Enclosure or None
        In radians, above -pi and at most pi; nothing where the amplitude may be zero.
    """

    car: int
    frequency: Number
    amplitude: Enclosure
    phase: Enclosure | None

    def _repr_html_(self) -> str:
        phase = "not known: the amplitude may be zero" if self.phase is None else str(self.phase)
        rows = [("amplitude", str(self.amplitude)), ("phase (radians)", phase)]
        return table((f"car {self.car} at {self.frequency} rad/s", "enclosed"), rows)

    def __complex__(self) -> complex:
        turn = 0.0 if self.phase is None else float(self.phase)
        return float(self.amplitude) * complex(np.cos(turn), np.sin(turn))


class Platoon(Shown):
    """Cars on a line behind a leader, each steered by its distance and velocity to the cars ahead and behind.

    Parameters
    ----------
    followers
        Number of cars behind the leader, up to 200; peaks are proved for up to 100.
    f, g
        Gains of the positions (1/s^2) and of the velocities (1/s), below 0: one, or one for each follower, as a list
        or as a text (``"-1,-2,-1"``).
    ahead, behind
        Weights of the car ahead and of the car behind, one, or one for each follower: an asymmetric platoon. They are
        scaled to a sum of one for each car, so that the last car has the weight 1 ahead; one of them alone: the other
        is the rest to one. Left out, both are 1/2.
    f_ahead, f_behind, g_ahead, g_behind
        The same for positions (f) or velocities (g) only. Without ``f`` they are the gains of the two links, below 0;
        likewise without ``g``.

    Raises
    ------
    ValueError, TypeError
        Gains that are not negative, weights below 0, lists of another length.

    Examples
    --------
    >>> platoon = Platoon(20, -1, -1, ahead="0.6", behind="0.4")
    >>> print(platoon.peak(digits=6).amplitude)
    [36.6019264, 36.6019265]
    >>> print(platoon.response(1, car=1, digits=6).amplitude)
    [0.712026195, 0.712026196]
    """

    def __init__(
        self,
        followers: int,
        f: Numbers = None,
        g: Numbers = None,
        *,
        ahead: Numbers = None,
        behind: Numbers = None,
        f_ahead: Numbers = None,
        f_behind: Numbers = None,
        g_ahead: Numbers = None,
        g_behind: Numbers = None,
    ) -> None:
        sides = (ahead, behind, f_ahead, f_behind, g_ahead, g_behind)
        given = {"f": f, "g": g, **dict(zip(_SIDES, sides, strict=True))}
        self._parameters = [(name, _listed(value)) for name, value in given.items() if value is not None]
        self.followers = followers
        # What is wrong is said at once.
        self._matrices = _native.platoon_matrices(followers, self._parameters, followers)
        self.from_floats = floats_among(
            **{f"{name}[{k}]": x for name, numbers in self._parameters for k, x in enumerate(numbers)}
        )

    def __repr__(self) -> str:
        def shown(numbers: list[Any]) -> str:
            return repr(numbers[0] if len(numbers) == 1 else numbers)

        parts = [str(self.followers), *(f"{name}={shown(numbers)}" for name, numbers in self._parameters)]
        return f"Platoon({', '.join(parts)})"

    def _repr_html_(self) -> str:
        rows = [(name, ", ".join(map(str, numbers))) for name, numbers in self._parameters]
        return told(f"platoon of {self.followers} followers") + table(("gain or weight", "of each car"), rows)

    def peak(self, car: int | None = None, digits: int = 15) -> Peak:
        """Enclose the largest response of a car over all frequencies, with proof that no frequency is worse.

        Parameters
        ----------
        car
            From 1; left out, the last one.
        digits
            Significant digits, up to 10 000.

        Raises
        ------
        ValueError
            A platoon that is not stable, or of more than 100 followers.
        """
        car = self.followers if car is None else car
        return _peak(_native.platoon_peak(self.followers, self._parameters, car, digits), digits, self.from_floats)

    def response(self, frequency: Number, car: int | None = None, digits: int = 15) -> Response:
        """Enclose amplitude and phase of a car at an angular frequency (rad/s).

        Parameters
        ----------
        frequency
            Not negative.
        car
            From 1; left out, the last one.
        digits
            Significant digits, up to 10 000.
        """
        car = self.followers if car is None else car
        found = _native.platoon_response(self.followers, self._parameters, [car], frequency, digits)
        floats = bool(self.from_floats or floats_among(frequency=frequency))
        amplitude, phase = found[0]
        enclosed = None if phase is None else Enclosure._of(phase, floats)
        return Response(int(car), frequency, Enclosure._of(amplitude, floats), enclosed)

    def poles(self) -> list[Eigenvalue]:
        """Enclose the eigenvalues of the matrix A of :meth:`matrices`, with multiplicities."""
        floats = bool(self.from_floats)
        parts = _native.platoon_poles(self.followers, self._parameters)
        return [
            Eigenvalue(Enclosure._of(re, floats), multiplicity, None, None if im is None else Enclosure._of(im, floats))
            for re, im, multiplicity in parts
        ]

    @property
    def states(self) -> list[str]:
        """Names of the states: deviation ``y_k`` from the desired place and its rate ``u_k`` of each car."""
        return [name for k in range(1, self.followers + 1) for name in (f"y_{k}", f"u_{k}")]

    @property
    def inputs(self) -> list[str]:
        """Names of the inputs: position and velocity of the leader.

        Behind a leader that swings the velocity is ``i w`` times the position; the response is that of the first input
        plus ``i w`` times that of the second one. The first input alone has another peak.
        """
        return ["y_0", "u_0"]

    def exact_matrices(self) -> tuple[list[list[Fraction]], ...]:
        """A, B, C and D of x' = A x + B u, y = C x + D u with exact entries; the output is the last car's position."""
        return tuple([[Fraction(*entry) for entry in row] for row in rows] for rows in self._matrices)

    def matrices(self) -> tuple[npt.NDArray[np.float64], ...]:
        """The same, rounded, with the position of every car as an output."""
        a, b, _, _ = (np.array([[float(x) for x in row] for row in rows]) for rows in self.exact_matrices())
        c = np.zeros((self.followers, 2 * self.followers))
        c[range(self.followers), range(0, 2 * self.followers, 2)] = 1
        return a, b, c, np.zeros((self.followers, 2))

    def to_control(self) -> Any:
        """A ``control.StateSpace`` of python-control, with names of states, inputs and outputs.

        Its inputs are position and velocity of the leader, see :attr:`inputs`.
        """
        control = needed("control", "control")
        outputs = [f"y_{k}" for k in range(1, self.followers + 1)]
        return control.ss(*self.matrices(), inputs=self.inputs, outputs=outputs, states=self.states)

    def to_scipy(self) -> Any:
        """A ``scipy.signal.StateSpace`` with the inputs and outputs of :meth:`to_control`."""
        return needed("scipy.signal", "graphs").StateSpace(*self.matrices())
