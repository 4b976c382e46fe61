//! Model K in the plane: headings exact, positions enclosed and refined where a comparison needs it.

use super::flock::Switch;
use super::headings::{Headings, History, averaging};
use super::hysteresis::{Hysteresis, Threshold};
use super::kinematic_start::KinematicStart;
use super::rule::Rule;
use super::weights::FlockError;
use algebra::graph::Graph;
use arithmetic::{Complex, Field, Interval, Number, Rational, Ring, Sign, Signed};
use num_bigint::BigInt;
use std::cmp::Ordering;

/// A flock of model K at a time `t`: positions `x(t)`, headings `theta(t+1)` and the network `G_t`.
///
/// Headings are rationals. Positions are intervals; where a comparison is not decided, they are computed again from
/// `t = 0` at twice the precision, up to [`MOST_BITS`] or the limit given.
///
/// **Ties.** Speed, positions and headings are rational, so by the theorem of Lindemann and Weierstrass the powers
/// `e^(i theta)` of different headings are linearly independent over the algebraic numbers, and
/// `x_i(t) - x_j(t) = D + sigma sum m_theta e^(i theta)` (`D` at `t = 0`, `m_theta` integers with sum 0) has modulus 1 only if
/// `|D| = 1` and the sum comes down to `D e^(i phi)` for one heading `phi`. This is decided exactly: birds in parallel flight
/// at distance 1, and all others. So only lack of precision leaves a distance undecided. A change of distance can equal
/// the hysteresis threshold only where that is `2 |D|`; this tie is not recognised. `notes/model_k.md` has the proofs.
#[derive(Debug, Clone)]
pub struct KinematicFlock {
    history: History,
    threshold: Threshold,
    rule: Rule,
    time: u64,
    headings: Headings,
    positions: Vec<Complex<Interval>>,
    precision: u32,
    most_bits: u32,
    /// Pair `i < j` at `j (j - 1)/2 + i`.
    pairs: Vec<Pair>,
}

/// What is known exactly about two birds.
#[derive(Debug, Clone)]
struct Pair {
    /// `|x_i(0) - x_j(0)|` against 1.
    at_start: Ordering,
    /// Whether `x_i(t) - x_j(t)` is `x_i(0) - x_j(0)` times one `e^(i phi)`; `None` where nobody asked.
    turned_start: Option<bool>,
    /// Before this time its status cannot change.
    quiet_until: u64,
}

/// Rounding in double precision, generously.
const SLACK: f64 = 1e-9;

/// Bits of the positions at first.
const FIRST_BITS: u32 = 128;

/// Bits of the positions at most, unless another limit is given.
pub const MOST_BITS: u32 = 1 << 13;

impl KinematicFlock {
    /// The flock at `t = 0`; `G_0` is the network of the distance rule.
    ///
    /// # Errors
    /// [`FlockError`] where the start is not a flock.
    pub fn new(start: &KinematicStart) -> Result<Self, FlockError> {
        let birds = start.positions.len();
        start.check()?;
        let pair = |i: usize, j: usize| {
            let squared = (start.positions[i].clone() - &start.positions[j]).norm_squared();
            Pair { at_start: squared.cmp(&squared.one()), turned_start: Some(true), quiet_until: 0 }
        };
        let pairs: Vec<Pair> = (0..birds).flat_map(|j| (0..j).map(move |i| pair(i, j))).collect();
        let network = Graph::from_fn(birds, |i, j| pairs[index(i, j)].at_start != Ordering::Greater);
        Ok(KinematicFlock {
            threshold: Threshold::new(start.hysteresis.clone(), birds)?,
            rule: averaging(&network, 0)?,
            history: History::new(start.clone(), network),
            time: 0,
            headings: Headings::new(&start.headings),
            positions: at_start(start, FIRST_BITS),
            precision: FIRST_BITS,
            most_bits: MOST_BITS,
            pairs,
        })
    }

    /// The same flock with another limit of precision.
    pub fn with_most_bits(mut self, bits: u32) -> Self {
        self.most_bits = bits;
        self
    }

    /// Number of birds.
    pub fn birds(&self) -> usize {
        self.positions.len()
    }

    /// `sigma`.
    pub fn speed(&self) -> &Rational {
        &self.history.start.speed
    }

    /// The time `t`.
    pub fn time(&self) -> u64 {
        self.time
    }

    /// `G_t`.
    pub fn network(&self) -> &Graph {
        self.history.network()
    }

    /// The hysteresis rule.
    pub fn hysteresis(&self) -> &Hysteresis {
        self.threshold.kind()
    }

    /// `theta(t+1)` in radians.
    pub fn headings(&self) -> Vec<Rational> {
        (0..self.birds()).map(|i| self.headings.value(i)).collect()
    }

    /// Encloses `x(t)`.
    pub fn positions(&self) -> &[Complex<Interval>] {
        &self.positions
    }

    /// Significant bits the positions are computed with.
    pub fn precision(&self) -> u32 {
        self.precision
    }

