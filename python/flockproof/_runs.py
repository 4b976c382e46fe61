"""Simulated scenarios and measured trajectories."""

from __future__ import annotations

import io
import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _native, _recordings
from ._extras import needed
from ._flock import _refused
from ._numbers import float_seen, number_text
from ._progress import Progress, callback
from ._shown import Shown, table, told
from .law import Law

if TYPE_CHECKING:
    import pandas

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Event(Shown):
    """A link that came or went.

    Attributes
    ----------
    t : float
        When.
    kind : str
        ``"link"`` or ``"unlink"``.
    pair : tuple of int
        The agents, from 1; of an arc the one that senses the other first.
    """

    t: float
    kind: str
    pair: tuple[int, int]

    def _repr_html_(self) -> str:
        i, j = self.pair
        return table(("t", "link", "agents"), [(f"{self.t:.10g}", _CHANGE.get(self.kind, self.kind), f"{i}, {j}")])


#: What became of a link.
_CHANGE = {"link": "came", "unlink": "went"}


@dataclass(frozen=True, eq=False)
class Simulation(Shown):
    """A simulated run: floating point, no bound of the error but the tolerance of the steps.

    Attributes
    ----------
    t : array, shape (times,)
        All times that were written; ``sampled`` says which were asked for in ``run.samples``.
    states : dict of arrays
        What the model has of ``positions``, ``velocities``, ``centres``, shape (times, agents, coordinates), and
        ``phases`` in radians, shape (times, agents).
    observables : dict of arrays
        Shape (times,), or (times, count) for lists such as ``order``. NaN where there is no value.
    events : tuple of Event
        Links that came and went, in order.
    model, declaration : str
        What was run: equations and every choice that the scenario leaves open.
    remarks : tuple of str
        What was special about the run.
    """

    model: str
    t: Array
    sampled: npt.NDArray[np.bool_]
    states: dict[str, Array]
    observables: dict[str, Array]
    events: tuple[Event, ...]
    declaration: str
    remarks: tuple[str, ...]

    def _state(self, name: str) -> Array:
        if name not in self.states:
            raise AttributeError(f"the model {self.model} has no {name}; it has {', '.join(self.states)}")
        return self.states[name]

    @property
    def positions(self) -> Array:
        """Shape (times, agents, coordinates)."""
        return self._state("positions")

    @property
    def velocities(self) -> Array:
        """Shape (times, agents, coordinates)."""
        return self._state("velocities")

    @property
    def phases(self) -> Array:
        """Radians, shape (times, agents)."""
        return self._state("phases")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Simulation):
            return NotImplemented
        mine = [self.t, self.sampled, *self.states.values(), *self.observables.values()]
        theirs = [other.t, other.sampled, *other.states.values(), *other.observables.values()]
        names = (list(self.states), list(self.observables)) == (list(other.states), list(other.observables))
        same = names and all(
            np.array_equal(a, b, equal_nan=a.dtype.kind == "f") for a, b in zip(mine, theirs, strict=True)
        )
        return same and (self.events, self.declaration) == (other.events, other.declaration)

    __hash__ = None  # type: ignore[assignment]

    def to_pandas(self) -> tuple[pandas.DataFrame, pandas.DataFrame]:
        """The states, a row for each time and agent, and the observables, a row for each time.

        The columns are those of ``trajectory.csv`` and ``observables.csv``.
        """
        needed("pandas", "pandas")
        import pandas

        agents = max((array.shape[1] for array in self.states.values()), default=0)
        columns: dict[str, Any] = {
            "t": np.repeat(self.t, agents),
            "agent": np.tile(np.arange(1, agents + 1), len(self.t)),
        }
        prefixes = {"positions": "", "velocities": "v", "centres": "centre_"}
        for name, array in self.states.items():
            if array.ndim == 2:
                columns["theta"] = array.ravel()
            else:
                columns.update({prefixes[name] + "xy"[k]: array[:, :, k].ravel() for k in range(array.shape[2])})
        observed: dict[str, Any] = {"t": self.t}
        for name, array in self.observables.items():
            if array.ndim == 1:
                observed[name] = array
            else:
                observed.update({f"{name}_{k + 1}": array[:, k] for k in range(array.shape[1])})
        return pandas.DataFrame(columns), pandas.DataFrame(observed)

    def __repr__(self) -> str:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in self.states.items())
        last = self.t[-1] if len(self.t) else 0
        lines = [
            f"Simulation of {self.model}: {len(self.t)} times up to {last:g}, {len(self.events)} events",
            f"  {shapes}",
            f"  observables {', '.join(self.observables)}",
            *(f"  {remark}" for remark in self.remarks),
        ]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        last = self.t[-1] if len(self.t) else 0
        head = f"{self.model}: {len(self.t)} times up to {last:g}, {len(self.events)} events"
        rows = [
            (f"{name} (radians)" if name == "phases" else name, str(array.shape), "")
            for name, array in self.states.items()
        ]
        for name, array in self.observables.items():
            ends = f"{array[0]:.6g} to {array[-1]:.6g}" if array.ndim == 1 and len(array) else ""
            rows.append((name, str(array.shape), ends))
        return told(head, self.remarks) + table(("what", "shape", "from start to end"), rows)


