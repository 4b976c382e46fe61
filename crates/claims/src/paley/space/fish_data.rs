//! paley.figS1_S3, paley.figS3.difference: the measured tracks and what is inferred from them.

use crate::prelude::*;
use models::oscillator::{Neighbours, mean, phase_potential, phasor};
use models::tracks::{Scale, uniform_draws};
use motion::{Sample, Share};

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

/// The potentials are scaled with `2/(n + 1)` as printed, or with another function of `n`, before they are compared.
#[derive(Clone, Copy)]
pub struct ScaleVariant {
    name: &'static str,
    scale: fn(i64) -> (i64, i64),
}

impl ScaleVariant {
    fn factor(&self, n: usize) -> Rational {
        let (p, q) = (self.scale)(n as i64);
        rational(p, q)
    }

    /// A state in which the sign of the difference is not that of (synchrony of neighbours) - (synchrony of the school).
    fn wrong_sign(&self, t: &Rational) -> Result<Option<String>, CheckError> {
        let (positions, phasors) = two_pairs(t)?;
        let with = |n: usize, factor: &Rational| scaled(&positions, &phasors, n, factor);
        let difference = with(3, &self.factor(3))? - with(1, &self.factor(1))?;
        // W_1 = n A_n/2 with A_n the mean of 1 - cos over the arcs.
        let (school, near) = (with(3, &rational(2, 3))?, with(1, &rational(2, 1))?);
        let zero = rational(0, 1);
        let wrong = (difference > zero) != (school > near);
        Ok(wrong.then(|| {
            format!(
                "four circling fish in two close pairs, angle 2 arctan({t}) in each pair: the difference is \
                 {difference}, but the mean of 1 - cos is {near} for neighbours and {school} for the school"
            )
        }))
    }
}

/// Fish `2i` and `2i + 1` are each other's nearest: the difference against `(1/(2N)) sum |A_i - mean A|^2`, `A_i` the sum of a pair's phasors.
fn in_pairs(pairs: usize, complete: Rational, single: Rational) -> Identity<'static> {
    Identity::new(2 * pairs, move |t| {
        let (one, z) = (t[0].one(), t.iter().map(phasor).collect::<Result<Vec<_>, _>>()?);
        let potential = |network: &Neighbours, scale: &Rational| {
            Ok::<Probe, ArithmeticError>(phase_potential(network, &z, 1)? * one.rational(scale))
        };
        let near = Neighbours::from_fn(z.len(), |k, j| k / 2 == j / 2);
        let difference = potential(&Neighbours::complete(z.len()), &complete)? - potential(&near, &single)?;
        let sums: Vec<Complex<Probe>> = z.chunks(2).map(|pair| pair[0].clone() + &pair[1]).collect();
        let middle = mean(&sums)?;
        let spread = sums.into_iter().fold(one.zero(), |total, sum| total + (sum - &middle).norm_squared());
        Ok((vec![difference], vec![spread * one.ratio(1, 2 * z.len() as i64)]))
    })
}

/// Shares of draws with independent uniform headings above this are "nearly always".
const NEARLY_ALWAYS: f64 = 0.9;

/// The differences for independent headings, on positions uniform in a square.
fn drawn_differences(variant: &ScaleVariant, fish: usize, draws: usize, run: &Run) -> Vec<f64> {
    let mut random = run.random(fish as u64);
    let factor = |n: usize| {
        let (p, q) = (variant.scale)(n as i64);
        p as f64 / q as f64
    };
    let difference = |(complete, single)| factor(fish - 1) * complete - factor(1) * single;
    uniform_draws(fish, draws, &mut random).into_iter().map(difference).collect()
}

pub fn difference_inference() -> Record<ScaleVariant> {
    Record::new(
        "paley.figS3.difference",
        "Let A_n be the mean of 1 - cos theta_kj over the arcs of the network of the nearest n. W_1 = n \
         A_n/2, so the scaled potentials are (1 - 1/N) A_{N-1} and A_1/2: their difference is positive as \
         soon as A_1 < 2 (1 - 1/N) A_{N-1}, that is, even where neighbours are up to 1.75 times less \
         synchronised than the school (N = 8). For independent uniform headings, without any \
         synchronisation, both A have mean 1, and the difference has the mean 1/2 - 1/N > 0; it is positive \
         in about 94.5% of the draws for four fish and 99.8% for eight. Where the fish are in pairs of \
         mutual nearest neighbours it is (1/(2N)) sum |A_i - mean A|^2 with A_i = z_j + z_k over the pairs, \
         never negative whatever the headings are (the rule for neighbours in the zone of repulsion changes \
         who is a neighbour, not this). So \"nearly always positive\" does not imply local synchronisation. \
         Whether the histogram is as described cannot be checked without the tracks. Compared per arc, with \
         the factor 1/n, positive does mean A_1 < A_{N-1}, and independent headings give mean 0. \
         `flockproof tracks` does this comparison, with null models, on anyone's trajectories.",
        ScaleVariant { name: "2/(n+1)", scale: |n| Scale::Figure.ratio(n) },
        examine_difference_inference,
    )
    .repaired(Fault::False, "", ScaleVariant { name: "1/n", scale: |n| Scale::PerArc.ratio(n) })
    .repaired_clauses(&[
        "With W_1 of the network of the n nearest neighbours of each of N >= 2 fish, W_1/n for n = N-1 minus W_1/n for n = 1 is positive if \
         and only if nearest neighbours are on average more synchronised than all pairs (mean of 1 - cos th_kj over arcs).",
        "For independent uniform headings that do not depend on the positions it has mean zero.",
    ])
    .altered("unscaled", |v| (v.name, v.scale) = ("1", |_| (1, 1)))
    .altered("1/(n + 1)", |v| (v.name, v.scale) = ("1/(n+1)", |n| (1, n + 1)))
    .altered("1/n^2", |v| (v.name, v.scale) = ("1/n^2", |n| (1, n * n)))
}

