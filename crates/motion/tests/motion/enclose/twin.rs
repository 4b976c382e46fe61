//! A slow twin: solutions from single exact starts, by Taylor's formula in intervals of many bits over tiny steps. It shares no code with what is tested but
//! the law. The solution from every start of a box has to lie where the polynomials at that start say, within their proved distance.

use arithmetic::num_traits::ToPrimitive;
use arithmetic::random::{generator, uniform};
use arithmetic::{
    ArithmeticError, Enclosure, Field, FloatInterval, Interval, Number, Rational, Ring, Series, Signed, rational,
};
use motion::System;
use motion::enclose::{Expanded, Flow, Set};

const BITS: u32 = 128;

/// Powers of time of the twin.
const ORDER: usize = 10;

/// Longest step of the twin.
const LONGEST: f64 = 1.0 / 48.0;

fn exact(x: f64) -> Rational {
    Rational::from_float(x).expect("finite")
}

/// Taylor's coefficients, where the law is evaluated anew for each of them.
fn coefficients(system: &impl System, time: &Interval, state: &[Interval], order: usize) -> Option<Vec<Vec<Interval>>> {
    let mut known = vec![state.to_vec()];
    for k in 1..=order {
        let series = |i: usize| Series::from_coefficients(known[0][i].clone(), known[1..].iter().map(|c| c[i].clone()));
        let clock = (1..k).map(|j| time.integer(i64::from(j == 1)));
        let state: Vec<Series<Interval>> = (0..state.len()).map(series).collect();
        let rates = system.rate(&Series::from_coefficients(time.clone(), clock), &state).ok()?;
        let part = time.ratio(1, k as i64);
        known.push(rates.iter().map(|rate| rate.coefficients()[k - 1].clone() * &part).collect());
    }
    Some(known)
}

/// The solution after a short time.
fn stepped(system: &impl System, time: &Rational, state: &[Interval], length: &Rational) -> Option<Vec<Interval>> {
    let like = Interval::from_rational(time, BITS);
    let (during, span) = (
        Interval::hull_of_rationals(time, &(time + length), BITS),
        Interval::hull_of_rationals(&rational(0, 1), length, BITS),
    );
    // A box that the solution does not leave.
    let image = |b: &[Interval]| -> Option<Vec<Interval>> {
        let rates = system.rate(&during, b).ok()?;
        Some(state.iter().zip(rates).map(|(x, f)| x.clone() + &(f * &span)).collect())
    };
    let mut around = image(state)?;
    let mut found = None;
    for _ in 0..8 {
        let wider = |x: &Interval| {
            let (lo, hi) = x.to_rationals();
            let more = (&hi - &lo) / rational(4, 1) + rational(1, 1 << 40);
            Interval::hull_of_rationals(&(lo - &more), &(hi + &more), BITS)
        };
        around = around.iter().map(wider).collect();
        let next = image(&around)?;
        if around.iter().zip(&next).all(|(b, x)| b.lo() < x.lo() && x.hi() < b.hi()) {
            found = Some(next);
            break;
        }
        around = next;
    }
    let around = found?;
    let near = coefficients(system, &like, state, ORDER - 1)?;
    let far = coefficients(system, &during, &around, ORDER)?;
    let h = Interval::from_rational(length, BITS);
    let sum = |i: usize| (0..ORDER).rev().fold(far[ORDER][i].clone(), |sum, k| sum * &h + &near[k][i]);
    Some((0..state.len()).map(sum).collect())
}

/// The solution from one time to a later one.
fn followed(system: &impl System, from: &Rational, mut state: Vec<Interval>, to: &Rational) -> Option<Vec<Interval>> {
    let whole = to - from;
    let count = (float(&whole) / LONGEST).ceil().max(1.0) as i64;
    let length = &whole / rational(count, 1);
    for k in 0..count {
        state = stepped(system, &(from + &length * rational(k, 1)), &state, &length)?;
    }
    Some(state)
}

fn float(q: &Rational) -> f64 {
    q.to_f64().unwrap_or(f64::NAN)
}

/// What a comparison found.
#[derive(Default, Debug)]
struct Seen {
    points: usize,
    /// The largest distance from the middle of the enclosure as a part of its radius.
    fullest: f64,
    widest: f64,
}

impl Seen {
    fn compare(&mut self, what: &str, enclosures: &[FloatInterval], truth: &[Interval]) {
        for (own, truth) in enclosures.iter().zip(truth) {
            let Some((a, b)) = own.ends() else { continue };
            let (lo, hi) = truth.to_rationals();
            assert!(lo <= b && a <= hi, "{what}: {own} and {truth}");
            let middle = (&a + &b) / rational(2, 1);
            let off = float(&((&lo + &hi) / rational(2, 1) - middle)).abs();
            self.points += 1;
            // Where rounding is not all there is.
            if own.width() > 1e-10 {
                self.fullest = self.fullest.max(off / (0.5 * own.width()));
            }
            self.widest = self.widest.max(own.width());
        }
    }
}