def simulate(
    scenario: Mapping[str, Any] | str | os.PathLike[str], progress: Progress = None, *, member: int | None = None
) -> Simulation:
    """Simulate a scenario: phases, particles, fish, heading or velocity alignment, platoons, Vicsek.

    Parameters
    ----------
    scenario
        The path of a TOML file of ``flockproof simulate``, or the same as a dictionary; ``notes/simulate.md`` lists
        the keys. Fractions and arrays are taken too.
    progress
        Called with (stage, done, total), or True.
    member
        Of a scenario with ``[ensemble]`` or ``[sweep]`` this one of its runs, from 1: the same as
        ``flockproof simulate --member``. Each replica has random numbers of its own.

    Returns
    -------
    Simulation
        Arrays of float64 over all times that are written.

    Raises
    ------
    ValueError, TypeError
        What is no scenario, with the key at fault; a run that cannot go on.
    OSError
        A file that cannot be read.

    Notes
    -----
    Lengths and times are in the units of the scenario, angles in radians. The equations, with their sources, are in
    ``declaration``.

    Examples
    --------
    >>> run = simulate({
    ...     "model": "phase",
    ...     "graph": {"kind": "complete"},
    ...     "state": {"phases": ["0", "1/2", "1"]},
    ...     "law": {"K1": -1},
    ...     "run": {"until": 1, "samples": [1]},
    ... })
    >>> run.phases.shape == (len(run.t), 3), bool(run.observables["order"][-1, 0] > 0.9)
    (True, True)
    """
    float_seen("a simulated run is in floating point")
    if isinstance(scenario, Mapping):
        if isinstance(scenario.get("law"), Law):
            scenario = {**scenario, "law": scenario["law"].table()}
        text, told = toml(scenario), callback(progress)
        try:
            found = _native.simulate(text, named_files(text, Path()), member, told)
        except ValueError as error:
            # The lines are of a text that nobody sees.
            raise ValueError(re.sub(r"^line \d+(, column \d+)?: ", "", str(error))) from None
    elif isinstance(scenario, (str, os.PathLike)):
        path: str | os.PathLike[str] = scenario
        watched = callback(progress)
        text = _refused(path, lambda: Path(path).read_text(encoding="utf-8-sig"))
        files = named_files(text, Path(path).parent)
        found = _refused(path, lambda: _native.simulate(text, files, member, watched))
    else:
        raise TypeError(f"scenario should be a dictionary or a path, but it is `{str(scenario)[:60]}`")
    events = tuple(Event(t, "link" if gained else "unlink", tuple(pair)) for t, gained, pair in found["events"])
    return Simulation(
        found["model"],
        found["t"],
        found["sampled"],
        found["states"],
        found["observables"],
        events,
        found["declaration"],
        tuple(found["remarks"]),
    )


def named_files(text: str, folder: Path) -> dict[str, str]:
    """The files that a scenario or a system names: of its law, of its graph."""

    def read(name: str) -> str:
        text: str = _refused(folder / name, lambda: (folder / name).read_text(encoding="utf-8-sig"))
        return text

    return {name: read(name) for name in _native.named_files(text)}


def toml(table: Mapping[str, Any]) -> str:
    """A dictionary as TOML, as far as scenarios and questions need it; numbers stay exact.

    Examples
    --------
    >>> print(toml({"model": "vicsek", "run": {"until": 10}}), end="")
    "model" = "vicsek"
    ["run"]
    "until" = 10
    """
    lines: list[str] = []
    _table(table, "", lines)
    return "".join(line + "\n" for line in lines)


