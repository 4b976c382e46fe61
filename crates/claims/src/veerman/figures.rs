//! veerman.fig4, veerman.fig5: how well Theorem 1 agrees with the resonance.

use super::{enclosed, gains, unit, within};
use crate::prelude::*;
use crate::printed_decimal;
use arithmetic::regression_line;
use models::platoon::{Gains, resonance, theorem1};
use runs::table1::{ROWS, Row};

const PRECISION: u32 = 120;
const DIGITS: u32 = 24;

/// A column of Table 1.
type Column = fn(&Row) -> &'static str;

/// Frequency and amplitude: what is found, and what Theorem 1 gives for the gains and as many followers.
type Pairs = [(Interval, Interval); 2];

/// For `m` followers, with Theorem 1 for these gains and `m + offset` followers.
fn pairs(m: u64, gains: &Gains<Rational>, offset: i64) -> Result<Pairs, CheckError> {
    let found = resonance(&unit(), m, DIGITS)?;
    let (gains, size) = (enclosed(gains, PRECISION), m.saturating_add_signed(offset));
    Ok([(found.omega, theorem1::frequency(&gains, size)?), (found.amplitude, theorem1::amplitude(&gains, size)?)])
}

/// Theorem 1 for these gains and `M + offset` followers.
#[derive(Clone, Copy)]
pub struct Figure4Variant {
    f: i64,
    g: i64,
    offset: i64,
    /// The largest relative difference of an excellent agreement below 32 followers.
    small: (i64, i64),
}

impl Figure4Variant {
    /// The largest relative difference of an excellent agreement.
    fn limit(&self, size: u64) -> Rational {
        if size < 32 { rational(self.small.0, self.small.1) } else { rational(1, 2000) }
    }
}

pub fn figure4() -> Record<Figure4Variant> {
    Record::new(
        "veerman.fig4",
        "The true resonance is enclosed for M = 4 to 128 followers (the figure's range; the printed numbers are for N followers); beyond, beyond.veerman.resonance_frequency and \
         resonance_amplitude bound the differences by (0.26/M²)(1 + 62/M²) for all M >= 5. The four columns of Table 1 meet the same limits, although \
         its headings are exchanged and its simulated values not accurate to their digits (veerman.table1_*).",
        Figure4Variant { f: -1, g: -1, offset: 0, small: (1, 40) },
        examine_figure4,
    )
    .reading("Excellent: the curves of the figure differ by at most 2.5 per cent at every size of the figure from 4 on, up to 128, and by at most 0.05 per cent from 32 on.")
    .clauses(&[
        "The agreement between the numerical values of the resonance frequency and the second order approximation (as functions of flock size) is excellent.",
        "The agreement between the numerical values of the resonance amplitude and the second order approximation (as functions of flock size) is excellent.",
    ])
    .altered("Theorem 1 with N + 2 for N + 1", |v| v.offset = 1)
    .altered("Theorem 1 with f = -2", |v| v.f = -2)
    .altered("Theorem 1 with g = -2", |v| v.g = -2)
    .altered("0.05 per cent for small flocks too", |v| v.small = (1, 2000))
}

fn examine_figure4(variant: &Figure4Variant, run: &mut Run) -> Result<Outcome, CheckError> {
    const LARGEST: u64 = 128;
    let gains = gains(((variant.f, 1), (variant.g, 1)));
    let mut values = Vec::new();
    let detail = format!("relative differences for every M from 4 to {LARGEST}, f = g = -1");
    let evidence = certified("enclosed resonance against Theorem 1", detail).for_all();
    let curves = run.every(evidence, 4..=LARGEST, |m| {
        for (what, (found, leading)) in ["frequency", "amplitude"].into_iter().zip(pairs(m, &gains, variant.offset)?) {
            let relative = leading.over(&found)? - found.one();
            if ROWS.iter().any(|row| row.n == m) {
                let name = format!("relative_difference_of_the_{what}_{m}_followers");
                values.push((name, interval_value(&relative, 6)));
            }
            if !within(&relative, &rational(0, 1), &variant.limit(m)) {
                let size = interval_value(&relative, 6);
                return Ok(Some(format!("{m} followers: the relative difference of the {what} is {size}")));
            }
        }
        Ok(None)
    })?;
    values.into_iter().for_each(|(name, value)| run.value(&name, value));
    Run::all([Ok(curves), printed_cells(variant, run)]).on([1, 2])
}

