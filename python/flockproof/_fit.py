"""Parameters of a law from a recording."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from ._extras import needed
from ._numbers import float_seen
from ._progress import Progress, callback
from ._shown import Shown, table, told
from .law import Law

Array = npt.NDArray[np.float64]

#: Fewer windows than this say nothing about intervals.
_LEAST_WINDOWS = 10


@dataclass(frozen=True)
class Fit(Shown):
    """Parameters of a law that fit a recording best over short horizons.

    Attributes
    ----------
    parameters : dict of float
        Where the sum of squares is least.
    intervals : dict of (float, float)
        95 %, from the spread of the windows (a sandwich estimate with one cluster for each window). They rest
        on windows
        that do not depend on each other: neighbouring ones do where memory is longer than a horizon, and then
        they are
        too short.
    explained : float
        Share of the squared error of going straight on that the law takes away: 1 for a perfect law, 0 or
        less for one
        that says nothing.
    control : tuple of float
        The same for the law fitted anew after the identities were shuffled in every window, as often as was
        asked for: what a
        law with as many parameters takes away where there is nothing that it could know.
    windows, horizon, declaration
        How many windows there are, how long one is (s), and the choices in words.
    """

    parameters: Mapping[str, float] = field(hash=False)
    intervals: Mapping[str, tuple[float, float]] = field(hash=False)
    explained: float
    control: tuple[float, ...]
    windows: int
    horizon: float
    declaration: str

    def __repr__(self) -> str:
        lines = [self._head()]
        for name, value in self.parameters.items():
            low, high = self.intervals[name]
            lines.append(f"  {name} = {value:.5g}, 95 % in [{low:.5g}, {high:.5g}]")
        return "\n".join([*lines, f"  {self._compared()}", f"  {self.declaration}"])

    def _head(self) -> str:
        return f"Fit over {self.windows} windows of {self.horizon:g} s: {100 * self.explained:.1f} % explained"

    def _compared(self) -> str:
        if not self.control:
            return "negative control: not tried"
        shares = ", ".join(f"{100 * share:.1f} %" for share in self.control)
        said = "" if max(self.control) < self.explained else "; the law says no more than that"
        what = "negative control, identities shuffled in every window and the law fitted anew"
        return f"{what}: {shares} explained{said}"

    def _repr_html_(self) -> str:
        rows = [
            (name, f"{value:.5g}", "[{:.5g}, {:.5g}]".format(*self.intervals[name]))
            for name, value in self.parameters.items()
        ]
        return told(self._head(), [self._compared(), self.declaration]) + table(("parameter", "value", "95 %"), rows)


@dataclass(frozen=True)
class _Recording:
    """Starts and ends of the windows: for each part of the state an array (windows, agents, coordinates)."""

    starts: dict[str, Array]
    ends: dict[str, Array]
    straight: dict[str, Array]
    horizon: float


def fit(
    law: Law,
    positions: Any,
    *,
    fps: float,
    parameters: Mapping[str, float],
    horizon: int = 10,
    smoothing: int = 5,
    graph: Mapping[str, Any] | None = None,
    shuffles: int = 3,
    seed: int = 0,
    progress: Progress = None,
) -> Fit:
    """Fit parameters of a law to a recording by least squares over short horizons.

    The recording is cut into windows. In each the law starts from what was measured and is followed to the end of
    the window; the
    squared differences to what was measured there are added, each part of the state in units of what it changes
    over a window.

    Parameters
    ----------
    law
        In continuous time, without noise; its state has a vector for the position, and a second one for the
        velocity or an
        angle for the heading where it has more.
    positions
        An array of shape (frames, individuals, dimension), NaN where one was not seen; windows with a gap are
        left out.
    fps
        Frames per second; times of the law are seconds, its lengths those of the array.
    parameters
        Which parameters are fitted, with a first guess of each; the others stay as the law has them.
    horizon
        Frames of a window, at least 2.
    smoothing
        Frames, odd, over which the slope of a local cubic (Savitzky and Golay) is the velocity; 3 takes
        central differences.
    graph
        The network, as in a scenario; left out, all hear all.
    shuffles
        Negative controls: how often the identities are shuffled and the law is fitted anew.
    seed
        Of the shuffles.
    progress
        Called with (stage, done, total), or True.

    Returns
    -------
    Fit

    Raises
    ------
    ValueError, TypeError
        A law or an array of another form, a parameter that the law has not, too few windows.

    Examples
    --------
    >>> law = Law(state={"x": "vector"}, parameters={"k": 1}, rates={"x": "k * mean(j, x[j] - x)"})
    >>> run = law.simulate({
    ...     "state": {"x": [[0, 0], [4, 0], [0, 2]]},
    ...     "run": {"until": 6, "samples": [k / 10 for k in range(61)]},
    ... })
    >>> found = fit(law, run.states["x"][run.sampled], fps=10, parameters={"k": "1/2"}, horizon=5, shuffles=1)
    >>> abs(found.parameters["k"] - 1) < 0.01, found.explained > 0.99
    (True, True)
    """
    float_seen("a fit is in floating point")
    optimize = needed("scipy.optimize", "fit")
    names = _fitted(law, parameters)
    recording = _windows(law, np.asarray(positions, dtype=float), float(fps), int(horizon), int(smoothing))
    tell = callback(progress)
    count = len(next(iter(recording.starts.values())))
    scales = {name: _scale(recording.ends[name] - recording.starts[name]) for name in recording.ends}

    def changes(values: Sequence[float]) -> dict[str, Array]:
        moved = _moved(law, dict(zip(names, values, strict=True)), recording, graph)
        return {name: _difference(law, name, moved[name], recording.starts[name]) for name in moved}

    measured = {name: _difference(law, name, recording.ends[name], recording.starts[name]) for name in recording.ends}
    straight = {name: _difference(law, name, recording.straight[name], recording.starts[name]) for name in measured}

    def residuals(found: dict[str, Array], target: dict[str, Array]) -> Array:
        parts = [_difference(law, name, found[name], target[name]) / scales[name] for name in target]
        return np.concatenate([part.reshape(count, -1) for part in parts], axis=1)

    def best(target: dict[str, Array]) -> Any:
        return optimize.least_squares(
            lambda values: residuals(changes(values), target).ravel(),
            [float(x) for x in _guesses(parameters)],
            x_scale="jac",
        )

    if tell is not None:
        tell("fits", 0, 1 + shuffles)
    found = best(measured)
    base = float(np.sum(residuals(straight, measured) ** 2))
    if base <= 1e-20:
        raise ValueError("everybody goes straight on: there is nothing to fit")
    random = np.random.default_rng(seed)
    control = []
    for k in range(shuffles):
        if tell is not None:
            tell("fits", k + 1, 1 + shuffles)
        target = _shuffled(measured, random)
        control.append(1 - 2 * float(best(target).cost) / float(np.sum(residuals(straight, target) ** 2)))
    spread = 1.96 * np.sqrt(np.diag(_covariance(found.jac, found.fun, count)))
    return Fit(
        {name: float(x) for name, x in zip(names, found.x, strict=True)},
        {name: (float(x - d), float(x + d)) for name, x, d in zip(names, found.x, spread, strict=True)},
        1 - 2 * float(found.cost) / base,
        tuple(control),
        count,
        recording.horizon,
        f"windows of {horizon} frames one after the other, velocities over {smoothing} frames; each part of the state "
        f"in units of its change over a window: {', '.join(f'{name} {scale:.4g}' for name, scale in scales.items())}",
    )


def _guesses(parameters: Mapping[str, Any]) -> list[float]:
    from ._numbers import exact

    return [float(exact(value, name)) for name, value in parameters.items()]


def _fitted(law: Law, parameters: Mapping[str, Any]) -> list[str]:
    if not isinstance(law, Law):
        raise TypeError(f"law should be a flockproof.Law, but it is `{str(law)[:60]}`")
    if law.time != "continuous" or law.noise:
        raise ValueError("a law in continuous time without noise is needed")
    if not parameters:
        raise ValueError("parameters should name what is fitted, with a first guess of each")
    for name in parameters:
        if name not in law.parameters:
            raise ValueError(f"`{name}` is no parameter of the law; it has {', '.join(law.parameters) or 'none'}")
    return list(parameters)


def _parts(law: Law) -> dict[str, str]:
    """What each part of the state is in a recording."""
    vectors = [name for name, kind in law.state.items() if kind == "vector"]
    angles = [name for name, kind in law.state.items() if kind == "angle"]
    first = law.position or (vectors[0] if vectors else None)
    others = [name for name in vectors if name != first]
    if first is None or len(others) + len(angles) > 1 or len(vectors) + len(angles) != len(law.state):
        raise ValueError(
            "the state of the law should be a vector (the position), and at most another vector (the velocity) or an "
            "angle (the heading); it has " + ", ".join(f"{name}: {kind}" for name, kind in law.state.items())
        )
    return {first: "position"} | dict.fromkeys(others, "velocity") | dict.fromkeys(angles, "heading")


def _windows(law: Law, places: Array, fps: float, horizon: int, smoothing: int) -> _Recording:
    parts = _parts(law)
    if places.ndim != 3 or places.shape[1] < 2 or places.shape[2] != law.dimension:
        raise ValueError(
            f"positions should have the shape (frames, individuals, {law.dimension}) with two individuals at least, "
            f"not {places.shape}"
        )
    if not (fps > 0 and np.isfinite(fps)):
        raise ValueError(f"fps = {fps} should be a positive number")
    if horizon < 2 or smoothing < 3 or smoothing % 2 == 0:
        raise ValueError(f"horizon = {horizon} should be at least 2, smoothing = {smoothing} odd and at least 3")
    if "heading" in parts.values() and law.dimension != 2:
        raise ValueError("a heading needs positions in the plane")
    velocities = _velocities(places, fps, smoothing)
    measured = {
        "position": places,
        "velocity": velocities,
        "heading": np.arctan2(velocities[..., 1], velocities[..., 0]) if law.dimension == 2 else velocities[..., 0],
    }
    whole = np.asarray(np.isfinite(places).all(axis=(1, 2)) & np.isfinite(velocities).all(axis=(1, 2)))
    starts = [k for k in range(0, len(places) - horizon, horizon) if whole[k] and whole[k + horizon]]
    if len(starts) < _LEAST_WINDOWS:
        raise ValueError(
            f"there are {len(starts)} windows without a gap; at least {_LEAST_WINDOWS} are needed: a smaller horizon?"
        )
    ends = [k + horizon for k in starts]
    seconds = horizon / fps
    straight = {name: measured[kind][starts] for name, kind in parts.items()}
    for name, kind in parts.items():
        if kind == "position":
            straight[name] = places[starts] + seconds * velocities[starts]
    return _Recording(
        {name: measured[kind][starts] for name, kind in parts.items()},
        {name: measured[kind][ends] for name, kind in parts.items()},
        straight,
        seconds,
    )


def _velocities(places: Array, fps: float, smoothing: int) -> Array:
    """Slopes of local cubics, of the parabola for three frames; NaN where a frame is missing."""
    half = smoothing // 2
    steps = np.arange(-half, half + 1)
    degree = min(3, smoothing - 1)
    weights = np.linalg.pinv(np.vander(steps, degree + 1, increasing=True))[1]
    found = np.full(places.shape, np.nan)
    inner = len(places) - 2 * half
    if inner > 0:
        found[half : half + inner] = sum(w * places[k : k + inner] for k, w in enumerate(weights)) * fps
    return found


def _scale(change: Array) -> float:
    size = float(np.sqrt(np.mean(change**2)))
    # What only rounding changes does not change.
    return size if size > 1e-12 else 1.0


def _difference(law: Law, name: str, one: Array, other: Array) -> Array:
    """One less the other; of angles the shorter way round."""
    difference = one - other
    if law.state[name] == "angle":
        return (difference + np.pi) % (2 * np.pi) - np.pi
    return difference


def _moved(
    law: Law, values: Mapping[str, float], recording: _Recording, graph: Mapping[str, Any] | None
) -> dict[str, Array]:
    """Where the law leads from the starts of the windows."""
    own = Law(
        state=law.state,
        rates=law.rates,
        parameters={**law.parameters, **values},
        define=law.define,
        dimension=law.dimension,
        position=law.position,
    )
    ends: dict[str, list[Array]] = {name: [] for name in recording.starts}
    for k in range(len(next(iter(recording.starts.values())))):
        scenario: dict[str, Any] = {
            "state": {name: starts[k].tolist() for name, starts in recording.starts.items()},
            "run": {"until": recording.horizon, "samples": [recording.horizon]},
        }
        run = own.simulate(scenario if graph is None else {**scenario, "graph": dict(graph)})
        for name, found in ends.items():
            found.append(run.states[name][-1])
    return {name: np.array(found) for name, found in ends.items()}


def _shuffled(measured: dict[str, Array], random: np.random.Generator) -> dict[str, Array]:
    """What was measured in each window, of another individual."""
    count, agents = next(iter(measured.values())).shape[:2]
    # A cyclic order of all, so that nobody keeps its own.
    orders = np.array([_cycle(random.permutation(agents)) for _ in range(count)])
    return {name: values[np.arange(count)[:, None], orders] for name, values in measured.items()}


def _cycle(order: npt.NDArray[np.int64]) -> npt.NDArray[np.int64]:
    found = np.empty_like(order)
    found[order] = np.roll(order, 1)
    return found


def _covariance(jacobian: Array, residuals: Array, windows: int) -> Array:
    """Of least squares, with one cluster for each window."""
    inverse = np.linalg.pinv(jacobian.T @ jacobian)
    scores = np.einsum("wrp,wr->wp", jacobian.reshape(windows, -1, jacobian.shape[1]), residuals.reshape(windows, -1))
    return np.asarray(windows / (windows - 1) * inverse @ (scores.T @ scores) @ inverse)