fn examine_difference_inference(variant: &ScaleVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // What speaks against the inference, and what speaks for it.
    let (mut against, mut for_it) = (Vec::new(), Vec::new());
    let exact = |part: &str, detail: &str| exact(part, detail);
    let states = (-12..=12).map(|k| rational(k, 4));
    let mut wrong = None;
    for t in states.clone() {
        wrong = wrong.or(variant.wrong_sign(&t)?);
    }
    let signs = exact("sign of the difference", "W_1/n = A_n/2 by definition of W_1; exact states of four fish");
    match wrong {
        Some(what) => against.push((what, signs)),
        None => for_it.push(checking(signs.cases(states.count()).on([1]), "step 1")),
    }
    for fish in [4usize, 8] {
        run.checkpoint()?;
        // Mean 1 of 1 - cos for independent uniform headings: W_1 has the mean n/2.
        let mean = |n: usize| variant.factor(n) * rational(n as i64, 2);
        let difference = mean(fish - 1) - mean(1);
        let part = format!("{fish} fish, independent uniform headings");
        let evidence = exact(&format!("{part}, the mean"), "exact expectation");
        if difference == rational(0, 1) {
            for_it.push(checking(evidence.on([2]), "step 2"));
        } else {
            against.push((format!("{part}: the difference has the mean {difference}"), evidence));
        }
        let draws = run.cases(20_000, 400_000);
        let differences = drawn_differences(variant, fish, draws, run);
        // Zero up to rounding is not positive.
        let positive = Share::count(&differences, |x| *x > 1e-12);
        let interval = positive.enclosure();
        run.value(&format!("share_positive_{}_N_{fish}", variant.name), interval.clone());
        let mean = Sample::new(differences).enclosure();
        let detail = format!(
            "the difference has a mean in {mean} and is positive in a share {interval} of the draws (95%); positions uniform in a square"
        );
        let evidence = Evidence::new(Grade::Simulated, format!("{part}, the share"), detail).cases(draws);
        if positive.interval().0 > NEARLY_ALWAYS {
            against.push((format!("{part}: the difference is positive in a share {interval} of the draws"), evidence));
        } else {
            for_it.push(checking(evidence.on([2]), "step 2"));
        }
    }
    for pairs in [2usize, 4] {
        let fish = 2 * pairs;
        let identity = in_pairs(pairs, variant.factor(fish - 1), variant.factor(1));
        let names: Vec<String> = (1..=fish).map(|k| format!("t_{k}")).collect();
        let part = format!("{fish} fish in mutual pairs: the difference is a sum of squares");
        if let Outcome::Holds(evidence) = run.identity(&identity, &names, &part)? {
            let what = format!("{fish} fish in mutual pairs: the difference is never negative, whatever the headings");
            against.extend(evidence.into_iter().map(|evidence| (what.clone(), evidence)));
        }
    }
    let argued = Evidence::argued("any school", "notes/paley_particles.md, Figure S3, steps 1-2").on([1, 2]);
    for_it.push(argued);
    if against.is_empty() {
        return Ok(Outcome::Holds(for_it));
    }
    let (what, evidence): (Vec<String>, Vec<Evidence>) = against.into_iter().unzip();
    Ok(Outcome::failure(what.join("; "), evidence))
}

/// The value of the scaled potential for three fish in parallel and one opposite.
#[derive(Clone, Copy)]
pub struct PeakVariant {
    three_to_one: (i64, i64),
    balanced: (i64, i64),
}

pub fn measured_tracks() -> Record<PeakVariant> {
    Record::new(
        "paley.figS1_S3",
        "The statement is about recorded tracks of giant danios, which are not published with the paper. \
         Checked is what can be: the positions of the named peaks. For n = N - 1 the scaled potential is 1 \
         - |p_theta|^2: 0 synchronised, 3/4 for three parallel fish and one opposite, 1 balanced; and the \
         interval [0, 1] for n = 1. `flockproof tracks` makes these histograms from anyone's trajectories, \
         and `reproduce paley.figS3` from synthetic schools.",
        PeakVariant { three_to_one: (3, 4), balanced: (1, 1) },
        examine_measured_tracks,
    )
    .altered("three to one at 1/2", |v| v.three_to_one = (1, 2))
    .altered("balanced at 3/4", |v| v.balanced = (3, 4))
}

fn examine_measured_tracks(variant: &PeakVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let one = Complex::real(rational(1, 1));
    let positions: Vec<_> = (0..4).map(|k| Complex::real(rational(k * k, 1))).collect();
    let headings = |signs: [i64; 4]| signs.map(|s| one.scale(&rational(s, 1))).to_vec();
    let (p, b) = (variant.three_to_one, variant.balanced);
    let cases = [([1; 4], (0, 1)), ([1, 1, 1, -1], p), ([1, 1, -1, -1], b)];
    for (signs, (p, q)) in cases {
        let value = scaled(&positions, &headings(signs), 3, &rational(1, 2))?;
        if value != rational(p, q) {
            let what = format!("four fish with headings {signs:?}: the scaled potential is {value}, not {p}/{q}");
            return Ok(Outcome::fails(what, exact("where the named peaks lie", "exact potentials")));
        }
    }
    let detail = "scaled potential, n = 3: 0 synchronised, 3/4 for three against one, 1 balanced";
    let evidence = exact("where the named peaks lie", detail).cases(3);
    let why = "the measured tracks of Figures S1-S3 are not available; only the values at which the peaks are \
     said to lie can be checked";
    Ok(Outcome::NotCheckable(why.to_string(), vec![evidence]))
}
