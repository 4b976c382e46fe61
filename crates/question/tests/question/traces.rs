//! Time operators in discrete time against a naive evaluator of the temporal logic, which steps the flock and goes through the times of every window one by
//! one.

use arithmetic::{Rational, Unwatched, rational};
use models::averaging::Flock;
use models::averaging::read::{Model, read_flock};
use models::averaging::settle::{Ending, Limits, settle};
use num_traits::ToPrimitive;
use question::{Answer, Question, Verdict, decide};

/// A window with its text; the last step is `None` without end.
#[derive(Debug, Clone)]
struct Window {
    first: usize,
    last: Option<usize>,
    text: String,
}

/// A formula of the logic.
#[derive(Debug, Clone)]
enum Formula {
    /// The number of the quantity in [`Trace::values`], a relation, the other side.
    Fact(usize, &'static str, Rational),
    Not(Box<Formula>),
    And(Box<Formula>, Box<Formula>),
    Or(Box<Formula>, Box<Formula>),
    Implies(Box<Formula>, Box<Formula>),
    Always(Window, Box<Formula>),
    Eventually(Window, Box<Formula>),
    Until(Window, Box<Formula>, Box<Formula>),
}

const NAMES: [&str; 4] = ["components", "links", "disagreement", "min_distance"];

impl Formula {
    fn text(&self) -> String {
        match self {
            Formula::Fact(k, relation, bound) => format!("{} {relation} {bound}", NAMES[*k]),
            Formula::Not(p) => format!("not ({})", p.text()),
            Formula::And(p, q) => format!("({}) and ({})", p.text(), q.text()),
            Formula::Or(p, q) => format!("({}) or ({})", p.text(), q.text()),
            Formula::Implies(p, q) => format!("({}) implies ({})", p.text(), q.text()),
            Formula::Always(window, p) => format!("always{}({})", window.text, p.text()),
            Formula::Eventually(window, p) => format!("eventually{}({})", window.text, p.text()),
            Formula::Until(window, p, q) => format!("(({}) until{} ({}))", p.text(), window.text, q.text()),
        }
    }
}

/// The values of the quantities step by step; roots as their squares.
struct Trace {
    values: Vec<[Rational; 4]>,
    /// How many steps of a window without end are looked at. `None` where after the last step everything stays as it is.
    enough: Option<usize>,
}

impl Trace {
    fn of(text: &str, steps: usize) -> Self {
        let start = start(text);
        let mut flock = Flock::new(&start).expect("a flock");
        let mut values = Vec::new();
        for step in 0..=steps {
            if step > 0 {
                flock.step().expect("a step");
            }
            let (places, speeds) = (flock.positions(), flock.velocities());
            let n = places.len();
            let mean = speeds.iter().map(|v| v[0].clone()).sum::<Rational>() / rational(n as i64, 1);
            let spread = speeds.iter().map(|v| (&v[0] - &mean) * (&v[0] - &mean)).sum::<Rational>();
            let mut least: Option<Rational> = None;
            for i in 0..n {
                for j in 0..i {
                    let apart = &places[i][0] - &places[j][0];
                    let square = &apart * &apart;
                    least = Some(least.map_or(square.clone(), |least| least.min(square)));
                }
            }
            let network = flock.network();
            let count = |n: usize| rational(n as i64, 1);
            values.push([
                count(network.components().len()),
                count(network.edges().len()),
                spread,
                least.expect("two birds"),
            ]);
        }
        Trace { values, enough: None }
    }

    fn value(&self, quantity: usize, step: usize) -> &Rational {
        let last = self.values.len() - 1;
        assert!(self.enough.is_none() || step <= last, "a step that was not taken");
        &self.values[step.min(last)][quantity]
    }

    /// The steps of a window; of one without end all until nothing changes any more, and one of those after.
    fn steps(&self, window: &Window, now: usize) -> std::ops::RangeInclusive<usize> {
        let first = now + window.first;
        let enough = self.enough.map_or(first.max(self.values.len()), |enough| first + enough);
        first..=window.last.map_or(enough, |last| now + last)
    }

