"""Parameters of a law from a recording that the law made."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import flockproof
from flockproof import Law

pytest.importorskip("scipy")

ALIGNMENT = Law(
    state={"x": "vector", "v": "vector"},
    parameters={"K": "3/2", "beta": "1/4"},
    rates={"x": "v", "v": "sum(j, K / (1 + norm2(x[j] - x))^beta * (v[j] - v)) / agents"},
)
HEADINGS = Law(
    state={"x": "vector", "a": "angle"},
    parameters={"K": 1},
    rates={"x": "vector(cos(a), sin(a))", "a": "K * mean(j, sin(a[j] - a))"},
)


def recorded(law: Law, seconds: float = 6, **state: Any) -> np.ndarray:
    rng = np.random.default_rng(3)
    start = {"x": rng.uniform(-2, 2, (4, 2)).tolist(), **{name: make(rng) for name, make in state.items()}}
    samples = [k / 20 for k in range(int(20 * seconds) + 1)]
    run = law.simulate({"state": start, "run": {"until": seconds, "samples": samples}})
    return np.asarray(run.states["x"][run.sampled])


@pytest.fixture(scope="module")
def school() -> np.ndarray:
    return recorded(ALIGNMENT, v=lambda rng: rng.uniform(-1, 1, (4, 2)).tolist())


def test_a_gain_is_found_again(school: np.ndarray) -> None:
    found = flockproof.fit(ALIGNMENT, school, fps=20, parameters={"K": "1/2"}, horizon=8, shuffles=2)
    low, high = found.intervals["K"]
    assert found.parameters["K"] == pytest.approx(1.5, rel=1e-2) and low <= found.parameters["K"] <= high
    assert found.explained > 0.99 and max(found.control) < 0.5 and len(found.control) == 2
    assert found.windows == 13 and found.horizon == pytest.approx(0.4)
    assert "95 %" in repr(found) and "<td>K</td>" in found._repr_html_()
    # The negative control has its name wherever the result is shown.
    for shown in (repr(found), found._repr_html_(), found._repr_latex_()):
        assert "negative control, identities shuffled" in shown and "no more than that" not in shown


def test_a_law_that_says_nothing_is_no_better_than_its_negative_control() -> None:
    # Walks: the best gain is far away, and each of some sixty tries follows the law through all windows.
    walks = np.cumsum(np.random.default_rng(2).normal(0, 1, (120, 4, 2)), axis=0)
    found = flockproof.fit(ALIGNMENT, walks, fps=20, parameters={"K": "1/10"}, horizon=8, shuffles=2)
    worse, as_good = found.explained - 1e-9, found.explained
    for one in (found, replace(found, control=(worse, worse)), replace(found, control=(worse, as_good))):
        said = "the law says no more than that" in repr(one)
        assert said == (max(one.control) >= one.explained)


def test_noise_widens_the_interval_and_gaps_leave_windows_out(school: np.ndarray) -> None:
    noisy = school + np.random.default_rng(5).normal(0, 2e-3, school.shape)
    noisy[30, 2] = np.nan
    found = flockproof.fit(ALIGNMENT, noisy, fps=20, parameters={"K": 1}, horizon=8, smoothing=7, shuffles=0)
    low, high = found.intervals["K"]
    assert low < 1.5 < high and high - low > 1e-3
    assert found.windows < 13 and found.control == ()


def test_headings_turn_the_short_way() -> None:
    school = recorded(HEADINGS, a=lambda rng: rng.uniform(2, 4.5, 4).tolist())
    found = flockproof.fit(HEADINGS, school, fps=20, parameters={"K": "1/4"}, horizon=8, shuffles=0)
    assert found.parameters["K"] == pytest.approx(1, rel=0.05) and found.explained > 0.95


def test_bad_input(school: np.ndarray) -> None:
    def refused(match: str, law: Any = ALIGNMENT, data: Any = school, **options: Any) -> None:
        chosen = {"fps": 20, "parameters": {"K": 1}} | options
        with pytest.raises((ValueError, TypeError), match=match):
            flockproof.fit(law, data, **chosen)

    refused("`gain` is no parameter of the law; it has K, beta", parameters={"gain": 1})
    refused("first guess", parameters={})
    refused("law should be a flockproof.Law", law="cucker_smale.toml")
    refused("shape", data=school[:, :, :1])
    refused("shape", data=school[:, :1])
    refused("fps", fps=0)
    refused("horizon = 1", horizon=1)
    refused("smoothing = 4", smoothing=4)
    refused("0 windows|1 windows", horizon=100)
    refused("continuous time", law=Law(state={"x": "vector"}, parameters={"K": 1}, next={"x": "x"}))
    number = Law(state={"x": "vector", "u": "number"}, parameters={"K": 1}, rates={"x": "x", "u": "K"})
    refused("at most another vector", law=number)
    still = np.zeros((60, 3, 2)) + np.arange(3)[None, :, None]
    refused("goes straight on", data=still, horizon=4)
