//! Scaled phase potentials on the networks of nearest neighbours.

use super::Vector;
use crate::oscillator;
use arithmetic::Complex;

/// The factors with which `W_1` on the network of the nearest `n` is compared for different `n`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// `2/(n + 1)`, the labels of Figure S3.
    Figure,
    /// `2/n + 1`, as printed in the text; the values leave `[0, 1]`.
    Text,
    /// `1/n`: half the mean of `1 - cos theta_kj` over the arcs, which compares networks with different numbers of arcs.
    PerArc,
}

impl Scale {
    /// All three.
    pub const ALL: [Scale; 3] = [Scale::Figure, Scale::Text, Scale::PerArc];

    /// The factor as numerator and denominator.
    pub fn ratio(self, n: i64) -> (i64, i64) {
        match self {
            Scale::Figure => (2, n.saturating_add(1)),
            Scale::Text => (n.saturating_add(2), n),
            Scale::PerArc => (1, n),
        }
    }

    /// The factor.
    pub fn factor(self, n: usize) -> f64 {
        let (p, q) = self.ratio(n as i64);
        p as f64 / q as f64
    }

    /// The factor in letters.
    pub fn name(self) -> &'static str {
        match self {
            Scale::Figure => "2/(n+1)",
            Scale::Text => "2/n+1",
            Scale::PerArc => "1/n",
        }
    }

    /// Scaled potential for all neighbours less the one for a single neighbour, from `W_1` of both.
    pub fn difference(self, fish: usize, complete: f64, single: f64) -> f64 {
        self.factor(fish.saturating_sub(1)) * complete - self.factor(1) * single
    }
}

/// `(1/N) sum_k x_k`; of nothing, nothing that is a number.
pub(super) fn mean(x: &[Vector]) -> Vector {
    oscillator::mean(x).unwrap_or(Complex::new(f64::NAN, f64::NAN))
}

/// `W_1` where fish `k` has the one neighbour `partners[k]`, of headings of length 1: `(1/(2N)) sum_k (1 - cos theta_kj)`; a neighbour that is not there adds
/// nothing.
pub fn partner_potential(partners: &[usize], headings: &[Vector]) -> f64 {
    let sum: f64 = headings.iter().zip(partners).filter_map(|(z, &j)| Some(1.0 - z.dot(headings.get(j)?))).sum();
    sum / (2 * headings.len()) as f64
}

/// `W_1` on the complete graph, of headings of length 1: `(N/2)(1 - |p_theta|^2)`, (13) with (8).
pub fn complete_potential(headings: &[Vector]) -> f64 {
    0.5 * headings.len() as f64 * (1.0 - mean(headings).norm_squared())
}
