//! That the Fourier modes of a symmetric circular formation are invariant under its linearisation, exactly.

use crate::prelude::*;
use arithmetic::{RealCyclotomic, Sign, Signed};
use models::oscillator::{
    FourierFormation, Neighbours, circular_formation, linearisation, pattern_control, spacing_control,
};

/// (5) with (20) on a circulant graph and minus the gradient of (25), at the `(M,N)`-pattern.
pub struct Law {
    pub particles: usize,
    /// Spacing offsets from 1 to this one.
    pub reach: usize,
    pub omega: Rational,
    pub spacing: Rational,
    /// `K_1, ..., K_M`.
    pub gains: Vec<Rational>,
}

/// What a control alters in the matrix of a mode.
#[derive(Clone, Copy)]
pub struct Altered {
    /// Factor of `D_q`.
    pub twist: i64,
    /// Factor of `K_M` in the Hessian.
    pub last: i64,
}

impl Altered {
    pub const NOT: Self = Altered { twist: 1, last: 1 };
}

type Number = Complex<RealCyclotomic>;

impl Law {
    /// The derivative of the law at a circular formation with these phasors, by duals.
    fn linearised<T: Field>(&self, phasors: &[Complex<T>]) -> Result<Vec<Vec<T>>, ArithmeticError> {
        let first = phasors.first().ok_or(ArithmeticError::Domain("at least one particle"))?;
        let offsets: Vec<usize> = (1..=self.reach).collect();
        let network = Neighbours::circulant(self.particles, &offsets);
        let omega = first.re.rational(&self.omega);
        let constant = |q: &Rational| Dual::constant(omega.rational(q));
        let (turning, spacing) = (constant(&self.omega), constant(&self.spacing));
        let gains: Vec<Dual<T>> = self.gains.iter().map(constant).collect();
        linearisation(&circular_formation(&omega, phasors)?, &omega, |state| {
            let pulled = spacing_control(&turning, &spacing, &network, state)?;
            let turned = pattern_control(&gains, &state.phasors)?;
            Ok(pulled.into_iter().zip(turned).map(|(s, o)| s + o).collect())
        })
    }

    /// The linearisation over the rationals, for one, two or four clusters.
    pub fn rational_linearisation(&self) -> Result<Vec<Vec<Rational>>, ArithmeticError> {
        let quarters = [(1, 0), (0, 1), (-1, 0), (0, -1)].map(|(x, y)| Complex::new(rational(x, 1), rational(y, 1)));
        let step = 4 / self.gains.len().clamp(1, 4);
        let phasors: Vec<_> = (0..self.particles).map(|k| quarters[k * step % 4].clone()).collect();
        self.linearised(&phasors)
    }

    /// The formation mode by mode, with `K_M` times `last`.
    fn altered_formation(&self, last: i64) -> FourierFormation {
        let mut gains = self.gains.clone();
        if let Some(gain) = gains.last_mut() {
            *gain *= rational(last, 1);
        }
        let wave = self.particles / self.gains.len().max(1);
        FourierFormation::new(self.particles, 1..=self.reach, wave, (&self.omega, &self.spacing)).with_moments(&gains)
    }

    /// The formation mode by mode.
    pub fn formation(&self) -> FourierFormation {
        self.altered_formation(1)
    }

    /// A wave number `q` with `A F_q != F_q B_q`: `A` the linearisation, `F_q` the mode as a map from the amplitudes of `(a, b, phi)`, `B_q` its
    /// claimed matrix. Modes `q > N/2` are conjugate to others.
    fn wrong_mode(&self, altered: &Altered) -> Result<Option<usize>, ArithmeticError> {
        let formation = self.altered_formation(altered.last);
        let rows = self.linearised(&formation.phasors())?;
        let radius = formation.root(0).re.rational(&self.omega).recip()?;
        for q in 0..=self.particles / 2 {
            let columns = mode_columns(&formation, &radius, q);
            let mut mode = formation.mode(q);
            mode.twist = mode.twist.clone() * mode.twist.integer(altered.twist);
            let block = mode.block()?;
            for (row, own) in rows.iter().zip(&columns) {
                for j in 0..3 {
                    let zero = Complex::real(radius.zero());
                    let entries = row.iter().zip(&columns).filter(|(x, _)| x.sign() != Some(Sign::Zero));
                    let image = entries.fold(zero.clone(), |sum, (x, column)| sum + column[j].scale(x));
                    let claimed = (0..3).fold(zero, |sum, i| sum + own[i].clone() * &block[i][j]);
                    if image != claimed {
                        return Ok(Some(q));
                    }
                }
            }
        }
        Ok(None)
    }
}

/// The rows of `F_q`, for the real parts, the imaginary parts and the phases: with `c_k = (a + i b) e^{i theta_k}` the position
/// moves by `(a + phi/omega + i b) e^{i theta_k}`.
fn mode_columns(formation: &FourierFormation, radius: &RealCyclotomic, q: usize) -> Vec<[Number; 3]> {
    let zero = Complex::real(radius.zero());
    let phasors = formation.phasors();
    let at = |k: usize| formation.root(q * k);
    let part = |k: usize, along: &RealCyclotomic, across: RealCyclotomic| {
        [at(k).scale(along), at(k).scale(&across), at(k).scale(&(along.clone() * radius))]
    };
    let real = phasors.iter().enumerate().map(|(k, z)| part(k, &z.re, -z.im.clone()));
    let imaginary = phasors.iter().enumerate().map(|(k, z)| part(k, &z.im, z.re.clone()));
    let phases = (0..phasors.len()).map(|k| [zero.clone(), zero.clone(), at(k).clone()]);
    real.chain(imaginary).chain(phases).collect()
}

/// All modes of all patterns of some numbers of particles.
pub fn invariant_modes(altered: &Altered, run: &Run) -> Result<Outcome, CheckError> {
    let orders: &[usize] = if run.cases(0, 1) == 1 { &[2, 3, 4, 5, 6, 8, 9, 10, 12] } else { &[2, 3, 4, 5, 6] };
    let mut patterns = 0;
    for &particles in orders {
        for clusters in (1..=particles).filter(|m| particles.is_multiple_of(*m)) {
            for reach in if particles < 4 { vec![1] } else { vec![1, particles / 2] } {
                run.checkpoint()?;
                patterns += 1;
                // Unequal gains, so that no two can be taken for each other.
                let last = clusters as i64;
                let gains = (1..=last).map(|m| if m < last { rational(m, m + 1) } else { rational(-1, 3) }).collect();
                let law = Law { particles, reach, omega: rational(-1, 2), spacing: rational(3, 2), gains };
                if let Some(q) = law.wrong_mode(altered)? {
                    let what = format!("({clusters},{particles}), mode {q}: not invariant with the claimed matrix");
                    return Ok(Outcome::fails(what, exact("modes", "exact products")));
                }
            }
        }
    }
    let most = orders.last().copied().unwrap_or_default();
    let detail = format!(
        "A F_q = F_q B_q over the field of cosines, A the derivative of the law by duals, C_N and all-to-all, N up to {most}; proof for all N in \
         notes/paley_particles.md; the display before step 1"
    );
    holds(exact("modes", detail).cases(patterns))
}
