//! paley.chord, paley.fig7: the geometry of the zones.

use super::instances::scattered_phasors;
use crate::prelude::*;
use models::oscillator::{Zone, phasor};
use runs::zones_of_figure_7;

/// The distance of clusters `steps` places apart is `factor sin(pi steps'/M)`.
#[derive(Clone, Copy)]
pub struct ChordVariant {
    factor: i64,
    /// Twice the angle in the sine over the angle between clusters: 1 for half of it.
    doubled: u64,
}

fn chords(variant: &ChordVariant) -> Identity<'_> {
    Identity::of(|[tangent]| {
        // e^{i a} with a = pi/M or any angle; the clusters are at 1 and e^{2 i a}.
        let half = phasor(tangent)?;
        let distance = (half.square() - Complex::real(tangent.one())).norm_squared();
        let sine = half.power(variant.doubled).im;
        Ok((vec![distance], vec![sine.square() * tangent.integer(variant.factor * variant.factor)]))
    })
}

pub fn chord() -> Record<ChordVariant> {
    Record::new(
        "paley.chord",
        "Neighbouring clusters at 1 and e^{2 pi i/M}: |1 - e^{2 i a}|^2 = 4 sin^2 a with a = pi/M, and sin \
         a > 0 for M >= 2. An identity in a, hence for M = 2, 8, 12 and every other M.",
        ChordVariant { factor: 2, doubled: 1 },
        |variant, run| {
            run.identity(&chords(variant), &["tan(a/2)"], "|1 - e^{2 i a}|^2 = 4 sin^2 a, a = pi/M").for_all()
        },
    )
    .altered("sin(pi/M)", |v| v.factor = 1)
    .altered("2 sin(2 pi/M)", |v| v.doubled = 2)
}

/// The order of the outer radii, the side of the blind spot, and `cos^2` of half its angle.
#[derive(Clone, Copy)]
pub struct ZonesVariant {
    swapped: bool,
    ahead: bool,
    cosine: (i64, i64),
}

pub fn perceptual_zones() -> Record<ZonesVariant> {
    Record::new(
        "paley.fig7",
        "A schematic figure that shows definitions: a point is in the zone of repulsion, orientation or \
         attraction by its distance alone (annuli around the fish, both boundaries counted, so that a \
         boundary belongs to two), unless it lies in the open wedge of angular width alpha_k around the \
         direction opposite to the heading. That the zones of the library are these is decided on a grid \
         for alpha = 60 degrees and rational headings; it says nothing about the paper.",
        ZonesVariant { swapped: false, ahead: false, cosine: (3, 4) },
        examine_perceptual_zones,
    )
    .altered("attraction inside orientation", |v| v.swapped = true)
    .altered("blind spot in front", |v| v.ahead = true)
    .altered("a blind spot of 90 degrees", |v| v.cosine = (1, 2))
}

fn examine_perceptual_zones(variant: &ZonesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const REACH: i64 = 8;
    let zones = zones_of_figure_7(&rational(1, 1));
    let bounds = if variant.swapped { [(0, 2), (4, 7), (2, 4)] } else { [(0, 2), (2, 4), (4, 7)] };
    let cases = scattered_phasors(6)?.into_iter().flat_map(|heading| {
        let grid = (-REACH..=REACH).flat_map(|x| (-REACH..=REACH).map(move |y| (x, y)));
        grid.map(move |place| (heading.clone(), place))
    });
    let detail = "annuli by distance and a wedge behind, six rational headings, a grid of 17 x 17 points each";
    let evidence = exact("the zones of the library are those of the figure", detail);
    let found = run.every(evidence, cases, |(heading, (x, y))| {
        // In the frame of the fish: x ahead, y to the left.
        let offset = heading.clone() * Complex::new(rational(x, 1), rational(y, 1));
        let (behind, square) = (if variant.ahead { x } else { -x }, x * x + y * y);
        let (p, q) = variant.cosine;
        let blind = behind > 0 && q * behind * behind > p * square;
        let wrong = [Zone::Repulsion, Zone::Orientation, Zone::Attraction].into_iter().zip(bounds).find(
            |&(zone, (inner, outer))| {
                let inside = inner * inner <= square && square <= outer * outer && !blind;
                zones.senses(zone, &heading, &offset) != inside
            },
        );
        Ok(wrong.map(|(zone, _)| format!("{zone:?}: the point {x} ahead and {y} to the left of the fish")))
    })?;
    Ok(match found {
        Outcome::Holds(evidence) => {
            let why = "a schematic figure of definitions, which has no truth value";
            Outcome::NotCheckable(why.to_string(), evidence)
        }
        other => other,
    })
}
