//! tanner1.gyro, eq6, eq6b, eq7, eq8, eq9.chain, eq9, Vt_inv, decoupled: rates of change along the closed loop (1), (4), (5).
//!
//! The headings are variables of their own here: the identities hold for any numbers `theta_i` whose rates are those of the
//! headings of `v_i`, so under every reading of `theta_i - theta_j` away from its jumps. Counterexamples use velocities with
//! one common direction, for which all readings agree.

use crate::arithmetic::identity::RationalIdentity;
use crate::arithmetic::{ArithmeticError, Dual, Field, Rational, rational};
use crate::claims::record::Record;
use crate::claims::tanner2::arbitrary::{Arbitrary, dot, total};
use crate::double_integrator::{Vector, difference, gyroscopic, heading_rate, rotated, scaled, sum};
use crate::graph::Graph;
use crate::ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};

/// The closed loop at one state, with headings.
struct Loop<T> {
    flock: Arbitrary<T>,
    headings: Vec<T>,
    gradients: Vec<Vector<T>>,
    accelerations: Vec<Vector<T>>,
}

/// `a x b`.
fn cross<T: Field>(a: &Vector<T>, b: &Vector<T>) -> T {
    a[0].clone() * &b[1] - a[1].clone() * &b[0]
}

impl<T: Field> Loop<T> {
    fn variables(graph: &Graph) -> usize {
        Arbitrary::variables(graph) + graph.order()
    }

    fn read(graph: &Graph, at: &[T]) -> Result<Self, ArithmeticError> {
        let (own, headings) = at.split_at(Arbitrary::variables(graph));
        let flock = Arbitrary::read(graph, own)?;
        let gradients = flock.gradients()?;
        let accelerations =
            gyroscopic(&flock.state, &gradients, &flock.edges, |i, j| headings[i].clone() - &headings[j])?;
        Ok(Loop { flock, headings: headings.to_vec(), gradients, accelerations })
    }

    fn count(&self) -> usize {
        self.headings.len()
    }

    /// The alignment forces alone.
    fn alignment(&self) -> Vec<Vector<T>> {
        self.accelerations.iter().zip(&self.gradients).map(|(a, g)| sum(a, g)).collect()
    }

    /// `thetadot_i = (v_i x vdot_i)/|v_i|²`.
    fn heading_rates(&self) -> Result<Vec<T>, ArithmeticError> {
        self.flock.state.velocities.iter().zip(&self.accelerations).map(|(v, a)| heading_rate(v, a)).collect()
    }

    /// What the potentials alone do to the headings, `-(v_i x grad_{r_i} V_i)/|v_i|²`.
    fn potential_rates(&self) -> Result<Vec<T>, ArithmeticError> {
        let rate = |(v, g): (&Vector<T>, &Vector<T>)| Ok(-heading_rate(v, g)?);
        self.flock.state.velocities.iter().zip(&self.gradients).map(rate).collect()
    }

    /// `(L_w theta)_i`, from the sums over the neighbours.
    fn laplacian(&self) -> Result<Vec<T>, ArithmeticError> {
        (0..self.count())
            .map(|i| {
                let near = self.flock.edges.iter().filter_map(|&(a, b)| {
                    if a == i {
                        Some(b)
                    } else if b == i {
                        Some(a)
                    } else {
                        None
                    }
                });
                near.into_iter().try_fold(self.headings[i].zero(), |total, j| {
                    let r = self.flock.state.separation(i, j);
                    Ok(total + (self.headings[i].clone() - &self.headings[j]).over(&dot(&r, &r))?)
                })
            })
            .collect()
    }

