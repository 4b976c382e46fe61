"""Pictures of results, and how results show themselves in a notebook."""

from __future__ import annotations

import math
import os
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import flockproof
from flockproof import claims, plot

ASSETS = Path(os.environ.get("FLOCKPROOF_ASSETS", Path(__file__).resolve().parents[2] / "assets"))
PHASES = {
    "model": "phase",
    "graph": {"kind": "complete"},
    "state": {"phases": ["0", "1/2", "1"]},
    "law": {"K1": -1},
    "run": {"until": 1, "samples": [1]},
}


@pytest.fixture(autouse=True)
def _no_window() -> None:
    pytest.importorskip("matplotlib").use("Agg")


def test_eigenvalues_carry_their_multiplicities() -> None:
    drawn = plot.spectrum(flockproof.spectrum("ring:12"))
    # 0 and 4 are simple; five others are double.
    assert [text.get_text() for text in drawn.texts] == ["2"] * 5
    assert list(drawn.get_yticks()) == [0]
    turning = plot.spectrum(flockproof.spectrum([[0, 1, 0], [0, 0, 1], [1, 0, 0]], kind="out-degree"))
    assert len(turning.get_yticks()) > 1 and not turning.texts


def test_products_become_ergodic() -> None:
    found = flockproof.ergodicity([[["1/2", "1/2"], ["1/3", "2/3"]]] * 4 + [[["1/2", "1/2"]] * 2])
    first, second = plot.ergodicity(found).get_lines()
    assert list(first.get_xdata()) == [1, 2, 3, 4, 5]
    assert list(first.get_ydata())[:4] == pytest.approx([6.0**-k for k in range(1, 5)])
    # Equal rows: the coefficient is 0, which has no logarithm.
    assert math.isnan(first.get_ydata()[4]) and second.get_ydata()[0] == pytest.approx(2**0.5 / 6)
    with pytest.raises(TypeError, match=r"flockproof\.ergodicity"):
        plot.ergodicity(found.product)  # type: ignore[arg-type]


def test_a_fit_shows_its_intervals() -> None:
    found = flockproof.Fit({"k": 1.0, "b": 3.0}, {"k": (0.5, 1.5), "b": (2.0, 5.0)}, 0.9, (0.1, 0.2), 20, 0.5, "words")
    drawn = plot.fit(found)
    assert drawn.get_title() == "90.0 % explained, shuffled at most 20.0 %"
    spans = [bars.get_segments()[0][:, 0].tolist() for one in drawn.containers for bars in one.lines[2]]
    assert spans == [[0.5, 1.5], [2.0, 5.0]]
    assert [label.get_text() for label in drawn.get_yticklabels()] == ["k", "b"]


def test_axes_of_somebody_else_keep_their_ticks(tmp_path: Path) -> None:
    question = tmp_path / "paths.toml"
    question.write_text(
        '[question]\nid = "paths"\n[for]\nn = "3..5"\ngraph = "path(n)"\n[values]\nslow = "lambda(2)"\n'
    )
    axes = pytest.importorskip("matplotlib.pyplot").subplots()[1]
    axes.set_xscale("log")
    assert plot.sweep(flockproof.sweep(question), "n", "slow", axes) is axes and axes.get_xscale() == "log"


def test_birds_are_named_outside_of_their_circle() -> None:
    drawn = plot.network(flockproof.Flock([k * 9 / 10 for k in range(12)], [0] * 12).settle())
    drawn.figure.canvas.draw()
    assert len(drawn.texts) == 12
    for text in drawn.texts:
        x, y = text.get_position()
        assert x * text.xy[0] + y * text.xy[1] > 10


