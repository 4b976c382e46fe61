//! What can happen next where pairs are at distance exactly `R`: the solutions of the second paper's (10), in the sense of
//! Filippov, for a short time. Derivation in `notes/tanner2.md`.
//!
//! The law is of second order, so `d/dt |r_ij|² = 2 r_ij.v_ij` does not jump at the threshold: a pair for which it is not zero
//! passes. Where it is zero ("at rest radially") the second derivative decides. It falls by `8 V'(R²) R²` when the pair is linked;
//! a weight between that of the unlinked and of the linked side may keep the pair at `R`.

use crate::double_integrator::laws::{
    Coordinates, Pair, Potential, State, Vector, difference, linked_within, scaled, sum, tied, velocity_alignment,
};
use algebra::graph::Graph;
use algebra::matrix::solve_over_field;
use arithmetic::{ArithmeticError, Field, Sign, Signed};

/// What a pair at distance `R` does just after.
#[derive(Debug, Clone, PartialEq)]
pub enum Way<T> {
    /// The distance grows: the pair is not linked.
    Leaves,
    /// The distance falls: the pair is linked.
    Enters,
    /// The distance stays `R`, with the link in force with this weight in `[0, 1]` at the instant.
    Stays(T),
}

/// One way on for all pairs at distance `R`.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch<T> {
    /// Every tied pair with what it does.
    pub ways: Vec<(Pair, Way<T>)>,
    /// Whether there certainly is such a solution; otherwise derivatives up to the third do not tell (or, over intervals, their signs
    /// are not known).
    pub decided: bool,
}

/// All ways on from a state.
#[derive(Debug, Clone, PartialEq)]
pub struct Fork<T> {
    /// The solutions on which every pair does one thing for a short time. One means no choice.
    pub branches: Vec<Branch<T>>,
    /// The pairs at distance `R` whose distance has rate 0. With one of them, every solution from here takes a branch at once or
    /// after having stayed at `R` for a while; with several there might be solutions of other kinds.
    pub grazing: Vec<Pair>,
}

/// Why the ways on are not known.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ForkError {
    /// The law has no value.
    #[error(transparent)]
    Law(#[from] ArithmeticError),
    /// Too many to be gone through.
    #[error(
        "{0} pairs are at distance R with a distance that neither grows nor falls; at most {MOST_GRAZING} can be examined"
    )]
    TooMany(usize),
}

/// Pairs at distance `R` with rate 0 that are examined. Up to six such pairs can switch independently: a dependence between the
/// gradients of their distances takes more bars of one length, as long as no two agents are in one place.
pub const MOST_GRAZING: usize = 6;

impl<T> Branch<T> {
    /// With every weight converted.
    pub fn map<U>(&self, convert: impl Fn(&T) -> U) -> Branch<U> {
        let way = |way: &Way<T>| match way {
            Way::Leaves => Way::Leaves,
            Way::Enters => Way::Enters,
            Way::Stays(weight) => Way::Stays(convert(weight)),
        };
        Branch { ways: self.ways.iter().map(|(pair, w)| (*pair, way(w))).collect(), decided: self.decided }
    }
}

/// The ways on from a state: links where `|r_ij|² < square`, ties where it is equal. Exact over rationals.
///
/// # Errors
/// [`ForkError`].
pub fn fork<T: Field + Signed>(
    state: &State<T>,
    square: &T,
    coordinates: Coordinates,
    potential: &Potential,
) -> Result<Fork<T>, ForkError> {
    state.check()?;
    let links = linked_within(&state.positions, square, coordinates).edges();
    let ties = tied(&state.positions, square, coordinates);
    Law { coordinates, potential }.fork(state, &links, &ties, &[])
}

/// The law at hand.
#[derive(Clone, Copy)]
pub(super) struct Law<'a> {
    pub coordinates: Coordinates,
    pub potential: &'a Potential,
}

/// What is tried for a grazing pair.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Choice {
    Leave,
    Enter,
    Stay,
}

/// What is tried for all: the pairs that are linked, and those that stay at `R`.
struct Assignment {
    links: Vec<Pair>,
    staying: Vec<Pair>,
}

/// Weights of the pairs that stay, and the second derivatives of `|r_ij|²` of the grazing pairs.
struct Rates<T> {
    accelerations: Vec<Vector<T>>,
    weights: Vec<T>,
    second: Vec<T>,
}