    /// `d/dt` of `potentials sum V_i + kinetic sum |v_i|² + headings sum theta_i²`.
    fn rate_of(&self, potentials: (i64, i64), kinetic: (i64, i64), headings: (i64, i64)) -> Result<T, ArithmeticError> {
        let moving = self.flock.state.moving(&self.accelerations);
        let like = &moving.positions[0][0];
        let energy = self.flock.energy(&moving, potentials)?;
        let speeds = total(like, moving.velocities.iter().map(|v| dot(v, v)));
        let rest = like.ratio(kinetic.0, kinetic.1) - like.ratio(1, 2);
        let angles = self.headings.iter().zip(self.heading_rates()?).map(|(x, rate)| Dual::new(x.clone(), rate));
        let squares = total(like, angles.map(|x| x.clone() * x)) * like.ratio(headings.0, headings.1);
        Ok((energy + speeds * rest + squares).derivative)
    }
}

/// Runs an identity on connected graphs of up to three agents.
fn on_connected<I: RationalIdentity>(
    run: &Run,
    what: &str,
    identity: impl Fn(Graph) -> I,
) -> Result<Outcome, CheckError> {
    Run::all(Arbitrary::connected(3).into_iter().map(|graph| {
        let part = format!("{what}, {} agents, edges {:?}, any potentials", graph.order(), graph.edges());
        run.identity(&identity(graph), &["positions", "velocities", "slopes", "headings"], &part)
    }))
}

/// Two linked agents at (0, 0) and (1, 1) that move upwards with the speeds 2 and 1, `V = 1/s + log s`, so that `V'(2) = 1/4`. The
/// headings, both `pi/2`, are given in units of `pi/2`.
fn upwards() -> Vec<Rational> {
    let q = |n| rational(n, 1);
    vec![q(0), q(0), q(1), q(1), q(0), q(2), q(0), q(1), rational(1, 4), q(1), q(1)]
}

const UPWARDS: &str = "two agents at (0, 0) and (1, 1) with velocities (0, 2) and (0, 1), V = 1/s + log s";

/// Whether the sides agree at the state above; the counterexample if not.
fn at_upwards(identity: &impl RationalIdentity, what: &str) -> Result<Option<Outcome>, CheckError> {
    let (left, right) = identity.sides(&upwards())?;
    let place = left.iter().zip(&right).position(|(l, r)| l != r);
    Ok(place.map(|k| {
        Outcome::fails(
            format!("{UPWARDS}: {what} is {}, but {} is claimed", left[k], right[k]),
            Evidence::new(Grade::Exact, what, "exact rates of change; equal headings, so that alignment forces vanish"),
        )
    }))
}

// --- The alignment force ---

/// The vector that the sum of heading differences multiplies.
#[derive(Clone, Copy)]
pub enum ForceVariant {
    /// `z x v_i`.
    TurnedVelocity,
    /// `z x r_i`.
    TurnedPosition,
    /// `v_i`.
    Velocity,
}

struct Force(Graph, ForceVariant);

impl RationalIdentity for Force {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let whole = Loop::read(&self.0, at)?;
        let sums = whole.laplacian()?;
        let state = &whole.flock.state;
        let forces: Vec<Vector<T>> = (0..whole.count())
            .map(|i| match self.1 {
                ForceVariant::TurnedVelocity => scaled(&-sums[i].clone(), &rotated(&state.velocities[i])),
                ForceVariant::TurnedPosition => scaled(&-sums[i].clone(), &rotated(&state.positions[i])),
                ForceVariant::Velocity => scaled(&-sums[i].clone(), &state.velocities[i]),
            })
            .collect();
        let work: Vec<T> = forces.iter().zip(&state.velocities).map(|(a, v)| dot(a, v)).collect();
        let zeros = work.iter().map(|w| w.zero());
        // The library's law has the same force, and none of them does work.
        let law = whole.alignment().into_iter().flatten();
        let right = zeros.chain(law).collect();
        Ok((work.into_iter().chain(forces.into_iter().flatten()).collect(), right))
    }
}

pub fn gyro() -> Record<ForceVariant> {
    Record::new(
        "tanner1.gyro",
        "v_i . (z x v_i) = 0: the force is normal to the velocity and does no work, whatever the heading differences are.",
        ForceVariant::TurnedVelocity,
        |variant, run| on_connected(run, "the alignment force does no work", |graph| Force(graph, *variant)),
    )
    .control("along v_i", ForceVariant::Velocity)
    .control("z x r_i", ForceVariant::TurnedPosition)
}

