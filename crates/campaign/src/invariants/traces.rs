//! Properties of flocks with time operators against a naive evaluator of the temporal logic, which steps the flock.

use super::{Checked, Invariant, OrFails, Stop, Tested, require};
use crate::draws::Draws;
use crate::strategies::flock;
use arithmetic::{Rational, Unwatched, rational};
use models::averaging::{Flock, Hysteresis, Start, Weights};
use question::{Question, Truth};

pub(super) const TABLE: &[Invariant] = &[Invariant {
    id: "question.time_operators",
    statement: "What `check` decides of a property of a flock with time operators inside each other, going through all steps of every window one by one \
                gives, too; and it decides all of them up to step 63.",
    control: "`until` that asks for its first part also at the step at which the second one comes",
    block: 20,
    check: time_operators,
}];

/// A formula of the logic; windows are the first and the last step.
enum Formula {
    /// A name, a relation, a bound.
    Fact(&'static str, &'static str, Rational),
    Not(Box<Formula>),
    Both(Box<Formula>, Box<Formula>),
    Always([usize; 2], Box<Formula>),
    Eventually([usize; 2], Box<Formula>),
    Until([usize; 2], Box<Formula>, Box<Formula>),
}

impl Formula {
    /// With so many levels. Three windows inside each other end before step 63.
    fn drawn(draws: &mut Draws, levels: u32) -> Self {
        let next = |draws: &mut Draws| Box::new(Formula::drawn(draws, levels - 1));
        let window = |draws: &mut Draws| {
            let first = draws.between(0, 6);
            [first, first + draws.between(0, 12)]
        };
        if levels == 0 {
            let name = *draws.choice(&["links", "components", "min_distance", "disagreement"]);
            let relation = *draws.choice(&["=", "<=", ">"]);
            let size = draws.below(5) as i64;
            let scale = if matches!(name, "links" | "components") { 1 } else { 4 };
            return Formula::Fact(name, relation, rational(size, scale));
        }
        match draws.below(6) {
            0 => Formula::Always(window(draws), next(draws)),
            1 => Formula::Eventually(window(draws), next(draws)),
            2 => Formula::Not(next(draws)),
            3 => Formula::Both(next(draws), next(draws)),
            _ => Formula::Until(window(draws), next(draws), next(draws)),
        }
    }

    fn text(&self) -> String {
        match self {
            Formula::Fact(name, relation, bound) => format!("{name} {relation} {bound}"),
            Formula::Not(p) => format!("not ({})", p.text()),
            Formula::Both(p, q) => format!("({}) and ({})", p.text(), q.text()),
            Formula::Always([a, b], p) => format!("always[{a}, {b}]({})", p.text()),
            Formula::Eventually([a, b], p) => format!("eventually[{a}, {b}]({})", p.text()),
            Formula::Until([a, b], p, q) => format!("(({}) until[{a}, {b}] ({}))", p.text(), q.text()),
        }
    }

    fn holds(&self, facts: &[Facts], now: usize, tested: Tested) -> bool {
        let steps = |[a, b]: &[usize; 2]| now + a..=now + b;
        match self {
            Formula::Fact(name, relation, bound) => facts[now].compare(name, relation, bound),
            Formula::Not(p) => !p.holds(facts, now, tested),
            Formula::Both(p, q) => p.holds(facts, now, tested) && q.holds(facts, now, tested),
            Formula::Always(window, p) => steps(window).all(|t| p.holds(facts, t, tested)),
            Formula::Eventually(window, p) => steps(window).any(|t| p.holds(facts, t, tested)),
            Formula::Until(window, p, q) => steps(window).any(|t| {
                let end = if tested.is_altered() { t + 1 } else { t };
                q.holds(facts, t, tested) && (now..end).all(|s| p.holds(facts, s, tested))
            }),
        }
    }
}

/// What is asked of a step; distances and disagreement as their squares.
struct Facts {
    links: Rational,
    components: Rational,
    min_distance: Rational,
    disagreement: Rational,
}