    /// Bits of the common denominator of the headings, not reduced.
    pub fn denominator_bits(&self) -> u64 {
        self.headings.denominator_bits()
    }

    /// One step: `x(t+1) = x(t) + sigma e^(i theta(t+1))`, then `G_{t+1}`, then `theta(t+2) = P(t+1) theta(t+1)`. The change of
    /// the network, if there is one.
    ///
    /// # Errors
    /// [`FlockError::Undecided`] where the limit of precision does not suffice; the flock cannot go on then.
    pub fn step(&mut self) -> Result<Option<Switch>, FlockError> {
        self.step_controlled(|_| None)
    }

    /// One step with control, `theta(t+1) = kappa(t) + P(t) theta(t)` (Chazelle, equation (1.1)). The control sees the flock
    /// when `x(t)` and `G_t` are known and [`KinematicFlock::headings`] is still `theta(t)`; it gives `kappa(t)` in radians, or
    /// `None` for zero. What it gives is remembered, so it is asked once for each time.
    ///
    /// # Errors
    /// As [`KinematicFlock::step`], and [`FlockError::Kappa`] where there is not one number for each bird.
    pub fn step_controlled(
        &mut self,
        control: impl FnOnce(&Self) -> Option<Vec<Rational>>,
    ) -> Result<Option<Switch>, FlockError> {
        self.time += 1;
        let speed = self.speed_enclosure();
        fly(&mut self.positions, &self.headings, &speed);
        let network = self.decide_network()?;
        let switch = if network == *self.network() {
            None
        } else {
            let switch = Switch::between(self.network(), &network, BigInt::from(self.time));
            self.rule = averaging(&network, self.time)?;
            self.history.switch_to(self.time, network);
            Some(switch)
        };
        let kappa = control(self);
        if let Some(kappa) = &kappa {
            check_kappa(kappa, self.birds())?;
            // Headings leave the range that was counted on.
            self.pairs.iter_mut().for_each(|pair| pair.quiet_until = 0);
        }
        self.history.note_control(self.time, kappa);
        self.history.turn(&mut self.headings, &self.rule);
        Ok(switch)
    }

    fn speed_enclosure(&self) -> Interval {
        Interval::from_rational(&self.history.start.speed, self.precision)
    }

    /// Called between moving and averaging, when the headings are those of the move.
    fn decide_network(&mut self) -> Result<Graph, FlockError> {
        let mut joined = Vec::with_capacity(self.pairs.len());
        let most = self.most_change();
        for j in 0..self.birds() {
            for i in 0..j {
                if self.time < self.pairs[index(i, j)].quiet_until {
                    self.pairs[index(i, j)].turned_start = None;
                    joined.push(self.network().has_edge(i, j));
                    continue;
                }
                if !self.headings.are_equal(i, j) {
                    self.pairs[index(i, j)].turned_start = None;
                }
                let near = self.are_joined(i, j)?;
                joined.push(near);
                self.pairs[index(i, j)].quiet_until =
                    (self.time + 1).saturating_add(self.quiet_steps(i, j, near, most));
            }
        }
        Ok(Graph::from_fn(self.birds(), |i, j| joined[index(i, j)]))
    }

    /// How much any distance changes in a step at most, from now on without control: averaging keeps all headings in their range, and
    /// `|e^(i a) - e^(i b)| <= min(2, |a - b|)` (Lemma 2.1).
    fn most_change(&self) -> f64 {
        let headings = || (0..self.birds()).map(|i| self.headings.enclosure(i, FIRST_BITS).to_f64());
        let range = headings().fold(f64::NEG_INFINITY, f64::max) - headings().fold(f64::INFINITY, f64::min);
        self.speed_enclosure().to_f64() * (range + SLACK).min(2.0) * (1.0 + SLACK)
    }

    /// Steps in which a pair that is joined or not keeps its side of distance 1.
    fn quiet_steps(&self, i: usize, j: usize, near: bool, most: f64) -> u64 {
        let squared = self.difference(i, j).norm_squared();
        let (lo, hi) = (squared.lo().to_f64().max(0.0).sqrt(), squared.hi().to_f64().sqrt());
        let gap = if near { 1.0 - hi } else { lo - 1.0 };
        // Zero where the gap is negative or nothing is known.
        ((gap - SLACK * (1.0 + hi)) / most * (1.0 - SLACK)) as u64
    }

    /// An edge that hysteresis holds needs no decision about its length, which can be hard when changes are small.
    fn are_joined(&mut self, i: usize, j: usize) -> Result<bool, FlockError> {
        let edge = self.network().has_edge(i, j);
        loop {
            let near = self.are_near(i, j);
            let held = if edge && near != Some(true) { self.is_held(i, j) } else { Some(false) };
            match (near, held) {
                (Some(true), _) | (_, Some(true)) => return Ok(true),
                (Some(false), Some(false)) => return Ok(false),
                (Some(false), None) => self.refine(i, j, "the hysteresis threshold")?,
                (None, _) if self.is_tie(i, j)? => return Ok(true),
                (None, _) => self.refine(i, j, "distance 1")?,
            }
        }
    }