def test_links_begin_and_end_where_the_switches_are() -> None:
    found = flockproof.Flock([0, "9/10", "5/2"], ["1/8", 0, "-1/8"]).settle()
    assert found.switches
    bars = [line.get_xdata() for line in plot.settlement(found).get_lines()]
    times = {switch.t for switch in found.switches}
    inner = {int(x) for bar in bars for x in bar} - {0, max(int(bar[1]) for bar in bars)}
    assert inner <= times
    # At the end the links that last.
    end = max(int(bar[1]) for bar in bars)
    assert sum(int(bar[1]) == end for bar in bars) == len(found.edges)
    with pytest.raises(ValueError, match="ever linked"):
        plot.settlement(flockproof.Flock([0, 5], [0, 0]).settle())


def test_a_space_time_diagram_goes_through_the_exact_positions() -> None:
    flock = flockproof.Flock([0, "9/10", "5/2"], ["1/8", 0, "-1/8"])
    switch = flock.settle().switches[-1]
    drawn = plot.spacetime(flock)
    lines = drawn.get_lines()
    exact = flock.run(until=switch.t).positions
    for bird, line in enumerate(lines[:3]):
        at = list(line.get_xdata()).index(switch.t)
        assert line.get_ydata()[at] == pytest.approx(float(exact[bird][0]), abs=1e-15)
    # A line for each pair of each switch.
    pairs = [pair for one in flock.settle().switches for pair in (*one.gained, *one.lost)]
    assert len(lines) == 3 + len(pairs)
    i, j = pairs[-1]
    assert sorted(lines[-1].get_ydata()) == pytest.approx(sorted(float(exact[k - 1][0]) for k in (i, j)))
    for match, options in {"coordinate = 1": {"coordinate": 1}, "until = 0": {"until": 0}}.items():
        with pytest.raises(ValueError, match=match):
            plot.spacetime(flock, **options)
    headed = flockproof.Flock([[0, 0], [1, 0]], model="K", speed=1, headings=[0, 1])
    with pytest.raises(ValueError, match="model D"):
        plot.spacetime(headed)
    with pytest.raises(TypeError, match=r"flockproof\.Flock"):
        plot.spacetime(flock.settle())  # type: ignore[arg-type]


def test_a_sweep_over_a_name(tmp_path: Path) -> None:
    question = tmp_path / "paths.toml"
    question.write_text(
        '[question]\nid = "paths"\n[for]\nn = "3..5"\ngraph = "path(n)"\n[values]\nslow = "lambda(2)"\n'
    )
    table = flockproof.sweep(question)
    line = plot.sweep(table, "n", "slow").containers[0].lines[0]
    assert list(line.get_xdata()) == [3, 4, 5]
    assert line.get_ydata()[0] == pytest.approx(1)
    with pytest.raises(ValueError, match="`wrong` is none of n, graph, slow"):
        plot.sweep(table, "n", "wrong")
    with pytest.raises(ValueError, match="has numbers for both"):
        plot.sweep(table, "graph", "slow")


def test_worst_cases() -> None:
    """The worst motion stays within the enclosure of all and comes to its edge."""
    found = flockproof.reach(
        {
            "system": {"states": ["x"], "inputs": {"u": [-1, 1]}, "start": {"x": 0}},
            "mode": {"only": {"A": [[-1]], "B": [[1]]}},
            "run": {"until": 2},
            "check": [{"holds": "x <= 9/10"}, {"holds": "x >= -1/2"}],
        }
    )
    axes = plot.reach(found)
    worst, bound = axes.get_lines()
    assert worst.get_ydata()[-1] == pytest.approx(float(found[0].worst), abs=1e-9)
    assert list(bound.get_ydata()) == [0.9, 0.9]
    vertices = axes.collections[0].get_paths()[0].vertices
    assert vertices[:, 1].max() == pytest.approx(float(found[0].worst), abs=1e-3)
    assert vertices[:, 1].max() >= float(found[0].lo)
    assert plot.reach(found, 1).get_ylabel() == "x" and "false" in plot.reach(found, len(found) - 1).get_title()
    with pytest.raises(ValueError, match="check = 2"):
        plot.reach(found, 2)
    with pytest.raises(TypeError, match="flockproof.reach"):
        plot.reach("x")


