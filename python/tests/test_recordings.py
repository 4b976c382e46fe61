"""Recordings of trackers: the same school in every form is the same school."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.lib import format as npy

import flockproof


def school(frames: int = 200, fish: int = 4) -> np.ndarray:
    angle = 0.02 * np.arange(frames)[:, None] + np.arange(fish)[None, :]
    data = 20 * np.stack([np.cos(angle), np.sin(angle)], axis=2)
    data[50:53, 2] = np.nan
    return data


def analysed(data: Any, **chosen: Any) -> Any:
    return flockproof.tracks(data, window=5, null=0, max_gap=5, **chosen).summary


def same(found: Any, **declared: Any) -> None:
    plain = analysed(school(), fps=25)
    for key in ("p_1", "momentum", "rotation", "W_single"):
        assert found["means"][key] == pytest.approx(plain["means"][key], abs=1e-9)
    assert found["step"] == pytest.approx(1 / 25) and len(found["gaps"]) == 1
    for key, value in declared.items():
        assert found["declaration"][key] == value


IDTRACKER = {"trajectories": school(), "frames_per_second": 25.0, "body_length": 7.5, "version": "5.2"}


def test_idtracker(tmp_path: Path) -> None:
    arrays, zipped, pickled = (tmp_path / f"trajectories.{ending}" for ending in ("npy", "npz", "pickle"))
    np.save(arrays, np.array(IDTRACKER, dtype=object), allow_pickle=True)
    np.savez(zipped, **IDTRACKER)
    for protocol in range(2, 6):
        pickled.write_bytes(pickle.dumps(IDTRACKER, protocol=protocol))
        same(analysed(pickled), body_length=7.5)
    same(analysed(arrays), body_length=7.5)
    same(analysed(zipped), body_length=7.5)
    same(analysed(IDTRACKER), body_length=7.5)
    assert analysed(arrays, body_length=2)["declaration"]["body_length"] == 2
    assert analysed(arrays)["source"] == "trajectories.npy (idtracker.ai)"
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "trajectories.h5", "w") as file:
        file["trajectories"] = school()
        file.attrs.update(frames_per_second=25.0, body_length=7.5)
    same(analysed(tmp_path / "trajectories.h5"), body_length=7.5)
    table = tmp_path / "trajectories.csv"
    columns = np.column_stack([np.arange(200) / 25, school().reshape(200, 8)])
    header = "time," + ",".join(f"x{k},y{k}" for k in range(1, 5))
    np.savetxt(table, columns, delimiter=",", header=header, comments="", fmt="%.17g")
    same(analysed(table), table="all fish in one row, as idtracker.ai writes it")


@pytest.mark.parametrize("order", ["C", "F"])
def test_the_command_line_reads_arrays(tmp_path: Path, order: str) -> None:
    np.save(tmp_path / "school.npy", np.asarray(school(), order=order))
    command = [
        sys.executable,
        "-m",
        "flockproof",
        "tracks",
        str(tmp_path / "school.npy"),
        "--fps",
        "25",
        "--window",
        "5",
    ]
    command += ["--null", "0", "--max-gap", "5", "--out", str(tmp_path / "out"), "--json"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    same(json.loads(done.stdout), table="an array of NumPy")


def test_plain_arrays(tmp_path: Path) -> None:
    np.save(tmp_path / "school.npy", school())
    same(analysed(tmp_path / "school.npy", fps=25))
    with pytest.raises(ValueError, match="comes with fps"):
        analysed(tmp_path / "school.npy")
    with pytest.raises(ValueError, match=r"\(frames, individuals, 2\)"):
        analysed(np.zeros((3, 2)), fps=1)


class Wicked:
    def __reduce__(self) -> Any:
        return (Path.touch, (Path("ran"),))


def test_pickles_are_not_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    bad = tmp_path / "bad.pickle"
    bad.write_bytes(pickle.dumps({"trajectories": Wicked()}))
    with pytest.raises(ValueError, match="without running"):
        analysed(bad, fps=25)
    with open(tmp_path / "bad.npy", "wb") as file:
        npy.write_array(file, np.array({"trajectories": Wicked()}, dtype=object), allow_pickle=True)
    with pytest.raises(ValueError, match="without running"):
        analysed(tmp_path / "bad.npy", fps=25)
    assert not (tmp_path / "ran").exists()
    for contents in (b"", b"\x93NUMPY", b"PK\x03\x04", b"\x80\x04.", pickle.dumps([1, 2]), pickle.dumps({"x": 1})):
        bad.write_bytes(contents)
        with pytest.raises(ValueError):
            analysed(bad, fps=25)


def poses() -> tuple[np.ndarray, np.ndarray]:
    """Places of shape (frames, fish, parts, 2), whose means are the school, and scores; the third part is unsure and off."""
    ahead = np.array([[1.0, 0.5], [-1.0, -0.5], [30.0, 30.0]])
    places = school()[:, :, None] + ahead
    scores = np.broadcast_to(np.array([0.9, 0.8, 0.1]), places.shape[:3]).copy()
    return places, scores


NODES = ["nose", "tail", "shadow"]


def test_sleap(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    places, scores = poses()
    with h5py.File(tmp_path / "run.analysis.h5", "w") as file:
        file["tracks"] = places.transpose(1, 3, 2, 0)
        file["point_scores"] = scores.transpose(1, 2, 0)
        file["node_names"] = np.array(NODES, dtype="S")
        file["track_names"] = np.array([f"track_{k}" for k in range(4)], dtype="S")
    found = analysed(tmp_path / "run.analysis.h5", fps=25, score=0.5)
    same(found)
    assert [fish["id"] for fish in found["per_fish"]] == [f"track_{k}" for k in range(4)]
    nose = analysed(tmp_path / "run.analysis.h5", fps=25, part="nose")
    assert nose["means"] == analysed(school() + np.array([1.0, 0.5]), fps=25)["means"]
    with pytest.raises(ValueError, match="there are nose, tail, shadow"):
        analysed(tmp_path / "run.analysis.h5", fps=25, part="fin")


def test_deeplabcut(tmp_path: Path) -> None:
    places, scores = poses()
    cells = np.concatenate([places, scores[..., None]], axis=3).reshape(200, -1)
    lines = [["scorer", *["net"] * 36], ["individuals"], ["bodyparts"], ["coords"]]
    for k in range(4):
        for node in NODES:
            lines[1] += [f"fish{k}"] * 3
            lines[2] += [node] * 3
            lines[3] += ["x", "y", "likelihood"]
    text = "\n".join(",".join(line) for line in lines) + "\n"
    for i, row in enumerate(cells):
        text += ",".join([str(i), *("" if np.isnan(x) else repr(float(x)) for x in row)]) + "\n"
    (tmp_path / "poses.csv").write_text(text)
    same(analysed(tmp_path / "poses.csv", fps=25, score=0.5), table="body parts of DeepLabCut")
    with pytest.raises(ValueError, match="frames there are in a second"):
        analysed(tmp_path / "poses.csv")


def test_trex(tmp_path: Path) -> None:
    data = school()
    for k in range(4):
        seen = ~np.isnan(data[:, k, 0])
        # TRex writes infinity where an individual was not found.
        x, y = (np.where(seen, data[:, k, c], np.inf) for c in (0, 1))
        contents = {"X#wcentroid": x, "Y#wcentroid": y, "frame": np.arange(200) + 7, "time": np.arange(200) / 25}
        np.savez(tmp_path / f"video_fish{k}.npz", **contents)
    found = analysed(tmp_path)
    same(found)
    assert found["per_fish"][1]["id"] == "video_fish1"
    (tmp_path / "empty").mkdir()
    with pytest.raises(ValueError, match="no .npz"):
        analysed(tmp_path / "empty")


def test_datasets_of_movement(tmp_path: Path) -> None:
    xarray = pytest.importorskip("xarray")
    places, scores = poses()
    names = [f"individual_{k}" for k in range(4)]
    dataset = xarray.Dataset(
        {
            "position": (("time", "space", "keypoints", "individuals"), places.transpose(0, 3, 2, 1)),
            "confidence": (("time", "keypoints", "individuals"), scores.transpose(0, 2, 1)),
        },
        coords={"time": np.arange(200) / 25, "space": ["x", "y"], "keypoints": NODES, "individuals": names},
        attrs={"fps": 25.0, "time_unit": "seconds", "source_software": "SLEAP"},
    )
    same(analysed(dataset, score=0.5))
    assert analysed(dataset, score=0.5)["source"] == "movement (SLEAP)"
    boxes = dataset.mean("keypoints").assign(position=(("time", "space", "individuals"), school().transpose(0, 2, 1)))
    same(analysed(boxes.drop_vars("confidence")))
    with pytest.raises(ValueError, match="leave fps out"):
        analysed(dataset, fps=25)
    with pytest.raises(ValueError, match="not in the plane"):
        analysed(dataset.isel(space=[0]))
    counted = dataset.assign_coords(time=np.arange(200)).assign_attrs(time_unit="frames")
    same(analysed(counted, score=0.5))
    pytest.importorskip("h5netcdf")
    dataset.to_netcdf(tmp_path / "poses.nc", engine="h5netcdf")
    same(analysed(tmp_path / "poses.nc", score=0.5))


def test_smoothing_is_that_of_scipy() -> None:
    signal = pytest.importorskip("scipy.signal")
    interpolate = pytest.importorskip("scipy.interpolate")
    rng = np.random.default_rng(5)
    data = 20 * np.cumsum(rng.standard_normal((80, 3, 2)), axis=0)
    cubic = signal.savgol_filter(data, 9, 3, deriv=1, delta=1 / 25, axis=0, mode="interp")[4:-4]
    found = flockproof.tracks(data, fps=25, window=9, smoothing="savgol", null=0)
    speeds = np.linalg.norm(cubic, axis=2).mean(axis=0)
    assert [fish["mean_speed"] for fish in found.summary["per_fish"]] == pytest.approx(speeds, rel=1e-9)
    frames = np.arange(80.0)
    splines = interpolate.make_smoothing_spline(frames, data.reshape(80, 6), lam=(9 / (2 * np.pi)) ** 4)
    slopes = 25 * splines.derivative()(frames).reshape(80, 3, 2)
    found = flockproof.tracks(data, fps=25, window=9, smoothing="spline", null=0)
    speeds = np.linalg.norm(slopes, axis=2).mean(axis=0)
    assert [fish["mean_speed"] for fish in found.summary["per_fish"]] == pytest.approx(speeds, rel=1e-7)
    with pytest.raises(ValueError, match="at least 5 frames"):
        flockproof.tracks(data, fps=25, window=3, smoothing="savgol")
    with pytest.raises(ValueError, match="there are mean, savgol, spline"):
        flockproof.tracks(data, fps=25, smoothing="kalman")
