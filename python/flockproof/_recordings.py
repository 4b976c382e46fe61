"""Recordings as trackers write them: arrays, pickled dictionaries, HDF5, tables of MATLAB, datasets of `movement`."""

from __future__ import annotations

import csv
import io
import json
import os
import pickle
import re
import zipfile
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _videos
from ._extras import needed
from ._flock import _refused

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Recording:
    """Positions of all individuals, shape (frames, individuals, 2), NaN where one was not seen.

    ``times`` in seconds where the file has them; ``fps``, ``unit`` (of the positions) and ``body_length`` (in that
    unit) where it says so; ``form`` is where it comes from, and ``rate_from`` where its rate does, in words.
    """

    positions: Array
    form: str
    names: Sequence[str] | None = None
    times: Array | None = None
    fps: float | None = None
    body_length: float | None = None
    unit: str | None = None
    rate_from: str = "in the file"

    def __post_init__(self) -> None:
        if self.positions.ndim != 3 or self.positions.shape[2] != 2:
            raise ValueError(f"positions have the shape (frames, individuals, 2), not {self.positions.shape}")

    def table(self) -> dict[str, Any]:
        """The columns ``t``, ``id``, ``x``, ``y``; ``t`` counts frames where there are no times."""
        frames, individuals = np.nonzero(~np.isnan(self.positions).any(axis=2))
        x, y = self.positions[frames, individuals].T
        names = np.arange(1, self.positions.shape[1] + 1) if self.names is None else np.asarray(self.names)
        times = frames if self.times is None else self.times[frames]
        return {"t": times, "id": names[individuals], "x": x, "y": y}


def of_array(positions: Any, **known: Any) -> Recording:
    """An array of shape (frames, individuals, 2)."""
    return Recording(np.asarray(positions, dtype=float), known.pop("form", "an array"), **known)


def read(data: Any, part: str | None, score: float) -> Recording | None:
    """A recording of a file or object with other contents than a table; None for what is read as one."""
    if isinstance(data, np.ndarray):
        return of_array(data)
    if _is_dataset(data):
        return _movement(data, part, score)
    if isinstance(data, Mapping) and "trajectories" in data:
        return _idtracker(data)
    if not isinstance(data, (str, os.PathLike)):
        return None
    path = Path(data)
    ending = path.suffix.lower()
    if path.is_dir():
        return _folder(path)
    if ending in (".npy", ".npz", ".pickle", ".pkl"):
        contents = _refused(path, lambda: _arrays(path.read_bytes()))
        return of_array(contents) if isinstance(contents, np.ndarray) else _idtracker(contents)
    if ending in (".h5", ".hdf5"):
        return _hdf5(path, part, score)
    if ending == ".nc":
        return _movement(needed("xarray", "recordings").open_dataset(path), part, score)
    if ending == ".slp":
        project: Recording = _refused(path, lambda: _slp(path, part, score))
        return project
    if ending == ".mat":
        flies: Recording = _refused(path, lambda: _ctrax(path))
        return flies
    return None


#: Where rates and lengths come from that lie beside a table.
ATTRIBUTES = "attributes.json of idtracker.ai"
METADATA = "in the metadata of DeepLabCut"


def attributes(path: Path) -> tuple[float | None, float | None]:
    """Frame rate and body length that idtracker.ai writes beside its tables."""
    file = path.with_name("attributes_tidy.json" if path.stem.endswith("_tidy") else "attributes.json")
    try:
        said = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None, None
    if not isinstance(said, Mapping):
        return None, None
    return _number(said.get("frames_per_second", 0)), _number(said.get("body_length", 0))


