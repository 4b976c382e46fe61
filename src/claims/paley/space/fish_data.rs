//! paley.figS1_S3, paley.figS3.difference: the measured tracks and what is inferred from them.

use crate::arithmetic::{Complex, Rational, rational};
use crate::ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use crate::oscillator::{Neighbours, phase_potential, phasor};

/// Positions or headings in the plane.
type Points = Vec<Complex<Rational>>;

/// `factor(n) W_1` on the network of the nearest `n`.
fn scaled(
    positions: &[Complex<Rational>],
    phasors: &[Complex<Rational>],
    n: usize,
    factor: &Rational,
) -> Result<Rational, CheckError> {
    Ok(phase_potential(&Neighbours::nearest(positions, n), phasors, 1)? * factor)
}

/// Headings of four fish in two close pairs: angle `2 arctan t` within a pair, the second pair opposite to the first.
fn two_pairs(t: &Rational) -> Result<(Points, Points), CheckError> {
    let (first, second) = (Complex::real(rational(1, 1)), phasor(t)?);
    let positions = [0, 1, 10, 11].map(|x| Complex::real(rational(x, 1)));
    Ok((positions.to_vec(), vec![first.clone(), second.clone(), -first, -second]))
}

/// paley.figS3.difference.
pub struct DifferenceInference;

/// The potentials are scaled with `2/(n + 1)` as printed, or with another function of `n`, before they are compared.
#[derive(Clone, Copy)]
pub struct ScaleVariant {
    scale: fn(i64) -> (i64, i64),
}

impl Claim for DifferenceInference {
    type Variant = ScaleVariant;

    fn id(&self) -> &str {
        "paley.figS3.difference"
    }

    fn derivation(&self) -> &str {
        "Let A_n be the mean of 1 - cos theta_kj over the arcs of the network of the nearest n. W_1 = n A_n/2, so the scaled potentials are (1 - 1/N) A_{N-1} and A_1/2: \
         their difference is positive as soon as A_1 < 2 (1 - 1/N) A_{N-1}, that is, even where neighbours are up to 1.75 times less synchronised than \
         the school (N = 8). For independent uniform headings, without any synchronisation, both A have mean 1, and the difference has the mean \
         1/2 - 1/N > 0. So \"nearly always positive\" does not imply local synchronisation. Whether the histogram is as described cannot be checked \
         without the tracks. Compared per arc, with the factor 1/n, positive does mean A_1 < A_{N-1}, and independent headings give mean 0."
    }

    fn printed(&self) -> ScaleVariant {
        ScaleVariant { scale: |n| (2, n + 1) }
    }

    fn repair(&self) -> Option<Repair<ScaleVariant>> {
        Some(Repair {
            fault: Fault::False,
            statement: "The difference of W_1/n for n = N-1 and n = 1 is positive if and only if nearest neighbours are on average more synchronised than all pairs \
                        (mean of 1 - cos th_kj over arcs); for independent uniform headings it has mean zero."
                .to_string(),
            variant: ScaleVariant { scale: |n| (1, n) },
        })
    }

    fn controls(&self) -> Vec<Control<ScaleVariant>> {
        vec![
            Control::new("unscaled", ScaleVariant { scale: |_| (1, 1) }),
            Control::new("1/(n + 1)", ScaleVariant { scale: |n| (1, n + 1) }),
            Control::new("1/n^2", ScaleVariant { scale: |n| (1, n * n) }),
        ]
    }

    fn examine(&self, variant: &ScaleVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
        let factor = |n: usize| {
            let (p, q) = (variant.scale)(n as i64);
            rational(p, q)
        };
        let exact = |part: &str, detail: &str| Evidence::new(Grade::Exact, part, detail);
        // Mean 1 of 1 - cos for independent uniform headings: W_1 has the mean n/2.
        for fish in [4usize, 8] {
            let mean = |n: usize| factor(n) * rational(n as i64, 2);
            let difference = mean(fish - 1) - mean(1);
            if difference != rational(0, 1) {
                let what =
                    format!("{fish} fish with independent uniform headings: the difference has the mean {difference}");
                return Ok(Outcome::fails(what, exact("independent headings", "exact expectations")));
            }
        }
        let mut states = 0;
        for t in (-12..=12).map(|k| rational(k, 4)) {
            let (positions, phasors) = two_pairs(&t)?;
            let (all, near) =
                (scaled(&positions, &phasors, 3, &factor(3))?, scaled(&positions, &phasors, 1, &factor(1))?);
            let per_arc = |n: usize| scaled(&positions, &phasors, n, &rational(2, n as i64));
            states += 1;
            if (all > near) != (per_arc(3)? > per_arc(1)?) {
                let what = format!(
                    "two close pairs, angle 2 arctan {t} in each: the difference is {}, the wrong sign",
                    all - near
                );
                return Ok(Outcome::fails(what, exact("four fish", "exact potentials")));
            }
        }
        Ok(Outcome::Holds(vec![
            exact(
                "sign of the difference, all states",
                "W_1/n = A_n/2 by definition of W_1; exact states of four fish",
            )
            .cases(states),
            exact("independent headings", "exact expectations for four and eight fish"),
        ]))
    }
}

/// paley.figS1_S3.
pub struct MeasuredTracks;

/// The value of the scaled potential for three fish in parallel and one opposite.
#[derive(Clone, Copy)]
pub struct PeakVariant {
    three_to_one: (i64, i64),
    balanced: (i64, i64),
}

impl Claim for MeasuredTracks {
    type Variant = PeakVariant;

    fn id(&self) -> &str {
        "paley.figS1_S3"
    }

    fn derivation(&self) -> &str {
        "The statement is about recorded tracks of giant danios, which are not published with the paper. Checked is what can be: the positions of the named peaks. For n = N - 1 the \
         scaled potential is 1 - |p_theta|^2: 0 synchronised, 3/4 for three parallel fish and one opposite, 1 balanced; and the interval [0, 1] for n = 1."
    }

    fn printed(&self) -> PeakVariant {
        PeakVariant { three_to_one: (3, 4), balanced: (1, 1) }
    }

    fn controls(&self) -> Vec<Control<PeakVariant>> {
        vec![
            Control::new("three to one at 1/2", PeakVariant { three_to_one: (1, 2), balanced: (1, 1) }),
            Control::new("balanced at 3/4", PeakVariant { three_to_one: (3, 4), balanced: (3, 4) }),
        ]
    }

    fn examine(&self, variant: &PeakVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
        let one = Complex::real(rational(1, 1));
        let positions: Vec<_> = (0..4).map(|k| Complex::real(rational(k * k, 1))).collect();
        let headings = |signs: [i64; 4]| signs.map(|s| one.scale(&rational(s, 1))).to_vec();
        let (p, b) = (variant.three_to_one, variant.balanced);
        let cases = [([1; 4], (0, 1)), ([1, 1, 1, -1], p), ([1, 1, -1, -1], b)];
        for (signs, (p, q)) in cases {
            let value = scaled(&positions, &headings(signs), 3, &rational(1, 2))?;
            if value != rational(p, q) {
                let what = format!("four fish with headings {signs:?}: the scaled potential is {value}, not {p}/{q}");
                return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "peaks", "exact potentials")));
            }
        }
        let detail = "scaled potential, n = 3: 0 synchronised, 3/4 for three against one, 1 balanced";
        let evidence = Evidence::new(Grade::Exact, "where the named peaks lie", detail).cases(3);
        let why = "the measured tracks of Figures S1-S3 are not available; only the values at which the peaks are said to lie can be checked";
        Ok(Outcome::NotCheckable(why.to_string(), vec![evidence]))
    }
}
