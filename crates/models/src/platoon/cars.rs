//! A platoon as it is steered: whose position and whose velocity each car keeps track of, with which weights, and the gains of each car.

use super::communication_graph::{CommunicationError, CommunicationGraph};
use super::law::{Gains, accelerations_by};
use super::vector_form::motion_rows_of;
use algebra::matrix::{MatrixError, solve_over_field};
use arithmetic::{ArithmeticError, Complex, Field, Rational, Ring};
use std::sync::Arc;

/// Followers with gains of their own, `y_k'' = f_k e_k + g_k e'_k`, where `e_k` is the deviation of car `k` from the weighted mean of the cars whose
/// positions it tracks, and `e'_k` that of its velocity from the weighted mean of the cars whose velocities it tracks.
#[derive(Debug, Clone, PartialEq)]
pub struct Platoon<T> {
    positions: Arc<CommunicationGraph>,
    /// Where it is another one than that of the positions.
    velocities: Option<Arc<CommunicationGraph>>,
    gains: Vec<Gains<T>>,
}

/// An agent that a follower tracks, with the weights of its position and of its velocity.
pub(super) struct Tracked {
    pub agent: usize,
    pub position: Rational,
    pub velocity: Rational,
}

impl<T> Platoon<T> {
    /// Followers that track positions and velocities of the same cars with the same weights; follower `k` has the gains `gains[k - 1]`.
    ///
    /// # Errors
    /// [`CommunicationError::Gains`].
    pub fn new(graph: CommunicationGraph, gains: Vec<Gains<T>>) -> Result<Self, CommunicationError> {
        let followers = graph.followers();
        if gains.len() != followers {
            return Err(CommunicationError::Gains { given: gains.len(), followers });
        }
        Ok(Platoon { positions: Arc::new(graph), velocities: None, gains })
    }

    /// The same platoon with velocities that are tracked along another graph.
    ///
    /// # Errors
    /// [`CommunicationError::Velocities`].
    pub fn with_velocities(self, velocities: CommunicationGraph) -> Result<Self, CommunicationError> {
        let (positions, found) = (self.positions.followers(), velocities.followers());
        if positions != found {
            return Err(CommunicationError::Velocities { positions, velocities: found });
        }
        let velocities = Some(velocities).filter(|other| *other != *self.positions).map(Arc::new);
        Ok(Platoon { velocities, ..self })
    }

    /// The number `M` of followers.
    pub fn followers(&self) -> usize {
        self.gains.len()
    }

    /// The gains of the followers, in order.
    pub fn gains(&self) -> &[Gains<T>] {
        &self.gains
    }

    /// Whose positions are tracked.
    pub fn positions(&self) -> &CommunicationGraph {
        &self.positions
    }

    /// Whose velocities are tracked.
    pub fn velocities(&self) -> &CommunicationGraph {
        self.velocities.as_deref().unwrap_or(&self.positions)
    }

    /// The one graph, where positions and velocities are tracked alike.
    pub fn one_graph(&self) -> Option<&CommunicationGraph> {
        self.velocities.is_none().then_some(self.positions())
    }

    /// Whom follower `k >= 1` tracks, the weights of what it does not track being zero.
    pub(super) fn tracked_by(&self, k: usize) -> Vec<Tracked> {
        let agents = self.positions.tracked_by(k).iter();
        let Some(velocities) = &self.velocities else {
            let both = |(agent, weight): &(usize, Rational)| Tracked {
                agent: *agent,
                position: weight.clone(),
                velocity: weight.clone(),
            };
            return agents.map(both).collect();
        };
        let zero = Rational::default;
        let mut all: Vec<Tracked> = agents
            .map(|(agent, weight)| Tracked { agent: *agent, position: weight.clone(), velocity: zero() })
            .collect();
        for (agent, weight) in velocities.tracked_by(k) {
            match all.iter_mut().find(|other| other.agent == *agent) {
                Some(known) => known.velocity = weight.clone(),
                None => all.push(Tracked { agent: *agent, position: zero(), velocity: weight.clone() }),
            }
        }
        all
    }

    /// Pairs of a follower and an agent whose position or velocity it tracks.
    pub fn links(&self) -> Vec<(usize, usize)> {
        let of = |k: usize| self.tracked_by(k).into_iter().map(move |other| (k, other.agent));
        (1..=self.followers()).flat_map(of).collect()
    }

    /// Which of the agents 0 to M the movement of the leader reaches, by positions or velocities.
    pub fn reached_by_leader(&self) -> Vec<bool> {
        let links = self.links();
        let mut reached = vec![false; self.followers() + 1];
        reached[0] = true;
        loop {
            let next = links.iter().find(|(k, agent)| reached[*agent] && !reached[*k]);
            let Some((k, _)) = next else { return reached };
            reached[*k] = true;
        }
    }