def _table(table: Mapping[str, Any], name: str, lines: list[str]) -> None:
    for key, value in table.items():
        if not isinstance(key, str):
            raise TypeError(f"the keys of a scenario are texts, but one is `{str(key)[:60]}`")
        if not isinstance(value, Mapping) and value is not None:
            lines.append(f"{json.dumps(key)} = {_value(value, key)}")
    for key, value in table.items():
        if isinstance(value, Mapping):
            inner = f"{name}.{json.dumps(key)}" if name else json.dumps(key)
            lines.append(f"[{inner}]")
            _table(value, inner, lines)


def _value(value: Any, key: str, depth: int = 0) -> str:
    if depth > 8:
        raise TypeError(f"{key} is nested too deeply")
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value).replace("\x7f", "\\u007f")
    if isinstance(value, np.ndarray):
        return _value(value.tolist(), key, depth + 1)
    if isinstance(value, (float, np.floating)):
        if not np.isfinite(value):
            raise ValueError(f"{key}: `{value}` is not a number")
        return repr(float(value))
    if isinstance(value, (int, np.integer)):
        # TOML has 64 bits; longer ones are texts, which are read exactly.
        number = int(value)
        return str(number) if -(2**63) <= number < 2**63 else _value(_exact_text(number, key), key)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(str(k))} = {_value(v, key, depth + 1)}" for k, v in value.items()) + "}"
    if isinstance(value, (Sequence, range)):
        return "[" + ", ".join(_value(x, key, depth + 1) for x in value) + "]"
    return json.dumps(_exact_text(value, key))


def _exact_text(value: Any, key: str) -> str:
    return number_text(value, key)


@dataclass(frozen=True)
class Tracks(Shown):
    """The analysis of measured trajectories.

    Attributes
    ----------
    summary : dict
        Everything in ``summary.json``: choices, order, potentials, zones, null models.
    files : dict of bytes
        ``frames.csv``, ``fish.csv``, ``gaps.csv``, ``histograms.csv``, and pictures where they were asked for.
    text : str
        What the command line prints.
    """

    summary: dict[str, Any]
    files: dict[str, bytes]
    text: str

    def table(self, name: str) -> npt.NDArray[Any]:
        """``frames``, ``fish``, ``gaps`` or ``histograms`` as a structured array; empty cells are NaN."""
        return np.genfromtxt(
            io.StringIO(self._csv(name)), delimiter=",", names=True, dtype=None, encoding="utf-8", invalid_raise=True
        )

    def to_pandas(self, name: str = "frames") -> pandas.DataFrame:
        """``frames``, ``fish``, ``gaps`` or ``histograms`` as a DataFrame."""
        needed("pandas", "pandas")
        import pandas

        return pandas.read_csv(io.StringIO(self._csv(name)))

    def _csv(self, name: str) -> str:
        names = [file.removesuffix(".csv") for file in self.files if file.endswith(".csv")]
        if name not in names:
            raise ValueError(f"`{name}` is none of {', '.join(names)}")
        return self.files[f"{name}.csv"].decode()

    def write(self, folder: str | os.PathLike[str]) -> None:
        """Writes all files into a folder, which is made if it is missing."""
        Path(folder).mkdir(parents=True, exist_ok=True)
        for name, contents in self.files.items():
            (Path(folder) / name).write_bytes(contents)

    def __repr__(self) -> str:
        return self.text

    def _with_unit(self, name: str) -> str:
        """A name of what is measured, with its unit where it has one."""
        unit = self.summary["declaration"]["unit"] or "unit of the file"
        if name.startswith("nearest_distance"):
            return f"{name} ({unit})"
        return f"{name} ({unit}/s)" if name == "momentum" else name

    def _repr_html_(self) -> str:
        s, left = self.summary, self.summary["left_out"]
        head = f"{s['source']}: {s['fish']} fish, {s['frames']} frames of {s['step']:g} s, {left['used']} of them used"
        means = [
            (self._with_unit(name), f"{value:.6g}")
            for name, value in s["means"].items()
            if isinstance(value, (int, float))
        ]
        few = ["few frames"] if s["few_frames"]["means"] else []
        return told(head, few) + table(("mean over these frames", "value"), means)


