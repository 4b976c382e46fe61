"""Graphs as people have them: the same graph gives the same spectrum."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import networkx as nx
import numpy as np
import pytest
import rustworkx as rx
import scipy.sparse as sp
from hypothesis import given, settings
from hypothesis import strategies as st

import flockproof


@st.composite
def weighted(draw: st.DrawFn) -> Any:
    order = draw(st.integers(2, 6))
    pairs = [(i, j) for i in range(order) for j in range(i)]
    edges = draw(st.lists(st.sampled_from(pairs), min_size=1, unique=True))
    graph = nx.Graph()
    graph.add_nodes_from(range(order))
    graph.add_weighted_edges_from((i, j, draw(st.fractions(Fraction(1, 9), 9, max_denominator=9))) for i, j in edges)
    return graph


@settings(max_examples=30, deadline=None)
@given(weighted())
def test_all_ways_to_give_a_graph_agree(graph: Any) -> None:
    order = len(graph)
    rows: list[list[Any]] = [[0] * order for _ in range(order)]
    twin = rx.PyGraph()
    twin.add_nodes_from(range(order))
    for i, j, w in graph.edges(data="weight"):
        rows[i][j] = rows[j][i] = w
        twin.add_edge(i, j, w)
    expected = flockproof.spectrum(graph)
    assert expected == flockproof.spectrum(twin) == flockproof.spectrum(rows)
    assert (
        expected
        == flockproof.spectrum(np.array(rows, dtype=object))
        == flockproof.spectrum(nx.relabel_nodes(graph, "abcdef".__getitem__))
    )
    floats = np.array(rows, dtype=float)
    doubles = flockproof.spectrum(floats)
    assert doubles.from_floats and not expected.from_floats
    assert (
        list(doubles)
        == list(flockproof.spectrum(sp.csr_array(floats)))
        == list(flockproof.spectrum(np.asfortranarray(floats)))
    )
    assert np.allclose(np.asarray(doubles), np.linalg.eigvalsh(np.diag(floats.sum(axis=1)) - floats), atol=1e-9)


def test_directed_graphs() -> None:
    arcs = [("a", "b"), ("b", "c"), ("c", "a")]
    expected = flockproof.spectrum(np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]]), "out-degree")
    twin = rx.PyDiGraph()
    a, b, c = twin.add_nodes_from("abc")
    twin.add_edges_from([(a, b, None), (b, c, None), (c, a, None)])
    assert expected == flockproof.spectrum(nx.DiGraph(arcs), "out-degree") == flockproof.spectrum(twin, "out-degree")
    assert expected[1].imaginary is not None and complex(expected[1]).imag != 0
    with pytest.raises(TypeError, match="real"):
        float(expected[1])


def test_the_root_is_a_vertex_of_the_graph() -> None:
    star = nx.star_graph(3)
    assert flockproof.spectrum(star, "reduced", root=0) == flockproof.spectrum("star:4", "reduced", root=1)
    assert flockproof.spectrum(star, "reduced", root=2) == flockproof.spectrum("star:4", "reduced", root=2)
    with pytest.raises(ValueError, match="not a vertex"):
        flockproof.spectrum(star, "reduced", root=9)


def test_edges_are_tuples_and_rows_are_lists() -> None:
    assert flockproof.spectrum([(0, 1), (1, 2)]) == flockproof.spectrum("path:3")
    assert flockproof.spectrum([[0, 1], [1, 0]]) == flockproof.spectrum("path:2")
    for wrong, sentence in [([(1, 1)], "itself"), ([(1, 2), (2, 1)], "given twice"), ([[0, 1]], "not square")]:
        with pytest.raises(ValueError, match=sentence):
            flockproof.spectrum(wrong)


#: Who tracks whom: sharp peaks that a grid of frequencies passes over.
SEVEN = [(2, 6, 10), (3, 5, 1), (4, 7, 1), (4, 3, 100), (5, 6, 1), (5, 3, 100), (6, 4, 10), (7, 1, 100), (7, 5, 1)]
GAINS = ([-10, -1, -1, -2, -2, -2], ["-1/10", -1, "-1/100", "-1/2", "-1/10", -1])


def seven() -> Any:
    graph = nx.DiGraph()
    graph.add_nodes_from(range(1, 8))
    graph.add_weighted_edges_from(SEVEN)
    return graph


def test_peaks_on_graphs_are_those_of_their_matrices() -> None:
    found = flockproof.peak(seven(), *GAINS, leader=1, car=5, digits=8)
    assert found.frequency is not None
    assert abs(found.amplitude.mid - Fraction("168.164")) < Fraction(1, 1000)
    assert abs(found.frequency.mid - Fraction("0.0080049")) < Fraction(1, 10**6)
    # The same system by its matrices: y'' = f e + g e', e the deviation from the weighted mean of what is tracked.
    sums = {i: sum(w for k, _, w in SEVEN if k == i) for i in range(2, 8)}
    a = [[Fraction(0)] * 12 for _ in range(12)]
    b = [[Fraction(0)] * 2 for _ in range(12)]
    for k, (f, g) in enumerate(zip(*GAINS, strict=True)):
        f, g = Fraction(f), Fraction(g)
        a[2 * k][2 * k + 1] = Fraction(1)
        a[2 * k + 1][2 * k] += f
        a[2 * k + 1][2 * k + 1] += g
        for tail, head, weight in SEVEN:
            if tail != k + 2:
                continue
            share = Fraction(weight, sums[tail])
            if head == 1:
                b[2 * k + 1] = [-f * share, -g * share]
            else:
                a[2 * k + 1][2 * (head - 2)] -= f * share
                a[2 * k + 1][2 * (head - 2) + 1] -= g * share
    c = [[Fraction(int(j == 2 * 3)) for j in range(12)]]
    other = flockproof.system_peak(a, b, c, digits=8)
    assert abs(other.amplitude.mid - found.amplitude.mid) < Fraction(1, 10**5)


def test_peaks_say_what_is_wrong() -> None:
    line = [("a", "b"), ("b", "c")]
    assert flockproof.peak("path:4", -1, -1).amplitude > 1
    for sentence, call in [
        ("leader: 'x' is not a vertex", lambda: flockproof.peak(line, -1, -1, leader="x")),
        ("car: vertex 1 leads", lambda: flockproof.peak(line, -1, -1, car="a")),
        ("f must be negative", lambda: flockproof.peak(line, 1, -1)),
        ("f has 3 numbers for 2 followers", lambda: flockproof.peak(line, [-1, -1, -1], -1)),
        ("not stable", lambda: flockproof.system_peak([[1]], [[1]], [[1]])),
        ("without bound", lambda: flockproof.system_peak([[-1]], [[0, 1]], [[1]], [[0, 1]])),
        ("more than the 100", lambda: flockproof.peak("path:200", -1, -1)),
        ("A has", lambda: flockproof.system_peak([[1, 2]], [[1]], [[1]])),
    ]:
        with pytest.raises(ValueError, match=re.escape(sentence)):
            call()


def test_a_file_is_named_as_in_questions(tmp_path: Path) -> None:
    (tmp_path / "square.txt").write_text("1 2\n2 3\n3 4\n4 1\n")
    plain = flockproof.spectrum(tmp_path / "square.txt")
    named = flockproof.spectrum(f"file:{tmp_path / 'square.txt'}")
    assert [str(e.value) for e in named] == [str(e.value) for e in plain]
    with pytest.raises(ValueError, match=r"there is no file .*nowhere\.txt"):
        flockproof.spectrum(f"file:{tmp_path / 'nowhere.txt'}")


def test_a_vertex_called_leader_leads(tmp_path: Path) -> None:
    """As on the command line; other vertices have their names, or their numbers in the file."""
    path = tmp_path / "cars.txt"
    path.write_text("a b\nb leader\n")
    found = flockproof.peak(f"file:{path}", -1, -1, car="a", digits=6)
    line = flockproof.resonance(2, -1, -1, digits=6)
    assert str(found.amplitude) == str(line.amplitude)
    for leader in ("leader", 3):
        assert flockproof.peak(path, -1, -1, leader=leader, car=1, digits=6) == found
    with pytest.raises(ValueError, match="leader: 'c' is not a vertex"):
        flockproof.peak(path, -1, -1, leader="c")
