//! How fast symmetric circular formations are reached: enclosed spectral abscissae of their linearisations.

use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::threads::side_by_side;
use arithmetic::{Interval, Rational, decimals, parse_rational, rational};
use ledger::CheckError;
use models::oscillator::{FourierFormation, TransverseSpectrum};
use runs::{CyclicFormation, OMEGA, PARTICLES, PatternFormation};
use std::fmt::Write;

/// Numbers of particles; all their divisors are taken.
const ORDERS: [usize; 6] = [5, 8, 12, 18, 24, 30];
/// Gains of a curve: from 1/1000 to 10, so many for each factor ten.
const STEPS: i32 = 12;

/// The number that is printed for this float.
fn printed(x: f64) -> Result<Rational, CheckError> {
    parse_rational(&x.to_string()).map_err(|error| CheckError::Other(error.to_string()))
}

fn spectrum(formation: &FourierFormation) -> Result<TransverseSpectrum, CheckError> {
    formation.transverse()?.ok_or_else(|| CheckError::Other("a formation without transverse motions".to_string()))
}

/// Figure 4 with other numbers of particles and another `-K_M`.
fn pattern(clusters: usize, particles: usize, last: &Rational) -> Result<TransverseSpectrum, CheckError> {
    let (omega, below) = (printed(OMEGA)?, printed(PatternFormation::GAINS.0)?);
    let gains: Vec<Rational> =
        (1..=clusters).map(|m| if m < clusters { below.clone() } else { -last.clone() }).collect();
    let formation = FourierFormation::pattern(clusters, particles, (&omega, &omega), &gains);
    spectrum(&formation.ok_or_else(|| CheckError::Other(format!("{clusters} does not divide {particles}")))?)
}

/// Figure 3: the phases `2 pi m k/12` on the cyclic graph.
pub(super) fn twisted(gain: f64, wave: i64) -> Result<TransverseSpectrum, CheckError> {
    let omega = printed(OMEGA)?;
    let spacing = &omega * rational(PARTICLES as i64, 1);
    let wave = wave.rem_euclid(PARTICLES as i64) as usize;
    spectrum(&FourierFormation::new(PARTICLES, [1], wave, (&omega, &spacing)).with_alignment(&printed(gain)?))
}

/// Six digits that are known.
pub(super) fn rate(x: &Interval) -> String {
    format!("{:.6}", x.to_f64())
}

/// Gains from 1/1000 to 10 with three digits.
fn gains() -> Result<Vec<(f64, Rational)>, CheckError> {
    let gain = |k: i32| {
        let x = 10f64.powf(f64::from(k) / f64::from(STEPS));
        let text = format!("{x:.2e}");
        let q = parse_rational(&text).map_err(|error| CheckError::Other(error.to_string()))?;
        Ok((text.parse().map_err(|_| CheckError::Other(text.clone()))?, q))
    };
    (-3 * STEPS..=STEPS).map(gain).collect()
}

fn row(model: &str, particles: usize, kind: usize, gain: &str, found: &TransverseSpectrum) -> Vec<String> {
    let (lo, hi) = decimals(&found.abscissa, 17);
    [
        model,
        &particles.to_string(),
        &kind.to_string(),
        gain,
        &found.zeros.to_string(),
        &found.wave.to_string(),
        &lo,
        &hi,
    ]
    .map(str::to_string)
    .to_vec()
}

/// Rates over the gain: `(gain, -abscissa)`.
fn curve(
    name: String,
    of: impl Fn(f64, &Rational) -> Result<TransverseSpectrum, CheckError> + Sync,
) -> Result<Series, CheckError> {
    let points = side_by_side(&gains()?, |(x, q)| Ok((*x, -of(*x, q)?.abscissa.to_f64())));
    let points = points.into_iter().collect::<Result<Vec<_>, CheckError>>()?;
    Ok(Series::line(name, points))
}

