//! What the figures of Veerman, Stosic and Olvera share.

use arithmetic::{Rational, rational};
use ledger::CheckError;
use models::platoon::{Gains, ResonanceError, resonance, theorem1};

/// The gains of Section 7, in floats.
pub(super) const UNIT: Gains<f64> = Gains { f: -1.0, g: -1.0 };

/// The same, exactly.
pub(super) fn unit() -> Gains<Rational> {
    Gains { f: rational(-1, 1), g: rational(-1, 1) }
}

/// The certified main resonance for `f = g = -1`, as floats: frequency and amplitude.
pub(super) fn certified(followers: u64) -> Result<(f64, f64), ResonanceError> {
    let found = resonance(&unit(), followers, 15)?;
    Ok((found.omega.to_f64(), found.amplitude.to_f64()))
}

/// Theorem 1 for `f = g = -1`, as floats.
pub(super) fn leading(followers: u64) -> Result<(f64, f64), CheckError> {
    Ok((theorem1::frequency(&UNIT, followers)?, theorem1::amplitude(&UNIT, followers)?))
}

/// `count + 1` equidistant numbers.
pub(super) fn steps(low: f64, high: f64, count: u32) -> impl Iterator<Item = f64> + Clone {
    (0..=count).map(move |k| low + (high - low) * f64::from(k) / f64::from(count))
}
