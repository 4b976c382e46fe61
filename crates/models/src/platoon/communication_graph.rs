//! Which agents each follower keeps track of, for any communication graph on the line, and the matrices made from it.

use super::law::{Communication, Gains, accelerations_by};
use algebra::graph::WeightedGraph;
use algebra::matrix::{MatrixError, RationalMatrix, solve_over_field};
use arithmetic::{ArithmeticError, Complex, Field, Rational, Ring, Signed, rational};

/// The agents that each follower keeps track of, with weights that sum to one. Agent 0 is the leader, which tracks nobody; the
/// followers are 1 to M. A follower that tracks nobody moves with constant velocity.
#[derive(Debug, Clone, PartialEq)]
pub struct CommunicationGraph {
    tracked: Vec<Vec<(usize, Rational)>>,
}

/// Platoons of more followers are not listed.
const MOST_FOLLOWERS: usize = 1 << 30;

/// Refuses what no list would hold.
pub(super) fn check_count(followers: usize) -> Result<(), CommunicationError> {
    if followers > MOST_FOLLOWERS { Err(CommunicationError::TooManyFollowers(followers)) } else { Ok(()) }
}

/// Why a list of tracked agents is refused.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CommunicationError {
    /// No followers.
    #[error("a platoon needs at least one follower")]
    NoFollowers,
    /// More followers than a list holds.
    #[error("a platoon has at most {MOST_FOLLOWERS} followers, not {0}")]
    TooManyFollowers(usize),
    /// An agent that is not there, or the follower itself.
    #[error("follower {follower} cannot keep track of agent {agent}")]
    Agent {
        /// The follower, from 1.
        follower: usize,
        /// The agent it is said to track.
        agent: usize,
    },
    /// Gains of another number of followers.
    #[error("there are {given} gains for {followers} followers")]
    Gains {
        /// The gains.
        given: usize,
        /// The followers.
        followers: usize,
    },
    /// Velocities of another number of followers than positions.
    #[error("the positions are those of {positions} followers, the velocities those of {velocities}")]
    Velocities {
        /// Followers in the one graph.
        positions: usize,
        /// Followers in the other one.
        velocities: usize,
    },
    /// Weights that are not positive or do not sum to one.
    #[error("the weights of follower {0} must be positive and sum to one")]
    Weights(usize),
}

impl CommunicationGraph {
    /// The graph in which follower `k` tracks the agents `tracked[k - 1]` with these weights.
    ///
    /// # Errors
    /// [`CommunicationError`].
    pub fn new(tracked: Vec<Vec<(usize, Rational)>>) -> Result<Self, CommunicationError> {
        if tracked.is_empty() {
            return Err(CommunicationError::NoFollowers);
        }
        for (row, follower) in tracked.iter().zip(1..) {
            if let Some(&(agent, _)) = row.iter().find(|(agent, _)| *agent > tracked.len() || *agent == follower) {
                return Err(CommunicationError::Agent { follower, agent });
            }
            let sum: Rational = row.iter().map(|(_, weight)| weight).sum();
            let positive = row.iter().all(|(_, weight)| weight.is_certainly_positive());
            if !row.is_empty() && (!positive || sum != rational(1, 1)) {
                return Err(CommunicationError::Weights(follower));
            }
        }
        Ok(CommunicationGraph { tracked })
    }

    /// The vertices of a weighted graph but the leader, in order, each of which tracks those that its arcs lead to, with weights scaled to a sum of one.
    ///
    /// # Errors
    /// [`CommunicationError`].
    pub fn behind(graph: &WeightedGraph, leader: usize) -> Result<Self, CommunicationError> {
        let agent = |vertex: usize| if vertex == leader { 0 } else { vertex + usize::from(vertex < leader) };
        let row = |vertex: usize| {
            let arcs = graph.adjacency().row(vertex);
            let sum: Rational = arcs.iter().map(|(_, weight)| weight).sum();
            // A sum of zero is refused with the weights.
            let share = |weight: &Rational| if sum.is_certainly_positive() { weight / &sum } else { weight.clone() };
            arcs.iter().map(|(to, weight)| (agent(*to), share(weight))).collect()
        };
        CommunicationGraph::new((0..graph.order()).filter(|&vertex| vertex != leader).map(row).collect())
    }

