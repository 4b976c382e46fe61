"""Graphs as people have them: names, files, networkx, rustworkx, SciPy, arrays, lists of edges."""

from __future__ import annotations

import os
from collections.abc import Hashable, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from . import _native
from ._extras import needed
from ._numbers import ExactMatrix, exact_matrix, float_seen, holds_floats, over_common_denominator

#: What the native half takes: order, tails, heads, weights over a denominator; or "name", "text" or "text from 0"
#: and a text.
Native = tuple[int, list[int], list[int], list[int], int] | tuple[str, str]

#: What a text is whose vertices are counted from 1, and from 0.
TEXTS = ("text", "text from 0")

FLOATS = "the weights are floats, which stand for their exact values"


class Given:
    """A graph for the native half, with what it is called and the names of its vertices."""

    def __init__(
        self, native: Native, name: str, labels: Sequence[Hashable] | None = None, floats: bool = False
    ) -> None:
        self.native = native
        self.name = name
        self.labels = labels
        self.from_floats = (FLOATS,) if floats else ()
        if floats:
            float_seen(FLOATS)

    def root(self, root: Any, argument: str = "root") -> int | None:
        """The number of a vertex, from 1; in a file it may stand by itself."""
        if root is None or self.labels is None or (self.native[0] in TEXTS and isinstance(root, int)):
            return root  # type: ignore[no-any-return]
        try:
            return self.labels.index(root) + 1
        except ValueError:
            raise ValueError(f"{argument}: {root!r} is not a vertex of the graph") from None


def given(graph: Any, zero_based: bool = False) -> Given:
    """Reads a graph; ``zero_based`` is about the numbers of a file.

    Raises
    ------
    ValueError, TypeError
        What is no graph, with what is wrong.
    """
    if isinstance(graph, (str, os.PathLike)):
        return _named_or_file(os.fspath(graph), zero_based)
    if zero_based:
        raise ValueError("zero_based is for the numbers of a file, and graph is none")
    module = type(graph).__module__.partition(".")[0]
    if module == "rustworkx":
        return _rustworkx(graph)
    if hasattr(graph, "is_directed") and hasattr(graph, "adjacency"):
        return _networkx(graph)
    if hasattr(graph, "tocoo"):
        return _sparse(graph)
    if isinstance(graph, (list, tuple, set, frozenset)) and all(isinstance(edge, tuple) for edge in graph):
        return _edges(list(graph))
    if isinstance(graph, (list, tuple, ExactMatrix)) or hasattr(graph, "__array__"):
        return _dense(graph)
    kinds = "a name such as 'ring:12', a file, a graph of networkx or rustworkx, a matrix, or a list of edges (i, j)"
    raise TypeError(f"graph: `{str(graph)[:60]}` is none of {kinds}")


#: An edge or an arc from 1, with its weight where the graph has other ones than 1.
Edge = tuple[int, int] | tuple[int, int, int | Fraction]


def networkx_graph(order: int, edges: Sequence[Edge], directed: bool) -> Any:
    """The graph of networkx on the vertices 1 to ``order``; weights stand in ``weight``."""
    networkx = needed("networkx", "graphs")
    graph = networkx.DiGraph() if directed else networkx.Graph()
    graph.add_nodes_from(range(1, order + 1))
    for i, j, *weight in edges:
        graph.add_edge(i, j, **({"weight": weight[0]} if weight else {}))
    return graph


def read_member(text: str) -> tuple[int, list[Edge], bool]:
    """Order, edges or arcs from 1, and whether they are arcs, of graph6, ``edges:N:..`` or ``arcs:N:..``."""
    if text.startswith(("arcs:", "edges:")):
        kind, count, listed = text.split(":")
        weighted = "*" in listed

        def one(edge: str) -> Edge:
            ends, _, weight = edge.partition("*")
            i, j = (int(vertex) for vertex in ends.split("-"))
            number = Fraction(weight or 1)
            return (i, j, int(number) if number.denominator == 1 else number) if weighted else (i, j)

        return int(count), [one(edge) for edge in listed.split(",") if edge], kind == "arcs"
    sixes = [ord(sign) - 63 for sign in text]
    order, start = sixes[0], 1
    if order == 63:
        order, start = (sixes[1] << 12) + (sixes[2] << 6) + sixes[3], 4
    bits = (six >> k & 1 for six in sixes[start:] for k in range(5, -1, -1))
    pairs_of = ((i, j) for j in range(2, order + 1) for i in range(1, j))
    return order, [pair for pair, bit in zip(pairs_of, bits, strict=False) if bit], False


