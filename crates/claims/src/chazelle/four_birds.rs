//! chazelle.ex4birds.*: the flock on the line whose network never settles without hysteresis.
//!
//! The proof for all `t` is by invariants. With `r = (-1/3)^t` the state at time `t` is
//! `x(t) = x(0) + (3/4)(1 - r) v(1)`, `v(t+1) = r v(1)`: affine in `r`. For `r` in `(0, 1]` the distance rule gives one
//! network, for `r` in `[-1/3, 0)` the other; both multiply `v(1)` by -1/3, so a step maps `r` to `-r/3`, from one
//! range into the other.

use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use models::averaging::{Affine, Flock, HalfOpenRange, Hysteresis, Start, Weights, transition_matrix};

/// The example with everything that the claims print about it.
#[derive(Clone)]
pub struct FourBirds {
    /// x(0), over 16.
    positions: [i64; 4],
    /// v(1), over 8.
    velocities: [i64; 4],
    eigenvalue: (i64, i64),
    /// The two printed matrices, over 3: two pairs, one path.
    pairs: [[i64; 4]; 4],
    path: [[i64; 4]; 4],
    /// `x(t) = x(0) + factor (1 - ratio^t) v(1)`.
    factor: (i64, i64),
    /// The printed gaps for t >= 1, `(constant, coefficient of ratio^(t-1))` over 16: outer and middle.
    outer_gap: (i64, i64),
    middle_gap: (i64, i64),
    /// The bounds of the outer gaps, over 16.
    outer_bounds: (i64, i64),
    hysteresis: Option<(i64, i64)>,
    weights: Weights,
}

impl FourBirds {
    fn printed() -> Self {
        FourBirds {
            positions: [0, 8, 21, 29],
            velocities: [1, -1, 1, -1],
            eigenvalue: (-1, 3),
            pairs: [[1, 2, 0, 0], [2, 1, 0, 0], [0, 0, 1, 2], [0, 0, 2, 1]],
            path: [[1, 2, 0, 0], [1, 1, 1, 0], [0, 1, 1, 1], [0, 0, 2, 1]],
            factor: (3, 4),
            outer_gap: (5, -1),
            middle_gap: (16, 1),
            outer_bounds: (4, 8),
            hysteresis: None,
            weights: Weights::Lazy,
        }
    }

    fn start(&self) -> Vec<Rational> {
        self.positions.iter().map(|&x| rational(x, 16)).collect()
    }

    fn velocity(&self) -> Vec<Rational> {
        self.velocities.iter().map(|&v| rational(v, 8)).collect()
    }

    fn eigenvalue(&self) -> Rational {
        rational(self.eigenvalue.0, self.eigenvalue.1)
    }

    fn flock(&self) -> Result<Flock, CheckError> {
        let hysteresis = self.hysteresis.map_or(Hysteresis::None, |(p, q)| Hysteresis::Constant(rational(p, q)));
        Ok(Flock::new(&Start::on_the_line(self.start(), self.velocity(), self.weights.clone(), hysteresis))?)
    }

    /// `x(t)` as affine functions of `r = ratio^t`.
    fn closed_form(&self) -> Vec<Affine> {
        let factor = rational(self.factor.0, self.factor.1);
        let position =
            |(x, v): (Rational, Rational)| Affine { constant: x + factor.clone() * &v, slope: -(factor.clone() * v) };
        self.start().into_iter().zip(self.velocity()).map(position).collect()
    }
}

/// The network at even and at odd times.
fn networks() -> [Graph; 2] {
    [Graph::path(4), Graph::empty(4).with_edges(&[(0, 1), (2, 3)])]
}

/// Both printed matrices are those of model D with lazy weights, and `v(1)` is an eigenvector of both.
fn examine_eigenvector(birds: &FourBirds) -> Result<Outcome, CheckError> {
    let velocity = birds.velocity();
    let expected: Vec<Rational> = velocity.iter().map(|v| v * birds.eigenvalue()).collect();
    let [path, pairs] = networks();
    let (mut other_image, mut other_matrix) = (None, None);
    for (name, printed, graph) in [("two pairs", birds.pairs, pairs), ("path", birds.path, path)] {
        let matrix = RationalMatrix::from_integers(&printed, 3)?;
        let image = matrix.apply(&velocity)?;
        if image != expected {
            let [v, image, expected] = [&velocity, &image, &expected].map(list);
            let what = format!("the matrix of the {name} maps v(1) = ({v}) to ({image}), not to ({expected})");
            other_image.get_or_insert(what);
        }
        if matrix != transition_matrix(&graph, &Weights::Lazy)? {
            let what = format!("the matrix of the {name} is not the lazy transition matrix of that network");
            other_matrix.get_or_insert(what);
        }
    }
    let matrices = exact("the printed matrices", "I - CL with c_i = 2/(3 d_i) for two pairs and for the path").cases(2);
    Run::all([
        unless(other_image, exact("the eigenvector", "both matrices map v(1) to its multiple").cases(2)).for_all(),
        unless(other_matrix, matrices).for_all(),
    ])
}

