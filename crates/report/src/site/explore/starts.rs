//! What the fields of live pages begin with, and the examples to choose from: texts, or paths of files that stand for theirs.

/// What a flock is at first.
pub(super) const BIRDS: &str = "{\"model\": \"D\", \"dimension\": 2, \"weights\": \"lazy\", \"hysteresis\": \"paper\",\n \
                     \"positions\": [[\"0\", \"0\"], [\"1/2\", \"1/4\"], [\"2\", \"0\"]],\n \"velocities\": [[\"1/8\", \"0\"], [\"0\", \"1/8\"], [\"-1/8\", \"0\"]]}";

pub(super) const GAP: &str = "assets/questions/gap_and_diameter.toml";
pub(super) const GAINS: &str = "assets/questions/gains_for_256.toml";
pub(super) const PAIRS: &str = "assets/questions/never_meets.toml";
pub(super) const PAIRS_FLOCK: &str = "assets/questions/two_pairs.json";
pub(super) const PHASES: &str = "assets/questions/altered_sign.toml";
pub(super) const PHASES_SCENARIO: &str = "assets/questions/five_repelling_phases.toml";
pub(super) const SWITCHING: &str = "assets/scenarios/switching_flock.toml";
pub(super) const PATTERN: &str = "assets/scenarios/pattern.toml";
pub(super) const THREE: &str = "assets/scenarios/three_agents.toml";
pub(super) const PLATOON: &str = "assets/scenarios/platoon.toml";
pub(super) const TWO_CARS: &str = "assets/systems/two_cars.toml";
pub(super) const PLAD01: &str = "assets/systems/platoon_plad01.toml";
pub(super) const PLAA01: &str = "assets/systems/platoon_plaa01.toml";
pub(super) const FORTY_CARS: &str = "assets/systems/forty_cars.toml";
pub(super) const CERTIFICATE: &str = "proofs_checks/checker/corpus/pass/chazelle.lem3.3.one_edge.cert";

/// All that are paths.
pub(in super::super) const FILES: [&str; 15] = [
    GAP,
    GAINS,
    PAIRS,
    PAIRS_FLOCK,
    PHASES,
    PHASES_SCENARIO,
    SWITCHING,
    PATTERN,
    THREE,
    PLATOON,
    TWO_CARS,
    PLAD01,
    PLAA01,
    FORTY_CARS,
    CERTIFICATE,
];
