//! The files of the repository that pages of the site show.

macro_rules! files {
    ($($path:literal),* $(,)?) => {
        [$(($path, include_str!(concat!("../../", $path)))),*]
    };
}

const FILES: &[(&str, &str)] = &files![
    "notes/chazelle.md",
    "notes/chazelle_fixed_network.md",
    "notes/chazelle_switches.md",
    "notes/communication_sweep.md",
    "notes/guarantees.md",
    "notes/integrators.md",
    "notes/model_k.md",
    "notes/paley_particles.md",
    "notes/paley_phases.md",
    "notes/resonance.md",
    "notes/results.md",
    "notes/settling.md",
    "notes/spectra.md",
    "notes/tanner1.md",
    "notes/tanner2.md",
    "notes/tracks.md",
    "notes/validated.md",
    "notes/veerman.md",
    "notes/veerman_next_order.md",
    "notes/veerman_platoons.md",
    "notes/veerman_time_domain.md",
    "assets/questions/gap_and_diameter.toml",
    "assets/questions/gains_for_256.toml",
    "assets/questions/never_meets.toml",
    "assets/questions/two_pairs.json",
    "assets/questions/altered_sign.toml",
    "assets/questions/five_repelling_phases.toml",
    "assets/scenarios/switching_flock.toml",
    "assets/scenarios/pattern.toml",
    "assets/scenarios/three_agents.toml",
    "assets/scenarios/platoon.toml",
];

/// The text of a file by its path.
pub fn text(path: &str) -> Option<&'static str> {
    if path == flockproof_checker::EXAMPLE.0 {
        return Some(flockproof_checker::EXAMPLE.1);
    }
    FILES.iter().find(|(known, _)| *known == path).map(|(_, text)| *text)
}
