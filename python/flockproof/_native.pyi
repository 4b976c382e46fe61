import os
from collections.abc import Callable, Sequence
from typing import Any

_Ratio = tuple[int, int]
_Ends = tuple[str, str]
_Progress = Callable[[str, int, int | None], object] | None
_Matrix = tuple[int, int, list[int], int]
_Found = tuple[str, list[str], list[str], str, list[tuple[str, str]]]

__all__ = [
    "__version__",
    "campaign_merge",
    "campaign_shard",
    "campaign_size",
    "check",
    "claims",
    "command_line",
    "ergodicity",
    "explain",
    "flock_check",
    "flock_run",
    "flock_settle",
    "fuzz_summary",
    "graph_labels",
    "graph_name_problem",
    "graphs",
    "invariants",
    "judge",
    "named_files",
    "pattern",
    "peak",
    "platoon_matrices",
    "platoon_peak",
    "platoon_poles",
    "platoon_response",
    "question_needs",
    "ratio",
    "reach",
    "reach_tube",
    "read_sequence",
    "resonance",
    "simulate",
    "spectrum",
    "sweep_table",
    "system_peak",
    "theorem_1",
    "tracks",
    "verify",
]

__version__: str

def ratio(name: str, value: Any) -> _Ratio: ...
def resonance(followers: Any, f: Any, g: Any, digits: Any) -> tuple[_Ends, _Ends]: ...
def peak(
    graph: Any,
    gains: tuple[Sequence[Any], Sequence[Any]],
    vertices: tuple[Any | None, Any | None],
    digits: Any,
) -> tuple[_Ends | None, _Ends]: ...
def system_peak(matrices: tuple[Any, Any, Any, Any | None], digits: Any) -> tuple[_Ends | None, _Ends]: ...
def platoon_peak(
    followers: Any, parameters: Sequence[tuple[str, Sequence[Any]]], car: Any, digits: Any
) -> tuple[_Ends | None, _Ends]: ...
def platoon_response(
    followers: Any, parameters: Sequence[tuple[str, Sequence[Any]]], cars: Sequence[Any], frequency: Any, digits: Any
) -> list[tuple[_Ends, _Ends | None]]: ...
def platoon_matrices(
    followers: Any, parameters: Sequence[tuple[str, Sequence[Any]]], car: Any
) -> list[list[list[_Ratio]]]: ...
def platoon_poles(
    followers: Any, parameters: Sequence[tuple[str, Sequence[Any]]]
) -> list[tuple[_Ends, _Ends | None, int]]: ...
def pattern(
    particles: Any, gains: Sequence[Any], omega0: Any, spacing: Any, progress: _Progress
) -> list[tuple[int, str, int, _Ends | None, int | None]]: ...
def theorem_1(followers: int, f: Any, g: Any, digits: int) -> tuple[str, str]: ...
def graph_labels(text: str, zero_based: bool) -> list[str] | None: ...
def graph_name_problem(name: str) -> str | None: ...
def spectrum(
    graph: Any, kind: str, root: Any | None, digits: Any | None
) -> tuple[int, str, str, list[tuple[_Ends, _Ends | None, int, _Ratio | None]]]: ...
def read_sequence(text: str, normalise: bool) -> tuple[list[_Matrix], list[tuple[int, int, _Ratio]]]: ...
def ergodicity(
    matrices: Sequence[Any], progress: _Progress
) -> tuple[_Matrix, list[tuple[_Ratio, _Ratio, _Ends, str]], list[tuple[int, list[int]]]]: ...
def reach(text: str, files: dict[str, str], digits: Any, progress: _Progress) -> tuple[str, str]: ...
def reach_tube(
    text: str, files: dict[str, str], digits: Any, check: int, samples: int
) -> tuple[str, str, list[list[float]], list[list[float]]]: ...
def flock_check(text: str) -> tuple[str, int]: ...
def flock_run(
    text: str, until: Any, from_: Any, products: bool, state: bool, progress: _Progress
) -> dict[str, Any]: ...
def flock_settle(text: str, steps: Any | None, switches: Any | None, progress: _Progress) -> dict[str, Any]: ...
def simulate(text: str, files: dict[str, str], member: Any | None, progress: _Progress) -> dict[str, Any]: ...
def named_files(text: str) -> list[str]: ...
def tracks(
    text: str, source: str, chosen: dict[str, Any], null: Any, at: float | None, progress: _Progress
) -> tuple[str, list[tuple[str, bytes]]]: ...
def claims() -> list[tuple[str, str, str, str, str, str, str]]: ...
def verify(
    papers: Sequence[str],
    claims: Sequence[str],
    seed: str,
    full: bool,
    threads: Any | None,
    progress: _Progress,
) -> _Found: ...
def explain(id: str, width: int) -> str: ...
def judge(document: str, seed: str) -> _Found: ...
def question_needs(text: str, files: dict[str, str]) -> str | None: ...
def check(
    text: str,
    files: dict[str, str],
    progress: _Progress,
    functions: list[tuple[str, Any]],
    counterexamples: Any,
    tight: Any,
) -> tuple[str, str, str | None]: ...
def graphs(family: str, progress: _Progress) -> list[str]: ...
def invariants() -> list[tuple[str, str]]: ...
def campaign_size(plan: dict[str, Any]) -> tuple[str, int]: ...
def campaign_shard(
    plan: dict[str, Any],
    store: os.PathLike[str],
    index: Any,
    of: Any,
    resume: bool,
    threads: int,
    progress: _Progress,
) -> tuple[int, int]: ...
def campaign_merge(store: os.PathLike[str]) -> str: ...
def sweep_table(store: os.PathLike[str]) -> tuple[str, str, str, list[str], list[str]]: ...
def fuzz_summary(store: os.PathLike[str]) -> tuple[str, list[tuple[str, int, str | None]]]: ...
def command_line(arguments: Sequence[str]) -> int: ...
