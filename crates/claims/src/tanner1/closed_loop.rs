//! The closed loop (1), (4), (5) of the first paper at one state, for any potentials.
//!
//! The headings are variables of their own here: the identities hold for any numbers `theta_i` whose rates are those of the
//! headings of `v_i`, so under every reading of `theta_i - theta_j` away from its jumps. Counterexamples use velocities with
//! one common direction, for which all readings agree.

use crate::tanner2::arbitrary::{Arbitrary, dot, total};
use algebra::graph::Graph;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Dual, Field, Rational, rational};
use ledger::{CheckError, Evidence, Grade, Outcome, Run};
use models::double_integrator::{Vector, gyroscopic, heading_rate, sum};

/// The closed loop at one state, with headings.
pub(super) struct Loop<T> {
    pub flock: Arbitrary<T>,
    pub headings: Vec<T>,
    pub gradients: Vec<Vector<T>>,
    pub accelerations: Vec<Vector<T>>,
}

/// `a x b`.
pub(super) fn cross<T: Field>(a: &Vector<T>, b: &Vector<T>) -> T {
    a[0].clone() * &b[1] - a[1].clone() * &b[0]
}

impl<T: Field> Loop<T> {
    pub fn variables(graph: &Graph) -> usize {
        Arbitrary::variables(graph) + graph.order()
    }

    pub fn read(graph: &Graph, at: &[T]) -> Result<Self, ArithmeticError> {
        let (own, headings) = at.split_at(Arbitrary::variables(graph));
        let flock = Arbitrary::read(graph, own)?;
        let gradients = flock.gradients()?;
        let accelerations =
            gyroscopic(&flock.state, &gradients, &flock.edges, |i, j| headings[i].clone() - &headings[j])?;
        Ok(Loop { flock, headings: headings.to_vec(), gradients, accelerations })
    }

    pub fn count(&self) -> usize {
        self.headings.len()
    }

    /// The alignment forces alone.
    pub fn alignment(&self) -> Vec<Vector<T>> {
        self.accelerations.iter().zip(&self.gradients).map(|(a, g)| sum(a, g)).collect()
    }

    /// `thetadot_i = (v_i x vdot_i)/|v_i|²`.
    pub fn heading_rates(&self) -> Result<Vec<T>, ArithmeticError> {
        self.flock.state.velocities.iter().zip(&self.accelerations).map(|(v, a)| heading_rate(v, a)).collect()
    }

    /// What the potentials alone do to the headings, `-(v_i x grad_{r_i} V_i)/|v_i|²`.
    pub fn potential_rates(&self) -> Result<Vec<T>, ArithmeticError> {
        let rate = |(v, g): (&Vector<T>, &Vector<T>)| Ok(-heading_rate(v, g)?);
        self.flock.state.velocities.iter().zip(&self.gradients).map(rate).collect()
    }

    /// `(L_w theta)_i`, from the sums over the neighbours.
    pub fn laplacian(&self) -> Result<Vec<T>, ArithmeticError> {
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
    pub fn rate_of(
        &self,
        potentials: (i64, i64),
        kinetic: (i64, i64),
        headings: (i64, i64),
    ) -> Result<T, ArithmeticError> {
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
pub(super) fn on_connected<I: RationalIdentity>(
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
pub(super) fn upwards() -> Vec<Rational> {
    let q = |n| rational(n, 1);
    vec![q(0), q(0), q(1), q(1), q(0), q(2), q(0), q(1), rational(1, 4), q(1), q(1)]
}

pub(super) const UPWARDS: &str = "two agents at (0, 0) and (1, 1) with velocities (0, 2) and (0, 1), V = 1/s + log s";

/// Whether the sides agree at the state above; the counterexample if not.
pub(super) fn at_upwards(identity: &impl RationalIdentity, what: &str) -> Result<Option<Outcome>, CheckError> {
    let (left, right) = identity.sides(&upwards())?;
    let place = left.iter().zip(&right).position(|(l, r)| l != r);
    Ok(place.map(|k| {
        Outcome::fails(
            format!("{UPWARDS}: {what} is {}, but {} is claimed", left[k], right[k]),
            Evidence::new(Grade::Exact, what, "exact rates of change; equal headings, so that alignment forces vanish"),
        )
    }))
}