/// How long flocks are stepped.
const STEPS: usize = 64;

/// The network alternates forever: first stepped, then proved for all t by the invariants at the head of this file.
fn examine_alternation(birds: &FourBirds, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut flock = birds.flock()?;
    let expected = networks();
    let stepped = run.instances("t = 0, ..., 64", "stepped exactly", 0..=STEPS, |t| {
        let components = flock.network().components().len();
        let edges = flock.network().edges();
        let as_claimed = *flock.network() == expected[t % 2];
        flock.step()?;
        Ok((!as_claimed)
            .then(|| format!("at t = {t} the network has {components} component(s), edges {edges:?} (birds from 0)")))
    });
    Run::all([stepped, induction(birds)])
}

/// The proof for all `t`. A distance that is settled otherwise refutes the alternation, since `r` is 1 at `t = 0` and the ratio at `t = 1`; what
/// else is not as it should be leaves it open.
fn induction(birds: &FourBirds) -> Result<Outcome, CheckError> {
    let (ratio, positions) = (birds.eigenvalue(), birds.closed_form());
    let not_proved = |what: String| Ok(Outcome::Undecided(what));
    let proved = exact(
        "the alternation for all t",
        "induction: states affine in r = (-1/3)^t, all six distances settled on (0,1] and on [-1/3,0), a step maps r to -r/3",
    );
    // The initial state is r = 1.
    if positions.iter().map(|x| x.at(&rational(1, 1))).collect::<Vec<_>>() != birds.start() {
        return not_proved("the family does not start at x(0)".to_string());
    }
    if birds.hysteresis.is_some() {
        return not_proved("the network is not that of the distance rule".to_string());
    }
    // x(t+1) = x(t) + r v(1) is the family at ratio r, as affine functions.
    for (x, v) in positions.iter().zip(birds.velocity()) {
        let moved = Affine { constant: x.constant.clone(), slope: x.slope.clone() + v };
        if moved != x.rescaled(&ratio) {
            return not_proved("a step leaves the family".to_string());
        }
    }
    let [first, second] = [rational(1, 1), ratio.clone()].map(|end| HalfOpenRange { end });
    let [path, pairs] = networks();
    for (range, network) in [(&first, &path), (&second, &pairs)] {
        for (i, j) in (0..4).flat_map(|j| (0..j).map(move |i| (i, j))) {
            match positions[j].minus(&positions[i]).is_within_one(range) {
                None => return not_proved(format!("the distance of birds {} and {} is not settled", i + 1, j + 1)),
                Some(near) if near != network.has_edge(i, j) => {
                    let side = if near { "at most" } else { "more than" };
                    let what =
                        format!("birds {} and {} are {side} 1 apart for all r up to {}", i + 1, j + 1, range.end);
                    return Ok(Outcome::fails(what, proved));
                }
                Some(_) => {}
            }
        }
        // v(t+2) = P v(t+1) = ratio r v(1).
        let scaled: Vec<Rational> = birds.velocity().iter().map(|v| v * &ratio).collect();
        if transition_matrix(network, &birds.weights)?.apply(&birds.velocity())? != scaled {
            return not_proved("v(1) is not an eigenvector of both networks".to_string());
        }
    }
    // The end of each range goes into the other.
    if ratio.square() > rational(1, 1) || ratio >= rational(0, 1) {
        return not_proved("a step leaves the ranges".to_string());
    }
    holds(proved.for_all())
}

/// The closed form for all t (induction, using the alternation), the printed gaps and their bounds.
fn examine_closed_form(birds: &FourBirds, run: &mut Run) -> Result<Outcome, CheckError> {
    let ratio = birds.eigenvalue();
    let positions = birds.closed_form();
    let (mut flock, mut r) = (birds.flock()?, rational(1, 1));
    let stepped = run.instances("the closed form for t = 0, ..., 64", "stepped exactly", 0..=STEPS, |t| {
        let found = flock.positions().concat();
        let other = (1..).zip(&positions).zip(found).find(|((_, form), x)| form.at(&r) != *x);
        let wrong = other.map(|((i, form), x)| format!("x_{i}({t}) = {x}, the closed form gives {}", form.at(&r)));
        flock.step()?;
        r *= &ratio;
        Ok(wrong)
    });
    // ratio^(t-1) = r/ratio.
    let printed = |(constant, slope): (i64, i64)| Affine {
        constant: rational(constant, 16),
        slope: rational(slope, 16) / &ratio,
    };
    let gap = |clause: usize, i: usize, claimed: (i64, i64)| {
        let derived = positions[i + 1].minus(&positions[i]);
        let wrong = (derived != printed(claimed))
            .then(|| format!("x_{} - x_{} at t = 1 is {}", i + 2, i + 1, derived.at(&ratio)));
        let part = format!("the gap of birds {} and {}", i + 1, i + 2);
        unless(wrong, exact(part, "compared as affine functions of (-1/3)^t").on([clause])).for_all()
    };
    Run::all([
        stepped.on([1]),
        gap(2, 0, birds.outer_gap),
        gap(4, 1, birds.middle_gap),
        gap(2, 2, birds.outer_gap),
        outer_bounds(&printed(birds.outer_gap), birds, run),
        examine_alternation(birds, run).on([1, 2, 3, 4]),
    ])
}