    /// The same cars with other gains, `f` and `g` of each follower; nothing where there are more or fewer.
    pub fn with_gains<S>(&self, gains: Vec<[S; 2]>) -> Option<Platoon<S>> {
        let gains: Vec<Gains<S>> = gains.into_iter().map(|[f, g]| Gains { f, g }).collect();
        let (positions, velocities) = (self.positions.clone(), self.velocities.clone());
        (gains.len() == self.gains.len()).then_some(Platoon { positions, velocities, gains })
    }

    /// The same platoon with gains in another scalar.
    pub fn map<S>(&self, convert: impl Fn(&T) -> S) -> Platoon<S>
    where
        T: Ring,
    {
        Platoon {
            positions: self.positions.clone(),
            velocities: self.velocities.clone(),
            gains: self.gains.iter().map(|gains| gains.map(&convert)).collect(),
        }
    }
}

impl<T: Field> Platoon<T> {
    /// The graph and the gains, where all cars have the same ones.
    pub fn with_equal_gains(&self) -> Option<(&CommunicationGraph, &Gains<T>)>
    where
        T: PartialEq,
    {
        let first = self.gains.first()?;
        Some((self.one_graph()?, first)).filter(|_| self.gains.iter().all(|other| other == first))
    }

    /// The accelerations of the followers. `leader` is `(y_0, u_0)`; `positions` and `velocities` hold `y_1..y_M` and `u_1..u_M`. From shorter
    /// lists only those of the cars before the first one that is not in both, or tracks one that is not.
    pub fn accelerations(&self, leader: (&T, &T), positions: &[T], velocities: &[T]) -> Vec<T> {
        let given = positions.len().min(velocities.len());
        let graphs = [self.positions(), self.velocities()];
        let cars = graphs.map(|graph| graph.moved_by(given)).into_iter().fold(self.followers(), usize::min);
        let means = graphs.map(|graph| |k: usize, value: &dyn Fn(usize) -> T| graph.mean(k, value));
        accelerations_by(cars, means, |k| &self.gains[k - 1], leader, (positions, velocities))
    }

    /// The rows of the matrix of order 2M by which the pairs `(y_k, u_k)` of the followers move behind a resting leader.
    ///
    /// # Errors
    /// Does not fail for graphs that could be made.
    pub fn motion_rows(&self) -> Result<Vec<Vec<T>>, MatrixError> {
        let positions = self.positions.reduced_laplacian()?;
        match &self.velocities {
            None => Ok(motion_rows_of([&positions; 2], |k| &self.gains[k])),
            Some(other) => Ok(motion_rows_of([&positions, &other.reduced_laplacian()?], |k| &self.gains[k])),
        }
    }

    /// The row of each follower's acceleration in what the leader does: by its position and by its velocity.
    pub fn leader_rows(&self) -> Vec<[T; 2]> {
        let row = |(k, gains): (usize, &Gains<T>)| {
            let weight = |graph: &CommunicationGraph| {
                let own = graph.tracked_by(k).iter().filter(|(agent, _)| *agent == 0);
                own.fold(gains.f.zero(), |sum, (_, weight)| sum + gains.f.rational(weight))
            };
            [-(weight(&self.positions) * &gains.f), -(weight(self.velocities()) * &gains.g)]
        };
        (1..).zip(&self.gains).map(row).collect()
    }

    /// The amplitudes `a_1..a_M` behind the leader `y_0 = e^{iwt}`: the solution of
    /// `-w² a_k = f_k (a_k - mean of the a_j) + i w g_k (a_k - mean of the a_j)`. Followers that the leader does not reach are at rest.
    /// Cost: `M³` products.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the response does not exist or cannot be separated from a pole.
    pub fn response(&self, w: &T) -> Result<Vec<Complex<T>>, ArithmeticError> {
        let reached = self.reached_by_leader();
        let index: Vec<usize> = (1..=self.followers()).filter(|&k| reached[k]).collect();
        let zero = Complex::real(w.zero());
        let mut rows = Vec::with_capacity(index.len());
        for (own, &k) in index.iter().enumerate() {
            let gains = &self.gains[k - 1];
            let mut row = vec![zero.clone(); index.len() + 1];
            row[own].re = -w.square();
            for Tracked { agent, position, velocity } in self.tracked_by(k) {
                let term =
                    Complex::new(gains.f.clone() * w.rational(&position), gains.g.clone() * w * w.rational(&velocity));
                row[own] = row[own].clone() - &term;
                match agent {
                    0 => row[index.len()] = row[index.len()].clone() - &term,
                    // A reached follower may track one that is not; that one is at rest.
                    _ => {
                        if let Ok(place) = index.binary_search(&agent) {
                            row[place] = row[place].clone() + &term;
                        }
                    }
                }
            }
            rows.push(row);
        }
        let mut amplitudes = vec![zero; self.followers()];
        if !rows.is_empty() {
            for (k, value) in index.into_iter().zip(solve_over_field(rows)?) {
                amplitudes[k - 1] = value;
            }
        }
        Ok(amplitudes)
    }
}
