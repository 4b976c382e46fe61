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
    "assets/systems/two_cars.toml",
    "assets/systems/platoon_plad01.toml",
    "assets/systems/platoon_plaa01.toml",
    "assets/laws/boids.toml",
    "assets/laws/questions/boids.toml",
    "assets/laws/circling.toml",
    "assets/laws/questions/circling.toml",
    "assets/laws/couzin.toml",
    "assets/laws/questions/couzin.toml",
    "assets/laws/cucker_smale.toml",
    "assets/laws/questions/cucker_smale.toml",
    "assets/laws/dorsogna.toml",
    "assets/laws/questions/dorsogna.toml",
    "assets/laws/fish.toml",
    "assets/laws/questions/fish.toml",
    "assets/laws/heading_alignment.toml",
    "assets/laws/questions/heading_alignment.toml",
    "assets/laws/hegselmann_krause.toml",
    "assets/laws/questions/hegselmann_krause.toml",
    "assets/laws/intelligent_driver.toml",
    "assets/laws/questions/intelligent_driver.toml",
    "assets/laws/jadbabaie.toml",
    "assets/laws/questions/jadbabaie.toml",
    "assets/laws/kuramoto.toml",
    "assets/laws/questions/kuramoto.toml",
    "assets/laws/lazy_averaging.toml",
    "assets/laws/questions/lazy_averaging.toml",
    "assets/laws/moreau.toml",
    "assets/laws/questions/moreau.toml",
    "assets/laws/motsch_tadmor.toml",
    "assets/laws/questions/motsch_tadmor.toml",
    "assets/laws/olfati_saber.toml",
    "assets/laws/questions/olfati_saber.toml",
    "assets/laws/phase_model.toml",
    "assets/laws/questions/phase_model.toml",
    "assets/laws/platoon_behind.toml",
    "assets/laws/questions/platoon_behind.toml",
    "assets/laws/platoon_both_sides.toml",
    "assets/laws/questions/platoon_both_sides.toml",
    "assets/laws/sakaguchi.toml",
    "assets/laws/questions/sakaguchi.toml",
    "assets/laws/velocity_alignment.toml",
    "assets/laws/questions/velocity_alignment.toml",
    "assets/laws/vicsek.toml",
    "assets/laws/questions/vicsek.toml",
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