def _named_or_file(graph: str | bytes, zero_based: bool) -> Given:
    name = os.fsdecode(graph)
    is_file = name.startswith("file:")
    problem = None if is_file else _native.graph_name_problem(name)
    if problem is None and not is_file:
        if zero_based:
            raise ValueError(f"zero_based is for the numbers of a file, and {name} names a graph")
        return Given(("name", name), name)
    path = Path(name.removeprefix("file:"))
    if "\0" not in name and path.is_file():
        text = path.read_text(encoding="utf-8-sig")
        return Given((TEXTS[zero_based], text), name, _native.graph_labels(text, zero_based))
    if is_file:
        raise ValueError(f"graph: there is no file {path}")
    if ":" in name:
        raise ValueError(f"graph: {problem}")
    raise ValueError(f"graph: there is no file of that name, and {problem}")


def _arcs(
    order: int, edges: list[tuple[int, int, Any]], both: bool, name: str, labels: list[Hashable] | None = None
) -> Given:
    if order == 0:
        raise ValueError("graph: there is no graph in it")
    names = range(order) if labels is None else labels
    _once([(i, j) for i, j, _ in edges], both, names)
    weights, denominator = over_common_denominator([w for _, _, w in edges], "weight")
    tails = [i for i, _, _ in edges]
    heads = [j for _, j, _ in edges]
    if both:
        mirrored = [k for k, (i, j, _) in enumerate(edges) if i != j]
        # Tuples on the right: each list is extended by a part of the others as they were.
        tails, heads = tails + [heads[k] for k in mirrored], heads + [tails[k] for k in mirrored]
        weights = weights + [weights[k] for k in mirrored]
    return Given((order, tails, heads, weights, denominator), name, labels, holds_floats([w for _, _, w in edges]))


def _once(pairs: Sequence[tuple[int, int]], both: bool, names: Sequence[Hashable]) -> None:
    """Refuses an arc, or an edge in either direction, that is listed twice."""
    first: dict[tuple[int, int], int] = {}
    for number, (i, j) in enumerate(pairs, 1):
        before = first.setdefault((min(i, j), max(i, j)) if both else (i, j), number)
        if before != number:
            what = f"({names[i]}, {names[j]})"
            raise ValueError(f"graph: the edge {what} is given twice, as number {before} and number {number}")


def _networkx(graph: Any) -> Given:
    labels: list[Hashable] = list(graph.nodes)
    place = {label: k for k, label in enumerate(labels)}
    edges = [(place[u], place[v], w) for u, v, w in graph.edges(data="weight", default=1)]
    return _arcs(len(labels), edges, not graph.is_directed(), f"graph of {len(labels)} vertices", labels)


def _rustworkx(graph: Any) -> Given:
    labels: list[Hashable] = list(graph.node_indices())
    place = {label: k for k, label in enumerate(labels)}
    directed = type(graph).__name__ == "PyDiGraph"
    # Edges of rustworkx carry any object; nothing and the empty data of its generators mean 1.
    edges = [(place[u], place[v], 1 if w is None or w == {} else w) for u, v, w in graph.weighted_edge_list()]
    return _arcs(len(labels), edges, not directed, f"graph of {len(labels)} vertices", labels)


def _sparse(graph: Any) -> Given:
    if len(graph.shape) != 2 or graph.shape[0] != graph.shape[1]:
        raise ValueError(f"graph: a matrix of {' x '.join(map(str, graph.shape))} is not square")
    entries = graph.tocoo()
    order = int(graph.shape[0])
    if order == 0:
        raise ValueError("graph: there is no graph in it")
    _once(list(zip(entries.row.tolist(), entries.col.tolist(), strict=True)), False, range(1, order + 1))
    weights, denominator = over_common_denominator(entries.data, "weight")
    native = (order, entries.row.tolist(), entries.col.tolist(), weights, denominator)
    return Given(native, f"matrix of {order} x {order}", None, holds_floats(entries.data))


def _dense(graph: Any) -> Given:
    matrix = exact_matrix(graph, "graph")
    rows, columns = matrix.shape
    if rows != columns:
        raise ValueError(f"graph: a matrix of {rows} x {columns} is not square")
    places = [k for k, weight in enumerate(matrix.numerators) if weight]
    weights = [matrix.numerators[k] for k in places]
    native = (rows, [k // rows for k in places], [k % rows for k in places], weights, matrix.denominator)
    return Given(native, f"matrix of {rows} x {rows}", None, bool(matrix.from_floats))


def _edges(edges: list[tuple[Any, ...]]) -> Given:
    place: dict[Hashable, int] = {}
    read = []
    for edge in edges:
        if len(edge) not in (2, 3):
            raise ValueError(f"graph: an edge (i, j) or (i, j, weight) is expected, but it is `{str(edge)[:60]}`")
        i, j = (place.setdefault(label, len(place)) for label in edge[:2])
        if i == j:
            raise ValueError(f"graph: the edge from vertex {edge[0]} to itself is not allowed")
        read.append((i, j, edge[2] if len(edge) == 3 else 1))
    return _arcs(len(place), read, True, f"graph of {len(place)} vertices", list(place))