/// The numbers of Table 1, which the figure shows.
fn printed_cells(variant: &Figure4Variant, run: &Run) -> Result<Outcome, CheckError> {
    let columns: [[Column; 2]; 2] = [[|r| r.nfreq, |r| r.tfreq], [|r| r.namp, |r| r.tamp]];
    let cases = ROWS.iter().flat_map(|row| columns.map(|pair| (row, pair)));
    let evidence = exact("printed numbers", "cells of Table 1 in pairs, N = 4 to 128").for_all();
    run.every(evidence, cases, |(row, [first, second])| {
        let (first, second) = (printed_decimal(first(row))?.0, printed_decimal(second(row))?.0);
        let relative = (&first - &second) / &second;
        let far = relative > variant.limit(row.n) || -relative > variant.limit(row.n);
        Ok(far.then(|| format!("Table 1, N = {}: {first} and {second}", row.n)))
    })
}

/// The slope of the regression line of `ln |difference|` over `ln N` lies within 1/10 of `slope`; the differences are those of the frequency or of
/// the amplitude, for `N + offset` followers.
#[derive(Clone, Copy)]
pub struct Figure5Variant {
    slope: i64,
    of_amplitude: bool,
    offset: i64,
}

pub fn figure5() -> Record<Figure5Variant> {
    Record::new(
        "veerman.fig5",
        "Two sets of differences over the sizes N = 4, 8, ..., 128: those of the true resonance of N followers from Theorem 1, \
         enclosed, and those of the printed columns NFREQ and TFREQ. In both the slope is close to -3, as the expansion \
         w_0 - w = 0.2855/M³ + O(M^-5) says. (With N + 1 followers plotted over N the slope is near -2.8: value.)",
        Figure5Variant { slope: -3, of_amplitude: false, offset: 0 },
        examine_figure5,
    )
    .reading("Close to -3: within 1/10. The sizes are those of Table 1, the flock of a row has N followers.")
    .altered("slope -2", |v| v.slope = -2)
    .altered("N + 1 followers over N", |v| v.offset = 1)
    .altered("the amplitude in the place of the frequency", |v| v.of_amplitude = true)
}

fn examine_figure5(variant: &Figure5Variant, run: &mut Run) -> Result<Outcome, CheckError> {
    let interval = |q: &Rational| Interval::from_rational(q, PRECISION);
    let abscissa = |n: u64| interval(&rational(n as i64, 1)).ln();
    let enclosed = |offset: i64| -> Result<Interval, CheckError> {
        let point = |row: &Row| {
            let (found, leading) =
                pairs(row.n.saturating_add_signed(offset), &unit(), 0)?[usize::from(variant.of_amplitude)].clone();
            let difference = if variant.of_amplitude { found - leading } else { leading - found };
            Ok((abscissa(row.n)?, difference.ln()?))
        };
        let points: Vec<_> = ROWS.iter().map(point).collect::<Result<_, CheckError>>()?;
        Ok(regression_line(&points)?.0)
    };
    let printed = ROWS.iter().map(|row| {
        let difference = printed_decimal(row.nfreq)?.0 - printed_decimal(row.tfreq)?.0;
        Ok((abscissa(row.n)?, interval(&difference).ln()?))
    });
    let printed = regression_line(&printed.collect::<Result<Vec<_>, CheckError>>()?)?.0;
    run.value("slope_with_N+1_followers", interval_value(&enclosed(1)?, 6));
    let slopes = [("enclosed", enclosed(variant.offset)?), ("printed", printed)];
    Run::all(slopes.map(|(name, slope)| {
        run.value(&format!("slope_{name}"), interval_value(&slope, 8));
        let detail = "least squares in the logarithms, six sizes";
        let evidence = certified(format!("{name} differences"), detail).cases(ROWS.len());
        let steep = !within(&slope, &rational(variant.slope, 1), &rational(1, 10));
        let what = || format!("{name} differences: the slope is {}", interval_value(&slope, 8));
        unless(steep.then(what), evidence).for_all()
    }))
}
