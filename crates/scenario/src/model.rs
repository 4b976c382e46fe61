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

/// The models of a scenario, by their names in the file.
pub(super) const MODELS: [(&str, Model); 9] = [
    ("phase", Model::Phase),
    ("particles", Model::Particles),
    ("fish", Model::Fish),
    ("heading-alignment", Model::Headings),
    ("velocity-alignment", Model::Velocities),
    ("platoon", Model::Platoon),
    ("vicsek", Model::Vicsek),
    ("vicsek-noise", Model::Noisy),
    ("own", Model::Own),
];

impl Model {
    /// The name in a file, or what it is.
    pub fn name(self) -> &'static str {
        MODELS.iter().find(|(_, model)| *model == self).map_or("averaging flock", |(name, _)| name)
    }

    /// Whether its motions can be enclosed.
    pub fn is_enclosed(self) -> bool {
        matches!(
            self,
            Model::Phase | Model::Particles | Model::Headings | Model::Velocities | Model::Platoon | Model::Own
        )
    }
}
