//! Claims of Veerman, Stosic and Olvera, Spatial instabilities and size limitations of flocks.
//!
//! Reading of the text: `f, g < 0` wherever stability is assumed (Lemma 1), and a frequency is `w >= 0`, since the
//! leader moves as `cos w t`; `M = N + 1` is the number of followers.

mod figures;
mod front_limits;
mod graphs;
mod matrices;
pub(super) mod one_sided;
mod peaks;
mod small_frequencies;
mod stability;
mod stop_and_go;
mod table1;
mod theorem1;
mod two_sided;

use ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![
        Box::new(one_sided::Response),
        Box::new(one_sided::SpecialResponse),
        Box::new(one_sided::Substitution),
        Box::new(one_sided::GainAboveOne),
        Box::new(one_sided::StrongestGain),
        Box::new(two_sided::LastAmplitude),
        Box::new(two_sided::Derivation),
        Box::new(theorem1::Frequency),
        Box::new(theorem1::Amplitude),
        Box::new(theorem1::Epsilon),
        Box::new(theorem1::Modulus),
        Box::new(theorem1::Exponent),
        Box::new(table1::TheoryColumns),
        Box::new(table1::NumericColumns),
        Box::new(table1::Size),
        Box::new(table1::FirstGuess),
        Box::new(table1::WhichSystem),
        Box::new(matrices::FrontMatrices),
        Box::new(matrices::FrontAndBackMatrices),
        Box::new(matrices::Dimensions),
        Box::new(stability::MotionSpectrum),
        Box::new(stability::ReducedSpectrum),
        Box::new(stability::ModeEigenvalues),
        Box::new(stability::Stabilised),
        Box::new(front_limits::Separation),
        Box::new(front_limits::FrontSizeLimit),
        Box::new(small_frequencies::ExponentialDecay),
        Box::new(small_frequencies::OnlySmallFrequencies),
        Box::new(peaks::Figure1),
        Box::new(peaks::LesserResonances),
        Box::new(peaks::TwoSidedSizeLimit),
        Box::new(figures::Figure4),
        Box::new(figures::Figure5),
        Box::new(graphs::NthNeighbour),
        Box::new(graphs::OnlyTwo),
        Box::new(stop_and_go::Figure2),
        Box::new(stop_and_go::Figure3),
    ]
}
