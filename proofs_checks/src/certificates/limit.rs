//! `limit`: where the powers of the transition matrix of a fixed connected network go, and Gamma.

use super::{CertificateError, LARGEST_ORDER, at_most, text};
use algebra::graph::Graph;
use algebra::matrix::{MatrixError, RationalMatrix, StochasticMatrix};
use arithmetic::{Rational, Ring};
use models::averaging::{Weights, deviation_matrix, stationary_distribution, transition_matrix};

/// `P`, `pi` and `Gamma` of a fixed network (Chazelle, Lemma 3.3), with the first power of `P` that contracts.
#[derive(Debug, Clone)]
pub struct Limit {
    pub(super) p: RationalMatrix,
    pub(super) pi: RationalMatrix,
    pub(super) gamma: RationalMatrix,
    pub(super) power: usize,
    pub(super) tau: Rational,
}

impl Limit {
    /// Of a connected network.
    ///
    /// # Errors
    /// [`CertificateError`]: a network that is not connected or too large, weights that do not fit.
    pub fn new(network: &Graph, weights: &Weights) -> Result<Self, CertificateError> {
        at_most("birds", LARGEST_ORDER, network.order())?;
        let pi = stationary_distribution(network, weights)?;
        let p = transition_matrix(network, weights)?;
        let gamma = deviation_matrix(&p, &pi)?;
        let factor = StochasticMatrix::try_from(&p)?;
        let (mut product, mut power) = (factor.clone(), 1);
        // With a positive diagonal two walks meet within as many steps as there are birds.
        while product.tau_1() >= product.tau_1().one() {
            if power > network.order() {
                return Err(MatrixError::NotErgodic.into());
            }
            product = factor.times(&product)?;
            power += 1;
        }
        Ok(Limit { p, pi: text::list(&pi)?, gamma, power, tau: product.tau_1() })
    }

    pub(super) fn claim(&self) -> String {
        format!(
            "the powers of the stochastic matrix P below converge to the matrix whose rows all are pi, tau_1(P^{}) = {}, and \
             I + P + .. + P^(t-1) - t 1 pi^T converges to Gamma",
            self.power, self.tau
        )
    }

    pub(super) fn body(&self) -> String {
        format!(
            "order {}\n{}{}{}power {}\ntau_1 {}\n",
            self.p.rows(),
            text::matrix("P", &self.p),
            text::matrix("pi", &self.pi),
            text::matrix("Gamma", &self.gamma),
            self.power,
            self.tau
        )
    }
}
