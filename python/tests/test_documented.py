"""Every public name says what it takes and gives, what is wrong input, and where it comes from."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from typing import Any

import pytest

import flockproof
from flockproof import claims, law, plot, strategies

MODULES = [flockproof, claims, strategies, plot]


def public() -> Iterator[tuple[str, Any]]:
    for module in MODULES:
        for name in module.__all__:
            yield f"{module.__name__}.{name}", getattr(module, name)


CALLABLES = {name: thing for name, thing in public() if callable(thing)}
FUNCTIONS = {name: thing for name, thing in CALLABLES.items() if not inspect.isclass(thing)}


@pytest.mark.parametrize("module", [claims, law, plot, strategies], ids=lambda module: module.__name__)
def test_only_what_is_described_is_public(module: Any) -> None:
    assert dir(module) == sorted(module.__all__)


def signatures() -> Iterator[tuple[str, inspect.Signature]]:
    functions = [(f"flockproof.law.{name}", getattr(law, name)) for name in law.__all__]
    for name, thing in [*CALLABLES.items(), *functions]:
        # Texts and errors have none of their own.
        if not (inspect.isclass(thing) and issubclass(thing, (str, Exception))):
            yield name, inspect.signature(thing)
        for attribute, value in vars(thing).items() if inspect.isclass(thing) else ():
            bare = value.__func__ if isinstance(value, (classmethod, staticmethod)) else value
            if inspect.isfunction(bare) and not attribute.startswith("_"):
                yield f"{name}.{attribute}", inspect.signature(bare)


#: What may stand in a signature besides this package's own names.
WORDS = """
    Any Axes Callable DataFrame Decimal Fraction Generic Iterable Iterator Mapping None PathLike Random SearchStrategy
    Literal Sequence V bool bytes complex dict float float64 int list ndarray numpy object os pandas set str tuple
""".split()


@pytest.mark.parametrize(("name", "signature"), [pytest.param(*both, id=both[0]) for both in signatures()])
def test_help_says_types_that_a_reader_knows(name: str, signature: inspect.Signature) -> None:
    named = {word for module in [*MODULES, law] for word in module.__all__}
    types = [one.annotation for one in signature.parameters.values()] + [signature.return_annotation]
    for said in [repr(one) for one in types if one is not inspect.Signature.empty]:
        assert "'" not in said or "Literal" in said, said
        # Outcomes and agents are made by others, of what is private.
        words = set(re.findall(r"[A-Za-z_]\w*", re.sub(r"'.*?'", "", said)))
        unknown = words - set(WORDS) - named - {"_Evidence", "_Tracing"}
        assert not unknown, f"{name}: {said}: {unknown}"


def section(doc: str, title: str) -> str:
    """A section of a docstring in NumPy style; empty where there is none."""
    found = re.search(rf"^{title}\n-+\n(.*?)(?=^\w[^\n]*\n-+\n|\Z)", doc, re.MULTILINE | re.DOTALL)
    return found[1] if found else ""


def explained(doc: str) -> set[str]:
    """The names of the section of parameters."""
    rows = re.findall(r"^(\w[\w, ]*?)(?: :.*)?$", section(doc, "Parameters"), re.MULTILINE)
    return {name for row in rows for name in row.split(", ")}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_name_their_arguments(name: str) -> None:
    doc = inspect.getdoc(FUNCTIONS[name]) or ""
    if name.endswith((".every", ".some")):
        assert doc
        return
    wanted = set(inspect.signature(FUNCTIONS[name]).parameters) - {"draw"}
    assert wanted <= explained(doc), f"{name}: {wanted - explained(doc)}"
    # Strategies are drawn from, and say in their first lines what comes.
    if not name.startswith("flockproof.strategies"):
        assert section(doc, "Returns") or name == "flockproof.exact", name


#: Those that take anything that could be wrong.
CAREFUL = [
    name for name in FUNCTIONS if name.count(".") == 1 and name not in ("flockproof.ledger", "flockproof.invariants")
]


@pytest.mark.parametrize("name", CAREFUL)
def test_functions_say_what_is_refused(name: str) -> None:
    assert "Error" in section(inspect.getdoc(FUNCTIONS[name]) or "", "Raises"), name


@pytest.mark.parametrize("name", CALLABLES)
def test_everything_is_described(name: str) -> None:
    thing = CALLABLES[name]
    assert len(inspect.getdoc(thing) or "") > 10, name
    for attribute, value in vars(thing).items() if inspect.isclass(thing) else ():
        bare = value.__func__ if isinstance(value, (classmethod, staticmethod)) else value
        if not attribute.startswith("_") and (inspect.isfunction(bare) or isinstance(bare, property)):
            assert inspect.getdoc(bare), f"{name}.{attribute}"