// --- Equation (6) ---

/// The gradients of the potentials, turned or not, and the sign of the last sum.
#[derive(Clone, Copy)]
pub struct MomentumVariant {
    central: bool,
    sign: i64,
}

struct AngularMomentum(Graph, MomentumVariant);

impl RationalIdentity for AngularMomentum {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let whole = Loop::read(&self.0, at)?;
        let state = &whole.flock.state;
        let push = |g: &Vector<T>| if self.1.central { g.clone() } else { rotated(g) };
        let alignment = whole.alignment();
        let accelerations = alignment.iter().zip(&whole.gradients).map(|(a, g)| difference(a, &push(g)));
        let like = &at[0];
        let left = total(like, state.positions.iter().zip(accelerations).map(|(r, a)| cross(r, &a)));
        let turning = total(like, state.positions.iter().zip(&alignment).map(|(r, a)| cross(r, a)));
        // Both orders of every pair: r_ij x grad V_ij.
        let pairs = whole.flock.edges.iter().zip(whole.flock.pair_gradients()?);
        let internal = total(
            like,
            pairs.map(|(&(i, j), (at_i, _))| cross(&state.separation(i, j), &push(&at_i)) * like.integer(2)),
        );
        // r x (z x v) = r . v.
        let sums = whole.laplacian()?;
        let last = total(like, (0..whole.count()).map(|i| dot(&state.positions[i], &state.velocities[i]) * &sums[i]));
        Ok((vec![left.clone(), left], vec![turning - internal, last * like.integer(-self.1.sign)]))
    }
}

pub fn eq6() -> Record<MomentumVariant> {
    let printed = MomentumVariant { central: true, sign: 1 };
    Record::new(
        "tanner1.eq6",
        "grad V_ij is along r_ij, so every r_ij x grad V_ij vanishes (in both orders, however often a pair is counted), and the potential forces of a pair have opposite torques. What is left is the torque of the alignment forces.",
        printed,
        |variant, run| on_connected(run, "equation (6)", |graph| AngularMomentum(graph, *variant)),
    )
    .control("forces that are not central", MomentumVariant { central: false, ..printed })
    .control("the other sign", MomentumVariant { sign: -1, ..printed })
}

// --- The heading dynamics ---

/// Headings turn by minus the weighted sum times `alignment`, plus the potentials' part times `potential`.
#[derive(Clone, Copy)]
pub struct HeadingVariant {
    potential: i64,
    alignment: i64,
}

/// The statement before (7): weighted by `r_i . v_i` and summed.
struct Weighted(Graph, HeadingVariant);
/// The statement (7).
struct Separate(Graph, HeadingVariant);

/// The loop, its heading rates, and the rates that are claimed.
type HeadingSides<T> = (Loop<T>, Vec<T>, Vec<T>);

fn heading_sides<T: Field>(
    graph: &Graph,
    at: &[T],
    variant: HeadingVariant,
) -> Result<HeadingSides<T>, ArithmeticError> {
    let whole = Loop::read(graph, at)?;
    let left = whole.heading_rates()?;
    let own = whole.potential_rates()?;
    let right = whole
        .laplacian()?
        .into_iter()
        .zip(own)
        .map(|(sum, own)| own * at[0].integer(variant.potential) - sum * at[0].integer(variant.alignment));
    let right = right.collect();
    Ok((whole, left, right))
}

impl RationalIdentity for Separate {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let (_, left, right) = heading_sides(&self.0, at, self.1)?;
        Ok((left, right))
    }
}

impl RationalIdentity for Weighted {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let (whole, left, right) = heading_sides(&self.0, at, self.1)?;
        let state = &whole.flock.state;
        let weight = |i: usize| dot(&state.positions[i], &state.velocities[i]);
        let sum = |list: &[T]| total(&at[0], list.iter().enumerate().map(|(i, x)| x.clone() * weight(i)));
        Ok((vec![sum(&left)], vec![sum(&right)]))
    }
}

