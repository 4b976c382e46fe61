"""The same question gives the same digits as the command line."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import answer, command_line
from hypothesis import given, settings
from hypothesis import strategies as st

import flockproof

gains = st.fractions(min_value=-5, max_value=Fraction(-1, 50), max_denominator=100)


def ends(x: flockproof.Enclosure) -> dict[str, str]:
    lo, hi = x._texts()
    return {"lo": lo, "hi": hi}


@settings(max_examples=15, deadline=None)
@given(st.integers(1, 10**9), gains, gains, st.integers(1, 60))
def test_resonance(followers: int, f: Fraction, g: Fraction, digits: int) -> None:
    told = answer("resonance", "--followers", str(followers), f"--f={f}", f"--g={g}", "--digits", str(digits))
    found = flockproof.resonance(followers, f, g, digits)
    assert ends(found.frequency) == told["omega"] and ends(found.amplitude) == told["amplitude"]
    assert found.theorem1.frequency == Fraction(told["theorem1"]["omega"])
    assert found.frequency.lo == Fraction(told["omega"]["lo"])
    assert (str(found.f), str(found.g)) == (told["f"], told["g"])


@pytest.mark.parametrize("graph", ["ring:12", "circulant:12:1,3", "platoon2:8", "star:7", "geometric:20:1/2:7"])
@pytest.mark.parametrize("kind", ["laplacian", "walk", "reduced"])
def test_spectrum(graph: str, kind: str) -> None:
    told = answer("spectrum", "--graph", graph, "--kind", kind)
    found = flockproof.spectrum(graph, kind)
    assert (found.order, found.method, found.reason) == (told["order"], told["method"], told["reason"])
    assert len(found) == len(told["eigenvalues"])
    for mine, theirs in zip(found, told["eigenvalues"], strict=True):
        assert mine.multiplicity == theirs["multiplicity"] and str(mine.exact or 0) == theirs.get("exact", "0")
        if mine.imaginary is None:
            assert ends(mine.value) == {"lo": theirs["lo"], "hi": theirs["hi"]}
        else:
            assert (ends(mine.value), ends(mine.imaginary)) == (theirs["re"], theirs["im"])


def test_spectrum_of_files(tmp_path: Path) -> None:
    edges = tmp_path / "edges.txt"
    edges.write_text("1 2 1/3\n2 3\n3 4 0.5\n")
    market = tmp_path / "graph.mtx"
    market.write_text("%%MatrixMarket matrix coordinate real general\n3 3 3\n1 2 0.5\n2 3 1\n3 1 2\n")
    for path in (edges, market):
        told = answer("spectrum", "--graph", str(path))
        found = flockproof.spectrum(path)
        assert [x.multiplicity for x in found] == [x["multiplicity"] for x in told["eigenvalues"]]
        assert found.method == told["method"]


def test_ergodicity(assets: Path) -> None:
    file = assets / "two_matrices.txt"
    told = answer("ergodicity", str(file))
    found = flockproof.ergodicity(file)
    assert [[str(x) for x in row] for row in found.product] == told["product"]
    assert [str(p.tau_1) for p in found.prefixes] == [p["tau_1"] for p in told["prefixes"]]
    assert [str(p.tau_2_squared) for p in found.prefixes] == [p["tau_2_squared"] for p in told["prefixes"]]
    rows = [" ".join("".join("01"[x] for x in row) for row in f.astype(int)) for f in found.footprints]
    assert rows == [p["footprint"] for p in told["prefixes"]]
    assert [{"time": s.time, "members": list(s.members)} for s in found.stabilisers] == told["stabilisers"]
    assert found.tau_2 * found.tau_2 - found.tau_2_squared < Fraction(1, 10**15)


def same_flock(found: Any, told: dict[str, Any]) -> None:
    switches = [{"t": str(s.t), "gained": [*map(list, s.gained)], "lost": [*map(list, s.lost)]} for s in found.switches]
    assert switches == told["switches"]
    assert [list(flock) for flock in found.flocks] == told["flocks"]
    assert found.declaration == told["declaration"]


def test_flock_run_and_settle(assets: Path) -> None:
    file = assets / "four_birds.json"
    flock = flockproof.Flock.from_file(file)
    told = answer("flock", "settle", str(file))
    found = flock.settle()
    same_flock(found, told)
    steady = None if found.steady_from is None else str(found.steady_from)
    assert (steady, found.ending, found.why) == (told["steady_from"], told["ending"], told["why"])
    told = answer("flock", "run", str(file), "--until", "40")
    run = flock.run(40)
    same_flock(run, told)
    assert (run.until, run.denominator_bits) == (told["until"], told["denominator_bits"])


@settings(max_examples=8, deadline=None)
@given(
    st.lists(
        st.tuples(st.fractions(-2, 2, max_denominator=8), st.fractions(-1, 1, max_denominator=8)),
        min_size=2,
        max_size=4,
    )
)
def test_settling_random_flocks(
    tmp_path_factory: pytest.TempPathFactory, birds: list[tuple[Fraction, Fraction]]
) -> None:
    flock = flockproof.Flock([x for x, _ in birds], [v for _, v in birds], weights="vicsek")
    file = tmp_path_factory.mktemp("flock") / "flock.json"
    file.write_text(flock.to_json())
    told = answer("flock", "settle", str(file))
    found = flock.settle()
    same_flock(found, told)
    assert (found.ending, found.why) == (told["ending"], told["why"])


@pytest.mark.parametrize("name", ["pattern", "switching_flock", "three_agents"])
def test_simulate(name: str, assets: Path, tmp_path: Path) -> None:
    file = assets / "scenarios" / f"{name}.toml"
    told = answer("simulate", str(file), "--out", str(tmp_path))
    found = flockproof.simulate(file)
    assert found.declaration == told["declaration"] and list(found.remarks) == told["remarks"]
    assert [(e.t, e.kind, list(e.pair)) for e in found.events] == [
        (e["t"], e["kind"], e["pair"]) for e in told["events"]
    ]
    places = np.flatnonzero(found.sampled)
    assert len(places) == len(told["samples"])
    for k, sample in zip(places, told["samples"], strict=True):
        assert found.t[k] == sample["t"]
        for state, array in found.states.items():
            assert np.array_equal(array[k], np.array(sample[state]))
        for observable, array in found.observables.items():
            expected = sample["observables"][observable]
            expected = math.nan if expected is None else expected
            assert np.array_equal(array[k], np.array(expected), equal_nan=True)


def test_a_dictionary_is_the_same_scenario(assets: Path) -> None:
    import tomllib

    file = assets / "scenarios" / "three_agents.toml"
    assert flockproof.simulate(tomllib.loads(file.read_text())) == flockproof.simulate(file)


def test_tables_of_a_simulation(assets: Path, tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    file = assets / "scenarios" / "three_agents.toml"
    answer("simulate", str(file), "--out", str(tmp_path))
    trajectory, observables = flockproof.simulate(file).to_pandas()
    pandas.testing.assert_frame_equal(trajectory, pandas.read_csv(tmp_path / "trajectory.csv"))
    told = pandas.read_csv(tmp_path / "observables.csv")
    pandas.testing.assert_frame_equal(observables, told, check_dtype=False)


def test_tracks(assets: Path, tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    file = assets / "example_tracks.csv"
    told = answer("tracks", str(file), "--out", str(tmp_path), "--null", "9")
    found = flockproof.tracks(file, null=9)
    # These name the file with its place.
    for key in ("configuration", "digest"):
        assert found.summary.pop(key) and told.pop(key)
    assert found.summary == told
    assert found.files["frames.csv"] == (tmp_path / "frames.csv").read_bytes()
    frame = pandas.read_csv(file)
    again = flockproof.tracks(frame, null=9)
    assert again.files["frames.csv"] == found.files["frames.csv"]
    assert len(again.to_pandas("fish")) == len(again.table("fish")) == len(set(frame["id"]))


def test_verify_and_explain() -> None:
    done = command_line("verify", "--claim", "veerman.lem2", "--claim", "veerman.gain_max", "--json", "-")
    found = flockproof.verify(claims=["veerman.lem2", "veerman.gain_max"])

    def timeless(document: str) -> Any:
        read = json.loads(document)
        for claim in read["claims"]:
            claim["seconds"] = 0
        return read

    assert timeless(found.to_json()) == timeless(done.stdout)
    assert found.as_recorded == (done.returncode == 0)
    told = command_line("explain", "veerman.lem2").stdout
    # The program adds a line on how it was checked.
    assert " ".join(told.split()).startswith(" ".join(flockproof.explain("veerman.lem2").split()))


def test_the_ledger_is_the_record() -> None:
    claims = flockproof.ledger()
    assert claims["veerman.lem2"].paper == "veerman" and "veerman.lem2" in claims
    assert len(claims.to_pandas()) == len(claims) == len(set(claims))
    assert all(claim.statement and claim.verdict for claim in claims)


@pytest.mark.parametrize(
    ("call", "arguments"),
    [
        (lambda: flockproof.resonance(4, 1, -1), ["resonance", "--followers", "4", "--f", "1", "--g", "-1"]),
        (lambda: flockproof.resonance(0, -1, -1), ["resonance", "--followers", "0", "--f", "-1", "--g", "-1"]),
        (lambda: flockproof.resonance(4, "x", -1), ["resonance", "--followers", "4", "--f", "x", "--g", "-1"]),
        (lambda: flockproof.spectrum("ring:x"), ["spectrum", "--graph", "ring:x"]),
        (lambda: flockproof.spectrum("ring:5", "nothing"), ["spectrum", "--graph", "ring:5", "--kind", "nothing"]),
        (lambda: flockproof.spectrum("ring:0"), ["spectrum", "--graph", "ring:0"]),
        (lambda: flockproof.verify("nobody"), ["verify", "--paper", "nobody"]),
        (lambda: flockproof.explain("nothing"), ["explain", "nothing"]),
    ],
)
def test_errors_are_the_sentence_of_the_command_line(call: Any, arguments: list[str]) -> None:
    done = command_line(*arguments)
    assert done.returncode == 2
    sentence = done.stderr.removeprefix("error: ").strip().removeprefix("--")
    with pytest.raises(ValueError) as caught:
        call()
    assert str(caught.value) == sentence


def test_too_many_digits() -> None:
    arguments = ["resonance", "--followers", "4", "--f", "-1", "--g", "-1", "--digits", "100000"]
    assert "1 to 10000" in command_line(*arguments).stderr
    with pytest.raises(ValueError, match="digits must lie between 1 and 10000, but it is 100000"):
        flockproof.resonance(4, -1, -1, 10**5)