def test_phases_and_portraits() -> None:
    phases = flockproof.simulate(PHASES)
    assert f"{phases.observables['order'][-1, 0]:.3f}" in plot.circle(phases).get_title()
    with pytest.raises(ValueError, match="no positions with velocities"):
        plot.portrait(phases)
    with pytest.raises(ValueError, match="row = 1000000"):
        plot.circle(phases, row=1_000_000)
    cars = flockproof.simulate(ASSETS / "scenarios" / "platoon.toml")
    assert len(plot.portrait(cars).get_lines()) == cars.positions.shape[1] + 1
    with pytest.raises(ValueError, match="no phases"):
        plot.circle(cars)
    with pytest.raises(ValueError, match="coordinate = 7"):
        plot.portrait(cars, coordinate=7)


def test_a_recording_over_time() -> None:
    found = flockproof.tracks(ASSETS / "example_tracks.csv", null=9)
    assert [line.get_label() for line in plot.tracks(found).get_lines()] == ["p_1", "rotation"]
    with pytest.raises(ValueError, match="`left_out` is none of"):
        plot.tracks(found, ["left_out"])
    assert "few frames" not in found._repr_html_() and "nearest_distance (unit of the file)" in found._repr_html_()


def test_patterns_and_tubes() -> None:
    found = flockproof.pattern(4, [-1], "1/2")
    assert [one.clusters for one in found] == [1, 2, 4]
    drawn = plot.patterns(found)
    assert [text.get_text().split("\n")[1] for text in drawn.texts] == [one.verdict for one in found]
    assert "largest real part (1/s)" in found._repr_html_()
    with pytest.raises(ValueError, match="without turning"):
        flockproof.pattern(4, [-1], 0)
    with pytest.raises(ValueError, match="at most 2"):
        flockproof.pattern(2, [1, 1, 1])
    with pytest.raises(ValueError, match="particles: from 1 to 60"):
        flockproof.pattern(61, [1])
    system = {
        "system": {"states": ["x"], "inputs": {"u": [-1, 1]}, "start": {"x": 0}},
        "mode": {"only": {"A": [[-1]], "B": [[1]]}},
        "run": {"until": 2},
        "check": [{"holds": "x <= 9/10"}],
    }
    found = flockproof.reach(system)
    tube = found.tube(samples=10)
    # What no input can pass: 1 - exp(-t) to both sides, rounded outwards, over whole stretches of time.
    assert tube.shape == (10, 4) and tube[0, 0] == 0 and tube[-1, 1] == 2
    for _, until, low, high in tube:
        assert -low >= 1 - math.exp(-until) - 1e-15 and high == pytest.approx(1 - math.exp(-until), abs=1e-2)
    with pytest.raises(ValueError, match="check = 1"):
        plot.reach(found, check=1)
    with pytest.raises(TypeError, match=r"flockproof\.reach"):
        plot.reach(system)  # type: ignore[arg-type]


def test_order_against_the_noise() -> None:
    def birds(noise: int, seed: int) -> flockproof.Simulation:
        start = {"random": {"agents": 30, "seed": seed, "half": "5/2"}}
        law = {"box": 5, "speed": "3/100", "noise": noise, "seed": seed}
        return flockproof.simulate({"model": "vicsek-noise", "state": start, "law": law, "run": {"until": 60}})

    runs = {noise: [birds(noise, seed) for seed in range(1, 4)] for noise in (0, 3, 6)}
    drawn = plot.against(runs, since=30)
    means = drawn.containers[0].lines[0]
    late = {noise: [run.observables["order"][run.t >= 30, 0].mean() for run in some] for noise, some in runs.items()}
    assert list(means.get_xdata()) == [0, 3, 6]
    assert list(means.get_ydata()) == pytest.approx([sum(values) / 3 for values in late.values()])
    assert means.get_ydata()[0] > means.get_ydata()[2]
    with pytest.raises(ValueError, match="since = 61: a run ends at t = 60"):
        plot.against(runs, since=61)
    with pytest.raises(ValueError, match="`orders` is none of"):
        plot.against(runs, "orders")
    with pytest.raises(ValueError, match="no run"):
        plot.against({0: []})
    with pytest.raises(TypeError, match="mapping"):
        plot.against(runs[0])