def tracks(
    data: Any,
    *,
    columns: Mapping[str, str] | None = None,
    fps: float | None = None,
    part: str | None = None,
    score: float = 0.0,
    max_gap: int = 0,
    bridge: str = "line",
    min_fish: int | None = None,
    smoothing: str = "mean",
    window: int | None = None,
    smooth_positions: bool = False,
    body_length: float | None = None,
    zones: Sequence[float] = (1.4, 2.4),
    blind: float = 60.0,
    still: float = 0.0,
    plain_nearest: bool = False,
    nearest: Sequence[int] = (),
    ids: Sequence[str] | None = None,
    delays: float | None = None,
    null: int = 199,
    at: float | None = None,
    seed: str = "flockproof",
    pictures: bool = False,
    progress: Progress = None,
) -> Tracks:
    """Analyse measured trajectories of a school: order, potentials, zones, null models.

    Parameters
    ----------
    data
        A DataFrame (pandas, polars) or dictionary with the columns ``t`` (s, or dates), ``id``, ``x``, ``y``, or the
        path of such a CSV file; an array of shape (frames, individuals, 2) with ``fps``, NaN where one was not seen;
        what trackers write: idtracker.ai (CSV, .npy, .npz, .h5, or the folder trajectories_csv), SLEAP (CSV, .h5),
        DeepLabCut (CSV), a folder of TRex (.npz or CSV), Ctrax (.mat or CSV), a table of trackpy; a dataset of movement
        or its .nc file, and through movement .slp and DeepLabCut's .h5. Pickles are read without running them. Frame
        rate, unit and body length come from the file, or from one that the tracker writes beside it, where it has them;
        the rate of SLEAP and DeepLabCut else from the header of the video (AVI, MP4 or QuickTime) that the file names
        or that lies beside it.
    columns
        Other names of those columns: ``{"frame": "t", "particle": "id"}``.
    fps
        Frames per second, where ``t`` counts frames; needed where its column is named after frames.
    part, score
        In tables of DeepLabCut and SLEAP: the body part that stands for a fish (left out: the mean of those that were
        seen), and the smallest score or likelihood of a part that counts as seen.
    max_gap
        Gaps of at most so many frames are bridged and marked; 0: none.
    bridge
        ``"line"``, or ``"spline"``: the cubic with the positions and velocities at both ends.
    min_fish
        Frames count in which at least so many fish have a heading; left out: all.
    smoothing
        Before velocities are taken: ``"mean"`` (moving average), ``"savgol"`` (cubics by least squares, Savitzky and
        Golay) or ``"spline"`` (smoothing spline; an oscillation with a period of the window keeps half of its
        amplitude).
    window
        Frames that are smoothed over, odd; left out: closest to 5 s.
    smooth_positions
        Use the smoothed positions for distances and networks too.
    body_length
        In the unit of x and y; left out: as the file says, else 5.3 (the sidebar's, in centimetres), which means
        nothing for positions in pixels.
    zones
        Outer radii of repulsion, orientation and attraction in body lengths; the last may be left out.
    blind
        Blind spot behind each fish in degrees.
    still
        A fish that is no faster (in the unit of x and y per second) has no heading.
    plain_nearest
        For n = 1 always the nearest neighbour, also in the zone of repulsion.
    nearest
        Other numbers of nearest neighbours for which ``W_1`` is computed.
    ids
        Only the individuals with these names, as texts; left out: all.
    delays
        Delays between the headings of each pair, up to so many seconds: who turns first; left out: none.
    null
        Circular time shifts for each of the two null models.
    at, pictures
        The time of the snapshot (s), and whether SVG and PNG pictures are made.
    seed
        Of the null models; any text.
    progress
        Called with (stage, done, total), or True.

    Returns
    -------
    Tracks
        Everything that the command line writes.

    Raises
    ------
    ValueError, TypeError
        What is no table of trajectories, with the line at fault; choices that mean nothing.
    OSError
        A file that cannot be read.

    Notes
    -----
    Paley, Leonard, Sepulchre, Grünbaum and Parrish (2007), sidebar "Analysis of Fish Data"; ``notes/tracks.md``.

    Examples
    --------
    >>> rows = [(t / 10, name, float(t + 8 * k), float(t * k % 7)) for t in range(60) for k, name in enumerate("ab")]
    >>> school = tracks(dict(zip(["t", "id", "x", "y"], zip(*rows))), window=5, null=0)
    >>> school.summary["fish"], len(school.table("frames"))
    (2, 60)
    """
    float_seen("measured trajectories are floats")
    if columns is not None and not isinstance(columns, Mapping):
        example = "a dictionary of other names, such as {'frame': 't', 'particle': 'id'}"
        raise TypeError(f"columns should be {example}, but it is `{str(columns)[:60]}`")
    for name, several in (("zones", zones), ("nearest", nearest), ("ids", ids)):
        if isinstance(several, str):
            raise TypeError(f"{name} should be a list, but it is the text `{several[:60]}`")
    recording = _recordings.read(data, part, score)
    unit, times_from = None, "the file" if fps is None else "frames, and their rate is chosen"
    length, length_from = body_length, "chosen"
    if recording is None:
        text, source = _trajectories(data)
        if isinstance(data, (str, os.PathLike)):
            header = text.partition("\n")[0].strip().split(",")
            if fps is None and header[0] == "scorer":
                found = _recordings.rate_of_deeplabcut(Path(data))
                if found is not None:
                    fps, times_from = found[0], f"frames, and their rate is {found[1]}"
            if length is None and ({"x1", "y1"} <= set(header) or {"time", "individual"} <= set(header)):
                length, length_from = _recordings.attributes(Path(data))[1], _recordings.ATTRIBUTES
    else:
        source = Path(data).name if isinstance(data, (str, os.PathLike)) else recording.form
        if fps is None and recording.fps is not None:
            times_from = f"frames, and their rate is {recording.rate_from}"
        fps = _rate(recording, fps, source)
        if length is None and recording.body_length is not None:
            length, length_from = recording.body_length, "the file"
        unit = recording.unit
        text, _ = _trajectories(recording.table())
        source, part, score = f"{source} ({recording.form})" if source != recording.form else source, None, 0.0
    chosen = {
        "columns": [f"{name}={meaning}" for name, meaning in (columns or {}).items()],
        "fps": fps,
        "part": part,
        "score": score,
        "max_gap": max_gap,
        "bridge": bridge,
        "min_fish": min_fish,
        "smoothing": smoothing,
        "window": window,
        "smooth_positions": bool(smooth_positions),
        "body_length": 5.3 if length is None else length,
        "body_length_from": "the sidebar's, in cm" if length is None else length_from,
        "unit": unit,
        "times_from": times_from,
        "zones": list(zones),
        "blind": blind,
        "still": still,
        "plain_nearest": bool(plain_nearest),
        "nearest": list(nearest),
        "delays": delays,
        "ids": None if ids is None else [str(name) for name in ids],
        "seed": seed,
        "pictures": bool(pictures),
    }
    try:
        text, files = _native.tracks(text, source, chosen, null, at, callback(progress))
    except OverflowError as error:
        raise ValueError(str(error)) from None
    except ValueError as error:
        raise ValueError(f"{source}: {error}") from None
    named = dict(files)
    return Tracks(json.loads(named["summary.json"]), named, text)