    fn holds(&self, formula: &Formula, now: usize) -> bool {
        match formula {
            Formula::Fact(quantity, relation, bound) => {
                // Of squares where the value is a root, with the sign of the bound.
                let square = if *quantity < 2 { bound.clone() } else { bound * bound };
                let bound = if *quantity >= 2 && *bound < rational(0, 1) { rational(-1, 1) } else { square };
                let order = self.value(*quantity, now).cmp(&bound);
                match *relation {
                    "=" => order.is_eq(),
                    "!=" => order.is_ne(),
                    "<" => order.is_lt(),
                    "<=" => order.is_le(),
                    ">" => order.is_gt(),
                    _ => order.is_ge(),
                }
            }
            Formula::Not(p) => !self.holds(p, now),
            Formula::And(p, q) => self.holds(p, now) && self.holds(q, now),
            Formula::Or(p, q) => self.holds(p, now) || self.holds(q, now),
            Formula::Implies(p, q) => !self.holds(p, now) || self.holds(q, now),
            Formula::Always(window, p) => self.steps(window, now).all(|t| self.holds(p, t)),
            Formula::Eventually(window, p) => self.steps(window, now).any(|t| self.holds(p, t)),
            Formula::Until(window, p, q) => {
                self.steps(window, now).any(|t| self.holds(q, t) && (now..t).all(|s| self.holds(p, s)))
            }
        }
    }

    /// The margin in floats.
    fn margin(&self, formula: &Formula, now: usize) -> f64 {
        let float = |q: &Rational| q.to_f64().expect("a float");
        match formula {
            Formula::Fact(quantity, relation, bound) => {
                let value = float(self.value(*quantity, now));
                let slack = (if *quantity < 2 { value } else { value.sqrt() }) - float(bound);
                match *relation {
                    "=" => -slack.abs(),
                    "!=" => slack.abs(),
                    "<" | "<=" => -slack,
                    _ => slack,
                }
            }
            Formula::Not(p) => -self.margin(p, now),
            Formula::And(p, q) => self.margin(p, now).min(self.margin(q, now)),
            Formula::Or(p, q) => self.margin(p, now).max(self.margin(q, now)),
            Formula::Implies(p, q) => {
                if self.holds(p, now) {
                    self.margin(q, now)
                } else {
                    f64::INFINITY
                }
            }
            Formula::Always(window, p) => {
                self.steps(window, now).map(|t| self.margin(p, t)).fold(f64::INFINITY, f64::min)
            }
            Formula::Eventually(window, p) => {
                self.steps(window, now).map(|t| self.margin(p, t)).fold(f64::NEG_INFINITY, f64::max)
            }
            Formula::Until(window, p, q) => {
                let kept = |t: usize| (now..t).map(|s| self.margin(p, s)).fold(f64::INFINITY, f64::min);
                let at = |t: usize| kept(t).min(self.margin(q, t));
                self.steps(window, now).map(at).fold(f64::NEG_INFINITY, f64::max)
            }
        }
    }
}

fn start(text: &str) -> models::averaging::Start {
    match read_flock(text).expect("a flock").model {
        Model::D { start, .. } => start,
        _ => panic!("model D"),
    }
}

/// The last switch of a flock whose network becomes steady soon.
fn last_switch(text: &str) -> Option<usize> {
    let flock = Flock::new(&start(text)).expect("a flock");
    let limits = Limits { steps: 2000, switches: 100, jump_bits: 1 << 14 };
    let settled = settle(flock, &limits, &mut |_| (), &Unwatched).ok()?;
    let last = settled.last_switch.to_usize().filter(|last| *last <= 40)?;
    matches!(settled.ending, Ending::Steady).then_some(last)
}

/// Whether the networks of a flock alternate for ever.
fn alternates(text: &str) -> bool {
    let flock = Flock::new(&start(text)).expect("a flock");
    let limits = Limits { steps: 5000, switches: 1000, jump_bits: 1 << 14 };
    settle(flock, &limits, &mut |_| (), &Unwatched)
        .is_ok_and(|settled| matches!(settled.ending, Ending::Alternating { .. }))
}

/// Random numbers, the same in every run.
struct Draws(u64);

impl Draws {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % n
    }

    fn of<T: Clone>(&mut self, list: &[T]) -> T {
        list[self.below(list.len() as u64) as usize].clone()
    }

