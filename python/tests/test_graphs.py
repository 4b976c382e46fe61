"""Graphs as people have them: the same graph gives the same spectrum."""

from __future__ import annotations

from fractions import Fraction
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
