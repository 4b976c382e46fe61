//! How far apart cars must drive: worst lags and gaps behind a leader of bounded acceleration, over the number of followers.

use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::threads::side_by_side;
use arithmetic::{Rational, Unwatched, rational};
use ledger::CheckError;
use num_traits::ToPrimitive;
use reach::{Decided, System, decide};

const TWO_SIDED: [usize; 12] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128];
const ONE_SIDED: [usize; 9] = [1, 2, 3, 4, 6, 8, 12, 16, 24];

/// The worst lag of the last car and the worst gap: of the first car in the two-sided platoon, of the last one in the other.
struct Worst {
    followers: usize,
    lag: [Rational; 2],
    gap: [Rational; 2],
}

/// Lag or gap.
type Part = fn(&Worst) -> &[Rational; 2];

fn worst(graph: &str, followers: usize) -> Result<Worst, CheckError> {
    let car = if graph == "front" { followers } else { 1 };
    let text = format!(
        "[platoon]\nfollowers = {followers}\ngraph = \"{graph}\"\nf = -1\ng = -1\nacceleration = [-1, 1]\n[run]\nuntil = \"inf\"\n\
         [[check]]\nholds = \"lag{followers} <= 0\"\n[[check]]\nholds = \"gap{car} <= 0\"\n"
    );
    let failed = |error: &dyn std::fmt::Display| CheckError::Other(format!("{graph}, {followers} followers: {error}"));
    let system = System::read(&text).map_err(|error| failed(&error))?;
    let found = decide(&system, 10, &Unwatched).map_err(|error| failed(&error))?;
    let ends = |found: &Decided| {
        let part = found.decisive();
        Some([part.lo.clone()?, part.hi.clone()?])
    };
    match &found[..] {
        [lag, gap] => Ok(Worst {
            followers,
            lag: ends(lag).ok_or_else(|| failed(&"no bound"))?,
            gap: ends(gap).ok_or_else(|| failed(&"no bound"))?,
        }),
        _ => Err(failed(&"a check is missing")),
    }
}

fn float(x: &[Rational; 2]) -> f64 {
    ((&x[0] + &x[1]) * rational(1, 2)).to_f64().unwrap_or(f64::NAN)
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let all: Vec<(&str, usize)> =
        TWO_SIDED.iter().map(|&m| ("front-and-back", m)).chain(ONE_SIDED.iter().map(|&m| ("front", m))).collect();
    let found = side_by_side(&all, |(graph, m)| worst(graph, *m));
    let found: Vec<Worst> = found.into_iter().collect::<Result<_, _>>()?;
    let (two, one) = found.split_at(TWO_SIDED.len());
    let line = |list: &[Worst], of: Part| -> Vec<(f64, f64)> {
        list.iter().map(|w| (w.followers as f64, float(of(w)))).collect()
    };
    let square =
        |list: &[Worst]| list.iter().map(|w| (w.followers as f64, (w.followers as f64).powi(2))).collect::<Vec<_>>();
    let (lag, gap): (Part, Part) = (|w| &w.lag, |w| &w.gap);
    let picture = Picture::new("Worst cases behind a leader with accelerations in [−1, 1], for ever (f = g = −1)")
        .grid(2, (520.0, 420.0))
        .panel(
            Panel::new("a) two-sided", Axis::log("followers"), Axis::log("distance"))
                .series(Series::line("worst lag of the last car", line(two, lag)))
                .series(Series::line("worst gap, of the first car", line(two, gap)))
                .series(Series::dashed("lower bound of the lag, for all sizes", square(two))),
        )
        .panel(
            Panel::new("b) one-sided", Axis::linear("followers"), Axis::log("distance"))
                .series(Series::line("worst lag of the last car", line(one, lag)))
                .series(Series::line("worst gap, of the last car", line(one, gap))),
        );
    let rows = all.iter().zip(&found).map(|((graph, m), w)| {
        let mut row = vec![(*graph).to_string(), m.to_string()];
        row.extend(w.lag.iter().chain(&w.gap).map(|x| format!("{:.12e}", x.to_f64().unwrap_or(f64::NAN))));
        row
    });
    let table = csv("graph,followers,worst_lag_lo,worst_lag_hi,worst_gap_lo,worst_gap_hi", rows);
    let last = |list: &[Worst]| list.last().map_or((0, 0.0, 0.0), |w| (w.followers, float(&w.lag), float(&w.gap)));
    let ((m, lag_two, gap_two), (k, lag_one, gap_one)) = (last(two), last(one));
    let before = one.len().checked_sub(2).map_or((1, 1.0), |i| (one[i].followers, float(&one[i].gap)));
    let factor = (gap_one / before.1).powf(1.0 / (k - before.0).max(1) as f64);
    let text = format!(
        "How far apart cars must drive: enclosed worst lags |y_M - y_0| and gaps\n\
         |y_k - y_(k-1)| behind a leader with accelerations in [-1, 1], f = g = -1,\n\
         for ever (notes/reach.md).\n\n\
         \x20 two-sided, {m} followers: lag {lag_two:.4e} = {:.4} M^3,\n\
         \x20   gap {gap_two:.4e} = {:.4} M^2\n\
         \x20 one-sided, {k} followers: lag {lag_one:.4e}, gap {gap_one:.4e}\n\
         \x20 one car more multiplies the one-sided gap by {factor:.4};\n\
         \x20   max |1/gamma| = 1.4679\n",
        lag_two / (m as f64).powi(3),
        gap_two / (m as f64).powi(2),
    );
    Ok(Reproduced::new(text).table("", table).picture("", picture))
}
