//! The Coq sources: their texts, what each needs, and digests over both.

use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

macro_rules! sources {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!("../../coq/", $name, ".v")))),*]
    };
}

/// In an order in which they compile; the same as in `_CoqProject`.
const SOURCES: [(&str, &str); 186] = sources![
    "IntervalStdZ",
    "RealSums",
    "inclusions",
    "chazelle_birds",
    "chazelle_model",
    "chazelle_ergodicity",
    "chazelle_fixed",
    "chazelle_network",
    "chazelle_sharp",
    "chazelle_origins",
    "chazelle_limits",
    "chazelle_products",
    "chazelle_bits",
    "chazelle_recurrent",
    "chazelle_agreement",
    "chazelle_reals",
    "symmetric_spectra",
    "laplacian_edges",
    "chazelle_spectral",
    "chazelle_eigenvalues",
    "chazelle_distances",
    "chazelle_lifted",
    "chazelle_stabilisers",
    "chazelle_contraction",
    "chazelle_count",
    "chazelle_entries",
    "chazelle_estimates",
    "chazelle_switches",
    "chazelle_losses",
    "chazelle_worked",
    "chazelle_angle",
    "chazelle_lower",
    "paley_model",
    "paley_phase",
    "paley_laplacian",
    "paley_gradient",
    "paley_fourier",
    "paley_directed",
    "paley_particles",
    "paley_centre",
    "paley_convergence",
    "paley_patterns",
    "paley_composite",
    "paley_fish",
    "paley_isolated",
    "paley_settling",
    "paley_headings",
    "paley_releq",
    "paley_bal",
    "paley_stability",
    "paley_limits",
    "tanner_energy",
    "paley_behaviours",
    "paley_circulant",
    "paley_subfield",
    "paley_turning",
    "paley_circulant_reals",
    "paley_inertia",
    "tanner_flock",
    "tanner_paths",
    "tanner1_heading",
    "tanner1_examples",
    "tanner1_motion",
    "tanner1_pair",
    "tanner_nonsmooth",
    "tanner_saturated",
    "tanner2_examples",
    "tanner2_path",
    "tanner2_facts",
    "tanner2_motion",
    "tanner_trees",
    "tanner2_switching",
    "tanner2_distance",
    "tanner2_filippov",
    "paley_formations",
    "tanner1_jumps",
    "tanner2_appendix",
    "tanner2_limits",
    "tanner2_unique",
    "lipschitz",
    "tanner2_existence",
    "tanner2_lasting",
    "tanner2_solutions",
    "tanner2_onward",
    "tanner2_approach",
    "paley_cycles",
    "tanner_angle",
    "tanner1_swing",
    "tanner1_smooth",
    "tanner2_energies",
    "tanner2_collision",
    "tanner2_apart",
    "tanner2_field",
    "tanner2_definition4",
    "tanner2_stops",
    "tanner2_minima",
    "tanner_graph",
    "tanner_components",
    "tanner_rates",
    "tanner2_connectivity",
    "veerman_complex",
    "veerman_front",
    "veerman_chain",
    "veerman_stability",
    "veerman_lemma1",
    "veerman_matrices",
    "veerman_dimensions",
    "veerman_numbers",
    "veerman_rest",
    "veerman_amplitude",
    "veerman_settling",
    "veerman_rates",
    "linear_motions",
    "veerman_worst",
    "veerman_unsettled",
    "veerman_coordinates",
    "veerman_bounds",
    "veerman_window",
    "veerman_growth",
    "veerman_theorem1",
    "veerman_size_limit",
    "veerman_exponent",
    "veerman_lesser",
    "veerman_root",
    "certificate_matrices",
    "certificate_flocks",
    "certificate_limits",
    "certificate_inertia",
    "certificate_index",
    "certificate_polynomials",
    "certificate_peaks",
    "gen_inertia",
    "gen_limits",
    "gen_peaks",
    "gen_products",
    "gen_switches",
    "certificate_instances",
    "veerman_resonances",
    "audit_certificates",
    "audit_chazelle",
    "audit_distances",
    "audit_paley",
    "audit_paley_spectrum",
    "audit_paley_limits",
    "audit_tanner1",
    "audit_tanner2",
    "audit_tanner_motions",
    "audit_tanner_energies",
    "audit_veerman",
    "audit_matrices",
    "audit_laplacians",
    "audit_formations",
    "audit_growth",
    "audit_tanner_states",
    "audit_solutions",
    "audit_settling",
    "audit_stability",
    "audit_existence",
    "audit_definition4",
    "audit_minima",
    "audit_independent_chazelle",
    "audit_independent_angle",
    "audit_independent_paley",
    "audit_independent_particles",
    "audit_independent_phases",
    "audit_independent_tanner1",
    "audit_independent_tanner2",
    "audit_independent_connectivity",
    "audit_independent_veerman",
    "audit_independent_corrected",
    "audit_independent_corrected_more",
    "audit_independent_cars",
    "audit_independent_hessian",
    "audit_independent_inertia",
    "audit_independent_links",
    "audit_independent_sums",
    "audit_independent_chazelle_more",
    "audit_independent_motions",
    "audit_independent_lower",
    "audit_independent_limits",
    "audit_independent_matrices",
    "audit_independent_circular",
    "audit_independent_derivative",
    "audit_independent_growth",
    "audit_independent_formations",
    "audit_independent_existence",
];

/// A file of the development.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The name without `.v`.
    pub name: &'static str,
    /// The text.
    pub text: &'static str,
    /// The files of the development that it requires.
    pub needs: Vec<&'static str>,
    /// SHA-256 of the text and of the digests of what it needs, in hexadecimal.
    pub digest: String,
}

/// Every file, what a file needs before it.
pub fn files() -> &'static [Source] {
    static FILES: OnceLock<Vec<Source>> = OnceLock::new();
    FILES.get_or_init(|| with_digests(&SOURCES))
}

/// The files with these names and all that they need, what a file needs before it.
pub fn needed(names: &[&str]) -> Vec<&'static Source> {
    let mut wanted: BTreeSet<&str> = names.iter().copied().collect();
    for file in files().iter().rev() {
        if wanted.contains(file.name) {
            wanted.extend(&file.needs);
        }
    }
    files().iter().filter(|file| wanted.contains(file.name)).collect()
}

/// The files of a development, given as (name, text) in an order in which they compile.
pub fn with_digests(sources: &[(&'static str, &'static str)]) -> Vec<Source> {
    let mut digests: BTreeMap<&str, String> = BTreeMap::new();
    let describe = |&(name, text): &(&'static str, &'static str)| {
        let needs = needs(text, sources);
        let mut hash = Sha256::new();
        hash.update(text.as_bytes());
        for need in &needs {
            hash.update([0]);
            hash.update(digests.get(need).map_or("", String::as_str).as_bytes());
        }
        let digest = hexadecimal(&hash.finalize());
        digests.insert(name, digest.clone());
        Source { name, text, needs, digest }
    };
    sources.iter().map(describe).collect()
}

/// SHA-256 in hexadecimal.
pub fn digest_of(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The files named in `From Flockproof Require ...` sentences.
fn needs(text: &str, sources: &[(&'static str, &'static str)]) -> Vec<&'static str> {
    let sentences = text.split("From Flockproof Require").skip(1);
    let named: Vec<&str> =
        sentences.filter_map(|rest| rest.split_once('.')).flat_map(|(list, _)| list.split_whitespace()).collect();
    sources.iter().map(|(name, _)| *name).filter(|name| named.contains(name)).collect()
}