    /// Every follower compares itself with the mean of the agents it tracks.
    ///
    /// # Errors
    /// [`CommunicationError`].
    pub fn with_equal_weights(tracked: &[Vec<usize>]) -> Result<Self, CommunicationError> {
        let row = |agents: &Vec<usize>| {
            agents.iter().map(|&agent| (agent, rational(1, agents.len() as i64))).collect::<Vec<_>>()
        };
        CommunicationGraph::new(tracked.iter().map(row).collect())
    }

    /// Systems (1) and (2) of the paper.
    ///
    /// # Errors
    /// [`CommunicationError::NoFollowers`]; [`CommunicationError::TooManyFollowers`].
    pub fn of(communication: Communication, followers: usize) -> Result<Self, CommunicationError> {
        check_count(followers)?;
        let rows: Vec<_> = (1..=followers).map(|k| communication.tracked(k, followers)).collect();
        CommunicationGraph::with_equal_weights(&rows)
    }

    /// Every follower tracks only the `n`-th agent in front and the `n`-th behind, as far as they exist; `n >= 1`.
    ///
    /// # Errors
    /// [`CommunicationError`], also for `n = 0`.
    pub fn nth_neighbours(n: usize, followers: usize) -> Result<Self, CommunicationError> {
        check_count(followers)?;
        let row = |k: usize| {
            let front = k.checked_sub(n);
            let behind = k.checked_add(n).filter(|&agent| agent <= followers);
            front.into_iter().chain(behind).collect::<Vec<_>>()
        };
        CommunicationGraph::with_equal_weights(&(1..=followers).map(row).collect::<Vec<_>>())
    }

    /// Every follower tracks the leader.
    ///
    /// # Errors
    /// [`CommunicationError::NoFollowers`]; [`CommunicationError::TooManyFollowers`].
    pub fn star(followers: usize) -> Result<Self, CommunicationError> {
        check_count(followers)?;
        CommunicationGraph::with_equal_weights(&vec![vec![0]; followers])
    }

    /// Two-sided platoons one behind the other: the last car of each tracks only the car in front, and is the leader of the next.
    ///
    /// # Errors
    /// [`CommunicationError::NoFollowers`]; [`CommunicationError::TooManyFollowers`].
    pub fn in_series(lengths: &[usize]) -> Result<Self, CommunicationError> {
        check_count(lengths.iter().fold(0, |all: usize, length| all.saturating_add(*length)))?;
        let mut rows = Vec::new();
        for &length in lengths {
            let first = rows.len() + 1;
            rows.extend(
                (first..first + length).map(|k| if k + 1 == first + length { vec![k - 1] } else { vec![k - 1, k + 1] }),
            );
        }
        CommunicationGraph::with_equal_weights(&rows)
    }

    /// The same behind `spare` cars that track the leader, whom nobody tracks: the first platoon has the leader of all in front.
    ///
    /// # Errors
    /// [`CommunicationError::NoFollowers`]; [`CommunicationError::TooManyFollowers`].
    pub fn in_series_behind(spare: usize, lengths: &[usize]) -> Result<Self, CommunicationError> {
        check_count(spare)?;
        let series = CommunicationGraph::in_series(lengths)?;
        let moved = |agent: usize| if agent == 0 { 0 } else { agent + spare };
        let rows = series.tracked.iter().map(|row| row.iter().map(|(agent, _)| moved(*agent)).collect());
        CommunicationGraph::with_equal_weights(&vec![vec![0]; spare].into_iter().chain(rows).collect::<Vec<_>>())
    }

    /// The number `M` of followers.
    pub fn followers(&self) -> usize {
        self.tracked.len()
    }

