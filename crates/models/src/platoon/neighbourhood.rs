//! Platoons in which all inner cars follow the same rule: car `k` tracks the cars `k + d` with the weights `w_d`, d = -3 to 3 and so
//! on. Cars that are not there are left out and the other weights are scaled to the sum one, as equation (2) does for the last
//! car.

use super::communication_graph::{CommunicationError, CommunicationGraph, check_count};
use super::law::Gains;
use arithmetic::{Complex, Rational, Ring, rational};
use num_traits::{ToPrimitive, Zero};

/// The rule of the inner cars: offsets (negative in front) with positive weights of the sum one.
#[derive(Debug, Clone, PartialEq)]
pub struct Neighbourhood {
    weights: Vec<(i64, Rational)>,
}

impl Neighbourhood {
    /// The rule with these weights, scaled to the sum one; offsets without weight are dropped.
    ///
    /// # Errors
    /// [`CommunicationError::Weights`] for negative weights, none at all, or the offset 0.
    pub fn new(weights: impl IntoIterator<Item = (i64, Rational)>) -> Result<Self, CommunicationError> {
        let weights: Vec<(i64, Rational)> = weights.into_iter().filter(|(_, w)| !w.is_zero()).collect();
        let sum: Rational = weights.iter().map(|(_, w)| w).sum();
        if weights.is_empty() || weights.iter().any(|(d, w)| *d == 0 || *w < rational(0, 1)) {
            return Err(CommunicationError::Weights(0));
        }
        Ok(Neighbourhood { weights: weights.into_iter().map(|(d, w)| (d, w / &sum)).collect() })
    }

    /// Offsets and weights.
    pub fn weights(&self) -> &[(i64, Rational)] {
        &self.weights
    }

    /// The graph of so many followers.
    ///
    /// # Errors
    /// [`CommunicationError::NoFollowers`]; [`CommunicationError::TooManyFollowers`].
    pub fn graph(&self, followers: usize) -> Result<CommunicationGraph, CommunicationError> {
        check_count(followers)?;
        let row = |k: usize| {
            let place = |d: i64| usize::try_from(k as i128 + i128::from(d)).ok().filter(|agent| *agent <= followers);
            let there: Vec<_> = self.weights.iter().filter_map(|(d, w)| Some((place(*d)?, w))).collect();
            let sum: Rational = there.iter().map(|(_, w)| *w).sum();
            there.into_iter().map(|(agent, w)| (agent, w / &sum)).collect()
        };
        CommunicationGraph::new((1..=followers).map(row).collect())
    }

    /// The moment `sum w_d d^n`.
    pub fn moment(&self, n: u64) -> Rational {
        self.weights.iter().map(|(d, w)| rational(*d, 1).power(n) * w).sum()
    }

    /// `lambda(q) = 1 - sum w_d e^{iqd}`: what the Laplacian makes of a wave of the wave number `q` per car.
    pub fn symbol(&self, q: f64) -> Complex<f64> {
        let terms = self.weights.iter().map(|(d, w)| {
            let (sin, cos) = (q * *d as f64).sin_cos();
            Complex::new(cos, sin).scale(&w.to_f64().unwrap_or(f64::NAN))
        });
        terms.fold(Complex::real(1.0), |sum, term| sum - term)
    }

    /// The least of `(g² Re l |l|² - |f| (Im l)²)/(2 sin(q/2))^6`, `l = lambda(q)`, over wave numbers 0 < q <= pi on a grid. It is
    /// positive where waves of every length die out, and none of them can be driven by a real frequency: `x² = l (f + g x)` has its
    /// roots in Re x < 0 exactly where `Re l > 0` and `g² Re l |l|² > |f| (Im l)²`.
    pub fn wave_margin(&self, gains: &Gains<f64>) -> f64 {
        const STEPS: u32 = 720;
        let margin = |k: u32| {
            let q = std::f64::consts::PI * f64::from(k) / f64::from(STEPS);
            let l = self.symbol(q);
            let difference = gains.g.square() * l.re * l.norm_squared() - gains.f.abs() * l.im.square();
            difference / (2.0 * (0.5 * q).sin()).powi(6)
        };
        (2..=STEPS).map(margin).fold(f64::INFINITY, f64::min)
    }
}