/// For `t >= 1`, `r` runs between the ratio and its square: the outer gap is between its values there.
fn outer_bounds(outer: &Affine, birds: &FourBirds, run: &mut Run) -> Result<Outcome, CheckError> {
    let ratio = birds.eigenvalue();
    let (low, high) = (rational(birds.outer_bounds.0, 16), rational(birds.outer_bounds.1, 16));
    let ends = [outer.at(&ratio), outer.at(&ratio.square())];
    run.value("outer_gap_at_t_1", ends[0].to_string());
    run.value("outer_gap_at_t_2", ends[1].to_string());
    let wrong = ends.iter().find(|&end| *end < low || *end > high).map(|end| format!("an outer gap is {end}"));
    let detail = "for t >= 1 the outer gap runs between 1/4 (attained at t = 1) and 1/3 (at t = 2)";
    unless(wrong, exact("the bounds of the outer gaps", detail).on([3])).for_all()
}

pub fn eigenvector() -> Record<FourBirds> {
    let printed = FourBirds::printed;
    Record::new(
        "chazelle.ex4birds.eig",
        "Each bird has velocity +-1/8 and all its neighbours the opposite one: a third of the own minus two thirds, \
         or for the inner birds of the path 1/3 - 1/3 - 1/3, is -1/3 of the own velocity.",
        printed(),
        |birds, _| examine_eigenvector(birds),
    )
    .altered("eigenvalue 1/3", |v| v.eigenvalue = (1, 3))
    .altered("v(1) = (1,1,-1,-1)/8", |v| v.velocities = [1, 1, -1, -1])
    .altered("a matrix with two entries exchanged", |v| {
        v.path = [[1, 2, 0, 0], [1, 1, 1, 0], [0, 1, 1, 1], [0, 0, 1, 2]]
    })
}

pub fn closed_form() -> Record<FourBirds> {
    let printed = FourBirds::printed;
    Record::new(
        "chazelle.ex4birds.eq3.14",
        "v(s) = (-1/3)^(s-1) v(1) sums to (3/4)(1 - (-1/3)^t) v(1). The gaps follow; the outer gaps are exactly 1/4 \
         at t = 1 and never more than 1/3 for t >= 1.",
        printed(),
        examine_closed_form,
    )
    .reading("\"Stays between 1/4 and 1/2\" includes the ends: the outer gaps are exactly 1/4 at t = 1.")
    .clauses(&[
        "x(t) = x(0) + (3/4)(1-(-1/3)^t) v(1) for all t.",
        "For t >= 1, x_{i+1}(t) - x_i(t) = (1/16)(5 - (-1/3)^{t-1}) for i = 1, 3.",
        "For t >= 1 these two gaps stay between 1/4 and 1/2.",
        "For t >= 1, x_3(t) - x_2(t) = 1 + (1/16)(-1/3)^{t-1}.",
    ])
    .altered("factor 3/2", |v| v.factor = (3, 2))
    .altered("the sign in the outer gaps", |v| v.outer_gap = (5, 1))
    .altered("the sign in the middle gap", |v| v.middle_gap = (16, -1))
    .altered("a lower bound of 5/16", |v| v.outer_bounds = (5, 8))
    .altered("an upper bound of 5/16", |v| v.outer_bounds = (4, 5))
    .altered("x_3(0) = 20/16", |v| v.positions = [0, 8, 20, 29])
}

pub fn alternation() -> Record<FourBirds> {
    let printed = FourBirds::printed;
    Record::new(
        "chazelle.ex4birds.alt",
        "The middle gap is 1 - (3/16)(-1/3)^t: at most 1 for even t, more than 1 for odd t. The outer gaps stay below \
         1 and birds 1, 3 and 2, 4 stay 21/16 apart, birds 1, 4 farther. So the network is the path at even and two \
         pairs at odd times; both have the eigenvector v(1), which closes the induction.",
        printed(),
        examine_alternation,
    )
    .altered("a hysteresis threshold of 1/1024", |v| v.hysteresis = Some((1, 1024)))
    .altered("birds 3 and 4 farther by 1/4", |v| v.positions = [0, 8, 25, 33])
    .altered("opposite velocities", |v| v.velocities = [-1, 1, -1, 1])
    .altered("c_i = 1/(d_i + 1)", |v| v.weights = Weights::Vicsek)
}
