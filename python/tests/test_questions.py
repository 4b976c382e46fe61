"""Questions: the answers of the command line, tables, campaigns, and the same bytes however they are spread."""

from __future__ import annotations

import json
import os
import pickle
import signal
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from conftest import command_line

import flockproof

FALSE: dict[str, Any] = {
    "question": {"id": "mine.regular", "statement": "A connected graph on n vertices is regular."},
    "for": {"n": "1..4", "graph": "connected(n)"},
    "holds": {"property": "min_degree = max_degree", "controls": ["min_degree > max_degree"]},
}
TRUE: dict[str, Any] = {
    "question": {"id": "mine.tree", "statement": "A tree on n vertices has n - 1 edges."},
    "for": {"n": "1..6", "graph": "trees(n)"},
    "holds": {"property": "edges = n - 1", "controls": ["edges = n"]},
}
GRAPHS: dict[str, Any] = {
    "question": {"id": "mine.graphs"},
    "for": {"n": "2..5", "graph": "connected(n)"},
    "values": {"connectivity": "lambda(2)", "density": "2*edges/(n*(n - 1))"},
}
#: Nearly a thousand members.
MANY = {**GRAPHS, "for": {**GRAPHS["for"], "n": "2..7"}}


def written(question: dict[str, Any], folder: Path) -> Path:
    from flockproof._runs import toml

    path = folder / "question.toml"
    path.write_text(toml(question))
    return path


@pytest.mark.parametrize("question", [FALSE, TRUE], ids=["false", "true"])
def test_check_answers_as_the_command_line(question: dict[str, Any], tmp_path: Path) -> None:
    path = written(question, tmp_path)
    told = json.loads(command_line("check", str(path), "--json", "--replay", str(tmp_path)).stdout)
    found = flockproof.check(question)
    assert found == flockproof.check(path) and pickle.loads(pickle.dumps(found)) == found
    assert (found.verdict, list(found.grades), found.counterexample) == (
        told["verdict"],
        told["grades"],
        told["counterexample"],
    )
    assert (found.cases, found.undecided, found.why) == (told["cases"], told["undecided"], told["why"])
    assert found.controls_refuted == told["controls"]["refuted"]
    if found.replay is not None:
        assert Path(told["replay"]).read_text() == found.replay
        again = tmp_path / "again.toml"
        again.write_text(found.replay)
        assert flockproof.check(again).verdict == "false"


def test_questions_are_refused_in_one_sentence(tmp_path: Path) -> None:
    wrong = {**TRUE, "holds": {"property": "edges = n -", "controls": ["edges = n"]}}
    with pytest.raises(ValueError) as told:
        flockproof.check(wrong)
    done = command_line("check", str(written(wrong, tmp_path)))
    assert done.returncode == 2 and not str(told.value).startswith("line") and str(told.value) in done.stderr
    assert flockproof.check({**TRUE, "holds": {"property": "edges = n - 1"}}).controls_made
    for other in (None, 3, [], b"x"):
        with pytest.raises(TypeError):
            flockproof.check(other)  # type: ignore[arg-type]


def test_a_question_may_name_files(tmp_path: Path, assets: Path) -> None:
    (tmp_path / "net.txt").write_text("1 2\n2 3\n")
    question = {
        "question": {"id": "mine.file"},
        "for": {"graph": "file:net.txt"},
        "holds": {"property": "edges = 2", "controls": ["edges = 3"]},
    }
    assert flockproof.check(written(question, tmp_path)).verdict == "holds"


def test_sweep(tmp_path: Path) -> None:
    path = written(GRAPHS, tmp_path)
    store = tmp_path / "store"
    done = command_line("sweep", str(path), "--store", str(store))
    assert done.returncode == 0, done.stderr
    table = flockproof.sweep(GRAPHS)
    assert table.to_csv() == (store / "table.csv").read_text()
    assert table.to_json_lines() == (store / "table.jsonl").read_text()
    assert table.merged == (store / "merged.jsonl").read_text()
    assert len(table) == 1 + 2 + 6 + 21
    for row in table:
        assert row["density"] * row["n"] * (row["n"] - 1) == int(row["density"] * row["n"] * (row["n"] - 1))
        assert 0 < row["connectivity"] <= row["n"]
    complete = table[-1]
    assert complete["density"] == 1 and complete["connectivity"] in (5, flockproof.Enclosure(5))
    assert pickle.loads(pickle.dumps(table)) == table
    for shards in (3, 7):
        assert flockproof.sweep(GRAPHS, shards=shards, threads=1) == table