def rate_of_deeplabcut(path: Path) -> tuple[float, str] | None:
    """The frame rate that DeepLabCut writes beside its tables, or that of the video beside them, and where it is."""
    # VIDEO + SCORER + an ending beside VIDEO + SCORER + `.csv`, `_filtered.csv`, `_el.csv`; the first since 2.2.
    for ending in ("_meta.pickle", "includingmetadata.pickle"):
        for file in sorted(path.parent.glob("*" + ending)):
            if path.stem.startswith(file.name.removesuffix(ending)):
                try:
                    found = _number(_unpickled(io.BytesIO(file.read_bytes()))["data"]["fps"])
                except (OSError, ValueError, KeyError, TypeError):
                    continue
                if found is not None:
                    return found, METADATA
    return _of_video(path)


def _of_video(path: Path, name: str | None = None) -> tuple[float, str] | None:
    video = _videos.beside(path, name)
    return None if video is None else (video[0], f"in the header of {video[1]}")


def _rated(recording: Recording, found: tuple[float, str] | None) -> Recording:
    """A recording without a rate, with one that was found elsewhere."""
    if found is None or recording.fps is not None or recording.times is not None:
        return recording
    return replace(recording, fps=found[0], rate_from=found[1])


class _Unpickler(pickle.Unpickler):
    """Arrays, numbers, texts and containers; nothing that runs code."""

    # `encode` turns texts into bytes, as the second protocol writes arrays.
    ALLOWED = (
        ("numpy.multiarray", "_reconstruct"),
        ("numpy.multiarray", "scalar"),
        ("numpy.numeric", "_frombuffer"),
        ("numpy", "ndarray"),
        ("numpy", "dtype"),
        ("builtins", "set"),
        ("builtins", "complex"),
        ("collections", "OrderedDict"),
        ("_codecs", "encode"),
    )

    def find_class(self, module: str, name: str) -> Any:
        plain = module.replace("numpy._core.", "numpy.").replace("numpy.core.", "numpy.")
        if (plain, name) not in self.ALLOWED:
            raise pickle.UnpicklingError(f"it asks for {module}.{name}, and pickles are read without running them")
        if plain.startswith("numpy."):
            # The place in this version of NumPy.
            module = plain.replace("numpy.", "numpy._core." if hasattr(np, "_core") else "numpy.core.")
        return super().find_class(module, name)