    fn flock(&mut self) -> String {
        let birds = 2 + self.below(4);
        let rows = |numbers: Vec<String>| numbers.iter().map(|x| format!("[\"{x}\"]")).collect::<Vec<_>>().join(", ");
        let mut place = 0;
        let places = (0..birds).map(|_| {
            place += 1 + self.below(9) as i64;
            format!("{place}/6")
        });
        let places = places.collect();
        let equal = self.below(4) == 0;
        let speeds =
            (0..birds).map(|_| if equal { "1/3".to_string() } else { format!("{}/8", self.below(9) as i64 - 4) });
        let speeds = speeds.collect();
        format!(
            "{{\"model\": \"D\", \"dimension\": 1, \"weights\": \"{}\", \"positions\": [{}], \"velocities\": [{}], \
             \"hysteresis\": \"none\"}}",
            self.of(&["lazy", "vicsek"]),
            rows(places),
            rows(speeds)
        )
    }

    /// Four birds whose network alternates, and others far away that may meet each other.
    fn alternating(&mut self) -> String {
        let mut birds: Vec<(String, String)> = [("0", "1/8"), ("1/2", "-1/8"), ("21/16", "1/8"), ("29/16", "-1/8")]
            .map(|(x, v)| (x.into(), v.into()))
            .into();
        let mut place = 60;
        for _ in 0..self.below(4) {
            place += 1 + self.below(11) as i64;
            birds.push((format!("{place}/6"), format!("{}/8", self.below(5))));
        }
        let rows = |numbers: Vec<&String>| numbers.iter().map(|x| format!("[\"{x}\"]")).collect::<Vec<_>>().join(", ");
        format!(
            "{{\"model\": \"D\", \"dimension\": 1, \"weights\": \"lazy\", \"positions\": [{}], \"velocities\": [{}], \
             \"hysteresis\": \"none\"}}",
            rows(birds.iter().map(|(x, _)| x).collect()),
            rows(birds.iter().map(|(_, v)| v).collect())
        )
    }

    fn late_window(&mut self) -> Window {
        let first = self.of(&[0, 3, 62, 63, 64, 65, 90, 101]);
        let last = first + self.of(&[0, 1, 2, 5, 30]);
        Window { first, last: Some(last), text: format!("[{first}, {last}]") }
    }

    fn window(&mut self, endless: bool) -> Window {
        if endless && self.below(5) == 0 {
            return self.late_window();
        }
        let (first, from) = self.of(&[(0, "0"), (0, "0"), (1, "1"), (1, "1/2"), (2, "5/3"), (5, "5")]);
        let last = first + self.of(&[0, 0, 1, 2, 3, 7]);
        match self.below(3) {
            0 if endless => Window { first, last: None, text: format!("[{from}, inf]") },
            1 => Window { first, last: Some(last), text: format!("[{from}, {}]", rational(3 * last as i64 + 2, 3)) },
            _ => Window { first, last: Some(last), text: format!("[{from}, {last}]") },
        }
    }

    /// A formula with so many levels of time operators; facts of the state only where the trace has all of its times.
    fn formula(&mut self, levels: u32, endless: bool) -> Formula {
        let next = |own: &mut Self| Box::new(own.formula(levels - 1, endless));
        match (levels, self.below(9)) {
            (0, _) => {
                let quantity = self.below(if endless { 2 } else { 4 }) as usize;
                let bound = match quantity {
                    0 => rational(1 + self.below(3) as i64, 1),
                    1 => rational(self.below(5) as i64, 1),
                    _ => rational(self.below(8) as i64 - 1, 6),
                };
                Formula::Fact(quantity, self.of(&["=", "!=", "<", "<=", ">", ">="]), bound)
            }
            (_, 0) => Formula::Not(next(self)),
            (_, 1) => Formula::And(next(self), next(self)),
            (_, 2) => Formula::Or(next(self), next(self)),
            (_, 3) => Formula::Implies(next(self), next(self)),
            (_, 4 | 5) => Formula::Always(self.window(endless), next(self)),
            (_, 6) => Formula::Eventually(self.window(endless), next(self)),
            _ => Formula::Until(self.window(endless), next(self), next(self)),
        }
    }
}

