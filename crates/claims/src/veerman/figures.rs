//! veerman.fig4, veerman.fig5: how well Theorem 1 agrees with the resonance.

use crate::printed_decimal;
use arithmetic::{Field, Interval, Rational, Real, Ring, Signed, rational, regression_line};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, interval_value};
use models::platoon::table1::{ROWS, Row};
use models::platoon::{Gains, resonance, theorem1};

const PRECISION: u32 = 120;
const DIGITS: u32 = 24;

fn minus_one() -> Gains<Rational> {
    Gains { f: rational(-1, 1), g: rational(-1, 1) }
}

/// Enclosures of frequency and amplitude of the main resonance, and what Theorem 1 gives for `M + offset` followers.
fn pairs(m: u64, offset: i64) -> Result<[(Interval, Interval); 2], CheckError> {
    let found = resonance(&minus_one(), m, DIGITS)?;
    let gains = minus_one().map(|q| Interval::from_rational(q, PRECISION));
    let size = m.saturating_add_signed(offset);
    let leading = [theorem1::frequency(&gains, size)?, theorem1::amplitude(&gains, size)?];
    let [w, a] = leading;
    Ok([(found.omega, w), (found.amplitude, a)])
}

/// veerman.fig4.
pub struct Figure4;

/// "Excellent": relative differences of at most `smallest` from 4 cars on and at most `from_32` from 32 cars on, with Theorem 1 for
/// `M + offset` followers.
#[derive(Clone, Copy)]
pub struct Figure4Variant {
    smallest: (i64, i64),
    from_32: (i64, i64),
    offset: i64,
}

impl Figure4Variant {
    fn limit(&self, size: u64) -> Rational {
        let (p, q) = if size < 32 { self.smallest } else { self.from_32 };
        rational(p, q)
    }
}

impl Claim for Figure4 {
    type Variant = Figure4Variant;

    fn id(&self) -> &str {
        "veerman.fig4"
    }

    fn derivation(&self) -> &str {
        "Excellent is read as: the curves of the figure differ by at most 2.5 per cent at any size from 4 on and by at most 0.05 per cent from \
         32 on. The true resonance is enclosed for M = 4 to 128 followers (the figure's range; the printed numbers are for N followers); beyond, beyond.veerman.resonance_frequency and \
         resonance_amplitude bound the differences by (0.26/M²)(1 + 62/M²) for all M >= 5. The four columns of Table 1 meet the same limits, although \
         its headings are exchanged and its simulated values not accurate to their digits (veerman.table1_*)."
    }

    fn printed(&self) -> Figure4Variant {
        Figure4Variant { smallest: (1, 40), from_32: (1, 2000), offset: 0 }
    }

    fn controls(&self) -> Vec<Control<Figure4Variant>> {
        let printed = self.printed();
        vec![
            Control::new("one per cent from 4 on", Figure4Variant { smallest: (1, 100), ..printed }),
            Control::new("0.02 per cent from 32 on", Figure4Variant { from_32: (1, 5000), ..printed }),
            Control::new("Theorem 1 with N + 2 for N + 1", Figure4Variant { offset: 1, ..printed }),
        ]
    }

    fn examine(&self, variant: &Figure4Variant, run: &mut Run) -> Result<Outcome, CheckError> {
        const LARGEST: u64 = 128;
        for m in 4..=LARGEST {
            for (what, (found, leading)) in ["frequency", "amplitude"].into_iter().zip(pairs(m, variant.offset)?) {
                let relative = leading.over(&found)? - found.one();
                if ROWS.iter().any(|row| row.n == m) {
                    run.value(
                        &format!("relative_difference_of_the_{what}_{m}_followers"),
                        interval_value(&relative, 6),
                    );
                }
                let limit = variant.limit(m);
                let (lo, hi) = relative.to_rationals();
                if lo < -limit.clone() || hi > limit {
                    let size = interval_value(&relative, 6);
                    return Ok(Outcome::fails(
                        format!("{m} followers: the relative difference of the {what} is {size}"),
                        Evidence::new(Grade::Certified, "enclosed resonance", "against Theorem 1"),
                    ));
                }
            }
        }
        let detail = format!("relative differences for every M from 4 to {LARGEST}, f = g = -1");
        let enclosed = Evidence::new(Grade::Certified, "enclosed resonance", detail).cases(2 * (LARGEST as usize - 3));
        Run::all([Ok(Outcome::Holds(vec![enclosed])), printed_cells(variant)])
    }
}

