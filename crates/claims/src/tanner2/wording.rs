//! tanner2.eq2, sec6.figures, appA.thm5: a formula and two references.

use super::fixtures::{PLANE, spring};
use crate::prelude::*;
use arithmetic::Signed;
use models::double_integrator::{Pair, State, heading, linked_within, velocity_alignment};

/// How the heading is formed from `(x, y)`.
#[derive(Clone, Copy)]
pub(crate) enum HeadingVariant {
    /// `arctan(y/x)`.
    Quotient,
    /// `arctan(y, x)`, the angle in `(-pi, pi]`.
    TwoArguments,
    /// `arctan(x, y)`.
    Swapped,
    /// `arctan(y, x)` with values in `[0, 2 pi)`.
    Positive,
}

impl HeadingVariant {
    fn angle(self, v: &[Interval; 2]) -> Result<Interval, CheckError> {
        Ok(match self {
            HeadingVariant::Quotient => v[1].over(&v[0])?.atan()?,
            HeadingVariant::TwoArguments => heading(v)?,
            HeadingVariant::Swapped => heading(&[v[1].clone(), v[0].clone()])?,
            HeadingVariant::Positive => {
                let angle = heading(v)?;
                if angle.is_certainly_negative() { angle.pi() * angle.integer(2) + angle } else { angle }
            }
        })
    }
}

const ANGLE: &str = "the angle of every velocity that is not zero";

/// Whether the angle is the heading of every vector with small integer coordinates, and lies in `[-pi, pi]`; with the proof.
pub(crate) fn examine_heading(variant: &HeadingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    Run::all([
        headings(variant, run).checks("step 1"),
        argued(&[1], ANGLE, "notes/tanner1.md, Headings, step 1, by quadrants"),
    ])
}

/// The same without the proof.
pub(crate) fn headings(variant: &HeadingVariant, run: &Run) -> Result<Outcome, CheckError> {
    const PRECISION: u32 = 80;
    let enclose = |n: i64| Interval::from_rational(&rational(n, 1), PRECISION);
    // Smaller vectors first.
    let mut vectors: Vec<(i64, i64)> =
        (-4..=4).flat_map(|x| (-4..=4).map(move |y| (x, y))).filter(|v| *v != (0, 0)).collect();
    vectors.sort_by_key(|(x, y)| (x * x + y * y, -x, -y));
    let evidence = certified(
        ANGLE,
        "enclosures for all integer vectors up to 4 in size: direction, and -pi <= angle <= pi, up to 2^-64 of the length",
    );
    run.every(evidence, vectors, |(x, y)| {
        let v = [enclose(x), enclose(y)];
        let Ok(angle) = variant.angle(&v) else {
            return Ok(Some(format!("velocity ({x}, {y}): the formula has no value")));
        };
        let (sin, cos) = angle.sin_cos()?;
        let length = PLANE.square(&v).sqrt()?;
        let slack = length.scaled(-64);
        let inside = are_within(&angle, &angle.zero(), &(angle.pi() + &slack))?;
        let [along, across] = [length.clone() * cos, length * sin];
        let wrong = !inside || !are_within(&along, &v[0], &slack)? || !are_within(&across, &v[1], &slack)?;
        Ok(wrong.then(|| format!("velocity ({x}, {y}): the formula gives {:.4}", angle.to_f64())))
    })
}

pub fn eq2() -> Record<HeadingVariant> {
    Record::new(
        "tanner2.eq2",
        "arctan of the quotient gives the same angle to opposite velocities and none to (0, 1). The heading is the angle of the vector: the two-argument arctangent, as in equation (2) of the companion \
         paper. It needs a velocity that is not zero. Nothing else in the paper uses it.",
        HeadingVariant::Quotient,
        examine_heading,
    )
    .repaired(Fault::Typo, "theta_i = arctan(ydot_i, xdot_i), the two-argument arctangent, for velocities other than zero.", HeadingVariant::TwoArguments)
    .control("the arguments swapped", HeadingVariant::Swapped)
    .control("values in [0, 2 pi)", HeadingVariant::Positive)
}

/// The figures that Section 6 names for the fixed run, the run by distance, and the loss of connectivity.
type FigureVariant = [u8; 3];

