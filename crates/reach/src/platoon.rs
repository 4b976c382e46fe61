//! Platoons behind a leader of bounded acceleration: the section `[platoon]`, and the linear system that it stands for.

use crate::cascade::{self, Order};
use crate::decide::ReachError;
use crate::modal::{Modal, ModalError, balance};
use crate::support::Found;
use crate::system::{Input, Mode, Range, System};
use crate::witness::Witness;
use arithmetic::{Enclosure, Progress, Rational, rational};
use models::platoon::{Communication, CommunicationGraph, Gains};
use num_traits::Signed;

/// A platoon of Veerman and others: the acceleration of follower `k` is `f e_k + g e'_k`, with its deviation `e_k` from the mean of the agents that it tracks.
#[derive(Debug, Clone, PartialEq)]
pub struct Platoon {
    /// Who tracks whom; agent 0 leads.
    pub graph: CommunicationGraph,
    /// The gains.
    pub gains: Gains<Rational>,
    /// Where the leader's acceleration lies.
    pub acceleration: Range,
}

/// How worst cases are found without the matrices.
pub(crate) enum Way {
    /// As sums over the modes, where followers track each other in both directions; with the weights that make the matrix symmetric.
    Modes(Vec<Rational>),
    /// Car by car, where each tracks the one in front.
    Cascade,
    /// Car by car, where each tracks some that come earlier in an order.
    Ordered(Order),
}

/// Most followers whose motion is written out as one matrix.
pub(crate) const WRITTEN_OUT: usize = 100;

/// Most changes of sign of an input that is shown.
const MOST_CHANGES: usize = 50_000;

impl Platoon {
    /// The names that checks use: `lag1`, .. for `y_k - y_0`, `gap1`, .. for `y_k - y_(k-1)`, and `rate1`, .. for the rates of the lags.
    pub(crate) fn names(&self) -> Vec<String> {
        let m = self.graph.followers();
        ["lag", "gap", "rate"].iter().flat_map(|word| (1..=m).map(move |k| format!("{word}{k}"))).collect()
    }

    /// A row over the names as one over lags and rates.
    pub(crate) fn row(&self, named: &[Rational]) -> Vec<Rational> {
        let m = self.graph.followers();
        let mut row = named[..m].to_vec();
        for (k, gap) in named[m..2 * m].iter().enumerate() {
            row[k] += gap;
            if k > 0 {
                row[k - 1] -= gap;
            }
        }
        row.extend(named[2 * m..].iter().cloned());
        row
    }

    /// How worst cases of lags are found for many followers: with gains below zero and an acceleration that may be 0, so that they grow with time.
    pub(crate) fn way(&self) -> Option<Way> {
        let still = !self.acceleration.lo.is_positive() && !self.acceleration.hi.is_negative();
        let damped = self.gains.f.is_negative() && self.gains.g.is_negative();
        if !(still && damped) {
            return None;
        }
        let in_front = CommunicationGraph::of(Communication::Front, self.graph.followers());
        if self.graph.followers() > 1 && in_front.is_ok_and(|graph| graph == self.graph) {
            return Some(Way::Cascade);
        }
        balance(&self.graph).map(Way::Modes).or_else(|| Order::of(&self.graph).map(Way::Ordered))
    }

    /// States, inputs, start and the mode of the system; the matrices are left out where there are too many followers, so that only sums over modes are possible.
    pub(crate) fn system(&self) -> (Vec<String>, Vec<Input>, Vec<Range>, Vec<Mode>) {
        let m = self.graph.followers();
        let states = ["lag", "rate"].iter().flat_map(|word| (1..=m).map(move |k| format!("{word}{k}")));
        let leader = Input { name: "leader".to_string(), range: self.acceleration.clone(), constant: false };
        let start = vec![Range::point(Rational::ZERO); 2 * m];
        let mut mode = Mode { name: "platoon".to_string(), a: Vec::new(), b: Vec::new(), c: Vec::new() };
        if m <= WRITTEN_OUT {
            let unit = |i: usize, j: usize| rational(i64::from(i == j), 1);
            mode.a.extend((0..m).map(|i| (0..2 * m).map(|j| unit(i + m, j)).collect()));
            for i in 1..=m {
                let mut laplacian: Vec<Rational> = (1..=m).map(|j| unit(i, j)).collect();
                for (j, weight) in self.graph.tracked_by(i).iter().filter(|(j, _)| *j != 0) {
                    laplacian[j - 1] -= weight;
                }
                let times = |gain: &Rational| laplacian.iter().map(|x| x * gain).collect::<Vec<_>>();
                mode.a.push(times(&self.gains.f).into_iter().chain(times(&self.gains.g)).collect());
            }
            mode.b = (0..2 * m).map(|i| vec![rational(if i < m { 0 } else { -1 }, 1)]).collect();
            mode.c = vec![Rational::ZERO; 2 * m];
        }
        (states.collect(), vec![leader], start, vec![mode])
    }
}