fn examine_separate(variant: &HeadingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let pair = Separate(Graph::path(2), *variant);
    if let Some(outcome) = at_upwards(&pair, "thetadot_1")? {
        return Ok(outcome);
    }
    on_connected(run, "the heading dynamics", |graph| Separate(graph, *variant))
}

fn examine_weighted(variant: &HeadingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let pair = Weighted(Graph::path(2), *variant);
    if let Some(outcome) = at_upwards(&pair, "the sum of (r_i . v_i) thetadot_i")? {
        return Ok(outcome);
    }
    on_connected(run, "the weighted sum", |graph| Weighted(graph, *variant))
}

const PRINTED_HEADINGS: HeadingVariant = HeadingVariant { potential: 0, alignment: 1 };
const TRUE_HEADINGS: HeadingVariant = HeadingVariant { potential: 1, alignment: 1 };

pub fn eq7() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.eq7",
        "thetadot_i = (v_i x vdot_i)/|v_i|²: the alignment force gives the printed sum, but the potential force has a part normal to v_i too and turns the heading as well. The derivation drops it, and then concludes from one scalar equation \
         that each of N terms vanishes.",
        PRINTED_HEADINGS,
        examine_separate,
    )
    .repaired(
        Fault::False,
        "thetadot_i = - sum_{j~i} (theta_i - theta_j)/|r_ij|² - (v_i x grad_{r_i} V_i)/|v_i|², where v_i != 0.",
        TRUE_HEADINGS,
    )
    .control("the potentials' part with the other sign", HeadingVariant { potential: -1, ..TRUE_HEADINGS })
    .control("twice the alignment", HeadingVariant { alignment: 2, ..TRUE_HEADINGS })
}

pub fn eq6b() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.eq6b",
        "The step before it replaces vdot_i by omega_i x v_i, the part of vdot_i normal to v_i, but the potential forces have such a part too, and torque along v_i as well. With the true heading rates the sum is that of \
         -(r_i . v_i)(v_i x grad_{r_i} V_i)/|v_i|².",
        PRINTED_HEADINGS,
        examine_weighted,
    )
    .repaired(
        Fault::False,
        "sum_i (r_i . v_i)(thetadot_i + sum_{j~i} (theta_i - theta_j)/|r_ij|² + (v_i x grad_{r_i} V_i)/|v_i|²) = 0.",
        TRUE_HEADINGS,
    )
    .control("the potentials' part with the other sign", HeadingVariant { potential: -1, ..TRUE_HEADINGS })
    .control("twice the alignment", HeadingVariant { alignment: 2, ..TRUE_HEADINGS })
}

// --- Equation (8) ---

/// `dV/dr_i = sign dV/dr_j` and `d/dt factor sum V_i = sum grad V_i . v_i`.
#[derive(Clone, Copy)]
pub struct SymmetryVariant {
    sign: i64,
    factor: (i64, i64),
}

struct Symmetry(Graph, SymmetryVariant);

impl RationalIdentity for Symmetry {
    fn variables(&self) -> usize {
        Arbitrary::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let flock = Arbitrary::read(&self.0, at)?;
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for ((&(i, j), (at_i, at_j)), slope) in flock.edges.iter().zip(flock.pair_gradients()?).zip(&flock.slopes) {
            // dV/dr_ij of g |r_ij|².
            let own = scaled(&(slope.clone() + slope), &flock.state.separation(i, j));
            left.extend(own.into_iter().chain(at_i.clone()));
            right.extend(at_i.into_iter().chain(scaled(&at[0].integer(self.1.sign), &at_j)));
        }
        left.push(total(&at[0], flock.agent_rates()?) * at[0].ratio(self.1.factor.0, self.1.factor.1));
        let gradients = flock.gradients()?;
        right.push(total(&at[0], gradients.iter().zip(&flock.state.velocities).map(|(g, v)| dot(g, v))));
        Ok((left, right))
    }
}