/// What the captions say of the figures 4, 5 and 6: fixed topology, dynamic topology, loss of connectivity.
const CAPTIONS: [(u8, &str); 3] = [
    (4, "Successive simulation time snapshots of flocking with fixed interconnection topology."),
    (5, "Successive simulation time snapshots of flocking with dynamic interconnection topology."),
    (6, "Loss of connectivity and independent flocking in the connected components."),
];

fn examine_references(variant: &FigureVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const WORDS: [&str; 3] = ["fixed", "dynamic", "Loss of connectivity"];
    let references = WORDS.iter().zip(variant);
    run.exhaustive("references", "captions compared with references", references, |(word, figure)| {
        let shown = CAPTIONS.iter().find(|(_, caption)| caption.contains(word)).map_or(0, |(number, _)| *number);
        Ok((shown != *figure).then(|| {
            format!("the text names Figure {figure} for the run whose caption says \"{word}\", which is Figure {shown}")
        }))
    })
}

pub fn figure_references() -> Record<FigureVariant> {
    Record::new(
        "tanner2.sec6.figures",
        "By their captions Figure 4 shows the fixed topology, Figure 5 the dynamic one, Figure 6 the loss of connectivity. The text names Figure 6 for all three.",
        [6, 6, 6],
        examine_references,
    )
    .repaired(Fault::Typo, "The fixed-topology run is shown in Figure 4, the distance-dependent run in Figure 5, the loss of connectivity in Figure 6.", [4, 5, 6])
    .control("Figures 5, 4, 6", [5, 4, 6])
}

/// In the proof of which theorem (1 or 2) Theorem 5 is used.
fn examine_use(theorem: &u8, _run: &mut Run) -> Result<Outcome, CheckError> {
    // What the two proofs say they apply.
    const APPLIED: [(u8, &str); 2] = [
        (1, "By LaSalle's invariant principle, if the initial conditions of the system lie in Omega"),
        (2, "Applying the nonsmooth version of LaSalle's principle proposed by Shevitz and Paden (1994)"),
    ];
    let named = APPLIED.iter().any(|(number, text)| number == theorem && text.contains("Shevitz and Paden"));
    // Whether the law of the theorem jumps where |r_12| = R: three agents, two of them at the threshold.
    let q = |n: i64| rational(n, 1);
    let potential = spring();
    let at = |x: Rational| State {
        positions: vec![[q(0), q(0)], [q(1), q(0)], [x, q(0)]],
        velocities: vec![[q(0), q(0)]; 3],
    };
    let law =
        |state: &State<Rational>, edges: &[Pair]| velocity_alignment(state, edges, PLANE, |_, _, s| potential.slope(s));
    let step = rational(1, 1_000_000);
    let sides = [q(2) - &step, q(2) + &step].map(at);
    let edges = |state: &State<Rational>| match theorem {
        1 => vec![(0, 1), (1, 2)],
        _ => linked_within(&state.positions, &q(4), PLANE).edges(),
    };
    let [near, far] = [law(&sides[0], &edges(&sides[0]))?, law(&sides[1], &edges(&sides[1]))?];
    let jump = num_traits::Signed::abs(&(&near[0][0] - &far[0][0]));
    let jumps = jump > rational(1, 10);
    let evidence = vec![
        exact("whether the law jumps", "accelerations on both sides of |r_13| = R").for_all(),
        Evidence::new(Grade::Text, "what the proofs name", "the sentences that apply LaSalle's principle"),
    ];
    if named && jumps {
        return Ok(Outcome::Holds(evidence));
    }
    let what = format!(
        "the proof of Theorem {theorem} applies the nonsmooth principle: {named}; its law jumps by {} across R",
        if jumps { jump.to_string() } else { "nothing".to_string() }
    );
    Ok(Outcome::failure(what, evidence))
}

pub fn theorem5_use() -> Record<u8> {
    Record::new(
        "tanner2.appA.thm5",
        "Theorem 1 is about a fixed graph: its law is smooth and its proof applies the classical principle. The proof of Theorem 2 applies the nonsmooth one. (Even there its hypotheses fail: Q is not \
         regular and solutions are not unique; notes/tanner2.md proves the convergence without it.)",
        1,
        examine_use,
    )
    .repaired(Fault::Typo, "Theorem 5 is used in the proof of Theorem 2.", 2)
    .control("Theorem 3", 3)
}