def test_sweep_resumes(tmp_path: Path) -> None:
    class Enough(Exception):
        pass

    def stop(stage: str, done: int, total: int | None) -> None:
        raise Enough

    many = MANY
    with pytest.raises(Enough):
        flockproof.sweep(many, store=tmp_path, threads=1, progress=stop)
    with pytest.raises(ValueError, match="resume"):
        flockproof.sweep(many, store=tmp_path, threads=1)
    assert flockproof.sweep(many, store=tmp_path, resume=True).merged == flockproof.sweep(many, shards=2).merged


def test_tables_as_data(tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    table = flockproof.sweep(GRAPHS)
    frame = table.to_pandas()
    assert list(frame.columns[:2]) == ["n", "graph"] and frame["density"].dtype == float
    assert list(frame["density"]) == [float(row["density"]) for row in table]
    wide = next(k for k, row in enumerate(table) if isinstance(row["connectivity"], flockproof.Enclosure))
    assert Fraction(frame["connectivity.lo"][wide]) == table[wide]["connectivity"].lo
    table.to_parquet(tmp_path / "table.parquet")
    again = pandas.read_parquet(tmp_path / "table.parquet")
    assert list(again["connectivity"]) == list(frame["connectivity"]) and list(again.columns) == list(frame.columns)


def test_reasons_of_a_table() -> None:
    pytest.importorskip("pandas")
    platoon = {"followers": 3, "f": ["-1", "1"], "g": "-1"}
    values = {"height": "peak", "safe": "stable", "low": "stable and peak < 10"}
    table = flockproof.sweep({"question": {"id": "mine"}, "for": platoon, "values": values})
    assert table[0]["height"] > 1 and (table[0]["safe"], table[0]["low"]) == (True, True)
    assert (table[1]["height"], table[1]["safe"], table[1]["low"]) == (None, False, False)
    frame = table.to_pandas()
    assert frame["reason"][0] == "" and "negative" in frame["reason"][1]


def test_fuzz(tmp_path: Path) -> None:
    name = next(iter(flockproof.invariants()))
    store = tmp_path / "store"
    done = command_line("fuzz", name, "--cases", "40", "--seed", "s", "--store", str(store), "--json")
    told = json.loads(done.stdout)
    found = flockproof.fuzz(invariants=name, cases=40, seed="s", shards=2)
    assert (found.cases, found.failed, found.undecided) == (told["cases"], told["failed"], told["undecided"])
    command_line("fuzz", "--merge", str(store))
    assert found.merged == (store / "merged.jsonl").read_text()


def test_fuzz_finds_a_counterexample_that_check_decides() -> None:
    found = flockproof.fuzz(FALSE, cases=200)
    assert found.failed and found.failures[0].question is not None
    import tomllib

    assert flockproof.check(tomllib.loads(found.failures[0].question)).verdict == "false"


@pytest.mark.parametrize("wrong", [None, 0, -1, True, 1.5, "x", 10**30, [], {}, object()])
def test_campaigns_refuse_wrong_arguments(wrong: Any) -> None:
    for call in (
        lambda: flockproof.fuzz(TRUE, cases=wrong),
        lambda: flockproof.fuzz(TRUE, cases=1, seed=wrong),
        lambda: flockproof.fuzz(invariants=wrong if wrong not in ([], {}) else "x", cases=1),
        lambda: flockproof.sweep(wrong),
        lambda: flockproof.sweep(TRUE, shards=wrong),
        lambda: flockproof.sweep(TRUE, threads=wrong),
        lambda: flockproof.sweep(TRUE, store=wrong) if not isinstance(wrong, str) and wrong is not None else None,
        lambda: flockproof.check({**TRUE, "for": wrong}),
        lambda: flockproof.check({**TRUE, "for": {"n": wrong, "graph": "trees(3)"}}),
        lambda: flockproof.check({**TRUE, "holds": {"property": wrong, "controls": wrong}}),
    ):
        try:
            call()
        except (ValueError, TypeError, OSError) as error:
            assert str(error) and "internal error" not in str(error)


@pytest.mark.skipif(sys.platform == "win32", reason="workers are killed as on Unix")
def test_a_cluster_gives_the_same_bytes_though_a_worker_is_killed(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    many = MANY
    alone = flockproof.sweep(many)
    killed: list[int] = []
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):

        def kill_one(stage: str, done: int, total: int | None) -> None:
            if done >= 3 and not killed:
                killed.append(next(iter(client.run(os.getpid).values())))
                os.kill(killed[0], signal.SIGKILL)

        spread = flockproof.sweep(many, client, store=tmp_path / "sweep", shards=24, progress=kill_one)
        assert killed and spread.merged == alone.merged and spread.to_csv() == alone.to_csv()
        # Partial results are files of the store: what is there is not done again.
        (tmp_path / "sweep" / "shard-5-of-24.jsonl").unlink()
        with pytest.raises(ValueError, match="resume"):
            flockproof.sweep(many, client, store=tmp_path / "sweep", shards=24)
        told: list[int] = []
        again = flockproof.sweep(
            many,
            client,
            store=tmp_path / "sweep",
            shards=24,
            resume=True,
            progress=lambda stage, done, total: told.append(done),
        )
        assert told == [24] and again.merged == alone.merged
        found = flockproof.fuzz(TRUE, client, cases=300, shards=4)
        assert found.merged == flockproof.fuzz(TRUE, cases=300).merged


def test_functions_of_graphs_are_defined() -> None:
    """Exact numbers decide, floats do not; what has no value needs a guard."""
    networkx = pytest.importorskip("networkx")
    question = {
        "question": {"id": "mine.triangles"},
        "for": {"n": "2..5", "graph": "connected(n)"},
        "holds": {"property": "triangles <= edges*(n - 2)/3"},
    }

    def triangles(graph: Any) -> int:
        return sum(networkx.triangles(graph).values()) // 3

    answer = flockproof.check(question, define={"triangles": triangles}, tight=2)
    assert (answer.verdict, answer.grades, len(answer.tight)) == ("holds", ("exhaustive",), 2)
    assert answer.controls_made is not None and len(answer.controls_made) == answer.controls_total > 0
    assert answer.tight[0].names == {"n": "2", "graph": "edges:2:1-2"} and answer.tight[0].left == "0"
    floats = flockproof.check(question, define={"triangles": lambda graph: triangles(graph) / 1})
    assert (floats.verdict, floats.grades) == ("undecided", ("simulated",)) and "floating-point" in floats.why
    false = {**question, "holds": {"property": "triangles < 2"}}
    answer = flockproof.check(false, define={"triangles": triangles}, counterexamples=3)
    assert answer.verdict == "false" and len(answer.counterexamples) == 3
    assert answer.counterexamples[0].names == answer.counterexample
    texts = flockproof.check(
        {**question, "holds": {"property": "handshake"}}, define={"handshake": "sum(i, degree(i)) = 2*edges"}
    )
    assert texts.verdict == "holds"
    # Weights and loops arrive as they are.
    weighted = {"question": {"id": "mine.total"}, "for": {"graph": "edges:3:1-2*5,2-3*1/2,3-3*2"}}

    def total(graph: Any) -> Fraction:
        return Fraction(sum(data.get("weight", 1) for _, _, data in graph.edges(data=True)))

    answer = flockproof.check({**weighted, "holds": {"property": "total = 15/2"}}, define={"total": total})
    assert answer.verdict == "holds"
    assert list(flockproof.graphs("edges:3:1-2*5,2-3", edges=True)) == [(3, [(1, 2, 5), (2, 3, 1)])]
    assert next(flockproof.graphs("edges:2:1-1*1,1-2")).has_edge(1, 1)
    assert next(flockproof.graphs("platoon1:2")).is_directed()
    with pytest.raises(ValueError, match="`triangles` has no value: the function gave None"):
        flockproof.check(question, define={"triangles": lambda graph: None})
    with pytest.raises(ValueError, match="KeyError"):
        flockproof.check(question, define={"triangles": lambda graph: {}[graph]})
    with pytest.raises(TypeError, match="define"):
        flockproof.check(question, define={"triangles": 3})  # type: ignore[dict-item]
    with pytest.raises(ValueError, match="something else"):
        flockproof.check(question, define={"edges": triangles})


def test_graphs_of_a_family() -> None:
    networkx = pytest.importorskip("networkx")
    for family, numbers, count in [
        ("connected", (5,), 21),
        ("all", (5,), 34),
        ("trees", (7,), 11),
        ("bipartite", (5,), 13),
        ("planar", (5,), 33),
        ("regular", (6, 3), 2),
        ("digraphs", (3,), 16),
        ("petersen", (), 1),
    ]:
        graphs = list(flockproof.graphs(family, *numbers))
        edges = list(flockproof.graphs(family, *numbers, edges=True))
        assert len(graphs) == len(edges) == count, family
        for graph, (order, pairs) in zip(graphs, edges, strict=True):
            assert graph.is_directed() == (family == "digraphs")
            assert graph.number_of_nodes() == order and graph.number_of_edges() == len(pairs)
    assert all(networkx.is_connected(graph) for graph in flockproof.graphs("connected", 6))
    pairs = [networkx.to_graph6_bytes(graph) for graph in flockproof.graphs("connected", 6)]
    assert len(set(pairs)) == 112
    for text in ["connected(12)", "nothing", "2..3"]:
        with pytest.raises(ValueError):
            list(flockproof.graphs(text))


def test_names_of_graphs_are_those_of_the_command_line() -> None:
    for text, order in [("petersen", 10), ("edges:4:1-2,2-3", 4), ("graph6:DQc", 5), ("grid:3x4", 12)]:
        assert sum(own.multiplicity for own in flockproof.spectrum(text)) == order
    with pytest.raises(ValueError, match="petersson"):
        flockproof.spectrum("petersson")


def test_a_sweep_with_names_of_its_own() -> None:
    question = {
        "question": {"id": "mine.trees"},
        "for": {"n": "2..4", "graph": "trees(n)"},
        "values": {"twice": "2 * mine"},
    }
    table = flockproof.sweep(question, define={"mine": "lambda(2)"})
    assert [row["twice"] for row in table][:2] == [4, 2]
    with pytest.raises(TypeError, match="functions are for check"):
        flockproof.sweep(question, define={"mine": len})  # type: ignore[dict-item]


def sharp(names, property):
    return flockproof.check(
        {"question": {"id": "mine.sharp"}, "for": names, "holds": {"property": property, "controls": ["1 < 0"]}}
    )


def test_points_of_equality_and_open_parts():
    found = sharp({"x": "[-2, 2]"}, "exp(x) >= 1 + x")
    assert (found.verdict, found.attained, found.open) == ("holds", {"x": "0"}, None)
    assert sharp({"x": "[-2, 2]"}, "exp(x) >= 1000001/1000000 + x").verdict == "false"
    found = sharp({"x": "any", "y": "any"}, "x^2 + y^2 >= 2*x*y")
    assert found.verdict == "holds" and found.attained is not None
    found = sharp({"x": "[-1, 1]", "y": "[-1, 1]"}, "exp(x*y)*(2 + sin(x)) >= (1 + x*y)*(2 + sin(x))")
    assert found.verdict == "undecided" and set(found.open["boxes"][0]) == {"x", "y"}
    assert 0 <= float(found.open["share"].removeprefix("~")) <= 1
