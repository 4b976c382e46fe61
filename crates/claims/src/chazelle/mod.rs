//! Claims of Chazelle, Natural Algorithms.

pub(super) mod entries;
mod ergodicity;
mod filling;
mod fixed_network;
mod footprints;
mod four_birds;
pub(super) mod geometry;
mod hysteresis;
mod kronecker;
mod lengths;
pub(super) mod lower_bound;
mod model_matrices;
pub(super) mod sequences;
mod settling;
mod stabilisation;
mod switch_counts;
pub(super) mod switching;
mod velocity_bounds;
mod worked_matrices;

use ledger::AnyClaim;

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
        Box::new(hysteresis::Rule),
        Box::new(hysteresis::SmallerThreshold),
        Box::new(hysteresis::NearBirdsAreJoined),
        Box::new(hysteresis::FarBirdsAreNot),
        Box::new(geometry::AngleAndDistance),
        Box::new(geometry::AngleDecays),
        Box::new(geometry::NoLosses),
        Box::new(lower_bound::LowerBound),
        Box::new(lower_bound::SinglePaths),
        Box::new(settling::DistanceExpansion),
        Box::new(settling::Gaps),
        Box::new(settling::NextContact),
        Box::new(settling::SteadyState),
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
        Box::new(entries::Entries),
        Box::new(switch_counts::Count),
        Box::new(switch_counts::UntilStable),
        Box::new(stabilisation::Nested),
        Box::new(stabilisation::Blocks),
        Box::new(stabilisation::Contraction),
        Box::new(kronecker::Kronecker),
        Box::new(kronecker::Difference),
        Box::new(model_matrices::Stochastic),
        Box::new(model_matrices::Headings),
        Box::new(velocity_bounds::DistanceChange),
        Box::new(velocity_bounds::VelocityNorm),
        Box::new(lengths::ProductLength),
        Box::new(lengths::StateLength),
        Box::new(switching::ThresholdInequality),
        Box::new(switching::FinalCount),
        Box::new(switching::FlockingSwitches),
        Box::new(switching::TotalSwitches),
    ]
}