def test_members_of_one_place_have_a_mean(tmp_path: Path) -> None:
    question = tmp_path / "graphs.toml"
    question.write_text(
        '[question]\nid = "graphs"\n[for]\nn = "3..4"\ngraph = "connected(n)"\n[values]\nslow = "lambda(2)"\n'
    )
    table = flockproof.sweep(question)
    means = plot.sweep(table, "n", "slow").containers[0].lines[0]
    of = [[float(row["slow"]) for row in table if row["n"] == n] for n in (3, 4)]
    assert [len(values) for values in of] == [2, 6]
    assert list(means.get_ydata()) == pytest.approx([sum(values) / len(values) for values in of])


def test_results_show_themselves() -> None:
    matrix = flockproof.ergodicity([[["1/2", "1/2"], ["1/3", "2/3"]]])
    assert (
        matrix._repr_latex_()
        == r"$\begin{pmatrix} \frac{1}{2} & \frac{1}{2} \\ \frac{1}{3} & \frac{2}{3} \end{pmatrix}$"
    )
    assert flockproof.Enclosure(Fraction(-1, 2), Fraction(1, 2))._repr_latex_() == r"$[-0.5,\ 0.5]$"
    for found in (
        flockproof.resonance(5, -1, -1),
        flockproof.peak("path:3", -1, -1),
        flockproof.spectrum("ring:5"),
        matrix,
    ):
        html, latex = found._repr_html_(), found._repr_latex_()
        assert html.count("<table>") == html.count("</table>") == 1
        assert latex is not None and latex.startswith("$") and latex.endswith("$")
    assert flockproof.spectrum("ring:200")._repr_latex_() is None
    assert "order" in flockproof.simulate(PHASES)._repr_html_()
    name = next(iter(flockproof.invariants()))
    assert f"<td>{name}</td><td>2</td>" in flockproof.fuzz(invariants=name, cases=2)._repr_html_()


def test_results_and_claims_show_themselves_in_latex() -> None:
    odd = claims.claim("school.odd", "n^2 & {m}_k < 5 % of #1 \\\\ ~.", printed=2, controls={"the cube": 3})(
        lambda exponent, run: run.exhaustive("a part", "computed", [3], lambda n: claims.Exact(n) ** exponent == 9)
    )
    entry = claims.verify(odd)["school.odd"]
    assert r"n\textasciicircum{}2 \& \{m\}\_k \textless{} 5 \% of \#1" in entry._repr_latex_()
    assert r"\textbf{school.odd} (own): \emph{holds}" in entry._repr_latex_()
    assert claims.Exact(1, 2)._repr_latex_() == "$0.5$"
    flock = flockproof.Flock([0, "9/10"], ["1/8", 0])
    every = (odd, entry, claims.verify(odd), flockproof.ledger()["veerman.lem2"], flock, flock.settle())
    for found in (*every, flockproof.simulate(PHASES), flockproof.pattern(4, [-1], "1/2")):
        html, latex = found._repr_html_(), found._repr_latex_()
        plain = latex.replace(r"\{", "").replace(r"\}", "")
        assert plain.count("{") == plain.count("}") and "<" not in latex
        # The head is a row too, and every row has as many cells.
        assert latex.count(r"\begin{longtable}") == html.count("<table>")
        assert latex.count(r" \\" + "\n") == html.count("<tr>")