/// A column of Table 1.
type Column = fn(&Row) -> &'static str;

/// The numbers of Table 1, which the figure shows.
fn printed_cells(variant: &Figure4Variant) -> Result<Outcome, CheckError> {
    let columns: [[Column; 2]; 2] = [[|r| r.nfreq, |r| r.tfreq], [|r| r.namp, |r| r.tamp]];
    for row in &ROWS {
        for [first, second] in columns {
            let (first, second) = (printed_decimal(first(row))?.0, printed_decimal(second(row))?.0);
            let relative = (&first - &second) / &second;
            if relative > variant.limit(row.n) || -relative > variant.limit(row.n) {
                return Ok(Outcome::fails(
                    format!("Table 1, N = {}: {first} and {second}", row.n),
                    Evidence::new(Grade::Exact, "printed numbers", "cells of Table 1"),
                ));
            }
        }
    }
    let detail = "cells of Table 1 in pairs, N = 4 to 128";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "printed numbers", detail).cases(2 * ROWS.len())]))
}

/// veerman.fig5.
pub struct Figure5;

/// The slope of the regression line of `ln |difference|` over `ln N` lies within `tolerance` of `slope`.
#[derive(Clone, Copy)]
pub struct Figure5Variant {
    slope: (i64, i64),
    tolerance: (i64, i64),
}

impl Claim for Figure5 {
    type Variant = Figure5Variant;

    fn id(&self) -> &str {
        "veerman.fig5"
    }

    fn derivation(&self) -> &str {
        "Close to -3 is read as: within 1/10. Two sets of differences over the sizes N = 4, 8, ..., 128: those of the true resonance of N followers from Theorem 1, \
         enclosed, and those of the printed columns NFREQ and TFREQ. In both the slope is close to -3, as the expansion \
         w_0 - w = 0.2855/M³ + O(M^-5) says. (With N + 1 followers plotted over N the slope is near -2.8: value.)"
    }

    fn printed(&self) -> Figure5Variant {
        Figure5Variant { slope: (-3, 1), tolerance: (1, 10) }
    }

    fn controls(&self) -> Vec<Control<Figure5Variant>> {
        let printed = self.printed();
        vec![
            Control::new("slope -2", Figure5Variant { slope: (-2, 1), ..printed }),
            Control::new("slope -14/5", Figure5Variant { slope: (-14, 5), ..printed }),
            Control::new("-3 within 1/1000", Figure5Variant { tolerance: (1, 1000), ..printed }),
        ]
    }

    fn examine(&self, variant: &Figure5Variant, run: &mut Run) -> Result<Outcome, CheckError> {
        let interval = |q: &Rational| Interval::from_rational(q, PRECISION);
        let abscissa = |n: u64| interval(&rational(n as i64, 1)).ln();
        let (mut enclosed, mut shifted, mut printed) = (Vec::new(), Vec::new(), Vec::new());
        for row in &ROWS {
            for (points, followers) in [(&mut enclosed, row.n), (&mut shifted, row.n + 1)] {
                let [(found, leading), _] = pairs(followers, 0)?;
                points.push((abscissa(row.n)?, (leading - found).ln()?));
            }
            let difference = printed_decimal(row.nfreq)?.0 - printed_decimal(row.tfreq)?.0;
            printed.push((abscissa(row.n)?, interval(&difference).ln()?));
        }
        run.value("slope_with_N+1_followers", interval_value(&regression_line(&shifted)?.0, 6));
        let (slope, tolerance) =
            (rational(variant.slope.0, variant.slope.1), rational(variant.tolerance.0, variant.tolerance.1));
        let mut evidence = Vec::new();
        for (name, points) in [("enclosed", enclosed), ("printed", printed)] {
            let found = regression_line(&points)?.0;
            run.value(&format!("slope_{name}"), interval_value(&found, 8));
            let distance = found.clone() - interval(&slope);
            let detail = "least squares in the logarithms, six sizes";
            let piece = Evidence::new(Grade::Certified, format!("{name} differences"), detail).cases(points.len());
            let outside = |d: Interval| !(interval(&tolerance) - d).is_certainly_positive();
            if outside(distance.clone()) || outside(-distance) {
                return Ok(Outcome::fails(
                    format!("{name} differences: the slope is {}", interval_value(&found, 8)),
                    piece,
                ));
            }
            evidence.push(piece);
        }
        Ok(Outcome::Holds(evidence))
    }
}