/// Follows a box and exact starts in it, and compares within steps and at their ends.
fn compared(system: &impl System, start: &[(i64, i64)], degree: usize, until: f64, seen: &mut Seen, name: &str) {
    // Ends in 64ths, so that the middle and half the width are floats.
    let boxed: Vec<FloatInterval> =
        start.iter().map(|(a, b)| FloatInterval::between(*a as f64 / 64.0, *b as f64 / 64.0)).collect();
    let first = Set::of_numbers(&Expanded::with_degree(&boxed, degree));
    let mut random = generator("enclose", name, degree as u64);
    let starts: Vec<Vec<f64>> = (0..4)
        .map(|k| {
            // A corner, the middle, and two more, in eighths.
            let one = |_| match k {
                0 => {
                    if uniform(&mut random) < 0.5 {
                        -1.0
                    } else {
                        1.0
                    }
                }
                1 => 0.0,
                _ => (uniform(&mut random) * 16.0).floor() / 8.0 - 1.0,
            };
            (0..first.variables()).map(one).collect()
        })
        .collect();
    for variables in starts {
        let (mut flow, mut set, mut time) = (Flow::new(system, 0.1), first.clone(), 0.0);
        let begin = first.at(&variables);
        // Exactly there: the sum of two floats with few digits.
        let mut truth: Vec<Interval> = begin
            .iter()
            .map(|x| Interval::from_rational(&exact((x.midpoint() * 1024.0).round() / 1024.0), BITS))
            .collect();
        for (own, truth) in begin.iter().zip(&truth) {
            assert!(own.width() < 1e-12 && own.contains(truth.to_f64()));
        }
        while time < until {
            let Ok(step) = flow.step(&set, time, until) else { return };
            let (from, to) = (exact(time), exact(step.until));
            let middle = (&from + &to) / rational(2, 1);
            let Some(half) = followed(system, &from, truth.clone(), &middle) else { return };
            let Some(end) = followed(system, &middle, half.clone(), &to) else { return };
            let after = FloatInterval::from_rational(&(&middle - &from));
            if step.is_renewed {
                // The variables are others.
                seen.compare(name, &step.states(after), &half);
                seen.compare(name, &step.end.hull(), &end);
                return;
            }
            seen.compare(name, &step.states_at(&variables, after), &half);
            seen.compare(name, &step.end.at(&variables), &end);
            truth = end;
            (set, time) = (step.end, step.until);
        }
    }
}

/// An expression in the state and the time.
#[derive(Debug, Clone)]
enum Tree {
    State(usize),
    Time,
    Number(i64),
    Sum(Box<Tree>, Box<Tree>),
    Difference(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    Function(usize, Box<Tree>),
}

/// Functions, some of them of arguments that are moved to where they have values.
const FUNCTIONS: usize = 12;

fn function<T: Number>(which: usize, x: &T) -> Result<T, ArithmeticError> {
    let more = |p: i64| x.clone() + &x.integer(p);
    match which {
        0 => more(3).recip(),
        1 => (x.square() + &x.one()).recip(),
        2 => more(3).sqrt(),
        3 => (x.square() + &x.one()).sqrt(),
        4 => (x.clone() * &x.ratio(1, 2)).exp(),
        5 => more(3).ln(),
        6 => x.sin(),
        7 => x.cos(),
        8 => x.atan(),
        9 => Ok((x.clone() * &x.ratio(1, 2)).sinh_cosh()?.0),
        10 => (x.clone() * &x.ratio(1, 2)).cosh(),
        _ => T::angle(x, &more(3)),
    }
}

impl Tree {
    fn random(numbers: usize, depth: usize, random: &mut impl arithmetic::rand_chacha::rand_core::Rng) -> Tree {
        let mut below = |n: usize| (uniform(random) * n as f64) as usize;
        if depth == 0 || below(6) == 0 {
            return match below(5) {
                0 => Tree::Number(below(17) as i64 - 8),
                1 if below(2) == 0 => Tree::Time,
                _ => Tree::State(below(numbers)),
            };
        }
        let (kind, which) = (below(7), below(FUNCTIONS));
        let mut part = || Box::new(Tree::random(numbers, depth - 1, random));
        match kind {
            0 | 1 => Tree::Sum(part(), part()),
            2 => Tree::Difference(part(), part()),
            3 | 4 => Tree::Product(part(), part()),
            _ => Tree::Function(which, part()),
        }
    }

