//! Peaks and gain margins of random platoons, against the response at single frequencies and the stability of single platoons.

use super::{Checked, Invariant, OrFails, Stop, Tested, require, shown};
use crate::draws::Draws;
use arithmetic::{Rational, Unwatched, rational};
use models::platoon::gain_margin::{GainMargin, MOST_EXACT, gain_margin};
use models::platoon::vector_form::{is_stable, motion_rows_of_cars};
use models::platoon::{CommunicationGraph, Gains, PeakError, peak_on_graph};
use num_traits::ToPrimitive;

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "platoon.peak",
        statement: "A platoon on any directed graph with gains for each car has a peak exactly if it is stable, no frequency of a dense scan has a larger \
                    amplitude than the enclosure of the peak allows, and at its frequency the amplitude is that of the peak.",
        control: "the amplitude of the peak less 2^-20 of it",
        block: 5,
        check: peak,
    },
    Invariant {
        id: "platoon.gain_margin",
        statement: "A stable platoon stays stable when all gains are multiplied by a factor between the ends of its gain margin, and is not stable just \
                    beyond them.",
        control: "an infinite gain margin, whatever is found",
        block: 5,
        check: margin,
    },
    Invariant {
        id: "platoon.gain_margin_of_twelve",
        statement: "A platoon of twelve cars that is stable is so at all factors of a dense scan that lie between the ends of its gain margin, and is \
                    not stable just beyond them; one that is not stable has no peak.",
        control: "an infinite gain margin, whatever is found",
        block: 1,
        check: margin_of_most,
    },
];

const WEIGHTS: [i64; 3] = [1, 10, 100];
const GAINS: [(i64, i64); 7] = [(-10, 1), (-5, 1), (-2, 1), (-1, 1), (-1, 2), (-1, 10), (-1, 100)];

struct Platoon {
    graph: CommunicationGraph,
    gains: Vec<Gains<Rational>>,
}

impl Platoon {
    /// Car `k` tracks cars at random, the one in front among them more often than not, and all or none have the same gains.
    fn drawn(draws: &mut Draws, followers: usize) -> Result<Self, Stop> {
        let mut rows = Vec::new();
        for k in 1..=followers {
            let mut heard = Vec::new();
            for agent in (0..=followers).filter(|agent| *agent != k) {
                if draws.below(3) == 0 || agent + 1 == k && draws.below(2) == 0 {
                    heard.push((agent, *draws.choice(&WEIGHTS)));
                }
            }
            if heard.is_empty() {
                heard.push((k - 1, 1));
            }
            let sum: i64 = heard.iter().map(|(_, weight)| weight).sum();
            rows.push(heard.into_iter().map(|(agent, weight)| (agent, rational(weight, sum))).collect());
        }
        let mut pair = || (*draws.choice(&GAINS), *draws.choice(&GAINS));
        let all: Vec<_> = (0..followers).map(|_| pair()).collect();
        let equal = draws.below(2) == 0;
        let own = |k: usize| {
            let ((a, b), (c, d)) = all[if equal { 0 } else { k }];
            Gains { f: rational(a, b), g: rational(c, d) }
        };
        let graph = CommunicationGraph::new(rows).or_fails("the graph is refused")?;
        Ok(Platoon { graph, gains: (0..followers).map(own).collect() })
    }

    fn described(&self) -> String {
        let row = |k: usize| {
            let heard = self.graph.tracked_by(k).iter().map(|(agent, weight)| format!("{agent} ({weight})"));
            format!("car {k} tracks {}, f {}, g {}", shown(heard), self.gains[k - 1].f, self.gains[k - 1].g)
        };
        (1..=self.gains.len()).map(row).collect::<Vec<_>>().join("; ")
    }

    /// Whether it is stable with all gains multiplied by a factor, by its characteristic polynomial.
    fn is_stable(&self, factor: &Rational) -> Result<bool, Stop> {
        let reduced = self.graph.reduced_laplacian().or_fails("there is no Laplacian")?;
        let gains: Vec<Gains<Rational>> = self.gains.iter().map(|gains| gains.map(|q| q * factor)).collect();
        let rows = motion_rows_of_cars(&reduced, |k| &gains[k]);
        let motion = algebra::matrix::RationalMatrix::from_rows(&rows).or_fails("there is no matrix")?;
        is_stable(&motion).or_fails("stability is refused")
    }

    /// The square of the amplitude of the last car, exactly.
    fn squared(&self, w: &Rational) -> Option<Rational> {
        let all = self.graph.response_of_cars(&self.gains, w).ok()?;
        all.last().map(|amplitude| amplitude.norm_squared())
    }

    /// The frequency of the best of a scan in floating point.
    fn scanned(&self) -> Option<Rational> {
        let floats: Vec<Gains<f64>> =
            self.gains.iter().map(|gains| gains.map(|q| q.to_f64().unwrap_or(f64::NAN))).collect();
        let size = |w: f64| {
            let all = self.graph.response_of_cars(&floats, &w).ok();
            all.and_then(|all| all.last().map(|a| a.norm_squared())).unwrap_or(0.0)
        };
        let scan = (0..1500).map(|k| 1e-4 * 1.01f64.powi(k)).map(|w| (w, size(w)));
        let best = scan.max_by(|a, b| a.1.total_cmp(&b.1))?;
        Rational::from_float(best.0)
    }
}

