//! Inequalities on boxes against samples that are as dense as time allows: near misses above all, because a wrong `holds` is the worst answer there is.

use super::{Checked, Invariant, OrFails, Stop, Tested, require};
use crate::draws::Draws;
use arithmetic::{Rational, Unwatched, rational};
use num_traits::ToPrimitive;
use question::{Answer, Question, Value, Verdict, decide};

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "question.bounds",
        statement: "A bound that a sample misses is not said to hold, and one that is said to fail fails there.",
        control: "the bound that is decided is lower by a quarter than the one that is compared",
        block: 10,
        check: bounds,
    },
    Invariant {
        id: "question.squares",
        statement: "A sum of squares with a common zero is not negative, is not positive, and is negative with any dip.",
        control: "the common zero is moved",
        block: 10,
        check: squares,
    },
];

const NAMES: [&str; 3] = ["x", "y", "z"];

/// A function of the names.
#[derive(Clone)]
enum Term {
    Constant(Rational),
    Name(usize),
    Binary(char, Box<Term>, Box<Term>),
    Power(Box<Term>, u32),
    Call(&'static str, Box<Term>),
    /// The larger of two, or the smaller.
    Extreme(bool, Box<Term>, Box<Term>),
}

/// Why floats have no value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Doubt {
    /// There is none.
    Missing,
    /// Rounding may have changed it.
    Unsure,
}

fn term(draws: &mut Draws, names: usize, depth: usize, functions: bool) -> Term {
    let part = |draws: &mut Draws| Box::new(term(draws, names, depth.saturating_sub(1), functions));
    let forms = match (depth, functions) {
        (0, _) => 3,
        (_, false) => 8,
        _ => 15,
    };
    match draws.below(forms) {
        0 => Term::Constant(rational(draws.between(0, 6) as i64 - 3, draws.between(1, 3) as i64)),
        1 | 2 => Term::Name(draws.below(names as u64) as usize),
        3..=6 => Term::Binary(*draws.choice(&['+', '-', '*']), part(draws), part(draws)),
        7 => Term::Power(part(draws), draws.between(2, 4) as u32),
        8 => Term::Binary('/', part(draws), part(draws)),
        9 | 10 => Term::Call("sqrt", part(draws)),
        11 => Term::Call("abs", part(draws)),
        12 | 13 => Term::Extreme(draws.once_in(2), part(draws), part(draws)),
        _ => Term::Call(draws.choice::<&str>(&["exp", "log", "sin", "cos"]), part(draws)),
    }
}

impl Term {
    fn text(&self) -> String {
        match self {
            Term::Constant(q) => format!("({q})"),
            Term::Name(k) => NAMES[*k].to_string(),
            Term::Binary(sign, a, b) => format!("({} {sign} {})", a.text(), b.text()),
            Term::Power(a, k) => format!("({})^{k}", a.text()),
            Term::Call(name, a) => format!("{name}({})", a.text()),
            Term::Extreme(larger, a, b) => {
                format!("{}({}, {})", if *larger { "max" } else { "min" }, a.text(), b.text())
            }
        }
    }

    /// In floats, as long as rounding does not matter.
    fn value(&self, at: &[f64]) -> Result<f64, Doubt> {
        /// Larger numbers, and those nearer to 0 where that matters, have lost too many digits.
        const LARGE: f64 = 1e4;
        const SMALL: f64 = 1e-9;
        let value = match self {
            Term::Constant(q) => q.to_f64().ok_or(Doubt::Unsure)?,
            Term::Name(k) => at[*k],
            Term::Binary(sign, a, b) => {
                let (a, b) = (a.value(at)?, b.value(at)?);
                match sign {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    _ if b.abs() < SMALL => return Err(Doubt::Unsure),
                    _ => a / b,
                }
            }
            Term::Power(a, k) => a.value(at)?.powi(*k as i32),
            Term::Call(name, a) => {
                let a = a.value(at)?;
                match *name {
                    "sqrt" | "log" if a < -SMALL => return Err(Doubt::Missing),
                    "sqrt" if a == 0.0 => 0.0,
                    "sqrt" | "log" if a < SMALL => return Err(Doubt::Unsure),
                    "sqrt" => a.sqrt(),
                    "log" => a.ln(),
                    "abs" => a.abs(),
                    "exp" => a.exp(),
                    "sin" => a.sin(),
                    _ => a.cos(),
                }
            }
            Term::Extreme(larger, a, b) => {
                let (a, b) = (a.value(at)?, b.value(at)?);
                if *larger { a.max(b) } else { a.min(b) }
            }
        };
        if value.abs() < LARGE { Ok(value) } else { Err(Doubt::Unsure) }
    }

    /// The value of a polynomial.
    fn exact(&self, at: &[Rational]) -> Option<Rational> {
        Some(match self {
            Term::Constant(q) => q.clone(),
            Term::Name(k) => at[*k].clone(),
            Term::Binary(sign, a, b) => {
                let (a, b) = (a.exact(at)?, b.exact(at)?);
                match sign {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    _ => return None,
                }
            }
            Term::Power(a, k) => {
                let a = a.exact(at)?;
                (0..*k).fold(rational(1, 1), |product, _| product * &a)
            }
            _ => return None,
        })
    }
}