    /// The agents that follower `k >= 1` tracks, with weights.
    pub fn tracked_by(&self, k: usize) -> &[(usize, Rational)] {
        self.tracked.get(k.wrapping_sub(1)).map_or(&[], Vec::as_slice)
    }

    /// The directed Laplacian of all `M + 1` agents; the row of an agent that tracks nobody is zero.
    ///
    /// # Errors
    /// Does not fail for a graph that could be made.
    pub fn laplacian(&self) -> Result<RationalMatrix, MatrixError> {
        let order = self.followers() + 1;
        let mut rows = vec![vec![rational(0, 1); order]; order];
        for (k, row) in rows.iter_mut().enumerate() {
            for (agent, weight) in self.tracked_by(k) {
                row[*agent] -= weight;
                row[k] += weight;
            }
        }
        RationalMatrix::from_rows(&rows)
    }

    /// The reduced directed Laplacian `P`: the Laplacian without the row and the column of the leader.
    ///
    /// # Errors
    /// Does not fail for a graph that could be made.
    pub fn reduced_laplacian(&self) -> Result<RationalMatrix, MatrixError> {
        let rows = self.laplacian()?.to_rows();
        RationalMatrix::from_rows(&rows.into_iter().skip(1).map(|row| row[1..].to_vec()).collect::<Vec<_>>())
    }

    /// The vector `L_l`: the entries 1 to M of the first column of the Laplacian.
    ///
    /// # Errors
    /// Does not fail for a graph that could be made.
    pub fn leader_column(&self) -> Result<Vec<Rational>, MatrixError> {
        let laplacian = self.laplacian()?;
        Ok((1..=self.followers()).map(|k| laplacian.entry(k, 0)).collect())
    }

    /// Which of the agents 0 to M the movement of the leader reaches, along the tracking relation.
    pub fn reached_by_leader(&self) -> Vec<bool> {
        let mut reached = vec![false; self.followers() + 1];
        reached[0] = true;
        for _ in 0..self.followers() {
            for k in 1..=self.followers() {
                reached[k] |= self.tracked_by(k).iter().any(|(agent, _)| reached[*agent]);
            }
        }
        reached
    }

    /// Whether the graph of all `M + 1` agents is connected when directions are ignored.
    pub fn is_connected(&self) -> bool {
        let joined = |i: usize, j: usize| {
            let tracks = |a: usize, b: usize| self.tracked_by(a).iter().any(|(agent, _)| *agent == b);
            tracks(i, j) || tracks(j, i)
        };
        algebra::graph::Graph::from_fn(self.followers() + 1, joined).is_connected()
    }

    /// The accelerations of the followers, `f e_k + g e'_k`, where `e_k` is the deviation of follower `k` from the weighted mean
    /// of the agents it tracks. `leader` is `(y_0, u_0)`; `positions` and `velocities` hold `y_1..y_M` and `u_1..u_M`. From shorter lists only
    /// those of the cars before the first one that is not in both, or tracks one that is not.
    pub fn accelerations<T: Field>(
        &self,
        gains: &Gains<T>,
        leader: (&T, &T),
        positions: &[T],
        velocities: &[T],
    ) -> Vec<T> {
        let cars = self.moved_by(positions.len().min(velocities.len()));
        let means = [(); 2].map(|()| |k: usize, value: &dyn Fn(usize) -> T| self.mean(k, value));
        accelerations_by(cars, means, |_| gains, leader, (positions, velocities))
    }

    /// The weighted mean of a value over the agents that follower `k` tracks; nothing where it tracks nobody.
    pub(super) fn mean<T: Field>(&self, k: usize, value: &dyn Fn(usize) -> T) -> Option<T> {
        let terms = self.tracked_by(k).iter().map(|(agent, weight)| {
            let own = value(*agent);
            own.rational(weight) * own
        });
        terms.reduce(|sum, term| sum + term)
    }

    /// How many followers, from the first on, are among the first `given` ones and track only those.
    pub(super) fn moved_by(&self, given: usize) -> usize {
        if given >= self.followers() {
            return self.followers();
        }
        let is_there = |row: &Vec<(usize, Rational)>| row.iter().all(|(agent, _)| *agent <= given);
        self.tracked[..given].iter().position(|row| !is_there(row)).unwrap_or(given)
    }

