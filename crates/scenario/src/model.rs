//! The models that can be run.

/// Whose laws move the agents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Model {
    /// The phase model (Paley and others).
    Phase,
    /// Steered particles (Paley and others).
    Particles,
    /// The school of fish (Paley and others).
    Fish,
    /// Heading alignment (Tanner and others).
    Headings,
    /// Velocity alignment (Tanner and others).
    Velocities,
    /// A platoon (Veerman and others).
    Platoon,
    /// Chazelle's models in the plane.
    Vicsek,
    /// The model of Vicsek and others, with noise.
    Noisy,
    /// A law of one's own.
    Own,
    /// An averaging flock in a file of its own (JSON).
    Flock,
}

/// The names in a file, with whether motions can be enclosed.
const NAMES: [(Model, &str, bool); 9] = [
    (Model::Phase, "phase", true),
    (Model::Particles, "particles", true),
    (Model::Fish, "fish", false),
    (Model::Headings, "heading-alignment", true),
    (Model::Velocities, "velocity-alignment", true),
    (Model::Platoon, "platoon", true),
    (Model::Vicsek, "vicsek", false),
    (Model::Noisy, "vicsek-noise", false),
    (Model::Own, "own", true),
];

impl Model {
    /// The name in a file, or what it is.
    pub fn name(self) -> &'static str {
        NAMES.iter().find(|row| row.0 == self).map_or("averaging flock", |row| row.1)
    }

    /// Whether its motions can be enclosed.
    pub fn is_enclosed(self) -> bool {
        NAMES.iter().any(|row| row.0 == self && row.2)
    }

    /// The models of a scenario by their names in a file.
    pub(super) fn named() -> [(&'static str, Model); NAMES.len()] {
        NAMES.map(|(model, name, _)| (name, model))
    }
}
