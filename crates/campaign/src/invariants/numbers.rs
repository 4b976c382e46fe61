//! Arithmetics that enclose exact values.

use super::{Checked, Invariant, OrFails, Stop, Tested, require, shown};
use crate::draws::Draws;
use crate::strategies::fraction;
use arithmetic::{ArithmeticError, Field, FloatInterval, Interval, Number, Rational, Ring, rational};

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "interval.contains_exact",
        statement: "Sums, differences, products, squares and reciprocals of intervals, at any precision, and of pairs of floats contain the \
                    exact rational values.",
        control: "every interval is replaced by its midpoint",
        block: 200,
        check: contains_exact,
    },
    Invariant {
        id: "interval.functions",
        statement: "Enclosures at any precision fulfil sqrt(x)^2 = x, exp(log x) = x, sin^2 + cos^2 = 1, tan(atan x) = x and \
                    cosh^2 - sinh^2 = 1.",
        control: "the inverse functions of x + 2^-24",
        block: 50,
        check: functions,
    },
    Invariant {
        id: "interval.precisions_meet",
        statement: "Enclosures of sqrt, exp, log, sin, cos, atan, sinh and cosh of one number at two precisions have a point in common.",
        control: "at the second precision, the functions of x + 2^-24",
        block: 50,
        check: precisions_meet,
    },
];

/// A value in three arithmetics.
struct Enclosed {
    exact: Rational,
    interval: Interval,
    floats: FloatInterval,
}

fn contains_exact(draws: &mut Draws, tested: Tested) -> Checked {
    let precision = draws.between(2, 120) as u32;
    let inputs: Vec<Rational> = (0..draws.between(1, 3)).map(|_| fraction(draws, 1000, 97)).collect();
    let enclosed = |exact: &Rational| Enclosed {
        interval: Interval::from_rational(exact, precision),
        floats: FloatInterval::from_rational(exact),
        exact: exact.clone(),
    };
    let mut values: Vec<Enclosed> = inputs.iter().map(enclosed).collect();
    let mut program = Vec::new();
    for _ in 0..draws.between(1, 8) {
        let (a, b) = (draws.below(values.len() as u64) as usize, draws.below(values.len() as u64) as usize);
        let name = *draws.choice(&["+", "-", "*", "square", "1/"]);
        program.push(format!("{name} {a} {b}"));
        let described = || format!("inputs {}, then {} at {precision} bits", shown(&inputs), program.join(", "));
        let Some(mut value) = applied(name, &values[a], &values[b], &described)? else { break };
        if tested.is_altered() {
            value.interval = value.interval.midpoint(precision);
        }
        let why = format!("{} does not contain {}", value.interval, value.exact);
        require(value.interval.contains(&value.exact), why, described)?;
        let why = format!("{} does not contain {}", value.floats, value.exact);
        require(between_floats(&value.floats, &value.exact), why, described)?;
        values.push(value);
    }
    Ok(None)
}

/// Whether a rational lies between two floats.
fn between_floats(x: &FloatInterval, q: &Rational) -> bool {
    let below = Rational::from_float(x.lo()).is_none_or(|lo| lo <= *q);
    below && Rational::from_float(x.hi()).is_none_or(|hi| *q <= hi)
}

/// One operation; `None` for the reciprocal of what may be zero.
fn applied(name: &str, a: &Enclosed, b: &Enclosed, described: &dyn Fn() -> String) -> Result<Option<Enclosed>, Stop> {
    fn ring<T: Ring>(name: &str, a: &T, b: &T) -> T {
        match name {
            "+" => a.clone() + b,
            "-" => a.clone() - b,
            "*" => a.clone() * b,
            _ => a.square(),
        }
    }
    if name == "1/" {
        let (Ok(interval), Ok(floats)) = (a.interval.recip(), a.floats.recip()) else { return Ok(None) };
        let exact = Field::recip(&a.exact).map_err(|error| Stop::Fails {
            why: format!("an interval has a reciprocal, and its exact value does not: {error}"),
            instance: described(),
        })?;
        return Ok(Some(Enclosed { exact, interval, floats }));
    }
    Ok(Some(Enclosed {
        exact: ring(name, &a.exact, &b.exact),
        interval: ring(name, &a.interval, &b.interval),
        floats: ring(name, &a.floats, &b.floats),
    }))
}

fn functions(draws: &mut Draws, tested: Tested) -> Checked {
    let precision = draws.between(8, 160) as u32;
    let exact = fraction(draws, 2000, 60);
    let x = Interval::from_rational(&exact, precision);
    let shift = if tested.is_altered() { rational(1, 1 << 24) } else { rational(0, 1) };
    let moved = Interval::from_rational(&(&exact + shift), precision);
    let one = rational(1, 1);
    let contains = |name: &str, found: Result<Interval, ArithmeticError>, value: &Rational| match found {
        // Too coarse to be inside the domain.
        Err(_) => Ok(()),
        Ok(found) => require(found.contains(value), format!("{name}: {found} does not contain {value}"), || {
            format!("x = {exact} at {precision} bits")
        }),
    };
    let positive = exact > rational(0, 1);
    if positive {
        contains("sqrt(x)^2", moved.sqrt().map(|root| root.square()), &exact)?;
        contains("exp(log x)", moved.ln().and_then(|log| log.exp()), &exact)?;
    }
    let circle = |(sin, cos): (Interval, Interval)| sin.square() + cos.square();
    contains("sin^2 + cos^2", x.sin_cos().map(circle), &one)?;
    let tangent = moved.atan().and_then(|angle| angle.sin_cos()).and_then(|(sin, cos)| sin.over(&cos));
    contains("tan(atan x)", tangent, &exact)?;
    let small = Interval::from_rational(&(&exact / rational(100, 1)), precision);
    let hyperbola = small.sinh_cosh().map(|(sinh, cosh)| cosh.square() - sinh.square());
    contains("cosh^2 - sinh^2", hyperbola, &one)?;
    Ok(None)
}

fn precisions_meet(draws: &mut Draws, tested: Tested) -> Checked {
    let (p, q) = (draws.between(8, 160) as u32, draws.between(8, 400) as u32);
    let exact = fraction(draws, 800, 60);
    let shift = if tested.is_altered() { rational(1, 1 << 24) } else { rational(0, 1) };
    let (x, y) = (Interval::from_rational(&exact, p), Interval::from_rational(&(&exact + shift), q));
    type Function = (&'static str, fn(&Interval) -> Result<Interval, ArithmeticError>);
    const FUNCTIONS: [Function; 8] = [
        ("sqrt", |x| x.sqrt()),
        ("exp", |x| x.exp()),
        ("log", |x| x.ln()),
        ("sin", |x| x.sin()),
        ("cos", |x| x.cos()),
        ("atan", |x| x.atan()),
        ("sinh", |x| Ok(x.sinh_cosh()?.0)),
        ("cosh", |x| Ok(x.sinh_cosh()?.1)),
    ];
    for (name, function) in FUNCTIONS {
        if let (Ok(a), Ok(b)) = (function(&x), function(&y)) {
            let why = format!("{name} is in {a} at {p} bits and in {b} at {q} bits");
            require(a.overlaps(&b), why, || format!("x = {exact}"))?;
        }
    }
    // Something must be there to be compared.
    x.exp().or_fails("exp has no value")?;
    Ok(None)
}
