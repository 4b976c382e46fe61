//! `switches`: every change of the network of a flock of model D up to a time.

use super::{CertificateError, at_most, text};
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use arithmetic::Rational;
use models::averaging::{Flock, Start, Weights};

/// A start, and the networks that follow from it.
#[derive(Debug, Clone)]
pub struct Switches {
    pub(super) start: Start,
    pub(super) threshold: Option<Rational>,
    pub(super) positions: RationalMatrix,
    pub(super) velocities: RationalMatrix,
    pub(super) until: u64,
    /// The network at t = 0 and each later one with its first time.
    pub(super) networks: Vec<(u64, Graph)>,
}

impl Switches {
    /// Steps the flock.
    ///
    /// # Errors
    /// [`CertificateError`]: a start that is no flock or too large, a hysteresis threshold too long to write out.
    pub fn new(start: &Start, until: u64) -> Result<Self, CertificateError> {
        let mut flock = Flock::new(start)?;
        at_most("birds", 64, flock.birds())?;
        at_most("dimensions", 8, flock.dimension())?;
        at_most("steps", 100_000, until as usize)?;
        let mut networks = vec![(0, flock.network().clone())];
        for t in 1..=until {
            if flock.step()?.is_some() {
                networks.push((t, flock.network().clone()));
            }
        }
        // In decimal, 10 000 digits.
        const MOST_BITS: u64 = 33_000;
        let threshold = start.hysteresis.exact(flock.birds(), MOST_BITS)?;
        let positions = RationalMatrix::from_rows(&start.positions)?;
        let velocities = RationalMatrix::from_rows(&start.velocities)?;
        Ok(Switches { start: start.clone(), threshold, positions, velocities, until, networks })
    }

    pub(super) fn claim(&self) -> String {
        match self.networks[1..].last() {
            None => format!("the flock of model D below keeps its network from t = 0 to t = {}", self.until),
            Some((last, _)) => format!(
                "the flock of model D below changes its network {} times from t = 1 to t = {}, at the times and to the \
                 networks below and at no other time, the last time at t = {last}",
                self.networks.len() - 1,
                self.until
            ),
        }
    }

    pub(super) fn body(&self) -> String {
        let weights = match &self.start.weights {
            Weights::Lazy => "weights lazy\n".to_string(),
            Weights::Vicsek => "weights vicsek\n".to_string(),
            Weights::Given(c) => {
                let c = text::list(&c[..self.positions.rows().min(c.len())]);
                format!("weights given\n{}", c.map(|c| text::matrix("c", &c)).unwrap_or_default())
            }
        };
        let threshold = self.threshold.as_ref().map_or("none".to_string(), ToString::to_string);
        let networks: String =
            self.networks.iter().map(|(t, network)| format!("network {t} {}\n", edges(network))).collect();
        format!(
            "birds {}\ndimension {}\n{weights}hysteresis {threshold}\n{}{}until {}\n{networks}",
            self.positions.rows(),
            self.positions.cols(),
            text::matrix("positions", &self.positions),
            text::matrix("velocities", &self.velocities),
            self.until
        )
    }
}

/// Edges `i-j`, birds from 1, in the order of `i` and then of `j`.
fn edges(network: &Graph) -> String {
    let mut edges = network.edges();
    edges.sort_unstable();
    let edges: Vec<String> = edges.into_iter().map(|(i, j)| format!("{}-{}", i + 1, j + 1)).collect();
    if edges.is_empty() { "none".to_string() } else { edges.join(" ") }
}
