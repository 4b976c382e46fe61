//! A flock of either model, stepped with its constant control.

use flockproof::arithmetic::Rational;
use flockproof::averaging::read::Model;
use flockproof::averaging::{Flock, FlockError, KinematicFlock, Switch, Weights, declaration, kinematic_declaration};
use flockproof::graph::Graph;
use flockproof::matrix::RationalMatrix;

pub enum Course {
    D(Box<Flock>, Option<RationalMatrix>),
    K(Box<KinematicFlock>, Option<Vec<Rational>>),
}

impl Course {
    pub fn new(model: Model) -> Result<Self, FlockError> {
        Ok(match model {
            Model::D { start, control } => Course::D(Box::new(Flock::new(&start)?), control),
            Model::K { start, control } => Course::K(Box::new(KinematicFlock::new(&start)?), control),
        })
    }

    pub fn declaration(&self) -> String {
        match self {
            Course::D(flock, control) => declaration(flock, control.as_ref()),
            Course::K(flock, kappa) => kinematic_declaration(flock, kappa.as_deref()),
        }
    }

    pub fn step(&mut self) -> Result<Option<Switch>, FlockError> {
        match self {
            Course::D(flock, control) => flock.step_controlled(|_| control.clone()),
            Course::K(flock, kappa) => flock.step_controlled(|_| kappa.clone()),
        }
    }

    pub fn network(&self) -> &Graph {
        match self {
            Course::D(flock, _) => flock.network(),
            Course::K(flock, _) => flock.network(),
        }
    }

    /// The weights of the averaging.
    pub fn weights(&self) -> &Weights {
        match self {
            Course::D(flock, _) => flock.weights(),
            Course::K(..) => &Weights::Vicsek,
        }
    }

    /// Whether `flock settle` takes it.
    pub fn can_be_settled(&self) -> bool {
        matches!(self, Course::D(_, None))
    }

    /// Bits of the common denominator of what is exact.
    pub fn denominator_bits(&self) -> u64 {
        match self {
            Course::D(flock, _) => flock.denominator_bits(),
            Course::K(flock, _) => flock.denominator_bits(),
        }
    }

    /// Bits of what is not exact.
    pub fn precision(&self) -> Option<u32> {
        match self {
            Course::D(..) => None,
            Course::K(flock, _) => Some(flock.precision()),
        }
    }
}
