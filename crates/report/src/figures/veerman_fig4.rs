//! Figure 4 of Veerman, Stosic and Olvera: resonance against the number of cars.

use super::veerman::{certified, leading};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use ledger::CheckError;
use runs::table1::{ROWS, Row};

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let sizes: Vec<u64> = (4..=128).collect();
    let values = |f: &dyn Fn(u64) -> Result<(f64, f64), CheckError>| {
        sizes.iter().map(|&n| Ok((n as f64, f(n)?))).collect::<Result<Vec<_>, CheckError>>()
    };
    let truth = values(&|n| Ok(certified(n)?))?;
    let theorem = values(&leading)?;
    let printed = |cell: fn(&Row) -> &'static str| -> Vec<(f64, f64)> {
        ROWS.iter().filter_map(|row| Some((row.n as f64, cell(row).parse().ok()?))).collect()
    };
    let ticks: Vec<f64> = ROWS.iter().map(|row| row.n as f64).collect();
    let panel = |name: &str, label: &str, part: fn(&(f64, f64)) -> f64, n: Vec<(f64, f64)>, t: Vec<(f64, f64)>| {
        let line = |points: &[(f64, (f64, f64))]| points.iter().map(|(n, pair)| (*n, part(pair))).collect::<Vec<_>>();
        let letter = label.to_uppercase();
        let letter = if letter.starts_with('A') { "AMP" } else { "FREQ" };
        Panel::new(name, Axis::log("N (followers)").ticks(ticks.clone()), Axis::log(label))
            .series(Series::line("certified", line(&truth)))
            .series(Series::dashed("Theorem 1", line(&theorem)))
            .series(Series::points(format!("printed N{letter}"), n).size(4.2))
            .series(Series::crosses(format!("printed T{letter}"), t))
    };
    let picture = Picture::new("Figure 4: the resonance of the last follower (f = g = −1)")
        .grid(2, (520.0, 420.0))
        .panel(panel("a) amplitude", "amplitude", |p| p.1, printed(|r| r.namp), printed(|r| r.tamp)))
        .panel(panel("b) frequency", "frequency", |p| p.0, printed(|r| r.nfreq), printed(|r| r.tfreq)));
    let rows = truth.iter().zip(&theorem).map(|((n, truth), (_, theorem))| {
        let mut row = vec![n.to_string()];
        row.extend([truth.0, theorem.0, truth.1, theorem.1].map(|x| format!("{x:.12e}")));
        row
    });
    let table = csv("N,frequency_certified,frequency_theorem1,amplitude_certified,amplitude_theorem1", rows);
    let worst = |from: f64, part: fn(&(f64, f64)) -> f64| {
        let pairs = truth.iter().zip(&theorem).filter(|((n, _), _)| *n >= from);
        pairs.map(|((_, a), (_, b))| (part(b) / part(a) - 1.0).abs()).fold(0.0, f64::max)
    };
    let text = format!(
        "Certified resonance, Theorem 1 and the printed cells, N followers (the rows of\n\
         Table 1 are for N followers: veerman.table1.size), N = 4 to 128, f = g = -1.\n\n\
         \x20 largest relative difference from Theorem 1   frequency  amplitude\n\
         \x20 N >= 4                                        {:9.2e}  {:9.2e}\n\
         \x20 N >= 32                                       {:9.2e}  {:9.2e}\n",
        worst(4.0, |p| p.0),
        worst(4.0, |p| p.1),
        worst(32.0, |p| p.0),
        worst(32.0, |p| p.1),
    );
    Ok(Reproduced::new(text).table("", table).picture("", picture))
}
