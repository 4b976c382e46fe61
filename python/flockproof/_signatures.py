"""Signatures as ``help`` shows them: types as they are written, and what abbreviations of the sources stand for."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Mapping
from typing import Any

#: Shorter ones may stand in the meaning of those below them.
_MEANINGS = {
    "Number": "int | Fraction | Decimal | str | float",
    "Numbers": "int | Fraction | Decimal | str | float | Iterable[int | Fraction | Decimal | str | float] | None",
    "Question": "Mapping[str, Any] | str | os.PathLike[str]",
    "System": "Mapping[str, Any] | str | os.PathLike[str]",
    "Progress": "Callable[[str, int, int | None], object] | bool | None",
    "Pair": "tuple[int, int]",
    "Array": "numpy.ndarray",
    "npt.NDArray": "numpy.ndarray",
    "np.ndarray": "numpy.ndarray",
    "np.float64": "numpy.float64",
    "np.bool_": "numpy.bool",
    "npt.ArrayLike": "numpy.typing.ArrayLike",
    "st.SearchStrategy": "SearchStrategy",
}
_ABBREVIATION = re.compile(r"(?<![\w.])(" + "|".join(map(re.escape, _MEANINGS)) + r")\b")


class _Written(str):
    """A type as it is written; it shows itself without the quotes of a text."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


def readable(module: Mapping[str, Any], names: Iterable[str]) -> None:
    """Gives the functions of a module with these names, and the methods of its classes, signatures that can be read."""
    for name in names:
        thing = module[name]
        for one in vars(thing).values() if inspect.isclass(thing) else [thing]:
            bare = one.__func__ if isinstance(one, (classmethod, staticmethod)) else one
            if inspect.isfunction(bare):
                _rewrite(bare)


def _rewrite(function: Any) -> None:
    found = inspect.signature(function)
    parameters = [one.replace(annotation=_written(one.annotation)) for one in found.parameters.values()]
    function.__signature__ = found.replace(parameters=parameters, return_annotation=_written(found.return_annotation))


def _written(annotation: Any) -> Any:
    if annotation is inspect.Signature.empty:
        return annotation
    # Strategies of Hypothesis carry types that they have made of texts.
    text = annotation if isinstance(annotation, str) else inspect.formatannotation(annotation)
    text = re.sub(r"ForwardRef\('(.*?)'[^)]*\)", r"\1", text).replace("hypothesis.strategies.", "st.")
    return _Written(_ABBREVIATION.sub(lambda found: _MEANINGS[found[1]], text))