pub fn eq8() -> Record<SymmetryVariant> {
    let printed = SymmetryVariant { sign: -1, factor: (1, 2) };
    Record::new(
        "tanner1.eq8",
        "V_ij depends on r_i - r_j. Half the sum of the V_i is the sum over the edges, whose rate is the sum of grad_{r_i} V_ij . v_i + grad_{r_j} V_ij . v_j.",
        printed,
        |variant, run| on_connected(run, "equation (8)", |graph| Symmetry(graph, *variant)),
    )
    .control("dV/dr_i = dV/dr_j", SymmetryVariant { sign: 1, ..printed })
    .control("without the half", SymmetryVariant { factor: (1, 1), ..printed })
}

// --- Equation (9) and after ---

/// What `Vdot_t` is said to be.
#[derive(Clone, Copy)]
pub enum RateVariant {
    /// The chain (9), the last term times a factor.
    Chain(i64),
    /// `-theta^T L_w theta` plus a factor times the sum of `theta_i` times the potentials' part of its rate.
    Form(i64),
    /// The same with the other sign of `L_w`.
    Opposite,
}

struct Rate(Graph, RateVariant);

impl RationalIdentity for Rate {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let whole = Loop::read(&self.0, at)?;
        let like = &at[0];
        let rate = whole.rate_of((1, 2), (1, 2), (1, 2))?;
        let along = |list: Vec<T>| total(like, whole.headings.iter().zip(list).map(|(x, y)| x.clone() * y));
        Ok(match self.1 {
            RateVariant::Chain(factor) => {
                let v = &whole.flock.state.velocities;
                let work = |list: &[Vector<T>]| total(like, v.iter().zip(list).map(|(v, a)| dot(v, a)));
                let turning = along(whole.heading_rates()?) * like.integer(factor);
                let chain = work(&whole.gradients) + work(&whole.accelerations) + turning.clone();
                (vec![rate.clone(), rate], vec![chain, turning])
            }
            RateVariant::Form(factor) => {
                let form = along(whole.laplacian()?);
                (vec![rate], vec![along(whole.potential_rates()?) * like.integer(factor) - form])
            }
            RateVariant::Opposite => {
                let form = along(whole.laplacian()?);
                (vec![rate], vec![along(whole.potential_rates()?) + form])
            }
        })
    }
}

fn examine_rate(variant: &RateVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let pair = Rate(Graph::path(2), *variant);
    if let Some(outcome) = at_upwards(&pair, "dV_t/dt in units of pi/2 (positive)")? {
        return Ok(outcome);
    }
    on_connected(run, "the rate of V_t", |graph| Rate(graph, *variant))
}

pub fn eq9_chain() -> Record<RateVariant> {
    Record::new(
        "tanner1.eq9.chain",
        "The alignment force does no work and the potential forces take from the potential what they give to the speeds: half the sum of V_i + |v_i|² is constant, and the rate of V_t is that of half the sum of theta_i². (Away from jumps of the headings; theta_i² does not jump at pi.)",
        RateVariant::Chain(1),
        examine_rate,
    )
    .control("twice the last sum", RateVariant::Chain(2))
    .control("without the last sum", RateVariant::Chain(0))
}

pub fn eq9() -> Record<RateVariant> {
    Record::new(
        "tanner1.eq9",
        "It puts (7), which is false, into (9). With the true heading rates the potentials add sum theta_i (-(v_i x grad_{r_i} V_i)/|v_i|²), of either sign: two agents with equal headings pi/2 and different speeds have theta^T L_w theta = 0 and a positive rate.",
        RateVariant::Form(0),
        examine_rate,
    )
    .repaired(
        Fault::False,
        "Vdot_t = - theta^T L_w theta - sum_i theta_i (v_i x grad_{r_i} V_i)/|v_i|², which may be positive.",
        RateVariant::Form(1),
    )
    .control("the potentials' part with the other sign", RateVariant::Form(-1))
    .control("plus theta^T L_w theta", RateVariant::Opposite)
}