impl Facts {
    fn of(flock: &Flock) -> Self {
        let (places, speeds) = (flock.positions(), flock.velocities());
        let count = |n: usize| rational(n as i64, 1);
        let size = count(places.len());
        let square = |a: &[Rational], b: &[Rational]| a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<Rational>();
        let pairs = || (0..places.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        // N sum |v_i - mean|² is the sum over pairs of |v_i - v_j|².
        let spread = pairs().map(|(i, j)| square(&speeds[i], &speeds[j])).sum::<Rational>();
        Facts {
            links: count(flock.network().edges().len()),
            components: count(flock.network().components().len()),
            min_distance: pairs().map(|(i, j)| square(&places[i], &places[j])).min().unwrap_or_default(),
            disagreement: spread / size,
        }
    }

    /// Bounds are not negative, so that squares are compared as their roots are.
    fn compare(&self, name: &str, relation: &str, bound: &Rational) -> bool {
        let (own, bound) = match name {
            "links" => (&self.links, bound.clone()),
            "components" => (&self.components, bound.clone()),
            "min_distance" => (&self.min_distance, bound * bound),
            _ => (&self.disagreement, bound * bound),
        };
        match relation {
            "=" => *own == bound,
            "<=" => *own <= bound,
            _ => *own > bound,
        }
    }
}

fn time_operators(draws: &mut Draws, tested: Tested) -> Checked {
    const STEPS: usize = 63;
    let birds = draws.between(2, 4);
    let mut start = flock(draws, birds, 1, 4);
    // As files write them.
    start.weights = if draws.once_in(2) { Weights::Vicsek } else { Weights::Lazy };
    start.hysteresis = Hysteresis::None;
    let levels = 1 + draws.below(3) as u32;
    let inner = Formula::drawn(draws, levels);
    let formula = Formula::Always([0, 0], Box::new(inner));
    let described = || format!("{} of the flock {}", formula.text(), file(&start));
    let mut flock = Flock::new(&start).or_fails("a flock is refused")?;
    let mut facts = vec![Facts::of(&flock)];
    for _ in 0..STEPS {
        flock.step().or_fails("a step is refused")?;
        facts.push(Facts::of(&flock));
    }
    let naive = formula.holds(&facts, 0, tested);
    let question = format!(
        "[question]\nid = \"trace\"\nscenario = \"flock.json\"\n[for]\nk = 1\n[holds]\nproperty = \"{}\"\ncontrols = [\"k < 0\"]\n",
        formula.text()
    );
    let question = Question::read(&question, &|_| Ok(file(&start))).or_fails("a question is refused")?;
    let member = question.case(0, &Unwatched).or_fails("no member")?.unwrap_or_default();
    let decided = question.decide(&member, &Unwatched).or_fails("not decided")?;
    let found = match decided.truth {
        Truth::True => true,
        Truth::False => false,
        Truth::Unknown(doubt) => {
            return Err(Stop::Fails { why: format!("undecided: {}", doubt.why), instance: described() });
        }
    };
    require(found == naive, format!("`check` says {found}, all steps one by one {naive}"), described)?;
    Ok(None)
}

/// The flock as a file of `flock`.
fn file(start: &Start) -> String {
    let rows = |rows: &[Vec<Rational>]| {
        let row = |row: &Vec<Rational>| {
            format!("[{}]", row.iter().map(|x| format!("\"{x}\"")).collect::<Vec<_>>().join(", "))
        };
        rows.iter().map(row).collect::<Vec<_>>().join(", ")
    };
    format!(
        "{{\"model\": \"D\", \"dimension\": 1, \"weights\": \"{}\", \"hysteresis\": \"none\", \"positions\": [{}], \"velocities\": [{}]}}",
        if start.weights == Weights::Lazy { "lazy" } else { "vicsek" },
        rows(&start.positions),
        rows(&start.velocities)
    )
}
