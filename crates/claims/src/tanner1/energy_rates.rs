//! tanner1.eq8, eq9.chain, eq9, Vt_inv, decoupled: rates of energies along the closed loop (1), (4), (5).

use super::closed_loop::{Loop, UPWARDS, at_upwards, on_connected, upwards};
use super::turning::{PRINTED_HEADINGS, examine_separate};
use crate::tanner2::arbitrary::{Arbitrary, dot, total};
use algebra::graph::Graph;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Field, Rational, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{Vector, scaled};

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