fn answered(flock: &str, property: &str) -> Answer {
    let text = format!(
        "[question]\nid = \"test\"\nscenario = \"flock.json\"\n[for]\nk = 1\n[holds]\nproperty = \"{property}\"\n\
         controls = [\"k < 0\"]\n"
    );
    let question = Question::read(&text, &|_| Ok(flock.to_string())).expect("a question");
    decide(&question, &Unwatched).expect("an answer")
}

/// Every formula is decided, as the naive evaluator says, and its margin encloses the naive one.
fn compared(flock: &str, trace: &Trace, formula: &Formula) -> (bool, bool) {
    // A time operator around it, so that facts are asked at a time.
    let whole = Formula::Always(Window { first: 0, last: Some(0), text: "[0, 0]".into() }, Box::new(formula.clone()));
    let text = whole.text();
    let holds = trace.holds(&whole, 0);
    let answer = answered(flock, &text);
    let expected = if holds { Verdict::Holds } else { Verdict::False };
    assert_eq!(answer.verdict, expected, "{text} of {flock}: {}", answer.why);
    let (own, margin) = (trace.margin(&whole, 0), answer.margin.expect("a margin"));
    let slack = 1e-9;
    assert!(margin.lo <= own + slack && own - slack <= margin.hi, "{own} and {margin:?}: {text} of {flock}");
    (holds, margin.hi - margin.lo < slack)
}

#[test]
fn the_naive_evaluator_agrees_on_facts_of_the_network_for_all_time() {
    let mut draws = Draws(46);
    let (mut true_ones, mut narrow, mut all) = (0, 0, 0);
    while all < 400 {
        let flock = draws.flock();
        let Some(last) = last_switch(&flock).filter(|last| *last > 0) else { continue };
        let trace = Trace::of(&flock, last);
        for _ in 0..8 {
            let levels = 1 + draws.below(3) as u32;
            let (holds, is_narrow) = compared(&flock, &trace, &draws.formula(levels, true));
            true_ones += usize::from(holds);
            narrow += usize::from(is_narrow);
            all += 1;
        }
    }
    assert!(true_ones > all / 5 && true_ones < 4 * all / 5 && narrow > all / 5, "{true_ones} {narrow} of {all}");
}

/// Against 600 steps of the flock, where a window without end is as good as its first forty steps.
#[test]
fn the_naive_evaluator_agrees_on_networks_that_alternate_for_ever() {
    let mut draws = Draws(49);
    let (mut true_ones, mut narrow, mut all, mut late) = (0, 0, 0, 0);
    while all < 300 {
        let flock = draws.alternating();
        if !alternates(&flock) {
            continue;
        }
        let trace = Trace { enough: Some(40), ..Trace::of(&flock, 600) };
        let before =
            |t: usize| t.checked_sub(2).is_some_and(|before| trace.values[t][..2] == trace.values[before][..2]);
        let settled = (2..=600).rev().find(|t| !before(*t)).unwrap_or(0);
        assert!(settled < 30 && trace.values[500][1] != trace.values[501][1], "{flock}");
        late += usize::from(settled > 5);
        for _ in 0..8 {
            let levels = 1 + draws.below(3) as u32;
            let (holds, is_narrow) = compared(&flock, &trace, &draws.formula(levels, true));
            true_ones += usize::from(holds);
            narrow += usize::from(is_narrow);
            all += 1;
        }
    }
    assert!(true_ones > all / 5 && true_ones < 4 * all / 5 && narrow > all / 5, "{true_ones} {narrow} of {all}");
    assert!(late > 0);
}

