"""Recordings of trackers: the same school in every form is the same school."""

from __future__ import annotations

import itertools
import json
import pickle
import struct
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.lib import format as npy

import flockproof
from flockproof import _recordings, _videos


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
    same(analysed(tmp_path / "trajectories.h5"), body_length=7.5, body_length_from="the file", unit="pixels")


def test_names_of_individuals_are_those_of_the_file() -> None:
    named = {**IDTRACKER, "identities_labels": ["red", "green", "blue", "none"]}
    assert [fish["id"] for fish in analysed(named)["per_fish"]] == ["blue", "green", "none", "red"]
    # Fewer than there are individuals: numbers.
    short = {**IDTRACKER, "identities_labels": ["red"]}
    assert [fish["id"] for fish in analysed(short)["per_fish"]] == ["1", "2", "3", "4"]


def test_tables_of_idtracker_have_their_attributes_beside_them(tmp_path: Path) -> None:
    table = tmp_path / "trajectories.csv"
    columns = np.column_stack([np.arange(200) / 25, school().reshape(200, 8)])
    header = "time," + ",".join(f"x{k},y{k}" for k in range(1, 5))
    np.savetxt(table, columns, delimiter=",", header=header, comments="", fmt="%.17g")
    form = "all fish in one row, as idtracker.ai writes it"
    same(analysed(table), table=form, body_length=5.3, unit="pixels", times_from="the file")
    said = {key: value for key, value in IDTRACKER.items() if key != "trajectories"}
    (tmp_path / "attributes.json").write_text(json.dumps(said))
    attributes = "attributes.json of idtracker.ai"
    same(analysed(table), table=form, body_length=7.5, body_length_from=attributes)
    assert analysed(table, body_length=2)["declaration"]["body_length_from"] == "chosen"
    # The folder as a whole, and the command line.
    same(analysed(tmp_path), body_length=7.5, unit="pixels", times_from="frames, and their rate is in the file")
    command = [sys.executable, "-m", "flockproof", "tracks", str(table), "--window", "5", "--null", "0", "--json"]
    command += ["--max-gap", "5", "--out", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    same(json.loads(done.stdout), body_length=7.5, body_length_from=attributes, unit="pixels")
    # One row for each fish in each frame.
    tidy = tmp_path / "trajectories_tidy.csv"
    frames, fish = (index.ravel() for index in np.indices((200, 4)))
    rows = np.column_stack([frames, frames / 25, fish, school().reshape(-1, 2), np.ones(800)])
    np.savetxt(tidy, rows, delimiter=",", header="frame,time,individual,x,y,probability", comments="", fmt="%.17g")
    (tmp_path / "attributes_tidy.json").write_text(json.dumps({**said, "body_length": 8.5}))
    same(
        analysed(tidy),
        body_length=8.5,
        unit="pixels",
        table="a row for each fish in each frame, as idtracker.ai writes it",
    )
    # What lies beside a table of another kind is not about it.
    plain = tmp_path / "plain.csv"
    plain.write_text("t,id,x,y\n" + "".join(f"{t},{k},{t + k},{k}\n" for t in range(20) for k in range(3)))
    assert analysed(plain)["declaration"]["body_length"] == 5.3


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
    """Places of shape (frames, fish, parts, 2), whose means are the school, and scores; the third part is off, unsurely."""
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
    assert found["declaration"]["unit"] == "pixels"
    assert found["declaration"]["times_from"] == "frames, and their rate is chosen"
    with h5py.File(tmp_path / "newer.h5", "w") as file:
        # Newer files name their dimensions and may have them in another order.
        file["tracks"], file["point_scores"] = places, scores
        file["tracks"].attrs["dims"] = '["frame", "track", "node", "xy"]'
        file["point_scores"].attrs["dims"] = '["frame", "track", "node"]'
        file["node_names"] = np.array(NODES, dtype="S")
        file["track_names"] = np.array([f"track_{k}" for k in range(4)], dtype="S")
    same(analysed(tmp_path / "newer.h5", fps=25, score=0.5))
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
    # What the network writes beside its tables: of this video, and of another one.
    (tmp_path / "other_meta.pickle").write_bytes(pickle.dumps({"data": {"fps": 99.0}}))
    (tmp_path / "poses_meta.pickle").write_bytes(pickle.dumps({"data": {"fps": 25.0, "Scorer": "net"}}))
    found = analysed(tmp_path / "poses.csv", score=0.5)
    same(found, unit="pixels", times_from="frames, and their rate is in the metadata of DeepLabCut")
    (tmp_path / "poses_meta.pickle").write_bytes(pickle.dumps({"data": Wicked()}))
    with pytest.raises(ValueError, match="frames there are in a second"):
        analysed(tmp_path / "poses.csv")
    assert not Path("ran").exists()


def deeplabcut_table() -> Any:
    """The school as DeepLabCut has it in HDF5."""
    pandas = pytest.importorskip("pandas")
    places, scores = poses()
    levels = [["net"], [f"fish{k}" for k in range(4)], NODES, ["x", "y", "likelihood"]]
    columns = pandas.MultiIndex.from_product(levels, names=["scorer", "individuals", "bodyparts", "coords"])
    cells = np.concatenate([places, scores[..., None]], axis=3).reshape(200, -1)
    return pandas.DataFrame(cells, columns=columns)


def test_deeplabcut_through_movement(tmp_path: Path) -> None:
    pytest.importorskip("movement")
    deeplabcut_table().to_hdf(tmp_path / "poses.h5", key="df_with_missing", format="table")
    same(analysed(tmp_path / "poses.h5", fps=25, score=0.5), unit="pixels")
    # A dataset that movement made, and its file.
    dataset = _recordings._with_movement(tmp_path / "poses.h5", "DeepLabCut")
    same(analysed(dataset, fps=25, score=0.5), unit="pixels")
    pytest.importorskip("h5netcdf")
    dataset.to_netcdf(tmp_path / "poses.nc", engine="h5netcdf")
    same(analysed(tmp_path / "poses.nc", fps=25, score=0.5), unit="pixels")
    (tmp_path / "poses_meta.pickle").write_bytes(pickle.dumps({"data": {"fps": 25.0}}))
    same(
        analysed(tmp_path / "poses.h5", score=0.5), times_from="frames, and their rate is in the metadata of DeepLabCut"
    )


@pytest.mark.parametrize("ending", ["h5", "slp"])
def test_what_is_no_hdf5_is_named(tmp_path: Path, ending: str) -> None:
    h5py = pytest.importorskip("h5py")
    file = tmp_path / f"run.{ending}"
    with pytest.raises(FileNotFoundError, match=f"run.{ending}"):
        analysed(file, fps=25)
    file.write_text("nothing")
    with pytest.raises(ValueError, match=f"run.{ending}: it is no file of HDF5"):
        analysed(file, fps=25)
    if ending == "slp":
        h5py.File(file, "w").close()
        with pytest.raises(ValueError, match=r"run\.slp: it has no table of frames"):
            analysed(file, fps=25)


def gaps_of(data: Any, **chosen: Any) -> tuple[int, list[tuple[str, float, float]]]:
    found = flockproof.tracks(data, window=5, null=0, **chosen).summary
    return found["frames"], sorted((gap["id"], gap["from"], gap["to"]) for gap in found["gaps"])


def test_rows_that_were_dropped_are_gaps(tmp_path: Path) -> None:
    """movement counts rows; what is left out of a table of DeepLabCut is missing there, not nearer in time."""
    pytest.importorskip("movement")
    table = deeplabcut_table()
    name = "poses.h5"

    def written(some: Any) -> Path:
        (tmp_path / name).unlink(missing_ok=True)
        some.to_hdf(tmp_path / name, key="df_with_missing", format="table")
        return tmp_path / name

    holes = school()
    holes[80:90] = np.nan
    wanted = gaps_of(holes, fps=25)
    assert wanted[0] == 200 and len(wanted[1]) == 5
    frames, gaps = gaps_of(written(table.drop(index=range(80, 90))), fps=25, score=0.5)
    assert frames == 200 and sorted(gap[1:] for gap in gaps) == sorted(gap[1:] for gap in wanted[1])
    # Backwards it is the same school, and later it is later.
    same(analysed(written(table.iloc[::-1]), fps=25, score=0.5))
    late = flockproof.tracks(written(table.iloc[60:]), fps=25, score=0.5, window=5, null=0)
    assert late.summary["frames"] == 140 and late.table("frames")["t"][0] == pytest.approx(60 / 25)
    for index, why in (
        ([0, 0, *range(2, 200)], "frame 0 is there twice"),
        ([f"img{k}.png" for k in range(200)], "not numbered by frames"),
        ([-1, *range(1, 200)], "not numbered by frames"),
        ([10**9 * k for k in range(200)], "not numbered one after the other"),
    ):
        with pytest.raises(ValueError, match=f"poses.h5: .*{why}"):
            analysed(written(table.set_axis(index, axis=0)), fps=25)
    # idtracker.ai's folder has times, and their rate beside them.
    folder = tmp_path / "trajectories_csv"
    folder.mkdir()
    rows = np.column_stack([np.round(np.arange(200) / 25, 3), school().reshape(200, 8)])
    header = "time," + ",".join(f"x{k},y{k}" for k in range(1, 5))
    kept = np.delete(rows, range(80, 90), axis=0)
    np.savetxt(folder / "trajectories.csv", kept, delimiter=",", header=header, comments="", fmt="%.17g")
    (folder / "attributes.json").write_text(json.dumps({"frames_per_second": 25.0, "body_length": 7.5}))
    assert gaps_of(folder) == wanted


def sleap_labels(videos: int = 1, frames: Any = range(200), tracked: bool = True, sure: bool = True) -> Any:
    """The school as a project of SLEAP: predicted, or set by hand, which has no scores."""
    sio = pytest.importorskip("sleap_io")
    places, scores = poses()
    skeleton = sio.Skeleton(list(NODES))
    files = [sio.Video(filename=f"school{k}.mp4" if k else "school.mp4", open_backend=False) for k in range(videos)]
    tracks = [sio.Track(f"track_{k}") for k in range(4)]

    def instance(frame: int, k: int) -> Any:
        track = tracks[k] if tracked else None
        if not sure:
            return sio.Instance.from_numpy(places[frame, k], skeleton=skeleton, track=track)
        return sio.PredictedInstance.from_numpy(
            places[frame, k], skeleton=skeleton, point_scores=scores[frame, k], score=1.0, track=track
        )

    labelled = [
        sio.LabeledFrame(
            video=video,
            frame_idx=int(frame),
            instances=[instance(frame, k) for k in range(4) if not np.isnan(places[frame, k]).any()],
        )
        for video in files
        for frame in frames
    ]
    return sio.Labels(labelled, videos=files, skeletons=[skeleton], tracks=tracks if tracked else [])


def test_projects_of_sleap_through_movement(tmp_path: Path) -> None:
    pytest.importorskip("movement")
    sio = pytest.importorskip("sleap_io")
    file = tmp_path / "run.slp"

    def written(**chosen: Any) -> Path:
        sio.save_slp(sleap_labels(**chosen), str(file))
        return file

    # movement reads positions in single precision.
    plain = analysed(school(), fps=25)["means"]["p_1"]
    found = analysed(written(), fps=25, score=0.5)
    assert found["means"]["p_1"] == pytest.approx(plain, abs=1e-6) and found["declaration"]["unit"] == "pixels"
    assert [fish["id"] for fish in found["per_fish"]] == [f"track_{k}" for k in range(4)]
    assert analysed(file, fps=25, part="tail")["means"]["p_1"] == pytest.approx(plain, abs=1e-6)
    with pytest.raises(ValueError, match="comes with fps"):
        analysed(file, score=0.5)
    (tmp_path / "school.mp4").write_bytes(mp4([512] * 200, 12800))
    rated = analysed(file, score=0.5)
    assert rated["declaration"]["times_from"] == "frames, and their rate is in the header of school.mp4"
    assert rated["means"] == found["means"] and rated["step"] == pytest.approx(1 / 25)
    # Set by hand: no score is too small.
    by_hand = analysed(written(sure=False), fps=25, score=0.5, part="nose")
    assert by_hand["means"]["p_1"] == pytest.approx(plain, abs=1e-6)
    # Frames in any order, and none of some.
    holes = [frame for frame in np.random.default_rng(2).permutation(200) if not 80 <= frame < 90]
    frames, gaps = gaps_of(written(frames=holes), fps=25, score=0.5)
    assert frames == 200 and len(gaps) == 5
    with pytest.raises(ValueError, match=r"run\.slp: it has frames of 2 videos"):
        analysed(written(videos=2), fps=25)
    with pytest.raises(ValueError, match="up to 4 instances in a frame and no tracks"):
        analysed(written(tracked=False), fps=25)


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
    # Beside the individuals TRex writes their postures.
    np.savez(tmp_path / "video_posture_fish0.npz", frames=np.arange(3), offset=np.zeros(2))
    same(analysed(tmp_path))
    (tmp_path / "empty").mkdir()
    with pytest.raises(ValueError, match=r"no .npz or .csv file"):
        analysed(tmp_path / "empty")


def test_tables_of_trex(tmp_path: Path) -> None:
    data = school()
    for k in range(4):
        lines = ["frame,missing,time,X#wcentroid (cm),Y#wcentroid (cm)"]
        for i, (x, y) in enumerate(data[:, k]):
            lines.append(
                f"{i},{int(np.isnan(x))},{i / 25!r}," + ("inf,inf" if np.isnan(x) else f"{float(x)!r},{float(y)!r}")
            )
        (tmp_path / f"video_fish{k}.csv").write_text("\n".join(lines) + "\n")
    same(analysed(tmp_path), unit="cm as TRex calls them")


def test_ctrax(tmp_path: Path) -> None:
    data = school()
    frames, flies = np.nonzero(~np.isnan(data[:, :, 0]))
    x, y = data[frames, flies].T
    rows = [f"{float(i / 25)!r},{k},{float(a)!r},{float(b)!r}" for i, k, a, b in zip(frames, flies, x, y, strict=True)]
    table = tmp_path / "flies.csv"
    table.write_text("timestamp,identity,x_pos,y_pos\n" + "\n".join(rows) + "\n")
    same(analysed(table), table="a row for each fly in each frame, as Ctrax writes it", unit="pixels")
    scipy_io = pytest.importorskip("scipy.io")
    counts, times = np.bincount(frames, minlength=200), np.arange(200) / 25
    flat = {"x_pos": x, "y_pos": y, "identity": flies.astype(float), "ntargets": counts, "timestamps": times}
    scipy_io.savemat(tmp_path / "movie.mat", flat)
    same(analysed(tmp_path / "movie.mat"), unit="pixels", times_from="the file")
    # A record for each fly; a gap is NaN there.
    kinds = [("x", object), ("y", object), ("firstframe", float), ("fps", float)]
    trx = np.array([(data[:, k, 0], data[:, k, 1], 7.0, 25.0) for k in range(4)], dtype=kinds)
    scipy_io.savemat(tmp_path / "trx.mat", {"trx": trx})
    same(analysed(tmp_path / "trx.mat"), unit="pixels", times_from="frames, and their rate is in the file")
    scipy_io.savemat(tmp_path / "other.mat", {"y_pos": y})
    with pytest.raises(ValueError, match="no `x_pos`"):
        analysed(tmp_path / "other.mat")
    scipy_io.savemat(tmp_path / "short.mat", {**flat, "ntargets": counts[1:]})
    with pytest.raises(ValueError, match="as long as the sum"):
        analysed(tmp_path / "short.mat")
    (tmp_path / "text.mat").write_text("nothing of MATLAB")
    with pytest.raises(ValueError, match="no table of MATLAB"):
        analysed(tmp_path / "text.mat")


def test_trackpy() -> None:
    pandas = pytest.importorskip("pandas")
    data = school()
    frames, particles = np.nonzero(~np.isnan(data[:, :, 0]))
    x, y = data[frames, particles].T
    found = pandas.DataFrame({"y": y, "x": x, "mass": 1.0, "frame": frames, "particle": particles})
    same(analysed(found, fps=25), table="a row for each particle in each frame, as trackpy writes it", unit="pixels")
    with pytest.raises(ValueError, match="frames there are in a second"):
        analysed(found)


def test_datasets_of_movement(tmp_path: Path) -> None:
    xarray = pytest.importorskip("xarray")
    places, scores = poses()
    names = np.array([f"individual_{k}" for k in range(4)])
    dataset = xarray.Dataset(
        {
            "position": (("time", "space", "keypoints", "individuals"), places.transpose(0, 3, 2, 1)),
            "confidence": (("time", "keypoints", "individuals"), scores.transpose(0, 2, 1)),
        },
        coords={"time": np.arange(200) / 25, "space": ["x", "y"], "keypoints": np.array(NODES), "individuals": names},
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


def test_texts_are_no_lists() -> None:
    places = np.arange(60.0).reshape(10, 3, 2)
    with pytest.raises(
        TypeError, match=r"columns should be a dictionary of other names, such as .* but it is `frame=t`"
    ):
        flockproof.tracks(places, fps=10, columns="frame=t")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="ids should be a list, but it is the text `ab`"):
        flockproof.tracks(places, fps=10, ids="ab")


def test_columns_of_frames_need_a_rate() -> None:
    table = {"frame": [], "id": [], "x": [], "y": []}
    for frame in range(60):
        for name in "ab":
            for key, value in zip(table, (frame, name, frame + 3.0 * (name == "a"), frame % 7), strict=True):
                table[key].append(value)
    names = {"frame": "t"}
    with pytest.raises(ValueError, match=r"called `frame` and holds whole numbers"):
        flockproof.tracks(table, columns=names, null=0)
    found = flockproof.tracks(table, columns=names, fps=10, null=0, window=5)
    assert found.summary["declaration"]["times_from"] == "frames, and their rate is chosen"


def mp4(durations: list[int], scale: int, wide: bool = False) -> bytes:
    """The header of an MP4 file with a track of sound and one of video, whose frames last so many units."""

    def box(kind: bytes, *inner: bytes) -> bytes:
        return struct.pack(">I4s", 8 + sum(map(len, inner)), kind) + b"".join(inner)

    def track(handler: bytes, units: int, runs: list[tuple[int, int]]) -> bytes:
        clock = (
            struct.pack(">IQQIQI", 1 << 24, 0, 0, units, 0, 0) if wide else struct.pack(">5II", 0, 0, 0, units, 0, 0)
        )
        times = struct.pack(">II", 0, len(runs)) + b"".join(struct.pack(">II", *run) for run in runs)
        media = box(b"mdhd", clock) + box(b"hdlr", struct.pack(">II4s12x", 0, 0, handler))
        return box(b"trak", box(b"mdia", media, box(b"minf", box(b"stbl", box(b"stts", times)))))

    runs = [(len(list(same)), length) for length, same in itertools.groupby(durations)]
    movie = box(b"moov", track(b"soun", 44100, [(900, 1024)]), track(b"vide", scale, runs))
    return box(b"ftyp", b"isom") + struct.pack(">I4sQ", 1, b"mdat", 16 + 100) + bytes(100) + movie


def avi(rate: int, scale: int) -> bytes:
    sound = b"strh" + struct.pack("<I4s4s5I", 56, b"auds", bytes(4), 0, 0, 0, 1, 44100) + bytes(28)
    video = b"strh" + struct.pack("<I4s4s5I", 56, b"vids", b"MJPG", 0, 0, 0, scale, rate) + bytes(28)
    return b"RIFF" + bytes(4) + b"AVI LIST" + bytes(80) + sound + video


@pytest.mark.parametrize(
    ("contents", "rate"),
    [
        (mp4([512] * 200, 12800), 25),
        (mp4([512] * 200, 12800, wide=True), 25),
        (mp4([1001] * 199 + [3000], 30000), 30000 / 1001),
        # Durations that are rounded: 1000/30.
        (mp4([33, 33, 34] * 60, 1000), 30),
        # The last frame often lasts otherwise: a single one says nothing.
        (mp4([512], 12800), None),
        (mp4([512, 512], 12800), 25),
        (mp4([512, 3000], 12800), None),
        (mp4([], 12800), None),
        # The rate changes in the middle.
        (mp4([512] * 100 + [1024] * 100, 12800), None),
        (avi(25, 1), 25),
        (avi(30000, 1001), 30000 / 1001),
        (avi(0, 0), None),
        (b"", None),
        (mp4([512] * 200, 12800)[:-30], None),
        (b"RIFF\0\0\0\0AVI strh", None),
        (struct.pack(">I4sI", 8, b"ftyp", 3) * 9, None),
    ],
)
def test_rates_of_videos(tmp_path: Path, contents: bytes, rate: float | None) -> None:
    (tmp_path / "video.mp4").write_bytes(contents)
    assert _videos.rate(tmp_path / "video.mp4") == (None if rate is None else pytest.approx(rate))


def test_a_header_cut_or_altered_anywhere_is_no_error(tmp_path: Path) -> None:
    random = np.random.default_rng(1)
    for whole in (mp4([512] * 20, 12800), avi(25, 1)):
        for _ in range(200):
            altered = bytearray(whole[: random.integers(len(whole))])
            for at in random.integers(max(len(altered), 1), size=3):
                altered[at : at + 1] = random.bytes(1)
            (tmp_path / "video.mp4").write_bytes(altered)
            found = _videos.rate(tmp_path / "video.mp4")
            assert found is None or found > 0


def test_sleap_and_deeplabcut_take_the_rate_of_their_video(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    places, scores = poses()
    with h5py.File(tmp_path / "run.analysis.h5", "w") as file:
        file["tracks"], file["point_scores"] = places.transpose(1, 3, 2, 0), scores.transpose(1, 2, 0)
        file["node_names"] = np.array(NODES, dtype="S")
        file["track_names"] = np.array([f"track_{k}" for k in range(4)], dtype="S")
        file["video_path"] = "C:\\videos\\school.mp4"
    with pytest.raises(ValueError, match="comes with fps"):
        analysed(tmp_path / "run.analysis.h5")
    (tmp_path / "school.mp4").write_bytes(mp4([512] * 200, 12800))
    said = "frames, and their rate is in the header of school.mp4"
    same(analysed(tmp_path / "run.analysis.h5", score=0.5), times_from=said)
    same(analysed(tmp_path / "run.analysis.h5", score=0.5, fps=25), times_from="frames, and their rate is chosen")
    # DeepLabCut: the video whose name begins that of the table, not the one of the labels, and metadata before it.
    table = tmp_path / "schoolDLC_net_filtered.csv"
    head = "scorer,net,net,net,net\nindividuals,a,a,b,b\nbodyparts,nose,nose,nose,nose\ncoords,x,y,x,y\n"
    table.write_text(head + "".join(f"{k},{k + 1},{k % 5},{k + 2},{k % 7}\n" for k in range(60)))
    (tmp_path / "schoolDLC_net_labeled.mp4").write_bytes(mp4([1] * 200, 99))
    assert analysed(table)["declaration"]["times_from"] == said
    (tmp_path / "schoolDLC_netincludingmetadata.pickle").write_bytes(pickle.dumps({"data": {"fps": 50.0}}))
    found = analysed(table)
    assert found["declaration"]["times_from"] == "frames, and their rate is in the metadata of DeepLabCut"
    assert found["step"] == pytest.approx(1 / 50)