/// The slack at a point.
type Sample = (f64, Vec<f64>);

/// What is asked of a term `f`, with a bound `c`.
struct Form {
    f: Term,
    guard: Option<Term>,
    /// How the guard stands beside `f >= c`.
    place: &'static str,
    strict: bool,
    sides: Vec<(i64, i64)>,
}

impl Form {
    fn drawn(draws: &mut Draws) -> Self {
        let names = draws.between(1, 3);
        let sides = (0..names)
            .map(|_| {
                let from = draws.between(0, 4) as i64 - 2;
                (from, from + draws.between(1, 3) as i64)
            })
            .collect();
        let f = term(draws, names, 3, true);
        let place = *draws.choice(&["", "", "implies", "or", "where"]);
        let guard = (!place.is_empty()).then(|| term(draws, names, 2, true));
        Form { f, guard, place, strict: draws.once_in(3), sides }
    }

    /// How far the property is from being false at a point; nothing where it is true without a bound.
    fn slack(&self, at: &[f64]) -> Result<Option<f64>, Doubt> {
        const NEAR: f64 = 1e-7;
        let guard = match self.guard.as_ref().map(|guard| guard.value(at)) {
            None => None,
            // What is missing on the left matters where the right is not true: nothing is said of it here.
            Some(Err(_)) => return Err(Doubt::Unsure),
            Some(Ok(value)) if value.abs() < NEAR => return Err(Doubt::Unsure),
            Some(Ok(value)) => Some(value > 0.0),
        };
        match (self.place, guard) {
            ("implies" | "where", Some(false)) | ("or", Some(true)) => Ok(None),
            _ => self.f.value(at).map(Some),
        }
    }

    fn text(&self, bound: &Rational, at: Option<&[f64]>) -> String {
        let range = |(k, (lo, hi)): (usize, &(i64, i64))| match at.and_then(|at| Rational::from_float(at[k])) {
            Some(q) => format!("{} = \"{q}\"\n", NAMES[k]),
            None => format!("{} = \"[{lo}, {hi}]\"\n", NAMES[k]),
        };
        let family: String = self.sides.iter().enumerate().map(range).collect();
        let relation = if self.strict { ">" } else { ">=" };
        let bounded = format!("{} {relation} {bound}", self.f.text());
        let used: String = NAMES[..self.sides.len()].iter().map(|name| format!(" and {name} < 9")).collect();
        let guard = self.guard.as_ref().map(Term::text).unwrap_or_default();
        let (restriction, property) = match self.place {
            "implies" => (String::new(), format!("({guard} >= 0 implies {bounded}){used}")),
            "or" => (String::new(), format!("({guard} >= 0 or {bounded}){used}")),
            "where" => (format!("where = \"{guard} >= 0\"\n"), format!("{bounded}{used}")),
            _ => (String::new(), format!("{bounded}{used}")),
        };
        asking(&family, &restriction, &property)
    }

    /// The point with the least slack among samples, and where the slack is missing.
    fn lowest(&self) -> (Option<Sample>, Option<Vec<f64>>) {
        let parts = [240, 30, 10][self.sides.len() - 1];
        let mut list: Vec<Sample> = Vec::new();
        let mut missing = None;
        let count = (0..self.sides.len()).fold(1usize, |count, _| count * (parts + 1));
        for number in 0..count {
            let mut rest = number;
            let place = |(lo, hi): &(i64, i64)| {
                let k = rest % (parts + 1);
                rest /= parts + 1;
                *lo as f64 + (hi - lo) as f64 * (k as f64 / parts as f64)
            };
            let at: Vec<f64> = self.sides.iter().map(place).collect();
            match self.slack(&at) {
                Ok(Some(slack)) => list.push((slack, at)),
                Err(Doubt::Missing) => missing = missing.or(Some(at)),
                _ => {}
            }
        }
        list.sort_by(|a, b| a.0.total_cmp(&b.0));
        list.truncate(3);
        let best = list.into_iter().map(|(slack, at)| self.descended(slack, at, 1.0 / parts as f64));
        (best.min_by(|a, b| a.0.total_cmp(&b.0)), missing)
    }

    /// Steps along single names as long as they go down.
    fn descended(&self, mut slack: f64, mut at: Vec<f64>, mut step: f64) -> Sample {
        while step > 1e-9 {
            let mut better = false;
            for k in 0..at.len() {
                for direction in [step, -step] {
                    let (lo, hi) = self.sides[k];
                    let mut next = at.clone();
                    next[k] = (next[k] + direction * (hi - lo) as f64).clamp(lo as f64, hi as f64);
                    if let Ok(Some(lower)) = self.slack(&next)
                        && lower < slack
                    {
                        (slack, at, better) = (lower, next, true);
                    }
                }
            }
            if !better {
                step *= 0.5;
            }
        }
        (slack, at)
    }
}

