//! Claims of Chazelle, Natural Algorithms.

mod ergodicity;
mod fixed_network;
mod footprints;
mod four_birds;
mod worked_matrices;

use crate::ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![
        Box::new(worked_matrices::Stretching),
        Box::new(worked_matrices::ProductAB),
        Box::new(ergodicity::Coefficient),
        Box::new(ergodicity::Submultiplicative),
        Box::new(ergodicity::SquareRootOfTwo),
        Box::new(footprints::Monotone),
        Box::new(four_birds::Eigenvector),
        Box::new(four_birds::ClosedForm),
        Box::new(four_birds::Alternation),
        Box::new(fixed_network::spectrum::Stationary),
        Box::new(fixed_network::spectrum::Symmetrised),
        Box::new(fixed_network::powers::Powers),
        Box::new(fixed_network::mixing::SecondEigenvalue),
        Box::new(fixed_network::mixing::EntrywiseRate),
        Box::new(fixed_network::mixing::HalvingTime),
        Box::new(fixed_network::fiedler::FiedlerRate),
        Box::new(fixed_network::limits::LimitOfGamma),
        Box::new(fixed_network::limits::Positions),
        Box::new(fixed_network::limits::RelativeLimit),
        Box::new(fixed_network::denominators::ShortLimit),
        Box::new(fixed_network::closed_forms::GeometricSums),
        Box::new(fixed_network::closed_forms::WithGamma),
        Box::new(fixed_network::closed_forms::TwoBirdsApart),
    ]
}
