//! Claims about particles in the plane and fish: (1)-(5), (17)-(22), (26)-(29).

mod balanced;
mod bifurcation;
mod composite;
mod convergence;
mod figures;
mod fish;
mod fish_control;
mod fish_data;
mod instances;
mod particles;
mod runs;
mod spacing;
mod stability;
mod symmetry;
mod zone_circles;
mod zone_patterns;
mod zones;

pub use instances::without_symmetries;

use ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![
        Box::new(particles::CircleOfParticle),
        Box::new(particles::KineticEnergy),
        Box::new(particles::RelativeEquilibria),
        Box::new(particles::CentreOfMassBall),
        Box::new(spacing::SpacingPotential),
        Box::new(spacing::CentreVelocity),
        Box::new(spacing::SpacingDescent),
        Box::new(convergence::Theorem2),
        Box::new(convergence::FixedCentre),
        Box::new(composite::CompositePotential),
        Box::new(composite::CircularControl),
        Box::new(composite::TwoNetworks),
        Box::new(composite::PatternPotential),
        Box::new(stability::SynchronyStable),
        Box::new(stability::DriftGain),
        Box::new(balanced::BalancedStable),
        Box::new(stability::PatternStable),
        Box::new(balanced::LargerGain),
        Box::new(balanced::UniqueMaximum),
        Box::new(symmetry::BeaconForm),
        Box::new(symmetry::CommonDrift),
        Box::new(fish::EulerStep),
        Box::new(fish::RepulsionField),
        Box::new(fish::AttractionField),
        Box::new(fish_control::LaplacianForm),
        Box::new(fish_control::Comparison),
        Box::new(zones::Chord),
        Box::new(zones::PerceptualZones),
        Box::new(figures::MotionsFigure),
        Box::new(figures::CyclicFigure),
        Box::new(figures::PatternsFigure),
        Box::new(figures::TrackingFigure),
        Box::new(figures::BeaconFigure),
        Box::new(zone_circles::CircularInZones),
        Box::new(bifurcation::FewerClusters),
        Box::new(zone_patterns::PatternsInZones),
        Box::new(fish_data::MeasuredTracks),
        Box::new(fish_data::DifferenceInference),
    ]
}