def _unpickled(file: Any) -> Any:
    try:
        return _Unpickler(file).load()
    except (pickle.UnpicklingError, EOFError, AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise ValueError(f"the pickle cannot be read: {error}") from None


def _arrays(contents: bytes) -> Any:
    """An array, or a dictionary of what is in the file; `ValueError` for what is neither."""
    if contents[:2] == b"PK":
        try:
            with np.load(io.BytesIO(contents), allow_pickle=False) as file:
                return {name: file[name] for name in file.files}
        except (ValueError, EOFError, zipfile.BadZipFile, zlib.error) as error:
            raise ValueError(f"it cannot be read: {error}") from None
    file = io.BytesIO(contents)
    if contents[:6] != b"\x93NUMPY":
        found = _unpickled(file)
    else:
        version = np.lib.format.read_magic(file)
        read_header = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        _, _, dtype = read_header(file)
        if not dtype.hasobject:
            return np.load(io.BytesIO(contents), allow_pickle=False)
        found = _unpickled(file)
        if isinstance(found, np.ndarray) and found.shape == ():
            found = found.item()
    if not isinstance(found, (dict, np.ndarray)):
        raise ValueError("it has neither an array nor a dictionary with trajectories")
    return found


def _number(value: Any) -> float | None:
    value = np.asarray(value)
    if value.shape == () and value.dtype.kind in "iuf" and np.isfinite(value) and value > 0:
        return float(value)
    return None


def _idtracker(contents: Mapping[str, Any]) -> Recording:
    if "trajectories" not in contents:
        raise ValueError(f"it has no `trajectories`; it has {', '.join(map(str, contents))[:80]}")
    positions = np.asarray(contents["trajectories"], dtype=float)
    fps, body_length = (_number(contents.get(key, 0)) for key in ("frames_per_second", "body_length"))
    labels = np.asarray(contents.get("identities_labels", ()), dtype=object).ravel()
    names = [name.decode() if isinstance(name, bytes) else str(name) for name in labels]
    whole = positions.ndim == 3 and len(set(names)) == positions.shape[1]
    return Recording(
        positions, "idtracker.ai", names=names if whole else None, fps=fps, body_length=body_length, unit="pixels"
    )


def _folder(folder: Path) -> Recording:
    """A folder of TRex, or `trajectories_csv` of idtracker.ai."""
    table = folder / "trajectories.csv"
    if table.is_file():
        values = _refused(table, lambda: np.loadtxt(table, skiprows=1, delimiter=",", ndmin=2))
        if values.shape[1] % 2 == 0:
            raise ValueError(f"{table}: it has {values.shape[1]} columns, not a time and two for each individual")
        fps, body_length = attributes(table)
        places = values[:, 1:].reshape(len(values), -1, 2)
        times = None if fps else values[:, 0]
        if fps:
            places = _refused(table, lambda: _at_frames(places, np.rint(values[:, 0] * fps)))
        return Recording(places, "idtracker.ai", times=times, fps=fps, body_length=body_length, unit="pixels")
    return _trex(sorted([*folder.glob("*.npz"), *folder.glob("*.csv")]), folder)


def _ctrax(path: Path) -> Recording:
    """The tables of Ctrax for MATLAB: flies one after the other in each frame, or `trx`, a record for each fly."""
    matlab = needed("scipy.io.matlab", "recordings")
    broken = (NotImplementedError, ValueError, TypeError, LookupError, EOFError, zlib.error, matlab.MatReadError)
    try:
        found = matlab.loadmat(path, squeeze_me=True)
    except broken as error:
        raise ValueError(f"it is no table of MATLAB up to version 7 (save it with -v7): {error}") from None
    if "trx" in found:
        flies = np.atleast_1d(found["trx"])
        wanted = ("x", "y", "firstframe")
        if flies.dtype.names is None or not set(wanted) <= set(flies.dtype.names):
            raise ValueError("its `trx` has no x, y and firstframe, as that of Ctrax")
        runs: list[tuple[int, Array, Array]] = [
            (int(fly["firstframe"]), np.atleast_1d(fly["x"]).astype(float), np.atleast_1d(fly["y"]).astype(float))
            for fly in flies
        ]
        first = min(run[0] for run in runs)
        last = max(run[0] + len(run[1]) for run in runs)
        places = np.full((last - first, len(runs), 2), np.nan)
        for k, (start, x, y) in enumerate(runs):
            places[start - first : start - first + len(x), k] = np.column_stack([x, y])
        fps = _number(flies[0]["fps"]) if "fps" in flies.dtype.names else None
        return Recording(places, "Ctrax", fps=fps, unit="pixels")
    missing = [name for name in ("x_pos", "y_pos", "identity", "ntargets") if name not in found]
    if missing:
        raise ValueError(f"it has no `{missing[0]}`, as Ctrax writes it")
    x, y, identity, counts = (np.atleast_1d(found[name]) for name in ("x_pos", "y_pos", "identity", "ntargets"))
    if not len(x) == len(y) == len(identity) == counts.sum():
        raise ValueError("x_pos, y_pos and identity are not as long as the sum of ntargets")
    names = np.unique(identity)
    places = np.full((len(counts), len(names), 2), np.nan)
    frames = np.repeat(np.arange(len(counts)), counts.astype(int))
    places[frames, np.searchsorted(names, identity)] = np.column_stack([x, y])
    times = np.atleast_1d(found["timestamps"]).astype(float) if "timestamps" in found else None
    known = times is not None and len(times) == len(counts)
    return Recording(
        places, "Ctrax", names=[f"{name:g}" for name in names], times=times if known else None, unit="pixels"
    )


def _columns(file: Path) -> dict[str, Any]:
    """The columns of a table of TRex by their names, or the arrays of an .npz."""
    if file.suffix == ".npz":
        found = _arrays(file.read_bytes())
        return found if isinstance(found, dict) else {}
    with open(file, encoding="utf-8", newline="") as text:
        rows = list(csv.reader(text))
    return dict(zip(rows[0], np.array(rows[1:], dtype=object).T, strict=False)) if len(rows) > 1 else {}


def _trex(files: Sequence[Path], folder: Path) -> Recording:
    frames: list[Any] = []
    names, unit = [], None
    for file in files:
        contents = _refused(file, lambda file=file: _columns(file))
        # In tables the unit follows in parentheses.
        plain = {re.sub(r" \(.*\)$", "", name): name for name in contents}
        key = next((key for key in ("X#wcentroid", "X#centroid", "X") if key in plain and "Y" + key[1:] in plain), None)
        # Beside the individuals TRex writes their postures and statistics.
        if key is None or "frame" not in contents:
            continue
        names.append(file.stem)
        written = re.search(r" \((.*)\)$", plain[key])
        unit = f"{written[1]} as TRex calls them" if written else unit
        x, y = (np.asarray(contents[plain[name]], dtype=float) for name in (key, "Y" + key[1:]))
        missing = ~np.isfinite(x) | ~np.isfinite(y)
        if "missing" in contents:
            missing |= np.asarray(contents["missing"], dtype=float) != 0
        x, y = np.where(missing, np.nan, x), np.where(missing, np.nan, y)
        time = np.asarray(contents["time"], dtype=float) if "time" in contents else None
        frames.append((np.asarray(contents["frame"], dtype=float).astype(int), x, y, time))
    if not frames:
        raise ValueError(
            f"{folder}: no .npz or .csv file in this folder has `X#wcentroid`, `Y#wcentroid` and `frame`, as TRex "
            "writes them for each individual, and there is no trajectories.csv of idtracker.ai"
        )
    first = min(int(frame.min()) for frame, *_ in frames)
    last = max(int(frame.max()) for frame, *_ in frames)
    positions = np.full((last - first + 1, len(frames), 2), np.nan)
    times = np.full(last - first + 1, np.nan)
    for k, (frame, x, y, time) in enumerate(frames):
        positions[frame - first, k, 0], positions[frame - first, k, 1] = x, y
        if time is not None:
            times[frame - first] = time
    known = np.isfinite(times)
    if known.sum() < 2:
        return Recording(positions, "TRex", names=names, unit=unit)
    # Frames without anybody have no time in the file; the others tell the rate.
    numbers = np.flatnonzero(known)
    rate = float((numbers[-1] - numbers[0]) / (times[known][-1] - times[known][0]))
    return Recording(positions, "TRex", names=names, fps=rate, unit=unit)


def _opened(path: Path) -> Any:
    """A file of HDF5, to be closed."""
    h5py = needed("h5py", "recordings")
    # Without a file this is an OSError that names it.
    if path.stat() and not h5py.is_hdf5(path):
        raise ValueError("it is no file of HDF5")
    return h5py.File(path, "r")


def _hdf5(path: Path, part: str | None, score: float) -> Recording:
    def found() -> Recording | None:
        with _opened(path) as file:
            if "tracks" in file and "node_names" in file:
                return _rated(_sleap(file, part, score), _of_video(path, _one_text(file.get("video_path"))))
            if "trajectories" in file:
                return _idtracker(
                    {**dict(file.attrs), **{key: file[key][()] for key in file if hasattr(file[key], "shape")}}
                )
        return None

    recording: Recording | None = _refused(path, found)
    if recording is not None:
        return recording
    recording = _refused(path, lambda: _deeplabcut(path, part, score))
    return _rated(recording, rate_of_deeplabcut(path))


def _deeplabcut(path: Path, part: str | None, score: float) -> Recording:
    """Through movement, which counts the rows of the table; they stand at the frames that the table numbers."""
    recording = _movement(_with_movement(path, "DeepLabCut"), part, score)
    # movement needs pandas, and has read the same table.
    rows = needed("pandas", "movement").read_hdf(path).index
    return replace(recording, positions=_at_frames(recording.positions, np.asarray(rows)))


def _at_frames(places: Array, numbers: npt.NDArray[Any]) -> Array:
    """Rows of positions at the numbers of their frames; a frame without a row is a gap."""
    if numbers.dtype.kind not in "iuf" or numbers.shape != places.shape[:1]:
        raise ValueError("its rows are not numbered by frames")
    if not ((numbers >= 0) & (numbers < 2**53)).all():
        raise ValueError("its rows are not numbered by frames")
    frames, counts = np.unique(numbers.astype(np.int64), return_counts=True)
    if counts.max(initial=1) > 1:
        raise ValueError(f"frame {frames[counts > 1][0]} is there twice")
    if not len(frames) or frames[-1] > _SPARSEST * len(frames):
        raise ValueError("its frames are not numbered one after the other")
    found = np.full((int(frames[-1]) + 1, *places.shape[1:]), np.nan)
    found[numbers.astype(np.int64)] = places
    return found


#: More frames for each row are no numbers of frames.
_SPARSEST = 10_000


def _slp(path: Path, part: str | None, score: float) -> Recording:
    """Through movement, which reads the frames of the first video, and takes what has no track for one individual."""
    with _opened(path) as file:
        frames: Any = file["frames"][()] if "frames" in file else np.zeros(0)
        if frames.dtype.names is None:
            raise ValueError("it has no table of frames, as SLEAP writes it")
        videos = set(frames["video"].tolist())
        most = int(np.max(frames["instance_id_end"] - frames["instance_id_start"], initial=0))
        tracks = len(file["tracks_json"]) if "tracks_json" in file else 0
    if len(videos) > 1:
        raise ValueError(f"it has frames of {len(videos)} videos; save those of one")
    if most > 1 and not tracks:
        raise ValueError(f"it has up to {most} instances in a frame and no tracks, so that nobody knows who is who")
    return _rated(_movement(_with_movement(path, "SLEAP"), part, score), _rate_of_slp(path))


def _one_text(data: Any) -> str:
    """A text of an HDF5 file, or of an array of one; empty where it is something else."""
    if data is None or not hasattr(data, "shape"):
        return ""
    texts = np.atleast_1d(np.asarray(data[()], dtype=object)).ravel()
    if len(texts) != 1 or not isinstance(texts[0], (bytes, str)):
        return ""
    return texts[0].decode("utf-8", "replace") if isinstance(texts[0], bytes) else texts[0]


def _rate_of_slp(path: Path) -> tuple[float, str] | None:
    """The rate that newer files of SLEAP have, or that of their video, where there is one video."""
    h5py = needed("h5py", "recordings")
    try:
        with h5py.File(path, "r") as file:
            video = json.loads(_one_text(file.get("videos_json")))
    except (OSError, ValueError):
        return None
    backend = video.get("backend") if isinstance(video, dict) else None
    if not isinstance(backend, dict):
        return None
    said = _number(backend.get("fps", 0))
    if said is not None:
        return said, "in the file"
    name = backend.get("filename", video.get("filename"))
    return _of_video(path, name) if isinstance(name, str) else None


def _sleap(file: Any, part: str | None, score: float) -> Recording:
    """The analysis file: `tracks` of shape (tracks, 2, nodes, frames), or in the order that it says itself."""
    tracks = _in_order(file["tracks"], ("track", "xy", "node", "frame"), ("frame", "track", "node", "xy"))
    nodes = [name.decode() if isinstance(name, bytes) else str(name) for name in file["node_names"][()]]
    names = [name.decode() if isinstance(name, bytes) else str(name) for name in file["track_names"][()]]
    sure = None
    if "point_scores" in file:
        sure = _in_order(file["point_scores"], ("track", "node", "frame"), ("frame", "track", "node"))
    return Recording(_of_parts(tracks, nodes, sure, part, score), "SLEAP", names=names or None, unit="pixels")


def _in_order(data: Any, usual: Sequence[str], wanted: Sequence[str]) -> Array:
    """An array of SLEAP with its dimensions in the wanted order; newer files name theirs."""
    dims = json.loads(data.attrs["dims"]) if "dims" in data.attrs else list(usual)
    if sorted(dims) != sorted(wanted):
        raise ValueError(
            f"it has an array with the dimensions {', '.join(map(str, dims))}; {', '.join(wanted)} are needed"
        )
    return np.asarray(data, dtype=float).transpose([dims.index(name) for name in wanted])


def _of_parts(places: Array, parts: Sequence[str], sure: Array | None, part: str | None, score: float) -> Array:
    """The chosen part, or the mean of those that were seen; `places` has the shape (frames, individuals, parts, 2)."""
    if sure is not None:
        places = np.where((sure < score)[..., None], np.nan, places)
    if part is not None:
        if part not in parts:
            raise ValueError(f"there is no body part `{part}`; there are {', '.join(parts)}")
        return places[:, :, list(parts).index(part)]
    seen = ~np.isnan(places).any(axis=3, keepdims=True)
    count = seen.sum(axis=2)
    total: Array = np.where(seen, places, 0).sum(axis=2)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def _with_movement(path: Path, software: str) -> Any:
    load = needed("movement.io", "movement")
    read = load.load_dataset if hasattr(load, "load_dataset") else load.load_poses.from_file
    try:
        return read(path, source_software=software)
    except (ValueError, LookupError, TypeError) as error:
        raise ValueError(f"movement cannot read it: {error}") from None


def _is_dataset(data: Any) -> bool:
    return hasattr(data, "data_vars") and "position" in getattr(data, "data_vars", ())


def _movement(data: Any, part: str | None, score: float) -> Recording:
    """A dataset with `position` over time, space, individuals and, of poses, keypoints."""
    if not _is_dataset(data):
        raise ValueError("the dataset has no `position`, as those of movement have")
    position = data["position"]
    names = {"keypoints": next((d for d in ("keypoints", "keypoint") if d in position.dims), None)}
    names["individuals"] = next((d for d in ("individuals", "individual") if d in position.dims), None)
    if names["individuals"] is None or "time" not in position.dims or "space" not in position.dims:
        raise ValueError(
            f"`position` has the dimensions {', '.join(map(str, position.dims))}; time, space, individuals are needed"
        )
    if position.sizes["space"] != 2:
        raise ValueError("`position` is not in the plane")
    individuals = [str(name) for name in position[names["individuals"]].values]
    order = ["time", names["individuals"], *([names["keypoints"]] if names["keypoints"] else []), "space"]
    places = np.asarray(position.transpose(*order).values, dtype=float)
    if names["keypoints"]:
        sure = None
        if "confidence" in data.data_vars:
            sure = np.asarray(data["confidence"].transpose(*order[:-1]).values, dtype=float)
        parts = [str(name) for name in position[names["keypoints"]].values]
        places = _of_parts(places, parts, sure, part, score)
    elif part is not None:
        raise ValueError(f"there is no body part `{part}`; the dataset has none")
    form = f"movement ({data.attrs['source_software']})" if data.attrs.get("source_software") else "movement"
    unit = str(data.attrs.get("space_unit") or position.attrs.get("units") or "") or None
    if unit is None and data.attrs.get("source_software") in ("DeepLabCut", "SLEAP"):
        unit = "pixels"
    recording = Recording(places, form, names=individuals, fps=_number(data.attrs.get("fps", 0)), unit=unit)
    in_seconds = str(data.attrs.get("time_unit", "frames")) == "seconds"
    times = np.asarray(position["time"].values, dtype=float)
    return replace(recording, times=times, fps=None) if in_seconds else recording
