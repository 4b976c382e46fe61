//! Worst cases of switched linear systems `x' = A x + B u + c` with bounded inputs.

mod condition;
mod family;
mod flow;
mod orders;
mod prepared;
mod read;
mod scalar;
mod search;
mod signs;
mod system;
mod walk;
mod worst;

pub use system::{Check, Condition, Input, Mode, Range, Side, Stay, Switching, System};

/// For trials.
pub fn trial(system: &System, digits: u32) {
    let prepared = prepared::Prepared::new(system);
    let times = orders::Times::Until(system.until.clone().unwrap_or_default());
    let start = std::time::Instant::now();
    let Some(solver) = worst::Solver::new(&prepared, &system.switching, &times, digits, &arithmetic::Unwatched) else { return };
    println!("tables {:?}", start.elapsed());
    for check in &system.checks {
        for c in &check.conditions {
            let mut row = if c.side == Side::AtLeast { c.row.iter().map(|x| -x.clone()).collect() } else { c.row.clone() };
            row.resize(prepared.order(), arithmetic::Rational::ZERO);
            let w = solver.greatest(&row).expect("not cancelled");
            let f = |q: &arithmetic::Rational| arithmetic::decimal(q, digits + 4, false);
            println!("{} {:?} [{}, {}] at {:?} legs {} {:?}", check.text, start.elapsed(), w.lo.as_ref().map_or("none".into(), f), f(&w.hi),
                w.at.as_ref().map(|r| (f(&r.lo), f(&r.hi))), w.legs.len(), w.legs.iter().map(|(m, d)| (m, f(d))).collect::<Vec<_>>());
        }
    }
}
