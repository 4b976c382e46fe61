//! A flock of either model, stepped with its constant control.

use flockproof::arithmetic::Progress;
use flockproof::arithmetic::Rational;
use flockproof::averaging::read::Model;
use flockproof::averaging::{
    FilteredFlock, Flock, FlockError, KinematicFlock, Switch, Weights, declaration, kinematic_declaration,
};
use flockproof::graph::Graph;
use flockproof::matrix::RationalMatrix;

pub enum SteppedFlock {
    /// Stepped by balls, with the declaration.
    D(Box<FilteredFlock>, String),
    /// Under control: stepped exactly.
    Controlled(Box<Flock>, RationalMatrix),
    K(Box<KinematicFlock>, Option<Vec<Rational>>),
}

impl SteppedFlock {
    pub fn new(model: Model) -> Result<Self, FlockError> {
        Ok(match model {
            Model::D { start, control } => {
                let flock = Flock::new(&start)?;
                match control {
                    Some(control) => SteppedFlock::Controlled(Box::new(flock), control),
                    None => {
                        let declaration = declaration(&flock, None);
                        SteppedFlock::D(Box::new(FilteredFlock::from_exact(flock)?), declaration)
                    }
                }
            }
            Model::K { start, control } => SteppedFlock::K(Box::new(KinematicFlock::new(&start)?), control),
        })
    }

    pub fn declaration(&self) -> String {
        match self {
            SteppedFlock::D(_, declaration) => declaration.clone(),
            SteppedFlock::Controlled(flock, control) => declaration(flock, Some(control)),
            SteppedFlock::K(flock, kappa) => kinematic_declaration(flock, kappa.as_deref()),
        }
    }

    /// One step; `progress` may stop a long one.
    pub fn step(&mut self, progress: &dyn Progress) -> Result<Option<Switch>, FlockError> {
        match self {
            SteppedFlock::D(flock, _) => flock.step(progress),
            SteppedFlock::Controlled(flock, control) => flock.step_controlled(|_| Some(control.clone())),
            SteppedFlock::K(flock, kappa) => flock.step_controlled(|_| kappa.clone()),
        }
    }

    pub fn network(&self) -> &Graph {
        match self {
            SteppedFlock::D(flock, _) => flock.network(),
            SteppedFlock::Controlled(flock, _) => flock.network(),
            SteppedFlock::K(flock, _) => flock.network(),
        }
    }

    /// The weights of the averaging.
    pub fn weights(&self) -> &Weights {
        match self {
            SteppedFlock::D(flock, _) => flock.weights(),
            SteppedFlock::Controlled(flock, _) => flock.weights(),
            SteppedFlock::K(..) => &Weights::Vicsek,
        }
    }

    /// Whether `flock settle` takes it.
    pub fn can_be_settled(&self) -> bool {
        matches!(self, SteppedFlock::D(..))
    }

    /// Bits of the common denominator of what is exact.
    pub fn denominator_bits(&self) -> u64 {
        match self {
            SteppedFlock::D(flock, _) => flock.denominator_bits(),
            SteppedFlock::Controlled(flock, _) => flock.denominator_bits(),
            SteppedFlock::K(flock, _) => flock.denominator_bits(),
        }
    }

    /// Bits of what is not exact.
    pub fn precision(&self) -> Option<u32> {
        match self {
            SteppedFlock::D(..) | SteppedFlock::Controlled(..) => None,
            SteppedFlock::K(flock, _) => Some(flock.precision()),
        }
    }
}