    fn difference(&self, i: usize, j: usize) -> Complex<Interval> {
        self.positions[i].clone() - &self.positions[j]
    }

    /// Whether `|x_i - x_j| <= 1`.
    fn are_near(&self, i: usize, j: usize) -> Option<bool> {
        let pair = &self.pairs[index(i, j)];
        if pair.turned_start == Some(true) {
            return Some(pair.at_start != Ordering::Greater);
        }
        let squared = self.difference(i, j).norm_squared();
        let beyond = (squared.clone() - squared.one()).sign()?;
        Some(beyond != Sign::Positive)
    }

    /// Whether the distance is exactly 1, for a pair of which [`KinematicFlock::are_near`] is not decided.
    fn is_tie(&mut self, i: usize, j: usize) -> Result<bool, FlockError> {
        let pair = &self.pairs[index(i, j)];
        if pair.at_start != Ordering::Equal {
            return Ok(false);
        }
        let turned = match pair.turned_start {
            Some(turned) => turned,
            None => self.history.is_turned_start(i, j, self.time)?,
        };
        self.pairs[index(i, j)].turned_start = Some(turned);
        Ok(turned)
    }

    /// Whether the change of distance is below the threshold.
    fn is_held(&self, i: usize, j: usize) -> Option<bool> {
        if self.threshold.holds_nothing() {
            return Some(false);
        }
        if self.headings.are_equal(i, j) {
            return Some(true);
        }
        let threshold = self.threshold.enclosure(self.precision);
        let change = self.change_of_distance(i, j)?;
        match ((change.clone() - &threshold).sign(), (change + &threshold).sign()) {
            (Some(Sign::Negative), Some(Sign::Positive)) => Some(true),
            (Some(Sign::Positive | Sign::Zero), _) | (_, Some(Sign::Negative | Sign::Zero)) => Some(false),
            _ => None,
        }
    }

    /// Encloses `|x_i(t) - x_j(t)| - |x_i(t-1) - x_j(t-1)|` with small relative width, however small it is: with `D = D' + m`
    /// it is `m . (D + D') / (|D| + |D'|)`, and `m = 2 sigma sin((theta_i - theta_j)/2) i e^(i (theta_i + theta_j)/2)`.
    fn change_of_distance(&self, i: usize, j: usize) -> Option<Interval> {
        let (half, mean) = self.headings.half_difference_and_mean(i, j, self.precision);
        let (sin, cos) = mean.sin_cos().ok()?;
        let across = Complex::new(-sin, cos);
        let length = (self.speed_enclosure() * half.sin().ok()?).scaled(1);
        let now = self.difference(i, j);
        let before = now.clone() - across.scale(&length);
        let roots = now.norm_squared().sqrt().ok()? + before.norm_squared().sqrt().ok()?;
        (length * across.dot(&(now + before))).over(&roots).ok()
    }

    /// Computes the positions again with twice the precision, for the sake of a comparison of birds `i` and `j`.
    fn refine(&mut self, i: usize, j: usize, against: &'static str) -> Result<(), FlockError> {
        if self.precision > self.most_bits / 2 {
            let (pair, time) = ((i + 1, j + 1), self.time);
            return Err(FlockError::Undecided { pair, time, against, bits: self.precision });
        }
        self.precision *= 2;
        let speed = self.speed_enclosure();
        let mut positions = at_start(&self.history.start, self.precision);
        self.history.replay(self.time, |headings| fly(&mut positions, headings, &speed))?;
        self.positions = positions;
        Ok(())
    }
}

fn index(i: usize, j: usize) -> usize {
    let (i, j) = (i.min(j), i.max(j));
    j * (j - 1) / 2 + i
}

fn at_start(start: &KinematicStart, precision: u32) -> Vec<Complex<Interval>> {
    let enclosure = |x: &Rational| Interval::from_rational(x, precision);
    start.positions.iter().map(|x| Complex::new(enclosure(&x.re), enclosure(&x.im))).collect()
}

/// `x = x + sigma e^(i theta)`.
fn fly(positions: &mut [Complex<Interval>], headings: &Headings, speed: &Interval) {
    let anything = || speed.one().hull(&speed.integer(-1));
    for (i, x) in positions.iter_mut().enumerate() {
        let heading = headings.enclosure(i, speed.precision());
        let (sin, cos) = heading.sin_cos().unwrap_or_else(|_| (anything(), anything()));
        *x = x.clone() + Complex::new(cos, sin).scale(speed);
    }
}

/// Whether this can be the control of so many birds.
///
/// # Errors
/// [`FlockError::Kappa`] where there is not one number for each bird.
pub fn check_kappa(kappa: &[Rational], birds: usize) -> Result<(), FlockError> {
    let found = kappa.len();
    if found == birds { Ok(()) } else { Err(FlockError::Kappa { birds, found }) }
}
