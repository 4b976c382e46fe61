//! Claims of Veerman, Stosic and Olvera, Spatial instabilities and size limitations of flocks.
//!
//! Reading of the text: `f, g < 0` wherever stability is assumed (Lemma 1), and a frequency is `w >= 0`, since the
//! leader moves as `cos w t`; `M = N + 1` is the number of followers.

mod figures;
mod front_limits;
pub(super) mod graphs;
mod matrices;
mod one_sided;
mod peaks;
mod small_frequencies;
mod stability;
mod stop_and_go;
mod table1;
mod theorem1;
mod two_sided;

use arithmetic::{Complex, Interval, Rational, Ring, Signed, rational};
use ledger::Claim;
use models::platoon::Gains;

pub(super) use one_sided::gain_factors;
pub(super) use theorem1::scaled_error_is_bounded;

pub(super) fn claims() -> Vec<Box<dyn Claim>> {
    claims! {
        one_sided: response, special_response, substitution, gain_above_one, strongest_gain;
        two_sided: last_amplitude, derivation;
        theorem1: frequency, amplitude, epsilon, modulus, exponent;
        table1: theory_columns, numeric_columns, size, first_guess, which_system;
        matrices: front, front_and_back, dimensions;
        stability: motion_spectrum, reduced_spectrum, mode_eigenvalues, stabilised;
        front_limits: separation, size_limit;
        small_frequencies: exponential_decay, only_small_frequencies;
        peaks: figure1, lesser_resonances, size_limit;
        figures: figure4, figure5;
        graphs: nth_neighbour, only_two;
        stop_and_go: figure2, figure3;
    }
}

/// Gains from fractions.
pub(super) fn gains((f, g): ((i64, i64), (i64, i64))) -> Gains<Rational> {
    Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) }
}

/// `f = g = -1`, the gains of Section 7.
pub(super) fn unit() -> Gains<Rational> {
    gains(((-1, 1), (-1, 1)))
}

/// The same gains as intervals.
pub(super) fn enclosed(gains: &Gains<Rational>, precision: u32) -> Gains<Interval> {
    gains.map(|q| Interval::from_rational(q, precision))
}

/// The same gains over complex numbers.
pub(super) fn complex_gains<T: Ring>(f: &T, g: &T) -> Gains<Complex<T>> {
    Gains { f: Complex::real(f.clone()), g: Complex::real(g.clone()) }
}

pub(super) fn imaginary<T: Ring>(x: &T) -> Complex<T> {
    Complex::new(x.zero(), x.clone())
}

/// Real and imaginary parts, one after the other.
pub(super) fn parts<T>(numbers: impl IntoIterator<Item = Complex<T>>) -> Vec<T> {
    numbers.into_iter().flat_map(|z| [z.re, z.im]).collect()
}

/// Whether the first two variables, `f` and `g`, are negative and the third one, `w`, is positive.
fn negative_gains(at: &[Rational]) -> bool {
    matches!(at, [f, g, w, ..] if f.is_certainly_negative() && g.is_certainly_negative() && w.is_certainly_positive())
}

/// Whether an enclosed number certainly lies within `slack` of `middle`.
fn within(x: &Interval, middle: &Rational, slack: &Rational) -> bool {
    let (lo, hi) = x.to_rationals();
    middle - slack <= lo && hi <= middle + slack
}