/// Planted: each is false, and would be true if the network stayed, if it were looked at one period too short, or if the state repeated too.
#[test]
fn false_statements_about_networks_that_alternate_are_found() {
    let flock = "{\"model\": \"D\", \"dimension\": 1, \"weights\": \"lazy\", \"positions\": [[\"0\"], [\"1/2\"], [\"21/16\"], \
                 [\"29/16\"]], \"velocities\": [[\"1/8\"], [\"-1/8\"], [\"1/8\"], [\"-1/8\"]], \"hysteresis\": \"none\"}";
    for (property, expected) in [
        ("always[0, inf](eventually[0, 1](components = 2))", Verdict::Holds),
        ("always[0, inf](eventually[0, 1](components = 1))", Verdict::Holds),
        ("always[1000000, inf](components = 1 implies always[1, 1](components = 2))", Verdict::Holds),
        ("eventually[0, inf](always[0, inf](components = 2))", Verdict::False),
        ("eventually[0, inf](always[0, inf](components = 1))", Verdict::False),
        ("eventually[0, inf](always[0, 1](components = 1))", Verdict::False),
        ("eventually[1000000, inf](always[0, 1](components = 2))", Verdict::False),
        ("always[0, inf](components = 2)", Verdict::False),
        ("always[100, inf](components = 1)", Verdict::False),
        ("components >= 1 until[12345, inf] components = 3", Verdict::False),
        ("components = 1 until[100, inf] components = 2", Verdict::False),
        (
            "eventually[1000000007, 1000000007](components = 2) and eventually[1000000008, 1000000008](components = 2)",
            Verdict::False,
        ),
        (
            "eventually[1000000007, 1000000007](components = 2) or eventually[1000000008, 1000000008](components = 2)",
            Verdict::Holds,
        ),
        // The state does not repeat, and the network beside it is not taken to stay.
        ("always[0, inf](components = 2 or disagreement < 1)", Verdict::Undecided),
        ("eventually[2000, inf](always[0, inf](components = 2) and disagreement < 100)", Verdict::Undecided),
        ("always[2000, inf](eventually[0, 0](components = 2) or disagreement < 0)", Verdict::Undecided),
    ] {
        let answer = answered(flock, property);
        assert_eq!(answer.verdict, expected, "{property}: {}", answer.why);
    }
}

#[test]
fn the_naive_evaluator_agrees_on_facts_of_the_state() {
    let mut draws = Draws(47);
    let (mut true_ones, mut all) = (0, 0);
    while all < 240 {
        let flock = draws.flock();
        if last_switch(&flock).is_none() {
            continue;
        }
        let trace = Trace::of(&flock, 64);
        for _ in 0..6 {
            let levels = 1 + draws.below(3) as u32;
            true_ones += usize::from(compared(&flock, &trace, &draws.formula(levels, false)).0);
            all += 1;
        }
    }
    assert!(true_ones > all / 5 && true_ones < 4 * all / 5, "{true_ones} of {all}");
}

/// Birds with one velocity: the state stays for ever, too.
#[test]
fn the_state_is_known_for_ever_once_all_velocities_are_equal() {
    let flock = "{\"model\": \"D\", \"dimension\": 1, \"weights\": \"lazy\", \"positions\": [[\"0\"], [\"1\"], [\"3\"]], \
                 \"velocities\": [[\"1/3\"], [\"1/3\"], [\"1/3\"]], \"hysteresis\": \"none\"}";
    for property in [
        "always[0, inf](disagreement = 0)",
        "always[0, inf](eventually[7, inf](min_distance = 1))",
        "always[0, inf](components = 2 and min_distance >= 1)",
        "eventually[5000, inf](min_distance = 1 and links = 1)",
    ] {
        assert_eq!(answered(flock, property).verdict, Verdict::Holds, "{property}");
    }
    assert_eq!(answered(flock, "min_distance = 1 until[3, inf] min_distance > 1").verdict, Verdict::False);
}

/// `q` at the step at which it comes needs no `p` there; a window of one step is one step.
#[test]
fn until_asks_for_its_first_part_before_the_second_one_comes() {
    let mut draws = Draws(48);
    let mut seen = 0;
    while seen < 12 {
        let flock = draws.flock();
        let Some(last) = last_switch(&flock).filter(|last| *last > 0) else { continue };
        let trace = Trace::of(&flock, last);
        let before = trace.value(1, 0);
        let Some(change) = (1..=last).find(|t| trace.value(1, *t) != before) else { continue };
        let after = trace.value(1, change);
        for (window, expected) in [
            (format!("[0, {change}]"), Verdict::Holds),
            (format!("[{change}, {change}]"), Verdict::Holds),
            ("[0, inf]".to_string(), Verdict::Holds),
            (format!("[0, {}]", change - 1), Verdict::False),
        ] {
            let property = format!("links = {before} until{window} links = {after}");
            assert_eq!(answered(&flock, &property).verdict, expected, "{property} of {flock}");
        }
        seen += 1;
    }
}
