//! The critical points of U_1, and the flow (6) with (9) around them.

use super::common::{Exact, at, turns};
use algebra::matrix::{Inertia, inertia};
use arithmetic::{Complex, CosineField, Field, Ring, Signed};
use ledger::CheckError;
use models::oscillator::{gradient_control, phase_jacobian};

/// The kinds of critical points of `U_1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Equal phases.
    Synchronised,
    /// `p = 0`.
    Balanced,
    /// Two clusters of different sizes on opposite sides.
    Unbalanced,
}

/// A critical point.
pub struct Critical {
    /// Which kind.
    pub kind: Kind,
    /// What it looks like.
    pub name: String,
    /// Its phasors.
    pub phasors: Exact,
}

/// The synchronised arrangement, all unbalanced ones, and balanced ones made of triangles and antipodal pairs at different angles,
/// one of each shape modulo rotation.
pub fn critical_points(particles: usize) -> Vec<Critical> {
    let field = CosineField::new(12);
    let line = |minority: usize| {
        let exponents: Vec<usize> = (0..particles).map(|k| if k + minority < particles { 0 } else { 6 }).collect();
        let kind = if minority == 0 { Kind::Synchronised } else { Kind::Unbalanced };
        let name = format!("{} phases opposite to {}", minority, particles - minority);
        Critical { kind, name, phasors: at(&field, &exponents) }
    };
    let mut points: Vec<Critical> = (0..particles.div_ceil(2)).map(line).collect();
    for triangles in 0..=particles / 3 {
        let rest = particles - 3 * triangles;
        if !rest.is_multiple_of(2) {
            continue;
        }
        for step in if rest > 2 || (triangles > 0 && rest > 0) { 0..3 } else { 0..1 } {
            let mut exponents = [0, 4, 8].repeat(triangles);
            exponents.extend((0..rest / 2).flat_map(|pair| [pair * step, pair * step + 6]));
            let name = format!("balanced, {}", turns(&exponents, 12));
            points.push(Critical { kind: Kind::Balanced, name, phasors: at(&field, &exponents) });
        }
    }
    points
}

/// The inertia of the linearisation of (6) with (9) for a gain.
pub fn linearisation<T: Field + Signed>(z: &[Complex<T>], gain: i64) -> Result<Inertia, CheckError> {
    let jacobian = phase_jacobian(z, |z| gradient_control(&z[0].re.integer(gain), z))?;
    Ok(inertia(&jacobian)?)
}

/// The rates of (6) with (9).
pub fn rates<T: Field>(z: &[Complex<T>], gain: i64, omega: i64) -> Result<Vec<T>, CheckError> {
    let control = gradient_control(&z[0].re.integer(gain), z)?;
    Ok(control.into_iter().map(|u| u + z[0].re.integer(omega)).collect())
}