def _rate(recording: _recordings.Recording, fps: float | None, source: str) -> float | None:
    """Frames per second; None where there are times in seconds."""
    if recording.times is not None:
        if fps is not None:
            raise ValueError(f"{source}: it has times in seconds; leave fps out")
        return None
    if fps is None and recording.fps is None:
        raise ValueError(f"{source} has no frame rate and comes with fps")
    return recording.fps if fps is None else fps


def _trajectories(data: Any) -> tuple[str, str]:
    if isinstance(data, (str, os.PathLike)):
        return _refused(data, lambda: Path(data).read_text(encoding="utf-8-sig")), Path(data).name
    if isinstance(data, Mapping):
        columns = {str(key): list(values) for key, values in data.items()}
    elif hasattr(data, "columns") and hasattr(data, "__getitem__"):
        columns = {str(key): list(data[key]) for key in data.columns}
    else:
        raise TypeError(f"data should be a DataFrame or the path of a CSV file, but it is `{str(data)[:60]}`")
    lengths = {len(values) for values in columns.values()}
    if len(lengths) > 1:
        raise ValueError("the columns have different lengths")
    rows = zip(*columns.values(), strict=True)
    import csv

    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([_cell(x) for x in row] for row in rows)
    return out.getvalue(), "trajectories"


def _cell(x: Any) -> str:
    return repr(float(x)) if isinstance(x, (float, np.floating)) else str(x)
