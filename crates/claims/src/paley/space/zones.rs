//! paley.chord, paley.fig7: the geometry of the zones.

use super::instances::scattered_phasors;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Ring, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use models::oscillator::{Zone, phasor, zones_of_figure_7};

/// paley.chord.
pub struct Chord;

/// The distance of clusters `steps` places apart is `factor sin(pi steps'/M)`.
#[derive(Clone, Copy)]
pub struct ChordVariant {
    factor: i64,
    /// Twice the angle in the sine over the angle between clusters: 1 for half of it.
    doubled: u64,
}

impl RationalIdentity for ChordVariant {
    fn variables(&self) -> usize {
        1
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        // e^{i a} with a = pi/M or any angle; the clusters are at 1 and e^{2 i a}.
        let half = phasor(&at[0])?;
        let distance = (half.square() - Complex::real(at[0].one())).norm_squared();
        let sine = half.power(self.doubled).im;
        Ok((vec![distance], vec![sine.square() * at[0].integer(self.factor * self.factor)]))
    }
}

impl Claim for Chord {
    type Variant = ChordVariant;

    fn id(&self) -> &str {
        "paley.chord"
    }

    fn derivation(&self) -> &str {
        "Neighbouring clusters at 1 and e^{2 pi i/M}: |1 - e^{2 i a}|^2 = 4 sin^2 a with a = pi/M, and sin a > 0 for M >= 2. An identity in a, hence for M = 2, 8, 12 \
         and every other M."
    }

    fn printed(&self) -> ChordVariant {
        ChordVariant { factor: 2, doubled: 1 }
    }

    fn controls(&self) -> Vec<Control<ChordVariant>> {
        vec![
            Control::new("sin(pi/M)", ChordVariant { factor: 1, doubled: 1 }),
            Control::new("2 sin(2 pi/M)", ChordVariant { factor: 2, doubled: 2 }),
        ]
    }

    fn examine(&self, variant: &ChordVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        run.identity(variant, &["tan(a/2)"], "|1 - e^{2 i a}|^2 = 4 sin^2 a, a = pi/M")
    }
}

/// paley.fig7.
pub struct PerceptualZones;

/// The order of the outer radii and the side of the blind spot.
#[derive(Clone, Copy)]
pub struct ZonesVariant {
    swapped: bool,
    ahead: bool,
    /// `cos^2` of half the blind angle that is claimed.
    claimed: (i64, i64),
}

impl Claim for PerceptualZones {
    type Variant = ZonesVariant;

    fn id(&self) -> &str {
        "paley.fig7"
    }

    fn derivation(&self) -> &str {
        "Definitions, read off the figure and the text: what is checked is that the zones as coded are these. A point is in the zone of repulsion, orientation or \
         attraction by its distance alone (annuli around the fish, both boundaries counted, so that a boundary belongs to two), unless it lies in the \
         open wedge of angular width alpha_k around the direction opposite to the heading; decided exactly on a grid for alpha = 60 degrees and rational headings."
    }

    fn printed(&self) -> ZonesVariant {
        ZonesVariant { swapped: false, ahead: false, claimed: (3, 4) }
    }

    fn controls(&self) -> Vec<Control<ZonesVariant>> {
        let printed = self.printed();
        vec![
            Control::new("attraction inside orientation", ZonesVariant { swapped: true, ..printed }),
            Control::new("blind spot in front", ZonesVariant { ahead: true, ..printed }),
            Control::new("a blind spot of 90 degrees", ZonesVariant { claimed: (1, 2), ..printed }),
        ]
    }

    fn examine(&self, variant: &ZonesVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
        const REACH: i64 = 8;
        let radius = |r: i64| rational(r, 1);
        let zones = zones_of_figure_7(&radius(1));
        let bounds = if variant.swapped { [(0, 2), (4, 7), (2, 4)] } else { [(0, 2), (2, 4), (4, 7)] };
        let mut points = 0;
        for heading in scattered_phasors(6)? {
            for (x, y) in (-REACH..=REACH).flat_map(|x| (-REACH..=REACH).map(move |y| (x, y))) {
                // In the frame of the fish: x ahead, y to the left.
                let offset = heading.clone() * Complex::new(radius(x), radius(y));
                let (behind, square) = (if variant.ahead { x } else { -x }, x * x + y * y);
                let (p, q) = variant.claimed;
                let blind = behind > 0 && q * behind * behind > p * square;
                for (zone, (inner, outer)) in
                    [Zone::Repulsion, Zone::Orientation, Zone::Attraction].into_iter().zip(bounds)
                {
                    points += 1;
                    let inside = inner * inner <= square && square <= outer * outer && !blind;
                    if zones.senses(zone, &heading, &offset) != inside {
                        let what = format!("{zone:?}: the point {x} ahead and {y} to the left of the fish");
                        return Ok(Outcome::fails(
                            what,
                            Evidence::new(Grade::Exact, "zones", "exact distances and angles"),
                        ));
                    }
                }
            }
        }
        let detail = "annuli by distance and a wedge behind, six rational headings, a grid of 17 x 17 points each";
        Ok(Outcome::Holds(vec![
            Evidence::new(Grade::Exhaustive, "zones and blind spot as coded", detail).cases(points),
            Evidence::new(Grade::Text, "figure", "the caption agrees with the text on the zones"),
        ]))
    }
}
