"""Laws of one's own: from texts, or from Python functions of symbolic agents."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ._progress import Progress
from ._signatures import readable

__all__ = [
    "Agent",
    "Expression",
    "Law",
    "choose",
    "count",
    "cross",
    "dot",
    "heading",
    "largest",
    "mean",
    "norm",
    "norm2",
    "normal",
    "smallest",
    "total",
    "turn",
    "uniform",
    "unit",
    "vector",
]


def __dir__() -> list[str]:
    return sorted(__all__)


_NAMES = "ijklmnpqrsuvwxyz"
_UFUNCS = {"sqrt": "sqrt", "exp": "exp", "log": "log", "sin": "sin", "cos": "cos", "absolute": "abs"}
_BINARY = {"add": "+", "subtract": "-", "multiply": "*", "divide": "/", "true_divide": "/", "power": "^"}


class Expression:
    """An expression of a law: operators, comparisons and NumPy functions make larger ones.

    Parameters
    ----------
    text
        The expression in the language of laws.
    """

    __array_priority__ = 1000
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, text: str) -> None:
        self.text = text

    def __repr__(self) -> str:
        return self.text

    def __bool__(self) -> bool:
        told = "use flockproof.law.choose(condition, a, b)"
        raise TypeError(f"`{self.text}` has no truth value while a law is traced: {told}")

    def __iter__(self) -> Any:
        raise TypeError(f"`{self.text}` cannot be taken apart while a law is traced: components are e[0], e[1]")

    def __float__(self) -> float:
        told = "use NumPy's functions or those of flockproof.law"
        raise TypeError(f"`{self.text}` is no number while a law is traced: {told}")

    def _with(self, other: Any, sign: str, turned: bool = False) -> Expression:
        first, second = (_text(other), self.text) if turned else (self.text, _text(other))
        return Expression(f"({first} {sign} {second})")

    def __add__(self, other: Any) -> Expression:
        return self._with(other, "+")

    def __radd__(self, other: Any) -> Expression:
        return self._with(other, "+", True)

    def __sub__(self, other: Any) -> Expression:
        return self._with(other, "-")

    def __rsub__(self, other: Any) -> Expression:
        return self._with(other, "-", True)

    def __mul__(self, other: Any) -> Expression:
        return self._with(other, "*")

    def __rmul__(self, other: Any) -> Expression:
        return self._with(other, "*", True)

    def __truediv__(self, other: Any) -> Expression:
        return self._with(other, "/")

    def __rtruediv__(self, other: Any) -> Expression:
        return self._with(other, "/", True)

    def __pow__(self, other: Any) -> Expression:
        return self._with(other, "^")

    def __rpow__(self, other: Any) -> Expression:
        return self._with(other, "^", True)

    def __neg__(self) -> Expression:
        return Expression(f"(-{self.text})")

    def __abs__(self) -> Expression:
        return _called("abs", self)

    def __lt__(self, other: Any) -> Expression:
        return self._with(other, "<")

    def __le__(self, other: Any) -> Expression:
        return self._with(other, "<=")

    def __gt__(self, other: Any) -> Expression:
        return self._with(other, ">")

    def __ge__(self, other: Any) -> Expression:
        return self._with(other, ">=")

    def __eq__(self, other: Any) -> Expression:  # type: ignore[override]
        return self._with(other, "=")

    def __ne__(self, other: Any) -> Expression:  # type: ignore[override]
        return self._with(other, "!=")

    def __and__(self, other: Any) -> Expression:
        return self._with(other, "and")

    def __or__(self, other: Any) -> Expression:
        return self._with(other, "or")

    def __invert__(self) -> Expression:
        return Expression(f"(not {self.text})")

    def __getitem__(self, index: int) -> Expression:
        if not re.fullmatch(r"\w+\[\w+\]", self.text):
            raise TypeError(f"only parts of the state have components, and `{self.text}` is none")
        return Expression(f"{self.text}.{index + 1}")

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Expression:
        name = ufunc.__name__
        if method == "__call__" and not options:
            if name in _UFUNCS and len(inputs) == 1:
                return _called(_UFUNCS[name], *inputs)
            if name in _BINARY and len(inputs) == 2:
                return Expression(f"({_text(inputs[0])} {_BINARY[name]} {_text(inputs[1])})")
            if name in ("maximum", "minimum") and len(inputs) == 2:
                return _called("max" if name == "maximum" else "min", *inputs)
            if name == "negative":
                return Expression(f"(-{_text(inputs[0])})")
        known = ", ".join(sorted(_UFUNCS))
        raise TypeError(f"numpy.{name} is not a function of laws; there are {known}, maximum, minimum")


def _text(value: Any) -> str:
    if isinstance(value, Expression):
        return value.text
    if isinstance(value, bool) or (not hasattr(value, "__index__") and not hasattr(value, "as_integer_ratio")):
        raise TypeError(f"`{str(value)[:60]}` is no expression of a law and no number")
    numerator, denominator = value.as_integer_ratio()
    return f"{numerator}" if denominator == 1 else f"({numerator}/{denominator})"


def _called(name: str, *arguments: Any) -> Expression:
    return Expression(f"{name}({', '.join(_text(argument) for argument in arguments)})")


def norm(a: Any) -> Expression:
    """The length of a vector."""
    return _called("norm", a)


def norm2(a: Any) -> Expression:
    """The square of the length of a vector."""
    return _called("norm2", a)


def unit(a: Any) -> Expression:
    """A vector divided by its length."""
    return _called("unit", a)


def dot(a: Any, b: Any) -> Expression:
    """The scalar product."""
    return _called("dot", a, b)


def cross(a: Any, b: Any) -> Expression:
    """The vector product; in the plane a number."""
    return _called("cross", a, b)


def turn(a: Any, angle: Any) -> Expression:
    """A vector of the plane, turned by an angle in radians."""
    return _called("turn", a, angle)


def heading(a: Any) -> Expression:
    """The angle of a vector of the plane in radians, in (-pi, pi]."""
    return _called("heading", a)


def vector(*numbers: Any) -> Expression:
    """The vector with these numbers."""
    return _called("vector", *numbers)


def choose(condition: Any, a: Any, b: Any) -> Expression:
    """The first where the condition holds, the second elsewhere."""
    return _called("if", condition, a, b)


def normal(sigma: Any) -> Expression:
    """A normal number of mean 0, drawn for the agent and the step; in discrete time."""
    return _called("normal", sigma)


def uniform(a: Any, b: Any) -> Expression:
    """A number between two, drawn for the agent and the step; in discrete time."""
    return _called("uniform", a, b)


class Agent:
    """A symbolic agent: its parts of the state and parameters are attributes."""

    def __init__(self, name: str, law: _Tracing) -> None:
        self._name, self._law = name, law

    def __getattr__(self, part: str) -> Expression:
        if part.startswith("__"):
            raise AttributeError(part)
        if part in self._law.lists:
            return Expression(f"{part}[{self._name}]")
        if part in self._law.parameters:
            return Expression(part)
        if part not in self._law.state:
            known = ", ".join([*self._law.state, *self._law.parameters])
            raise AttributeError(f"an agent has no {part}; it has {known}")
        return Expression(f"{part}[{self._name}]")


class _Tracing:
    """What is known while functions are traced, and the agents that are bound."""

    def __init__(self, state: Mapping[str, str], parameters: Mapping[str, Any]) -> None:
        self.state, self.parameters = state, parameters
        several = [isinstance(value, Sequence) and not isinstance(value, str) for value in parameters.values()]
        self.lists = [name for name, is_list in zip(parameters, several, strict=True) if is_list]
        self.bound: list[str] = []

    def agent(self) -> Agent:
        names = [name for name in _NAMES if name not in self.state and name not in self.parameters]
        name = names[len(self.bound)]
        self.bound.append(name)
        return Agent(name, self)


_open: list[_Tracing] = []


def _gathered(word: str, function: Callable[[Agent], Any], where: Callable[[Agent], Any] | None) -> Expression:
    if not _open:
        raise TypeError(f"flockproof.law.{word} is for functions that a Law traces")
    tracing = _open[-1]
    agent = tracing.agent()
    condition = f" where {_text(where(agent))}" if where is not None else ""
    body = _text(function(agent))
    tracing.bound.pop()
    return Expression(f"{word}({agent._name}{condition}, {body})")


def total(function: Callable[[Agent], Any], where: Callable[[Agent], Any] | None = None) -> Expression:
    """The sum over those whom the agent hears; over all agents in an observable."""
    return _gathered("sum", function, where)


def mean(function: Callable[[Agent], Any], where: Callable[[Agent], Any] | None = None) -> Expression:
    """The mean over those whom the agent hears; over all agents in an observable; 0 over none."""
    return _gathered("mean", function, where)


def largest(function: Callable[[Agent], Any], where: Callable[[Agent], Any] | None = None) -> Expression:
    """The largest value over those whom the agent hears."""
    return _gathered("max", function, where)


def smallest(function: Callable[[Agent], Any], where: Callable[[Agent], Any] | None = None) -> Expression:
    """The smallest value over those whom the agent hears."""
    return _gathered("min", function, where)


def count(condition: Callable[[Agent], Any]) -> Expression:
    """How many of those whom the agent hears satisfy a condition."""
    return _gathered("count", condition, None)


class Law:
    """A law of one's own.

    Parameters
    ----------
    state
        What each agent has: ``{"x": "vector", "v": "vector"}``; also ``"number"`` and ``"angle"`` (radians).
    rates
        Of each part of the state its rate of change, in continuous time: a text, or a function of an agent.
    next
        The same in discrete time: the next value.
    parameters
        Exact numbers; a list has one value for each agent.
    define
        Abbreviations: ``{"weight(i, j)": "K / (1 + norm2(x[j] - x[i]))^beta"}``.
    observables
        Of the flock: texts, or functions without arguments.
    noise
        In continuous time the strength of the noise of parts of the state.
    name, dimension, position, step, seed
        As in the table ``[law]`` of a file; ``notes/laws.md`` tells them.

    Examples
    --------
    >>> law = Law(
    ...     state={"x": "vector", "v": "vector"},
    ...     parameters={"K": 1},
    ...     rates={"x": "v", "v": lambda i: mean(lambda j: i.K / (1 + norm2(j.x - i.x)) * (j.v - i.v))},
    ... )
    >>> print(law.rates["v"])
    mean(j, ((K / (1 + norm2((x[j] - x[i])))) * (v[j] - v[i])))
    """

    def __init__(
        self,
        *,
        state: Mapping[str, str],
        rates: Mapping[str, Any] | None = None,
        next: Mapping[str, Any] | None = None,
        parameters: Mapping[str, Any] | None = None,
        define: Mapping[str, str] | None = None,
        observables: Mapping[str, Any] | None = None,
        noise: Mapping[str, Any] | None = None,
        name: str | None = None,
        dimension: int = 2,
        position: str | None = None,
        step: Any = None,
        seed: int | None = None,
    ) -> None:
        if (rates is None) == (next is None):
            raise ValueError("a law has `rates` in continuous time, or `next` in discrete time")
        self.state, self.parameters = dict(state), dict(parameters or {})
        self.time = "continuous" if next is None else "discrete"
        self.rates = {key: self._traced(key, rate, 1) for key, rate in (rates or next or {}).items()}
        self.define = dict(define or {})
        self.observables = {key: self._traced(key, value, 0) for key, value in (observables or {}).items()}
        self.noise = {key: self._traced(key, value, 1) for key, value in (noise or {}).items()}
        self.name, self.dimension, self.position, self.step, self.seed = name, dimension, position, step, seed

    def _traced(self, key: str, value: Any, agents: int) -> str:
        if isinstance(value, str):
            return value
        if not callable(value):
            return _text(value)
        tracing = _Tracing(self.state, self.parameters)
        _open.append(tracing)
        try:
            return _text(value(*(tracing.agent() for _ in range(agents))))
        except (TypeError, AttributeError) as error:
            raise type(error)(f"{key}: {error}{_line_of(error)}") from None
        finally:
            _open.pop()

    def table(self) -> dict[str, Any]:
        """The table ``[law]`` of a scenario."""
        parts: dict[str, Any] = {"name": self.name, "time": self.time, "dimension": self.dimension}
        parts |= {"position": self.position, "step": self.step, "seed": self.seed, "state": self.state}
        parts |= {"parameters": self.parameters, "define": self.define}
        parts |= {"rates" if self.time == "continuous" else "next": self.rates}
        parts |= {"noise": self.noise, "observables": self.observables}
        return {key: value for key, value in parts.items() if value is not None and value != {}}

    def to_toml(self) -> str:
        """The law as a file."""
        from ._runs import toml

        # A bare name: scenarios take the tables of `law` by their headers.
        return toml({"law": self.table()}).replace('["law"', "[law")

    def simulate(self, scenario: Mapping[str, Any], progress: Progress = None, *, member: int | None = None) -> Any:
        """Simulate the law: a scenario without ``model`` and ``law``."""
        from ._runs import simulate

        return simulate({"model": "own", **scenario, "law": self.table()}, progress, member=member)

    def check(self, question: Mapping[str, Any], progress: Progress = None) -> Any:
        """Decide a statement about all states: a question without ``law``."""
        from ._questions import check

        return check(self._asked(question), progress)

    def sweep(self, question: Mapping[str, Any], client: Any = None, **options: Any) -> Any:
        """A table of quantities over the states of the law: a question without ``law``, as for ``flockproof.sweep``."""
        from ._questions import sweep

        return sweep(self._asked(question), client, **options)

    def fuzz(self, question: Mapping[str, Any], client: Any = None, **options: Any) -> Any:
        """Attack a statement about all states: a question without ``law``, as for ``fuzz``."""
        from ._questions import fuzz

        return fuzz(self._asked(question), client, **options)

    def _asked(self, question: Mapping[str, Any]) -> dict[str, Any]:
        return {**question, "question": {**question["question"], "law": self}}

    def __repr__(self) -> str:
        sign = "d{}/dt" if self.time == "continuous" else "{}(t + step)"
        return "\n".join(f"{sign.format(key)} = {rate}" for key, rate in self.rates.items())

    def _repr_latex_(self) -> str:
        left = r"\dot {}_i" if self.time == "continuous" else "{}_i(t + 1)"
        lines = [left.replace("{}", _symbol(key)) + " &= " + latex(rate) for key, rate in self.rates.items()]
        return r"$$\begin{aligned}" + r" \\ ".join(lines) + r"\end{aligned}$$"


def _line_of(error: BaseException) -> str:
    """Where in the traced function something went wrong."""
    if error.__traceback__ is None:
        return ""
    frames = [frame for frame in inspect.getinnerframes(error.__traceback__) if frame.filename != __file__]
    return f" (line {frames[-1].lineno} of {frames[-1].filename})" if frames else ""


_LETTERS = "alpha beta gamma delta epsilon eta theta kappa lambda mu nu omega phi psi rho sigma tau pi"
_GREEK = set(_LETTERS.split())
_COMPARED = {ast.Lt: "<", ast.LtE: r"\le", ast.Gt: ">", ast.GtE: r"\ge", ast.Eq: "=", ast.NotEq: r"\ne"}


def _symbol(name: str) -> str:
    if name in _GREEK:
        return "\\" + name
    return name if len(name) == 1 else rf"\mathrm{{{name}}}".replace("_", r"\_")


def latex(text: str) -> str:
    r"""An expression of a law in LaTeX.

    Examples
    --------
    >>> print(latex("K / (1 + norm2(x[j] - x))^beta"))
    \frac{K}{\left(1 + \left|x_{j} - x_{i}\right|^{2}\right)^{\beta}}
    """
    # Components such as x[j].1 are attributes that Python can read.
    python = re.sub(r"\]\.(\d+)", r"]._\1", text)
    python = python.replace("^", "**").replace(" where ", ", __where__, ")
    python = re.sub(r"(?<![<>!=])=(?!=)", "==", python)
    python = re.sub(r"\bif\(", "if_(", python)
    try:
        return _latex(ast.parse(python, mode="eval").body, 0)
    except SyntaxError:
        return rf"\mathtt{{{text}}}"


def _latex(node: ast.AST, level: int) -> str:
    def bracketed(inner: str, own: int) -> str:
        return rf"\left({inner}\right)" if own < level else inner

    if isinstance(node, ast.Constant):
        return str(node.value)
    if isinstance(node, ast.Name):
        return _symbol(node.id) + ("_{i}" if len(node.id) == 1 and node.id in "xvqp" else "")
    if isinstance(node, ast.Subscript):
        return f"{_latex(node.value, 9).removesuffix('_{i}')}_{{{_latex(node.slice, 0)}}}"
    if isinstance(node, ast.Attribute):
        return f"({_latex(node.value, 9)})_{{{node.attr.lstrip('_')}}}"
    if isinstance(node, ast.UnaryOp):
        sign = r"\lnot " if isinstance(node.op, ast.Not) else "-"
        return bracketed(sign + _latex(node.operand, 3), 2)
    if isinstance(node, ast.BinOp):
        if isinstance(node.op, ast.Div):
            return rf"\frac{{{_latex(node.left, 0)}}}{{{_latex(node.right, 0)}}}"
        if isinstance(node.op, ast.Pow):
            return f"{_latex(node.left, 9)}^{{{_latex(node.right, 0)}}}"
        if isinstance(node.op, ast.Mult):
            return bracketed(rf"{_latex(node.left, 3)} \, {_latex(node.right, 3)}", 3)
        sign, right = ("+", 1) if isinstance(node.op, ast.Add) else ("-", 2)
        return bracketed(f"{_latex(node.left, 1)} {sign} {_latex(node.right, right)}", 1)
    if isinstance(node, ast.Compare):
        parts = [_latex(node.left, 1)]
        for op, other in zip(node.ops, node.comparators, strict=True):
            parts += [_COMPARED.get(type(op), "?"), _latex(other, 1)]
        return bracketed(" ".join(parts), 0)
    if isinstance(node, ast.BoolOp):
        sign = r" \land " if isinstance(node.op, ast.And) else r" \lor "
        return bracketed(sign.join(_latex(value, 1) for value in node.values), 0)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return _latex_call(node.func.id, node.args)
    return r"\mathtt{" + ast.unparse(node) + "}"


def _latex_call(name: str, arguments: list[ast.expr]) -> str:
    inner = [_latex(argument, 0) for argument in arguments]
    if name in ("sum", "mean", "max", "min", "count") and arguments and isinstance(arguments[0], ast.Name):
        sign = {"sum": r"\sum", "mean": r"\operatorname*{mean}", "max": r"\max", "min": r"\min", "count": r"\#"}[name]
        filtered = len(arguments) > 2 and isinstance(arguments[1], ast.Name) and arguments[1].id == "__where__"
        under = arguments[0].id + (rf":\, {inner[2]}" if filtered else "")
        return rf"{sign}_{{{under}}} " + (_latex(arguments[-1], 2) if len(arguments) > 1 else "")
    if name in ("norm", "norm2", "abs") and len(inner) == 1:
        return rf"\left|{inner[0]}\right|" + ("^{2}" if name == "norm2" else "")
    if name == "sqrt" and len(inner) == 1:
        return rf"\sqrt{{{inner[0]}}}"
    if name == "dot" and len(inner) == 2:
        return rf"{_latex(arguments[0], 3)} \cdot {_latex(arguments[1], 3)}"
    if name == "if_" and len(inner) == 3:
        return rf"\begin{{cases}} {inner[1]} & {inner[0]} \\ {inner[2]} & \text{{else}} \end{{cases}}"
    known = rf"\{name}" if name in ("sin", "cos", "exp", "log") else rf"\mathrm{{{name}}}".replace("_", r"\_")
    return rf"{known}\left({', '.join(inner)}\right)"


readable(globals(), __all__)
