"""Trajectories from arrays and tables of other forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import flockproof


def circling(frames: int = 300, fish: int = 6) -> np.ndarray:
    """Fish on a circle, all to the left, at 25 frames a second; shape (frames, fish, 2)."""
    angle = 0.02 * np.arange(frames)[:, None] + np.arange(fish)[None, :]
    return 20 * np.stack([np.cos(angle), np.sin(angle)], axis=2)


def table(data: np.ndarray, time: str, name: str) -> dict[str, Any]:
    frames, fish = np.nonzero(~np.isnan(data).any(axis=2))
    x, y = data[frames, fish].T
    return {time: frames, name: fish + 1, "x": x, "y": y}


def test_an_array_is_its_table() -> None:
    data = circling()
    own = flockproof.tracks(data, fps=25, window=5, null=0)
    named = flockproof.tracks(
        table(data, "frame", "particle"), columns={"frame": "t", "particle": "id"}, fps=25, window=5, null=0
    )
    assert own.summary["means"] == named.summary["means"]
    means = own.summary["means"]
    # By NumPy: unit vectors of central differences over five frames, and their mean.
    smooth = np.lib.stride_tricks.sliding_window_view(data, 5, axis=0).mean(axis=3)
    velocity = (smooth[2:] - smooth[:-2]) / (2 / 25)
    heading = velocity / np.linalg.norm(velocity, axis=2, keepdims=True)
    assert means["p_1"] == pytest.approx(np.linalg.norm(heading.mean(axis=1), axis=1).mean(), abs=1e-12)
    assert means["momentum"] == pytest.approx(np.linalg.norm(velocity.mean(axis=1), axis=1).mean(), abs=1e-9)


def test_gaps_are_bridged_and_groups_are_those_that_are_there() -> None:
    data = circling()
    data[50:53, 2] = np.nan
    data[100:180, 4] = np.nan

    def used(**chosen: Any) -> Any:
        return flockproof.tracks(data, fps=25, window=5, null=0, **chosen).summary

    plain, bridged, fewer = used(), used(max_gap=5), used(max_gap=5, min_fish=5)
    assert (plain["left_out"]["missing"], bridged["left_out"]["missing"], fewer["left_out"]["missing"]) == (83, 80, 0)
    assert fewer["left_out"]["used"] == 300 - 6 and 5 < fewer["mean_fish"] < 6
    assert [gap["bridged"] for gap in bridged["gaps"]] == [True, False]
    with pytest.raises(ValueError, match="between 2 and 6"):
        used(min_fish=7)
    with pytest.raises(ValueError, match="comes with fps"):
        flockproof.tracks(data)
    with pytest.raises(ValueError, match="two columns are to be t"):
        flockproof.tracks(table(data, "t", "id"), columns={"a": "t", "b": "t"})


def test_rotation_and_distances_stand_beside_null_models() -> None:
    rng = np.random.default_rng(3)
    data = circling(400) + 0.2 * rng.standard_normal((400, 6, 2)).cumsum(axis=0)
    null = flockproof.tracks(data, fps=25, window=5, null=19).summary["null_models"]
    smooth = np.lib.stride_tricks.sliding_window_view(data, 5, axis=0).mean(axis=3)
    velocity = smooth[2:] - smooth[:-2]
    heading = velocity / np.linalg.norm(velocity, axis=2, keepdims=True)
    places = data[3:-3]
    arm = places - places.mean(axis=1, keepdims=True)
    arm /= np.linalg.norm(arm, axis=2, keepdims=True)
    turn = (arm[:, :, 0] * heading[:, :, 1] - arm[:, :, 1] * heading[:, :, 0]).mean(axis=1)
    assert null["observed"]["rotation"] == pytest.approx(np.abs(turn).mean(), abs=1e-9)
    apart = np.linalg.norm(places[:, :, None] - places[:, None], axis=3) + 1e9 * np.eye(6)
    assert null["observed"]["nearest_distance"] == pytest.approx(apart.min(axis=2).mean(), rel=1e-9)
    assert null["shifted"]["headings shifted"]["nearest_distance"] is None
    assert 0 < null["shifted"]["tracks shifted"]["nearest_distance"]["share_at_most"] <= 1


def test_who_turns_first() -> None:
    rng = np.random.default_rng(9)
    turns = np.convolve(rng.standard_normal(1200), np.ones(10) / 40, mode="same").cumsum()
    angle = np.stack([turns[20 - late : 1120 - late] for late in (0, 5, 12)], axis=1)
    data = np.stack([np.cos(angle), np.sin(angle)], axis=2).cumsum(axis=0) + 10 * np.arange(3)[:, None]
    found = flockproof.tracks(data, fps=20, window=3, null=0, delays=1).summary["delays"]
    assert [pair["delay"] for pair in found["pairs"]] == pytest.approx([0.25, 0.6, 0.35])
    assert found["lead"] == pytest.approx({"1": 0.425, "2": 0.05, "3": -0.475})
    assert flockproof.tracks(data, fps=20, window=3, null=0).summary["delays"] is None
    with pytest.raises(ValueError, match="largest delay"):
        flockproof.tracks(data, fps=20, window=3, delays=50)


def test_dates_and_splines() -> None:
    data = circling(120)
    data[50:53, 2] = np.nan
    frames, fish = np.nonzero(~np.isnan(data).any(axis=2))
    x, y = data[frames, fish].T
    dates = np.datetime64("2024-05-01T12:00:00") + frames * np.timedelta64(40, "ms")
    rows = {"t": dates, "id": fish, "x": x, "y": y}
    dated = flockproof.tracks(rows, window=5, null=0, max_gap=3, bridge="spline").summary
    assert dated["start"] == "2024-05-01T12:00:00" and dated["step"] == pytest.approx(0.04)
    line = flockproof.tracks(rows, window=5, null=0, max_gap=3).summary
    # On the circle the chord of four steps is too short, the cubic is not: the momentum is nearer to that without a gap.
    whole = flockproof.tracks(circling(120), fps=25, window=5, null=0).summary
    off = [abs(run["means"]["momentum"] - whole["means"]["momentum"]) for run in (dated, line)]
    assert off[0] < off[1]
    with pytest.raises(ValueError, match="there are line, spline"):
        flockproof.tracks(rows, bridge="arc")
