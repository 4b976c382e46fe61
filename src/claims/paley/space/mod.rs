//! Claims about particles in the plane and fish: (1)-(5), (17)-(22), (26)-(29).

mod instances;
mod particles;
mod spacing;

use crate::ledger::AnyClaim;

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
        Box::new(spacing::Theorem2),
        Box::new(spacing::FixedCentre),
    ]
}