    /// The followers, counted from 1, that the law leaves at rest in their places, whatever those move that it does not leave at rest and the
    /// leader: all are at rest at first, and whoever is pushed moves from then on.
    pub fn staying_at_rest(&self, gains: &Gains<Rational>) -> Vec<usize> {
        let leader = rational(7, 1);
        let mut moves = vec![false; self.followers()];
        loop {
            // Positive, so that they do not cancel where a follower is at rest.
            let place = |k: usize| if moves[k] { rational(1, 3 * (k as i64 + 1)) } else { rational(0, 1) };
            let state: Vec<Rational> = (0..moves.len()).map(place).collect();
            let forces = self.accelerations(gains, (&leader, &leader), &state, &state);
            let pushed: Vec<bool> = moves.iter().zip(&forces).map(|(moves, f)| *moves || *f != f.zero()).collect();
            if pushed == moves {
                return (1..=moves.len()).filter(|k| !moves[k - 1]).collect();
            }
            moves = pushed;
        }
    }

    /// The amplitudes `a_1..a_M` of the harmonic response to `y_0 = e^{iwt}`: the solution of
    /// `(P + (gamma - 1) I) a = -L_l` with `gamma - 1 = w²/(f + iwg)`. Followers that the leader does not reach are at rest.
    /// Cost: `M³` products.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the response does not exist or cannot be separated from a pole.
    pub fn response<T: Field>(&self, gains: &Gains<T>, w: &T) -> Result<Vec<Complex<T>>, ArithmeticError> {
        let shift = super::gamma_minus_one(gains, w)?;
        self.shifted_response(&vec![shift; self.followers()])
    }

    /// The same where follower `k` has the gains `gains[k - 1]`; each row has its own `gamma - 1`.
    ///
    /// # Errors
    /// As [`CommunicationGraph::response`]; [`ArithmeticError::Domain`] where there are not as many gains as followers.
    pub fn response_of_cars<T: Field>(&self, gains: &[Gains<T>], w: &T) -> Result<Vec<Complex<T>>, ArithmeticError> {
        if gains.len() != self.followers() {
            return Err(ArithmeticError::Domain("gains for each follower"));
        }
        let shifts: Result<Vec<_>, _> = gains.iter().map(|gains| super::gamma_minus_one(gains, w)).collect();
        self.shifted_response(&shifts?)
    }

    /// The solution of `(P + diag(shifts)) a = -L_l` on the followers that the leader reaches.
    fn shifted_response<T: Field>(&self, shifts: &[Complex<T>]) -> Result<Vec<Complex<T>>, ArithmeticError> {
        let Some(first) = shifts.first() else { return Ok(Vec::new()) };
        let reached = self.reached_by_leader();
        let index: Vec<usize> = (1..=self.followers()).filter(|&k| reached[k]).collect();
        let mut rows: Vec<Vec<Complex<T>>> = Vec::with_capacity(index.len());
        for &k in &index {
            let shift = &shifts[k - 1];
            let mut row = vec![shift.zero(); index.len() + 1];
            let own = row.len() - 2;
            let place = |agent: usize| index.binary_search(&agent).unwrap_or(own);
            row[place(k)] = shift.clone() + shift.one();
            for (agent, weight) in self.tracked_by(k) {
                let weight = shift.rational(weight);
                match agent {
                    0 => row[index.len()] = row[index.len()].clone() + weight,
                    // A reached follower may track one that is not; that one is at rest.
                    &agent if reached[agent] => row[place(agent)] = row[place(agent)].clone() - weight,
                    _ => {}
                }
            }
            rows.push(row);
        }
        let solution = solve_over_field(rows)?;
        let mut amplitudes = vec![first.zero(); self.followers()];
        for (k, value) in index.into_iter().zip(solution) {
            amplitudes[k - 1] = value;
        }
        Ok(amplitudes)
    }
}