fn peak(draws: &mut Draws, tested: Tested) -> Checked {
    let followers = draws.between(1, 6);
    let platoon = Platoon::drawn(draws, followers)?;
    let described = || platoon.described();
    let stable = platoon.is_stable(&rational(1, 1))?;
    let found = match peak_on_graph(&platoon.graph, &platoon.gains, followers, 12, &Unwatched) {
        Ok(found) => found,
        Err(PeakError::NotStable) => {
            require(!stable, "a stable platoon has no peak", described)?;
            return Ok(None);
        }
        Err(error) => return Err(Stop::Undecided(error.to_string())),
    };
    require(stable, "a platoon that is not stable has a peak", described)?;
    let (lo, hi) = found.amplitude.to_rationals();
    let hi = if tested.is_altered() { hi * (rational(1, 1) - rational(1, 1 << 20)) } else { hi };
    let omega = found.omega.or_fails("the peak is nowhere")?;
    let (from, to) = omega.to_rationals();
    let middle = (from + to) / rational(2, 1);
    let zero = rational(0, 1);
    for w in [Some(middle.clone()), platoon.scanned()].into_iter().flatten().filter(|w| *w > zero) {
        let Some(square) = platoon.squared(&w) else { continue };
        require(square <= &hi * &hi, format!("at omega = {w} the amplitude is larger than {hi}"), described)?;
        // The top is flat: beside it by a part in 10^12 the amplitude is lower by far less than in 10^9.
        let near = w != middle || square * rational(1_000_000_001, 1_000_000_000) >= &lo * &lo;
        require(near, format!("at omega = {w} the amplitude is below {lo}"), described)?;
    }
    Ok(None)
}

/// The ends of the gain margin of a stable platoon, each between two numbers.
fn ends(platoon: &Platoon, tested: Tested) -> Result<[Option<(Rational, Rational)>; 2], Stop> {
    let reduced = platoon.graph.reduced_laplacian().or_fails("there is no Laplacian")?;
    match gain_margin(&reduced, &platoon.gains).or_fails("the margin is refused")? {
        GainMargin::Open(why) => Err(Stop::Undecided(why)),
        GainMargin::Ends { below, above } if !tested.is_altered() => {
            Ok([below, above].map(|end| end.map(|end| end.to_rationals())))
        }
        _ => Ok([None, None]),
    }
}

/// Whether it is stable with those of the factors that lie between the ends, and not just beyond them.
fn ends_there(
    platoon: &Platoon,
    [below, above]: &[Option<(Rational, Rational)>; 2],
    factors: impl IntoIterator<Item = Rational>,
) -> Result<(), Stop> {
    let between = |factor: &Rational| {
        below.as_ref().is_none_or(|(_, hi)| factor > hi) && above.as_ref().is_none_or(|(lo, _)| factor < lo)
    };
    for factor in factors.into_iter().filter(between) {
        let why = format!("with the factor {factor} it is not stable");
        require(platoon.is_stable(&factor)?, why, || platoon.described())?;
    }
    let (one, near) = (rational(1, 1), rational(1, 1_000_000));
    let beyond = [below.as_ref().map(|(lo, _)| lo * (&one - &near)), above.as_ref().map(|(_, hi)| hi * (&one + &near))];
    for factor in beyond.into_iter().flatten() {
        let why = format!("with the factor {factor} it is stable");
        require(!platoon.is_stable(&factor)?, why, || platoon.described())?;
    }
    Ok(())
}

fn margin(draws: &mut Draws, tested: Tested) -> Checked {
    let followers = draws.between(1, 6);
    let platoon = Platoon::drawn(draws, followers)?;
    let one = rational(1, 1);
    if !platoon.is_stable(&one)? {
        return Ok(None);
    }
    let found = ends(&platoon, tested)?;
    let low = found[0].as_ref().map_or(rational(0, 1), |(_, hi)| hi.clone());
    let mut factors = vec![rational(1, 1_000_000)];
    for k in 1..8i64 {
        factors.push(&low + (&one - &low) * rational(k * k, 64));
        let above = found[1].as_ref().map(|(lo, _)| &one + (lo - &one) * rational(k, 8));
        factors.push(above.unwrap_or_else(|| rational(1 << (2 * k), 1)));
    }
    ends_there(&platoon, &found, factors)?;
    Ok(None)
}

/// The largest platoons whose margin is decided whatever the gains, at factors from 1/1000 to 1000, each a fifth larger than the one before.
fn margin_of_most(draws: &mut Draws, tested: Tested) -> Checked {
    const STEPS: [i64; 12] = [100, 121, 147, 178, 215, 261, 316, 383, 464, 562, 681, 825];
    let platoon = Platoon::drawn(draws, MOST_EXACT)?;
    if !platoon.is_stable(&rational(1, 1))? {
        let found = peak_on_graph(&platoon.graph, &platoon.gains, MOST_EXACT, 6, &Unwatched);
        let refused = matches!(found, Err(PeakError::NotStable));
        require(refused, "a platoon that is not stable has a peak", || platoon.described())?;
        return Ok(None);
    }
    let factors = (0..6).flat_map(|decade| STEPS.map(|step| rational(step * 10i64.pow(decade), 100_000)));
    ends_there(&platoon, &ends(&platoon, tested)?, factors)?;
    Ok(None)
}
