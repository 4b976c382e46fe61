"""Laws of one's own: from texts and from Python functions, as files, in simulations and questions."""

import flockproof
import numpy as np
import pytest
from flockproof import Law
from flockproof.claims import claim, verify
from flockproof.law import mean, norm2, total


def cucker_smale(traced: bool) -> Law:
    if traced:
        rates = {"x": lambda i: i.v, "v": lambda i: mean(lambda j: i.K / np.sqrt(1 + norm2(j.x - i.x)) * (j.v - i.v))}
        observables = {"momentum": lambda: total(lambda i: i.v)}
    else:
        rates = {"x": "v", "v": "mean(j, K/sqrt(1 + norm2(x[j] - x)) * (v[j] - v))"}
        observables = {"momentum": "sum(i, v[i])"}
    return Law(state={"x": "vector", "v": "vector"}, parameters={"K": 1}, rates=rates, observables=observables)


RUN = {
    "state": {"x": [[0, 0], [1, 0], [0, 2]], "v": [[1, 0], [0, 1], [0, 0]]},
    "run": {"until": 2, "samples": [2]},
}


def test_functions_are_the_same_law_as_texts(tmp_path):
    runs = [cucker_smale(traced).simulate(RUN) for traced in (True, False)]
    np.testing.assert_array_equal(runs[0].states["v"], runs[1].states["v"])
    (tmp_path / "law.toml").write_text(cucker_smale(True).to_toml())
    (tmp_path / "run.toml").write_text(
        'model = "own"\nlaw = "law.toml"\n[state]\nx = [[0, 0], [1, 0], [0, 2]]\nv = [[1, 0], [0, 1], [0, 0]]\n'
        "[run]\nuntil = 2\nsamples = [2]\n"
    )
    run = flockproof.simulate(tmp_path / "run.toml")
    np.testing.assert_array_equal(run.states["v"], runs[0].states["v"])


def test_all_states():
    answer = cucker_smale(True).check(
        {
            "question": {"id": "mine.momentum"},
            "for": {"agents": "2..3", "x": "any", "v": "any"},
            "holds": {"property": "rate(momentum) = 0", "controls": ["rate(momentum) = v[1]"]},
        }
    )
    assert (answer.verdict, answer.grades) == ("holds", ("identity",))


@pytest.mark.parametrize(
    ("rate", "told"),
    [
        (lambda i: i.y, "an agent has no y"),
        (lambda i: np.tan(i.x), "numpy.tan is not a function of laws"),
        (lambda i: i.v if i.x[0] > 0 else 0, "no truth value"),
    ],
)
def test_what_cannot_be_traced_says_where(rate, told):
    with pytest.raises((TypeError, AttributeError), match=told) as found:
        Law(state={"x": "vector", "v": "vector"}, rates={"x": "v", "v": rate})
    assert "test_laws.py" in str(found.value) and "line" in str(found.value)


def test_latex():
    assert r"\dot v_i" in cucker_smale(False)._repr_latex_()


def question(property, **family):
    states = {"x": "any", "v": "any", **family}
    controls = ["rate(momentum) = v[1]"]
    return {"question": {"id": "mine.law"}, "for": states, "holds": {"property": property, "controls": controls}}


def test_flocks_of_every_size():
    answer = cucker_smale(False).check(question("rate(momentum) = 0", agents="any"))
    assert answer.verdict == "holds"
    assert "every number of agents" in answer.why


def test_sweeps_and_attacks():
    law = cucker_smale(True)
    table = law.sweep(question("rate(momentum) = 0", agents="2..4"), threads=1)
    assert len(table) == 3
    attacked = law.fuzz(question("rate(momentum.1) <= 0", agents="2..4", graph="path(agents)"), cases=4, threads=1)
    assert attacked.failed > 0
    assert attacked.failures[0].question is not None