    fn value<T: Number>(&self, time: &T, state: &[T]) -> Result<T, ArithmeticError> {
        Ok(match self {
            Tree::State(i) => state[*i].clone(),
            Tree::Time => time.clone(),
            Tree::Number(p) => time.ratio(*p, 5),
            Tree::Sum(a, b) => a.value(time, state)? + &b.value(time, state)?,
            Tree::Difference(a, b) => a.value(time, state)? - &b.value(time, state)?,
            Tree::Product(a, b) => a.value(time, state)? * &b.value(time, state)?,
            Tree::Function(which, a) => function(*which, &a.value(time, state)?)?,
        })
    }
}

struct Random(Vec<Tree>);

impl System for Random {
    fn rate<T: Number>(&self, time: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        self.0.iter().map(|tree| tree.value(time, state)).collect()
    }
}

#[test]
fn solutions_of_random_laws_lie_where_the_polynomials_say() {
    let mut seen = Seen::default();
    for case in 0..60u64 {
        let mut random = generator("enclose", "laws", case);
        let numbers = 1 + (case % 3) as usize;
        let law = Random((0..numbers).map(|_| Tree::random(numbers, 3, &mut random)).collect());
        let one = |_| {
            let (lo, width) = ((uniform(&mut random) * 128.0) as i64 - 64, (uniform(&mut random) * 24.0) as i64);
            // Some numbers are no intervals.
            (lo, lo + if width < 6 { 0 } else { 2 * width })
        };
        let start: Vec<(i64, i64)> = (0..numbers).map(one).collect();
        compared(&law, &start, 1 + (case % 5) as usize, 0.5, &mut seen, &format!("case {case}: {:?}", law.0));
    }
    assert!(seen.points > 700 && seen.fullest > 0.1 && seen.widest > 0.1, "{seen:?}");
}

/// `y' = f(y) + c`, for every function.
struct Of(usize);

impl System for Of {
    fn rate<T: Number>(&self, time: &T, y: &[T]) -> Result<Vec<T>, ArithmeticError> {
        Ok(vec![function(self.0, &y[0])? - &(y[0].ratio(1, 4) * time)])
    }
}

#[test]
fn every_function_is_enclosed_on_wide_sets() {
    for which in 0..FUNCTIONS {
        let mut seen = Seen::default();
        for (degree, width) in [(1, 8), (2, 32), (4, 64), (8, 96)] {
            compared(&Of(which), &[(-40, -40 + width)], degree, 1.0, &mut seen, &format!("function {which}"));
        }
        assert!(seen.points >= 40 && seen.fullest > 1e-3, "{which}: {seen:?}");
    }
}

/// Values of random expressions at exact points of a box lie where the polynomial at that point says, and within the bounds on the whole box; and where the
/// polynomial is the expression, the bounds are nearly attained.
#[test]
fn what_is_measured_lies_where_its_polynomial_says() {
    let mut seen = Seen::default();
    for case in 0..400u64 {
        let mut random = generator("enclose", "measured", case);
        let (numbers, degree) = (1 + (case % 3) as usize, 1 + (case % 7) as usize);
        let trees = [0; 2].map(|_| Tree::random(numbers, 4, &mut random));
        let one = |_| {
            let lo = (uniform(&mut random) * 128.0).floor() - 64.0;
            FloatInterval::between(lo / 64.0, (lo + (uniform(&mut random) * 32.0).floor() * 2.0) / 64.0)
        };
        let start: Vec<FloatInterval> = (0..numbers).map(one).collect();
        let state = Expanded::with_degree(&start, degree);
        let time = state[0].ratio(1, 2);
        let [Ok(a), Ok(b)] = [0, 1].map(|k: usize| trees[k].value(&time, &state)) else { continue };
        let extremes = [a.absolute(), a.larger(&b), a.smaller(&b)].map(|x| x.expect("a number").range());
        for _ in 0..6 {
            let point: Vec<f64> = (0..numbers).map(|_| (uniform(&mut random) * 17.0).floor() / 8.0 - 1.0).collect();
            let there = |x: &Expanded| exact((x.at(&point).midpoint() * 1024.0).round() / 1024.0);
            let exactly: Vec<Interval> = state.iter().map(|x| Interval::from_rational(&there(x), BITS)).collect();
            let half = Interval::from_rational(&rational(1, 2), BITS);
            let [Ok(p), Ok(q)] = [0, 1].map(|k: usize| trees[k].value(&half, &exactly)) else { continue };
            let name = format!("case {case}: {:?} on {start:?} at {point:?}", trees);
            seen.compare(&name, &[a.at(&point), b.at(&point)], &[p.clone(), q.clone()]);
            let two = [p.clone(), q.clone()];
            seen.compare(&name, &[a.range(), b.range()], &two);
            let known = [p.absolute(), p.larger(&q), p.smaller(&q)];
            for (own, truth) in extremes.iter().zip(known) {
                let Ok(truth) = truth else { continue };
                seen.compare(&name, &[*own], &[truth]);
            }
        }
    }
    assert!(seen.points > 4000 && seen.fullest > 0.99 && seen.widest > 0.1, "{seen:?}");
}

/// `(x - y)² + x (2 - x) = y² + 2 x (1 - y)` has the values from 0 to 2 on the square from 0 to 1.
#[test]
fn what_cancels_in_a_measure_cancels() {
    let unit = FloatInterval::between(0.0, 1.0);
    let state = Expanded::with_degree(&[unit, unit], 2);
    let [x, y] = [0, 1].map(|k: usize| state[k].clone());
    let found = (x.clone() - &y).square() + x.clone() * (x.integer(2) - &x);
    let range = found.range();
    // Intervals alone would say from 0 to 3.
    assert!(range.lo() <= 0.0 && range.lo() > -0.1 && range.hi() >= 2.0 && range.hi() < 2.1, "{range}");
}