/// What is said to be kept or not to increase.
#[derive(Clone, Copy)]
pub enum InvariantVariant {
    /// `V_t` does not increase.
    Decreasing,
    /// `a sum V_i + b sum |v_i|²` is constant.
    Constant((i64, i64), (i64, i64)),
}

struct Constant(Graph, (i64, i64), (i64, i64));

impl RationalIdentity for Constant {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let whole = Loop::read(&self.0, at)?;
        Ok((vec![whole.rate_of(self.1, self.2, (0, 1))?], vec![at[0].zero()]))
    }
}

pub(super) fn examine_invariant(variant: &InvariantVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    match *variant {
        InvariantVariant::Constant(potentials, kinetic) => {
            let identity = |graph| Constant(graph, potentials, kinetic);
            on_connected(run, "a constant of the closed loop", identity)
        }
        InvariantVariant::Decreasing => {
            let whole = Loop::read(&Graph::path(2), &upwards())?;
            let rate = whole.rate_of((1, 2), (1, 2), (1, 2))?;
            let evidence = Evidence::new(Grade::Exact, "V_t at one state", "exact rate, in units of pi/2");
            if rate > rational(0, 1) {
                return Ok(Outcome::fails(
                    format!(
                        "{UPWARDS}: dV_t/dt = {rate} pi/2 > 0, so that {{V_t <= c}} is left for the c of this state"
                    ),
                    evidence,
                ));
            }
            Ok(Outcome::Undecided("no increase at the state tried".to_string()))
        }
    }
}

/// Half the sum of `V_i + |v_i|²` is constant.
pub(super) const ENERGY: InvariantVariant = InvariantVariant::Constant((1, 2), (1, 2));

pub fn vt_inv() -> Record<InvariantVariant> {
    Record::new(
        "tanner1.Vt_inv",
        "V_t is a constant, the mechanical energy, plus half the sum of theta_i², and potential forces may turn headings away from 0. Two agents with heading pi/2 and different speeds can increase V_t. What is invariant is every level set of the mechanical energy.",
        InvariantVariant::Decreasing,
        examine_invariant,
    )
    .repaired(Fault::False, "The mechanical energy (1/2) sum_i (V_i + v_i^T v_i) is constant along the closed loop: {(1/2) sum_i (V_i + v_i^T v_i) <= c} is invariant.", ENERGY)
    .control("the kinetic energy is constant", InvariantVariant::Constant((0, 1), (1, 2)))
    .control("the potential energy is constant", InvariantVariant::Constant((1, 2), (0, 1)))
    .control("sum V_i + half the sum of |v_i|²", InvariantVariant::Constant((1, 1), (1, 2)))
}

// --- Decoupling ---

/// Which influences are said to be absent.
#[derive(Clone, Copy)]
pub struct DecoupledVariant {
    headings_from_potentials: bool,
    energy: InvariantVariant,
}

fn examine_decoupled(variant: &DecoupledVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let energy = examine_invariant(&variant.energy, run);
    if !variant.headings_from_potentials {
        return energy;
    }
    Run::all([examine_separate(&PRINTED_HEADINGS, run), energy])
}

pub fn decoupled() -> Record<DecoupledVariant> {
    let printed = DecoupledVariant { headings_from_potentials: true, energy: ENERGY };
    Record::new(
        "tanner1.decoupled",
        "Read as: neither rule influences what the other one governs. One half is true: alignment does no work on the energy of cohesion and separation. The other is not: the potential forces turn headings (tanner1.eq7). (That the law is a sum of one term for each is not in doubt.)",
        printed,
        examine_decoupled,
    )
    .repaired(
        Fault::False,
        "Alignment does not change the mechanical energy of the potentials and speeds; the potential forces do change the headings.",
        DecoupledVariant { headings_from_potentials: false, ..printed },
    )
    .control("alignment and the kinetic energy", DecoupledVariant { headings_from_potentials: false, energy: InvariantVariant::Constant((0, 1), (1, 2)) })
    .control("alignment and the potential energy", DecoupledVariant { headings_from_potentials: false, energy: InvariantVariant::Constant((1, 2), (0, 1)) })
}