def test_attained_inequalities_of_all_states_and_of_boxes_of_starts(tmp_path):
    # The rate is 0 where all velocities are equal.
    law = cucker_smale(True)
    falls = "rate(sum(i, norm2(v[i]))) <= 0"
    for agents in ("2", "3"):
        assert law.check(question(falls, agents=agents)).verdict == "holds"
    grows = law.check(question(falls.replace("<= 0", ">= 0"), agents="2"))
    assert grows.verdict == "false" and grows.counterexample
    (tmp_path / "averaging.toml").write_text(
        'model = "own"\n[law]\nname = "averaging"\ndimension = 1\nstate = { x = "number" }\n[law.rates]\n'
        'x = "sum(j, x[j] - x)"\n[law.observables]\nspread = "sum(i, (x[i] - mean(k, x[k]))^2)"\n'
        '[graph]\nkind = "complete"\n[state]\nx = [0, 1, 3]\n[run]\nuntil = 2\n'
    )

    def starts(property):
        path = tmp_path / "starts.toml"
        path.write_text(
            '[question]\nid = "mine.starts"\nscenario = "averaging.toml"\n[for]\n"state.x[1]" = "[-1/2, 1/2]"\n'
            f'[holds]\nproperty = "always[0, 2]({property})"\ncontrols = ["0 = 1"]\n'
        )
        return flockproof.check(path).verdict

    assert starts("spread <= initial(spread)") == "holds"
    assert starts("spread <= initial(spread) - 1/1000000") == "false"


def test_latex_of_a_law():
    assert r"\dot v_i" in cucker_smale(False)._repr_latex_()


def conserving() -> Law:
    """Two agents that draw each other along, with a momentum."""
    return Law(
        state={"v": "number"},
        rates={"v": lambda i: total(lambda j: j.v - i.v)},
        observables={"momentum": lambda: total(lambda i: i.v)},
    )


def all_velocities(law: Law, property: str) -> dict[str, object]:
    """A question about every state of three agents."""
    head = {"id": "mine.law", "law": law}
    return {"question": head, "for": {"agents": 3, "v": "any"}, "holds": {"property": property}}


def test_claims_over_own_laws():
    @claim(
        "mine.momentum",
        "The momentum of three agents is conserved, and no square of a velocity grows.",
        clauses=["The momentum is conserved.", "The sum of squares does not grow."],
        printed=conserving(),
        controls={
            "agents alone": Law(
                state={"v": "number"}, rates={"v": "v - v^3"}, observables={"momentum": "sum(i, v[i])"}
            )
        },
    )
    def momentum(law, run):
        "Terms of a pair cancel."
        return run.all(
            run.question("momentum", all_velocities(law, "rate(momentum) = 0"), clauses=[1], scope="all"),
            run.question("squares", all_velocities(law, "rate(sum(i, v[i]^2)) <= 0"), clauses=[2], scope="all"),
        )

    report = verify(momentum)
    entry = report["mine.momentum"]
    assert entry.verdict == "holds", report
    assert report.as_recorded, report.differences
    assert "identity" in entry.grades
    assert all(evidence.scope == "all" for evidence in entry.evidence)
    assert entry.controls.failed[0].startswith("momentum: ")


def test_a_claim_that_a_law_refutes():
    @claim("mine.rest", "Nobody's velocity changes.", printed="rate(v[1]) = 0", controls={"it grows": "rate(v[1]) > 0"})
    def rest(property, run):
        return run.question("rest", all_velocities(conserving(), property))

    entry = verify(rest)["mine.rest"]
    assert entry.verdict == "false" and entry.counterexample is not None, entry


def test_a_question_of_a_claim_whose_own_controls_hold():
    @claim("mine.open", "The momentum is conserved.", printed="0", controls={"a sum": "sum(i, v[i])"})
    def momentum(rate, run):
        asked = all_velocities(conserving(), f"rate(momentum) = {rate}")
        with pytest.raises(ValueError, match="scope should be all or instances"):
            run.question("momentum", asked, scope="some")
        return run.question("momentum", {**asked, "holds": {**asked["holds"], "controls": ["rate(momentum) < 1"]}})

    assert verify(momentum)["mine.open"].verdict == "undecided"