/// The patterns of all numbers of particles, as rows of the table, lines of the text, and points.
fn patterns(text: &mut String, table: &mut Vec<Vec<String>>) -> Result<Panel, CheckError> {
    let last = printed(PatternFormation::GAINS.1)?;
    let panel = Panel::new(
        "a) gains of Figure 4, all M and N",
        Axis::linear("M"),
        Axis::log("rate (per unit of time)").between(2e-3, 0.1),
    );
    // The rate depends on N through M < N or M = N only.
    let (mut fewer, mut single) = (Vec::new(), Vec::new());
    for particles in ORDERS {
        for clusters in (1..=particles).filter(|m| particles.is_multiple_of(*m)) {
            let found = pattern(clusters, particles, &last)?;
            let points = if clusters < particles { &mut fewer } else { &mut single };
            points.push((clusters as f64, -found.abscissa.to_f64()));
            table.push(row("(25)", particles, clusters, &format!("-{}", PatternFormation::GAINS.1), &found));
            if particles == PARTICLES {
                let (lo, hi) = decimals(&found.abscissa, 12);
                // Writing to a string cannot fail.
                let _ =
                    writeln!(text, "{clusters:4} {:8}   {:37} {:6}", found.zeros, format!("[{lo}, {hi}]"), found.wave);
            }
        }
    }
    Ok(panel.series(Series::points("M < N", fewer).size(4.0)).series(Series::points("M = N", single).size(4.0)))
}

/// The twisted states of Figure 3 for its gains.
fn twists(text: &mut String, table: &mut Vec<Vec<String>>) -> Result<(), CheckError> {
    let gain = CyclicFormation::GAIN;
    for (gain, waves) in [(-gain, 0..=2), (-1.0, 0..=2), (gain, 4..=6), (1.0, 4..=6)] {
        let _ = write!(text, "{gain:5}");
        for wave in waves {
            let found = twisted(gain, wave)?;
            let _ = write!(text, "   m = {wave}: {}", rate(&found.abscissa));
            table.push(row("(22) on C_12", PARTICLES, wave as usize, &gain.to_string(), &found));
        }
        text.push('\n');
    }
    Ok(())
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let (below, last) = PatternFormation::GAINS;
    let mut text = format!(
        "Largest real part of the linearisation at symmetric circular formations,\n\
         enclosed, without the eigenvalues that symmetry forces: 0 of the rotation and\n\
         +-i w0 of the translations, divided out exactly. Cubics for each wave number q\n\
         and Routh's table of the shifted cubics; notes/paley_particles.md.\n\n\
         Theorem 3 with the gains of Figure 4, N = 12: w0 = K_0 = {OMEGA}, K_m = {below}, K_M =\n\
         -{last}; zeros: how many were removed; q: a slowest mode\n\
         \x20  M    zeros   abscissa                                   q\n"
    );
    let mut table = Vec::new();
    let all = patterns(&mut text, &mut table)?;
    text += "The abscissa depends on N through M < N or M = N only. N = 5 to 30: the table.\n\n\
             (22) on C_12, K_0 = N w0: th_k = 2 pi m k/12, the stable ones of m = 0 to 6\n\
             \x20 K_1\n";
    twists(&mut text, &mut table)?;
    text += "\nMore gain is not faster: beyond some gain the rate falls again (panels b, c).\n\
             Centres move only while u_k differs from w0, and phases that are held firmly\n\
             keep u_k at w0.\n";
    let axes = |title: &str, gain: &str| {
        Panel::new(
            title,
            Axis::log(gain).ticks([0.001, 0.01, 0.1, 1.0, 10.0]),
            Axis::log("rate (per unit of time)").between(1e-6, 1.0),
        )
    };
    let mut raised = axes("b) N = 12, K_m = 0.2, over |K_M|", "|K_M|");
    for clusters in [1, 2, 3, 4, 12] {
        raised = raised.series(curve(format!("M = {clusters}"), |_, last| pattern(clusters, PARTICLES, last))?);
    }
    let mut ring = axes("c) Figure 3 on the ring, over |K_1|", "|K_1|");
    for (wave, sign) in [(0, -1.0), (1, -1.0), (2, -1.0), (4, 1.0), (5, 1.0), (6, 1.0)] {
        let name = format!("m = {wave}, K_1 {} 0", if sign < 0.0 { "<" } else { ">" });
        ring = ring.series(curve(name, |gain, _| twisted(sign * gain, wave))?);
    }
    let picture = Picture::new("Rates of decay to symmetric circular formations, ω_0 = 0.1")
        .caption("Some curves coincide over a part of the range.")
        .grid(3, (340.0, 360.0))
        .panel(all)
        .panel(raised)
        .panel(ring);
    let header = "model,N,M_or_m,K_M_or_K_1,zeros,q,abscissa_lo,abscissa_hi";
    Ok(Reproduced::new(text).table("", csv(header, table)).picture("", picture))
}