fn asking(family: &str, restriction: &str, property: &str) -> String {
    format!(
        "[question]\nid = \"q\"\nbudget = 400\n[for]\n{family}{restriction}[holds]\nproperty = \"{property}\"\ncontrols = [\"1 < 0\"]\n"
    )
}

fn asked(text: &str) -> Result<Result<Answer, String>, Stop> {
    let files = |name: &str| Err(format!("there is no file {name}"));
    let question = Question::read(text, &files).or_fails("the question is refused")?;
    Ok(decide(&question, &Unwatched).map_err(|error| error.to_string()))
}

fn bounds(draws: &mut Draws, tested: Tested) -> Checked {
    let form = Form::drawn(draws);
    let distance = rational(1, *draws.choice(&[10, 1000, 200_000]));
    let above = !draws.once_in(3);
    let (lowest, missing) = form.lowest();
    let Some((least, at)) = lowest else { return Ok(None) };
    let near = Rational::from_float((least * 1e7).round()).or_fails("a number")? * rational(1, 10_000_000);
    let bound = if above { near + &distance } else { near - &distance };
    let shift = if tested.is_altered() { rational(1, 4) } else { rational(0, 1) };
    let text = form.text(&(&bound - shift), None);
    let answer = match asked(&text)? {
        Ok(answer) => answer,
        Err(why) => {
            // What is refused has no value somewhere.
            let refused =
                why.contains("no value") || why.contains("zero") || why.contains("domain") || missing.is_some();
            require(refused || why.contains("leaves out"), why, || text.clone())?;
            return Ok(None);
        }
    };
    let limit = bound.to_f64().unwrap_or(0.0);
    match answer.verdict {
        Verdict::Holds => {
            let point = if above { Some(at) } else { missing };
            let Some(point) = point else { return Ok(None) };
            // The language itself at the point.
            let single = asked(&form.text(&bound, Some(&point)))?.map(|answer| answer.verdict);
            let wrong = !matches!(single, Ok(Verdict::Holds | Verdict::Undecided | Verdict::Withheld));
            require(!wrong, format!("it is said to hold, and at {point:?} it is {single:?}"), || text.clone())?;
        }
        Verdict::False => {
            let Some(found) = answer.counterexample else {
                // False at a number in closed form, which can be so for bounds above the least value only.
                require(above && answer.closed.is_some(), "it is said to fail, and no point is named", || {
                    text.clone()
                })?;
                return Ok(None);
            };
            let number = |name: &&str| match found.get(name) {
                Some(Value::Number(q)) => q.to_f64(),
                _ => None,
            };
            let point: Option<Vec<f64>> = NAMES[..form.sides.len()].iter().map(number).collect();
            let point = point.or_fails("numbers")?;
            let slack = form.slack(&point);
            let wrong = match slack {
                Ok(Some(slack)) => slack > limit + 1e-6,
                Ok(None) => true,
                Err(_) => false,
            };
            require(!wrong, format!("it is said to fail at {point:?}, where its slack is {slack:?}"), || text.clone())?;
        }
        Verdict::Undecided | Verdict::Withheld => return Err(Stop::Undecided(answer.why)),
    }
    Ok(None)
}

fn squares(draws: &mut Draws, tested: Tested) -> Checked {
    let names = draws.between(1, 2);
    let zero: Vec<Rational> =
        (0..names).map(|_| rational(draws.between(0, 4) as i64 - 2, draws.between(2, 4) as i64)).collect();
    let count = draws.between(1, 2);
    let mut parts = Vec::new();
    for _ in 0..count {
        let p = term(draws, names, 2, false);
        let value = p.exact(&zero).or_fails("a value")?;
        let shift = if tested.is_altered() { value + rational(1, 10) } else { value };
        parts.push(format!("({} - ({shift}))^2", p.text()));
    }
    let sum = parts.join(" + ");
    let range = |name: &&str| format!("{name} = \"[-1, 1]\"\n");
    let family: String = NAMES[..names].iter().map(range).collect();
    let used: String = NAMES[..names].iter().map(|name| format!(" and {name} < 9")).collect();
    let dip = *draws.choice(&["1/1000", "1/1000000", "1/1000000000"]);
    let mut open = None;
    for (property, wrong) in [
        (format!("{sum} >= 0"), Verdict::False),
        (format!("{sum} > 0"), Verdict::Holds),
        (format!("{sum} >= {dip}"), Verdict::Holds),
    ] {
        let text = asking(&family, "", &format!("{property}{used}"));
        let answer = asked(&text)?.or_fails("the question is refused")?;
        require(answer.verdict != wrong, format!("it is said to be {}", wrong.word()), || text.clone())?;
        if answer.verdict == Verdict::Undecided {
            open = Some(answer.why);
        }
    }
    open.map_or(Ok(None), |why| Err(Stop::Undecided(why)))
}