/// The greatest value of a row of lags with the leader's acceleration that attains it.
pub(crate) struct Swung {
    pub lo: Rational,
    pub hi: Rational,
    pub witness: Option<Witness>,
}

/// The greatest values of rows at a time, or for ever.
///
/// # Errors
/// [`ModalError`].
pub(crate) fn greatest(
    system: &System,
    (platoon, way): (&Platoon, &Way),
    rows: &[Vec<Rational>],
    until: Option<&Rational>,
    progress: &dyn Progress,
) -> Result<Vec<Swung>, ModalError> {
    let m = platoon.graph.followers();
    let rows: Vec<Vec<Rational>> = rows.iter().map(|row| row[..m].to_vec()).collect();
    let found = match way {
        Way::Cascade => cascade::greatest(&platoon.gains, None, &rows, &platoon.acceleration, until, progress)?,
        Way::Ordered(order) => {
            cascade::greatest(&platoon.gains, Some(order), &rows, &platoon.acceleration, until, progress)?
        }
        Way::Modes(weights) => {
            let modal = Modal::new(&platoon.graph, weights, &platoon.gains, progress)?;
            let one = |row: &Vec<Rational>| modal.greatest(row, &platoon.acceleration, until, progress);
            rows.iter().map(one).collect::<Result<_, _>>()?
        }
    };
    let swung = |found: Found| {
        let (lo, hi) = found.value.ends().ok_or(ModalError::Unbounded)?;
        let shown = found.signs.len() <= MOST_CHANGES;
        let witness = shown.then(|| swung(system, &found.signs, found.time.clone(), &lo, &hi, found.unsigned));
        Ok(Swung { lo, hi, witness })
    };
    found.into_iter().map(swung).collect()
}

/// For some cars, the first and the last among them, the least and the greatest gap to the car in front up to the last time, each rounded outwards; none where there is no
/// platoon, or one whose matrices are all that is known.
///
/// # Errors
/// [`ReachError`].
pub fn gaps(system: &System, cars: usize, progress: &dyn Progress) -> Result<Option<Vec<(usize, Range)>>, ReachError> {
    let Some((platoon, way)) = system.platoon.as_ref().and_then(|platoon| Some((platoon, platoon.way()?))) else {
        return Ok(None);
    };
    let m = platoon.graph.followers();
    let steps = cars.clamp(2, m.max(2)) - 1;
    let mut chosen: Vec<usize> = (0..=steps).map(|i| 1 + i * (m - 1) / steps).collect();
    chosen.dedup();
    let row = |car: usize, sign: i64| {
        let mut row = vec![Rational::ZERO; m];
        row[car - 1] = rational(sign, 1);
        if car > 1 {
            row[car - 2] = rational(-sign, 1);
        }
        row
    };
    let rows: Vec<Vec<Rational>> = chosen.iter().flat_map(|&car| [row(car, 1), row(car, -1)]).collect();
    let found = match greatest(system, (platoon, &way), &rows, system.until.as_ref(), progress) {
        Ok(found) => found,
        Err(ModalError::Cancelled(cancelled)) => return Err(cancelled.into()),
        Err(error) => return Err(ReachError::Platoon(error.to_string())),
    };
    let ends = found.chunks(2).map(|pair| Range { lo: -&pair[1].hi, hi: pair[0].hi.clone() });
    Ok(Some(chosen.into_iter().zip(ends).collect()))
}

/// The acceleration that follows the sign of the response, backwards from the end.
fn swung(
    system: &System,
    signs: &[(Rational, bool)],
    at: Rational,
    lo: &Rational,
    hi: &Rational,
    unsigned: f64,
) -> Witness {
    let range = &system.inputs[0].range;
    let mut input = Vec::new();
    for (i, (_, positive)) in signs.iter().enumerate().rev() {
        // The part ends where the next one begins, and so is on from the end less that.
        let from = signs.get(i + 1).map_or(Rational::ZERO, |(to, _)| &at - to);
        input.push((from, if *positive { range.hi.clone() } else { range.lo.clone() }));
    }
    if input.is_empty() {
        input.push((Rational::ZERO, range.lo.clone()));
    }
    let slack = Rational::from_float(unsigned.next_up()).unwrap_or_default();
    let start = vec![Rational::ZERO; system.states.len()];
    let value = Range { lo: lo - slack, hi: hi.clone() };
    Witness { at, start, modes: vec![(Rational::ZERO, 0)], inputs: vec![input], value }
}

/// The motion at a later time: before it begins the platoon rests, which the leader's acceleration allows where motions are found in this way.
pub(crate) fn after_rest(mut witness: Witness, at: &Rational) -> Witness {
    let rest = at - &witness.at;
    if rest.is_positive() {
        witness.at = at.clone();
        for input in &mut witness.inputs {
            input.iter_mut().for_each(|(from, _)| *from += &rest);
            input.insert(0, (Rational::ZERO, Rational::ZERO));
        }
    }
    witness
}