impl Law<'_> {
    /// As [`fork`], with given links and ties; those among the ties in `still` count as grazing whatever their rate is.
    pub fn fork<T: Field + Signed>(
        &self,
        state: &State<T>,
        links: &[Pair],
        ties: &[Pair],
        still: &[Pair],
    ) -> Result<Fork<T>, ForkError> {
        let (mut grazing, mut ways, mut links) = (Vec::new(), Vec::new(), links.to_vec());
        for &pair in ties {
            let rate =
                self.coordinates.product(&state.separation(pair.0, pair.1), &state.relative_velocity(pair.0, pair.1));
            match rate.sign() {
                Some(Sign::Positive) if !still.contains(&pair) => ways.push((pair, Way::Leaves)),
                Some(Sign::Negative) if !still.contains(&pair) => {
                    ways.push((pair, Way::Enters));
                    links.push(pair);
                }
                _ => grazing.push(pair),
            }
        }
        if grazing.len() > MOST_GRAZING {
            return Err(ForkError::TooMany(grazing.len()));
        }
        if grazing.is_empty() {
            return Ok(Fork { branches: vec![Branch { ways, decided: true }], grazing });
        }
        let mut branches = Vec::new();
        for code in 0..3usize.pow(grazing.len() as u32) {
            let choice = |k: usize| [Choice::Leave, Choice::Enter, Choice::Stay][code / 3usize.pow(k as u32) % 3];
            let those = |wanted: Choice| (0..grazing.len()).filter(move |&k| choice(k) == wanted).map(|k| grazing[k]);
            let links = links.iter().copied().chain(those(Choice::Enter)).collect();
            let assignment = Assignment { links, staying: those(Choice::Stay).collect() };
            if let Some(branch) = self.branch(state, &grazing, choice, &assignment)? {
                let ways = ways.iter().cloned().chain(branch.ways).collect();
                branches.push(Branch { ways, decided: branch.decided });
            }
        }
        Ok(Fork { branches, grazing })
    }

    /// The accelerations with some links, and other pairs linked with weights.
    pub fn weighted<T: Field>(
        &self,
        state: &State<T>,
        links: &[Pair],
        weights: &[(Pair, T)],
    ) -> Result<Vec<Vector<T>>, ArithmeticError> {
        let slope = |_: usize, _: usize, s: &T| self.potential.slope(s);
        let start = velocity_alignment(state, links, self.coordinates, slope)?;
        weights.iter().try_fold(start, |total, (pair, weight)| {
            let more = velocity_alignment(state, &[*pair], self.coordinates, slope)?;
            Ok(total.iter().zip(&more).map(|(a, b)| sum(a, &scaled(weight, b))).collect())
        })
    }

    /// `d²|r_ij|²/dt² = 2 (|v_ij|² + r_ij.a_ij)`.
    fn second<T: Field>(&self, state: &State<T>, accelerations: &[Vector<T>], (i, j): Pair) -> T {
        let bend = difference(&accelerations[i], &accelerations[j]);
        let sum = self.coordinates.square(&state.relative_velocity(i, j))
            + self.coordinates.product(&state.separation(i, j), &bend);
        sum.integer(2) * sum
    }

    /// The weights in force on pairs that stay at `R`: those for which every second derivative is `wanted`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where the weights are not determined.
    pub fn weights<T: Field>(
        &self,
        state: &State<T>,
        links: &[Pair],
        staying: &[Pair],
        wanted: impl Fn(Pair) -> T,
    ) -> Result<Vec<T>, ArithmeticError> {
        let base = self.weighted(state, links, &[])?;
        let mut rows: Vec<Vec<T>> = staying.iter().map(|_| Vec::new()).collect();
        for &pair in staying {
            // The second derivatives are affine in the weights.
            let pull = self.weighted(state, &[pair], &[])?;
            for (row, &(i, j)) in rows.iter_mut().zip(staying) {
                let bend = self.coordinates.product(&state.separation(i, j), &difference(&pull[i], &pull[j]));
                row.push(bend.integer(2) * bend);
            }
        }
        for (row, &pair) in rows.iter_mut().zip(staying) {
            row.push(wanted(pair) - self.second(state, &base, pair));
        }
        solve_over_field(rows)
    }

    fn rates<T: Field>(
        &self,
        state: &State<T>,
        grazing: &[Pair],
        assignment: &Assignment,
    ) -> Result<Rates<T>, ArithmeticError> {
        let zero = state.positions[grazing[0].0][0].zero();
        let weights = self.weights(state, &assignment.links, &assignment.staying, |_| zero.clone())?;
        let weighted: Vec<(Pair, T)> = assignment.staying.iter().copied().zip(weights.iter().cloned()).collect();
        let accelerations = self.weighted(state, &assignment.links, &weighted)?;
        let second = grazing.iter().map(|&pair| self.second(state, &accelerations, pair)).collect();
        Ok(Rates { accelerations, weights, second })
    }

    /// The branch in which the grazing pairs do what `choice` says, if there is one.
    fn branch<T: Field + Signed>(
        &self,
        state: &State<T>,
        grazing: &[Pair],
        choice: impl Fn(usize) -> Choice,
        assignment: &Assignment,
    ) -> Result<Option<Branch<T>>, ArithmeticError> {
        let now = match self.rates(state, grazing, assignment) {
            // Weights that the second derivatives do not depend on, or not independently: any will do, or none.
            Err(ArithmeticError::DivisionByZero) => self.rates_unweighted(state, grazing, assignment)?,
            other => other?,
        };
        // One derivative more, along the motion that this assignment gives.
        let soon = self.rates(&state.moving(&now.accelerations), grazing, assignment).ok();
        let (mut ways, mut decided) = (Vec::new(), true);
        let mut weights = now.weights.iter().enumerate();
        for (k, &pair) in grazing.iter().enumerate() {
            let bend = (now.second[k].clone(), soon.as_ref().map(|r| r.second[k].derivative.clone()));
            let (way, conditions) = match choice(k) {
                Choice::Leave => (Way::Leaves, vec![bend]),
                Choice::Enter => (Way::Enters, vec![(-bend.0, bend.1.map(|x| -x))]),
                Choice::Stay => {
                    let Some((place, weight)) = weights.next() else { return Ok(None) };
                    if bend.0.sign().is_some_and(|sign| sign != Sign::Zero) {
                        return Ok(None);
                    }
                    let rate = soon.as_ref().map(|r| r.weights[place].derivative.clone());
                    let room = (weight.one() - weight, rate.clone().map(|x| -x));
                    (Way::Stays(weight.clone()), vec![(weight.clone(), rate), room])
                }
            };
            for (value, rate) in conditions {
                let rate = rate.and_then(|x| x.sign());
                match (value.sign(), rate) {
                    (Some(Sign::Positive), _) | (Some(Sign::Zero), Some(Sign::Positive)) => {}
                    (Some(Sign::Negative), _) | (_, Some(Sign::Negative)) => return Ok(None),
                    // An equilibrium stays one: its distances neither grow nor fall.
                    (Some(Sign::Zero), _) if assignment.pair_rests(state, &now.accelerations, pair) => {
                        if choice(k) != Choice::Stay {
                            return Ok(None);
                        }
                    }
                    _ => decided = false,
                }
            }
            ways.push((pair, way));
        }
        Ok(Some(Branch { ways, decided }))
    }

    /// With weights 0 where they are not determined.
    fn rates_unweighted<T: Field>(
        &self,
        state: &State<T>,
        grazing: &[Pair],
        assignment: &Assignment,
    ) -> Result<Rates<T>, ArithmeticError> {
        let accelerations = self.weighted(state, &assignment.links, &[])?;
        let second = grazing.iter().map(|&pair| self.second(state, &accelerations, pair)).collect();
        let zero = accelerations.first().map(|a| a[0].zero());
        Ok(Rates { weights: zero.into_iter().cycle().take(assignment.staying.len()).collect(), accelerations, second })
    }
}

impl Assignment {
    /// Whether all agents joined to this one, directly or not, have one velocity and no acceleration.
    fn rests<T: Field + Signed>(&self, state: &State<T>, accelerations: &[Vector<T>], agent: usize) -> bool {
        let joined = Graph::empty(state.count()).with_edges(&self.links).with_edges(&self.staying);
        let none = |x: T| x.sign() == Some(Sign::Zero);
        let members = joined.components().into_iter().find(|members| members.contains(&agent)).unwrap_or_default();
        members.iter().all(|&i| state.relative_velocity(i, agent).into_iter().chain(accelerations[i].clone()).all(none))
    }

    /// Whether this holds on both sides of a pair, which are not joined where it parts.
    fn pair_rests<T: Field + Signed>(&self, state: &State<T>, accelerations: &[Vector<T>], (i, j): Pair) -> bool {
        self.rests(state, accelerations, i) && self.rests(state, accelerations, j)
    }
}