def test_parts_of_results_show_themselves() -> None:
    platoon = flockproof.Platoon(3, -1, -2, ahead="0.6")
    response = platoon.response(1, car=1)
    eigenvalue = flockproof.spectrum("complete:5")[1]
    assert eigenvalue._repr_latex_() == r"$5,\quad 4\ \text{times}$"
    assert flockproof.spectrum("complete:5")[0]._repr_latex_() == "$0$"
    pattern = flockproof.pattern(4, [-1], "1/2")[0]
    for found, words in (
        (platoon, "platoon of 3 followers"),
        (response, "phase (radians)"),
        (pattern, "<td>1</td><td>stable</td>"),
    ):
        html, latex = found._repr_html_(), found._repr_latex_()
        assert words in html and html.count("<table>") == html.count("</table>") == 1
        assert latex.count(r" \\" + "\n") == html.count("<tr>")


def test_the_smallest_parts_show_themselves() -> None:
    settled = flockproof.Flock([0, "5/2"], ["1/8", 0]).settle()
    event = flockproof.Event(1.5, "unlink", (2, 4))
    prefix = flockproof.ergodicity([[["1/2", "1/2"], ["0", "1"]]]).prefixes[0]
    evidence = flockproof.Evidence("identity", (1, 2), "all", "a < b", "computed", 64, "2^-190")
    for found, words in (
        (event, "<td>1.5</td><td>went</td><td>2, 4</td>"),
        (settled.switches[0], "<td>12</td><td>1–2</td><td></td>"),
        (prefix, "<td>1</td><td>0.5</td><td>0.7071067812</td><td>3</td>"),
        (evidence, "<td>identity</td><td>1, 2</td><td>a &lt; b</td><td>computed</td>"),
    ):
        html, latex = found._repr_html_(), found._repr_latex_()
        assert words in html and html.count("<table>") == html.count("</table>") == 1
        assert latex.count(r" \\" + "\n") == html.count("<tr>") == 2
    # As a row of the whole.
    assert settled.switches[0]._repr_html_().removesuffix("</table>") in settled._repr_html_()
    assert "cases: 64<br>bound of the error: 2^-190" in evidence._repr_html_()
    bare = flockproof.Evidence("text", (), None, "a", "b", None, None)
    assert bare._repr_html_().endswith("</table>")


def test_a_reach_shows_its_checks() -> None:
    found = flockproof.reach(
        {
            "system": {"states": ["x"], "inputs": {"u": [-1, 1]}, "start": {"x": 0}},
            "mode": {"only": {"A": [[-1]], "B": [[1]]}},
            "run": {"until": 2},
            "check": [{"holds": "x <= 9/10"}],
        }
    )
    assert "<td>x &lt;= 9/10</td><td>holds</td>" in found._repr_html_()
    assert "x &lt;= 9/10: holds" in found[0]._repr_html_() and r"\begin{longtable}" in found[0]._repr_latex_()


def test_a_platoon_that_is_not_stable_is_told() -> None:
    unstable = flockproof.Platoon(5, f_ahead=-1, f_behind=-1, g_ahead=-1, g_behind=-9)
    assert "not stable" in plot.bode(unstable)[0].get_title()
    assert plot.bode(flockproof.Platoon(5, -1, -1))[0].get_title() == "5 followers, peaks certified"


def test_legends_hide_no_curve() -> None:
    many = plot.observables(flockproof.simulate(ASSETS / "scenarios" / "pattern.toml"))
    few = plot.observables(flockproof.simulate(PHASES), ["order"])
    many.figure.canvas.draw()
    few.figure.canvas.draw()
    for axes in (many, few):
        box = axes.get_legend().get_window_extent()
        assert box.x0 >= axes.bbox.x1 or box.y1 <= axes.bbox.y0


def test_paths_in_a_periodic_box_do_not_cross_it() -> None:
    run = flockproof.simulate(ASSETS / "scenarios" / "vicsek_noise.toml")
    side = float(np.ptp(run.positions))
    steps = [np.abs(np.diff(line.get_xydata(), axis=0)) for line in plot.paths(run).get_lines()[:-1]]
    assert all(np.nanmax(step) <= side / 2 + 1e-9 for step in steps)
