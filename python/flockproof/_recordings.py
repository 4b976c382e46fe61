"""Recordings as trackers write them: arrays, pickled dictionaries, HDF5, datasets of `movement`."""

from __future__ import annotations

import io
import os
import pickle
import zipfile
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from ._extras import needed
from ._flock import _refused

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Recording:
    """Positions of all individuals, shape (frames, individuals, 2), NaN where one was not seen.

    ``times`` in seconds where the file has them; ``fps`` and ``body_length`` where it says so, the latter in the unit of
    the positions; ``form`` is where it comes from, in words.
    """

    positions: Array
    form: str
    names: Sequence[str] | None = None
    times: Array | None = None
    fps: float | None = None
    body_length: float | None = None

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
        return _trex(sorted(path.glob("*.npz")), path)
    if ending in (".npy", ".npz", ".pickle", ".pkl"):
        contents = _refused(path, lambda: _arrays(path.read_bytes()))
        return of_array(contents) if isinstance(contents, np.ndarray) else _idtracker(contents)
    if ending in (".h5", ".hdf5"):
        return _hdf5(path, part, score)
    if ending == ".nc":
        return _movement(needed("xarray", "recordings").open_dataset(path), part, score)
    if ending == ".slp":
        return _movement(_with_movement(path, "SLEAP"), part, score)
    return None


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
    return Recording(positions, "idtracker.ai", fps=fps, body_length=body_length)


def _trex(files: Sequence[Path], folder: Path) -> Recording:
    if not files:
        raise ValueError(f"{folder}: there is no .npz file in this folder, as TRex writes one for each individual")
    frames: list[Any] = []
    for file in files:
        contents = _refused(file, lambda file=file: _arrays(file.read_bytes()))
        key = next((key for key in ("X#wcentroid", "X#centroid", "X") if key in contents), None)
        if key is None or "frame" not in contents:
            raise ValueError(f"{file}: it has no `X#wcentroid` and `frame`, as TRex writes them")
        x, y = (np.asarray(contents[name], dtype=float) for name in (key, "Y" + key[1:]))
        missing = ~np.isfinite(x) | ~np.isfinite(y)
        if "missing" in contents:
            missing |= np.asarray(contents["missing"]).astype(bool)
        x, y = np.where(missing, np.nan, x), np.where(missing, np.nan, y)
        time = np.asarray(contents["time"], dtype=float) if "time" in contents else None
        frames.append((np.asarray(contents["frame"]).astype(int), x, y, time))
    first = min(int(frame.min()) for frame, *_ in frames)
    last = max(int(frame.max()) for frame, *_ in frames)
    positions = np.full((last - first + 1, len(frames), 2), np.nan)
    times = np.full(last - first + 1, np.nan)
    for k, (frame, x, y, time) in enumerate(frames):
        positions[frame - first, k, 0], positions[frame - first, k, 1] = x, y
        if time is not None:
            times[frame - first] = time
    names = [file.stem for file in files]
    known = np.isfinite(times)
    if known.sum() < 2:
        return Recording(positions, "TRex", names=names)
    # Frames without anybody have no time in the file; the others tell the rate.
    numbers = np.flatnonzero(known)
    rate = float((numbers[-1] - numbers[0]) / (times[known][-1] - times[known][0]))
    return Recording(positions, "TRex", names=names, fps=rate)


def _hdf5(path: Path, part: str | None, score: float) -> Recording:
    h5py = needed("h5py", "recordings")

    def opened() -> Recording:
        with h5py.File(path, "r") as file:
            if "tracks" in file and "node_names" in file:
                return _sleap(file, part, score)
            if "trajectories" in file:
                return _idtracker({**dict(file.attrs), **{key: file[key][()] for key in file if hasattr(file[key], "shape")}})
        return _movement(_with_movement(path, "DeepLabCut"), part, score)

    recording: Recording = _refused(path, opened)
    return recording


def _sleap(file: Any, part: str | None, score: float) -> Recording:
    """The analysis file: `tracks` of shape (tracks, 2, nodes, frames)."""
    tracks = np.asarray(file["tracks"], dtype=float).transpose(3, 0, 2, 1)
    nodes = [name.decode() if isinstance(name, bytes) else str(name) for name in file["node_names"][()]]
    names = [name.decode() if isinstance(name, bytes) else str(name) for name in file["track_names"][()]]
    sure = np.asarray(file["point_scores"], dtype=float).transpose(2, 0, 1) if "point_scores" in file else None
    return Recording(_of_parts(tracks, nodes, sure, part, score), "SLEAP", names=names or None)


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
    load = needed("movement.io.load_poses", "movement")
    return load.from_file(path, source_software=software)


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
        raise ValueError(f"`position` has the dimensions {', '.join(map(str, position.dims))}; time, space, individuals are needed")
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
    recording = Recording(places, form, names=individuals, fps=_number(data.attrs.get("fps", 0)))
    in_seconds = str(data.attrs.get("time_unit", "frames")) == "seconds"
    times = np.asarray(position["time"].values, dtype=float)
    return replace(recording, times=times, fps=None) if in_seconds else recording
