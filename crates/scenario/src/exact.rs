//! Motions with exact numbers, for enclosures.

use super::own::OwnMotion;
use arithmetic::Rational;
use models::double_integrator::{HeadingDifference, Pair, Potential};
use models::oscillator::{Neighbours, Spacing};
use models::platoon::Platoon;

/// Why motions are not enclosed that are drawn, or follow rounded numbers.
pub(super) const DRAWN: &str = "its time is discrete and its numbers are drawn or rounded";

/// A motion whose law and start are known exactly.
#[derive(Debug, Clone)]
pub enum ExactMotion {
    /// Velocity alignment or heading alignment (Tanner and others): rows of two coordinates.
    Velocities {
        /// Where the agents start.
        positions: Vec<Vec<Rational>>,
        /// Their velocities.
        velocities: Vec<Vec<Rational>>,
        /// The potential of linked pairs.
        potential: Potential,
        /// The links `i < j`, where they do not depend on the distances.
        pairs: Vec<Pair>,
        /// The distance below which pairs are linked, where they do.
        radius: Option<Rational>,
        /// Of heading alignment, on a fixed network, what a heading difference means.
        headings: Option<HeadingDifference>,
    },
    /// The phase model (Paley and others), `d theta_k/dt = frequency + u_k` with the control (14).
    Phases {
        /// The phases at the start, in radians.
        phases: Vec<Rational>,
        /// `omega_0`.
        frequency: Rational,
        /// `K_1`.
        gain: Rational,
        /// Who senses whom.
        network: Neighbours,
    },
    /// Steered particles (Paley and others): `dr_k/dt = e^(i theta_k) + drift`, `d theta_k/dt = frequency + u_k` with the
    /// orientation control (14) and a spacing control.
    Particles {
        /// Where the particles start: rows of two coordinates.
        positions: Vec<Vec<Rational>>,
        /// Their phases, in radians.
        phases: Vec<Rational>,
        /// `omega_0`; not zero where there is a spacing control.
        frequency: Rational,
        /// `K_1`.
        gain: Rational,
        /// The spacing control.
        spacing: Spacing<Rational>,
        /// The drift, the same for all.
        drift: [Rational; 2],
        /// Who senses whom; at the start, where that depends on the distances.
        network: Neighbours,
        /// The distance below which particles sense each other, where it does.
        radius: Option<Rational>,
    },
    /// A platoon (Veerman and others): deviations from the desired places, the leader first.
    Platoon {
        /// `y_0, y_1, ..` without the swing of the leader.
        deviations: Vec<Rational>,
        /// Their rates.
        rates: Vec<Rational>,
        /// Who tracks whom, and with which gains.
        platoon: Platoon<Rational>,
        /// Desired distance of two successive cars.
        spacing: Rational,
        /// Amplitude and angular frequency of the leader's swing.
        swing: (Rational, Rational),
    },
    /// A law of one's own.
    Own(Box<OwnMotion>),
    /// A motion that cannot be enclosed, and why.
    Other(&'static str),
}
