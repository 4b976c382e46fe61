//! What a run shows besides its network: footprints, stabilisers, ergodicity, lengths of numbers. One network at a time, in
//! memory that does not grow with the run (but for the exact product, whose numbers grow).

use super::weights::{Weights, transition_matrix};
use algebra::graph::Graph;
use algebra::matrix::{Footprint, MatrixError, Stabiliser, StabiliserStream, StochasticMatrix, tau_2_squared_watched};
use arithmetic::{Progress, Rational};

/// Stabilisers kept; the sequence `V_1 ⊇ V_2 ⊇ ..` has no end.
const LEVELS: usize = 8;

/// Ergodicity coefficients of `P(t, s)` at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct Decay {
    /// `t`.
    pub time: u64,
    /// `tau_1(P(t, s))`.
    pub tau_1: Rational,
    /// `tau_2(P(t, s))²`.
    pub tau_2_squared: Rational,
    /// Bits of the common denominator of the product (Chazelle, Lemma 2.2).
    pub denominator_bits: u64,
}

/// Watches the products `P(t, s) = P(t) ... P(s)` of a run.
#[derive(Debug, Clone)]
pub struct Observer {
    from: u64,
    footprints: bool,
    footprint: Option<Footprint>,
    stream: StabiliserStream,
    product: Option<Option<StochasticMatrix>>,
    decay: Vec<Decay>,
}

impl Observer {
    /// For a number of birds, from `s` on; with the exact product and its ergodicity coefficients, or without.
    pub fn new(birds: usize, from: u64, products: bool) -> Self {
        let stream = StabiliserStream::new(birds, LEVELS);
        let product = products.then_some(None);
        Observer { from: from.max(1), footprints: true, footprint: None, stream, product, decay: Vec::new() }
    }

    /// The same without footprints and stabilisers, which need the square of the number of birds in bits.
    pub fn without_footprints(self) -> Self {
        Observer { footprints: false, ..self }
    }

    /// The network `G_t` of the next time. Coefficients are noted when `t - s + 1` is a power of two.
    ///
    /// # Errors
    /// [`MatrixError`] where the weights do not suit the network; [`MatrixError::Cancelled`], after which the product is not known.
    pub fn push(
        &mut self,
        time: u64,
        network: &Graph,
        weights: &Weights,
        progress: &dyn Progress,
    ) -> Result<(), MatrixError> {
        if time < self.from {
            return Ok(());
        }
        if self.footprints {
            let factor = network.closed_adjacency();
            self.footprint =
                Some(self.footprint.as_ref().map_or_else(|| factor.clone(), |before| factor.times(before)));
            self.stream.push(&factor);
        }
        let Some(product) = &mut self.product else { return Ok(()) };
        let factor = StochasticMatrix::try_from(&transition_matrix(network, weights)?)?;
        let next = match product.take() {
            None => factor,
            Some(before) => factor.times_watched(&before, progress)?,
        };
        if (time - self.from + 1).is_power_of_two() {
            self.decay.push(Decay {
                time,
                tau_1: next.tau_1_watched(progress)?,
                tau_2_squared: tau_2_squared_watched(&next.to_rational_matrix(), progress)?,
                denominator_bits: next.denominator().bits(),
            });
        }
        *product = Some(next);
        Ok(())
    }

    /// `s`.
    pub fn from(&self) -> u64 {
        self.from
    }

    /// The footprint of `P(t, s)`, where it is kept.
    pub fn footprint(&self) -> Option<&Footprint> {
        self.footprint.as_ref()
    }

    /// The stabilisers so far with their times `T_k` on the clock of the run (a later network may move them).
    pub fn stabilisers(&self) -> Vec<Stabiliser> {
        let on_the_clock =
            |s: &Stabiliser| Stabiliser { time: s.time.saturating_add(self.from as usize - 1), ..s.clone() };
        self.stream.stabilisers().map(on_the_clock).collect()
    }

    /// The coefficients noted.
    pub fn decay(&self) -> &[Decay] {
        &self.decay
    }
}
