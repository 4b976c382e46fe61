//! Circular formations with the phases `theta_k = 2 pi m k/N` on a circulant spacing network: the linearisation mode by mode, the
//! eigenvalues that symmetry forces, and the enclosed spectral abscissa of the others.
//!
//! Every `(M,N)`-pattern is such a formation, with `m = N/M`; synchronised is `m = 0`. The formulas are derived in
//! `notes/paley_particles.md`.

use super::laplacian::circulant_eigenvalue;
use algebra::spectrum::{complex_abscissa, roots_are_left_of};
use arithmetic::{ArithmeticError, Complex, CosineField, Field, Interval, Rational, RealCyclotomic, Ring};
use arithmetic::{Sign, Signed};
use std::collections::BTreeSet;

/// Bits of the coefficients from which the abscissa is enclosed.
const PRECISION: u32 = 320;
/// Enclosures of it are narrower than this power of a half, up to Cauchy's bound.
const BITS: u32 = 64;

/// The linearisation on the mode `e^{2 pi i q k/N}`: for `y_k = (a_k + i b_k) e^{i theta_k}`, the displacement of the circle
/// centres, `adot = omega b - v/omega`, `bdot = -omega a`, `phidot = v = omega (pull a + i twist b) - hessian phi`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode<T> {
    /// `omega_0`.
    pub omega: T,
    /// `(K_0/N) (lambda_{m+q} + lambda_{m-q})/2`.
    pub pull: T,
    /// `(K_0/N) (lambda_{m+q} - lambda_{m-q})/2`.
    pub twist: T,
    /// The eigenvalue of the Hessian of the phase potential.
    pub hessian: T,
}

impl<T: Field> Mode<T> {
    /// The characteristic polynomial, monic, the constant coefficient first.
    pub fn cubic(&self) -> Vec<Complex<T>> {
        let square = self.omega.square();
        let linear = Complex::new(square.clone(), -(self.omega.clone() * &self.twist));
        let real = Complex::real;
        vec![real(square * &self.hessian), linear, real(self.pull.clone() + &self.hessian), real(self.omega.one())]
    }

    /// The matrix in the coordinates `(a, b, phi)`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] for `omega_0 = 0`.
    pub fn block(&self) -> Result<[[Complex<T>; 3]; 3], ArithmeticError> {
        let (omega, zero) = (&self.omega, Complex::real(self.omega.zero()));
        let steering = [
            Complex::real(omega.clone() * &self.pull),
            Complex::new(omega.zero(), omega.clone() * &self.twist),
            Complex::real(-self.hessian.clone()),
        ];
        let radius = omega.recip()?;
        let [a, b, phi] = steering.clone().map(|entry| -entry.scale(&radius));
        let turned = Complex::real(omega.clone());
        Ok([[a, b + &turned, phi], [-turned, zero.clone(), zero], steering])
    }
}

/// A circular formation with the phases `2 pi m k/N` under (5) with (20) on a circulant network and the negative gradient of a
/// phase potential that is invariant under shifts of the numbers.
#[derive(Debug, Clone)]
pub struct FourierFormation {
    wave: usize,
    omega: RealCyclotomic,
    /// `K_0/N`.
    share: RealCyclotomic,
    /// `e^{2 pi i k/N}`, `N` of them.
    roots: Vec<Complex<RealCyclotomic>>,
    /// Eigenvalues of the Laplacian of the network.
    laplacian: Vec<RealCyclotomic>,
    /// Eigenvalues of the Hessian of the phase potential.
    hessian: Vec<RealCyclotomic>,
}

/// What is left of a spectrum without the eigenvalues that symmetry forces.
#[derive(Debug, Clone)]
pub struct TransverseSpectrum {
    /// How many eigenvalues 0 were removed beside `± i omega_0`.
    pub zeros: usize,
    /// Encloses the largest real part of the others.
    pub abscissa: Interval,
    /// A wave number `q <= N/2` that attains it, as far as the enclosures tell.
    pub wave: usize,
}

impl FourierFormation {
    /// `N` particles with the phases `2 pi m k/N`, without a phase potential; `offsets` as in
    /// [`Neighbours::circulant`](super::Neighbours::circulant), none twice. `particles` is at least 1, and 0 counts as 1.
    pub fn new(
        particles: usize,
        offsets: impl IntoIterator<Item = usize>,
        wave: usize,
        (omega, spacing): (&Rational, &Rational),
    ) -> Self {
        let order = particles.max(1);
        let field = CosineField::new(order as u32);
        let roots: Vec<_> = (0..order).map(|k| field.phasor(k as i64)).collect();
        let both: BTreeSet<usize> =
            offsets.into_iter().flat_map(|s| [s % order, (order - s % order) % order]).collect();
        let laplacian = (0..order).map(|q| circulant_eigenvalue(&roots, both.iter().copied(), q).re).collect();
        let hessian = vec![roots[0].im.zero(); order];
        let share = field.number(spacing) * roots[0].re.ratio(1, order as i64);
        FourierFormation { wave: wave % order, omega: field.number(omega), share, roots, laplacian, hessian }
    }

    /// The `(M,N)`-pattern with all-to-all spacing under Theorem 3, with `gains = [K_1, ..., K_M]`; `None` where `M` does not
    /// divide `N`.
    pub fn pattern(
        clusters: usize,
        particles: usize,
        circular: (&Rational, &Rational),
        gains: &[Rational],
    ) -> Option<Self> {
        let divides = clusters > 0 && particles > 0 && particles.is_multiple_of(clusters);
        let formation = || FourierFormation::new(particles, 1..=particles / 2, particles / clusters, circular);
        divides.then(|| formation().with_moments(gains))
    }

    /// With the orientation control (14) on the spacing network: `U = -K_1 W_1`.
    pub fn with_alignment(mut self, gain: &Rational) -> Self {
        let share = self.omega.rational(gain) * self.omega.ratio(1, self.order() as i64);
        for q in 0..self.order() {
            let slope = self.even(q) - &self.laplacian[self.wave];
            self.hessian[q] = self.hessian[q].clone() - slope * &share;
        }
        self
    }

    /// With the negative gradient of (25), `gains = [K_1, K_2, ...]`, as many as there are.
    pub fn with_moments(mut self, gains: &[Rational]) -> Self {
        let order = self.order();
        for (m, gain) in (1..).zip(gains) {
            let wave = m * self.wave % order;
            // The Hessian of U_m is (1/N) (cos m theta_kj) - m |p_m| I, and m |p_m| is 1 or 0.
            for q in 0..order {
                let opposite = i64::from((q + wave).is_multiple_of(order));
                let halves = i64::from(q == wave) + opposite - 2 * i64::from(wave == 0);
                self.hessian[q] = self.hessian[q].clone() + self.omega.rational(gain) * self.omega.ratio(halves, 2);
            }
        }
        self
    }

    /// Number of particles.
    pub fn order(&self) -> usize {
        self.roots.len()
    }

    /// The wave number `m` of the phases.
    pub fn wave(&self) -> usize {
        self.wave
    }

    /// `e^{2 pi i k/N}` for any `k`.
    pub fn root(&self, k: usize) -> &Complex<RealCyclotomic> {
        &self.roots[k % self.order()]
    }

    /// The phasors.
    pub fn phasors(&self) -> Vec<Complex<RealCyclotomic>> {
        (0..self.order()).map(|k| self.root(self.wave * k).clone()).collect()
    }

    /// `(lambda_{m+q} + lambda_{m-q})/2`.
    fn even(&self, q: usize) -> RealCyclotomic {
        let (plus, minus) = self.neighbours(q);
        (plus.clone() + minus) * plus.ratio(1, 2)
    }

    /// `lambda_{m+q}` and `lambda_{m-q}`.
    fn neighbours(&self, q: usize) -> (&RealCyclotomic, &RealCyclotomic) {
        let (order, q) = (self.order(), q % self.order());
        (&self.laplacian[(self.wave + q) % order], &self.laplacian[(self.wave + order - q) % order])
    }

    /// The linearisation on the mode `q`.
    pub fn mode(&self, q: usize) -> Mode<RealCyclotomic> {
        let (plus, minus) = self.neighbours(q);
        let odd = (plus.clone() - minus) * plus.ratio(1, 2);
        Mode {
            omega: self.omega.clone(),
            pull: self.even(q) * &self.share,
            twist: odd * &self.share,
            hessian: self.hessian[q % self.order()].clone(),
        }
    }

    /// The eigenvalues on the mode `q` that symmetry forces: 0 on `q = 0` for rotations, `i omega_0` on `q = m` and `-i omega_0` on
    /// `q = -m` for translations. Where the Hessian of the phase potential has a larger kernel, as at balanced phases without further
    /// pattern, 0 for each vector of it.
    pub fn neutral(&self, q: usize) -> Vec<Complex<RealCyclotomic>> {
        let order = self.order();
        let turning = |omega: RealCyclotomic| Complex::new(omega.zero(), omega);
        let mut found = Vec::new();
        if self.hessian[q % order].sign() == Some(Sign::Zero) {
            found.push(Complex::real(self.omega.zero()));
        }
        if q % order == self.wave {
            found.push(turning(self.omega.clone()));
        }
        if (q % order + self.wave).is_multiple_of(order) {
            found.push(turning(-self.omega.clone()));
        }
        found
    }

    /// The spectrum without the [neutral](Self::neutral) eigenvalues; `None` where nothing is left.
    ///
    /// # Errors
    /// As [`Self::without`].
    pub fn transverse(&self) -> Result<Option<TransverseSpectrum>, ArithmeticError> {
        self.without(|q| self.neutral(q))
    }

    /// The spectrum without these eigenvalues of each mode; `None` where nothing is left. They are divided out exactly.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where one of them is no eigenvalue of the mode.
    pub fn without(
        &self,
        removed: impl Fn(usize) -> Vec<Complex<RealCyclotomic>>,
    ) -> Result<Option<TransverseSpectrum>, ArithmeticError> {
        let zero = Complex::real(self.omega.zero());
        let zeros = (0..self.order()).map(|q| removed(q).iter().filter(|root| **root == zero).count()).sum();
        let mut found: Option<TransverseSpectrum> = None;
        // Modes with the same polynomial, as most are all-to-all, have the same abscissa.
        let mut seen: Vec<Vec<Complex<RealCyclotomic>>> = Vec::new();
        // The mode -q is the conjugate of the mode q.
        for wave in 0..=self.order() / 2 {
            let rest = removed(wave).iter().try_fold(self.mode(wave).cubic(), |cubic, root| divided(&cubic, root))?;
            if seen.contains(&rest) {
                continue;
            }
            let enclosed = rest.iter().map(enclosed).collect::<Result<Vec<_>, _>>()?;
            // One table of Routh's shows that this mode decays faster than one before.
            if found.as_ref().is_some_and(|known| roots_are_left_of(&enclosed, &known.abscissa.lo().to_rational())) {
                continue;
            }
            let Some(own) = complex_abscissa(&enclosed, BITS) else { continue };
            found = Some(match found {
                None => TransverseSpectrum { zeros, abscissa: own, wave },
                Some(known) => known.joined(own, wave),
            });
            seen.push(rest);
        }
        Ok(found)
    }
}

impl TransverseSpectrum {
    /// With the abscissa of a further mode.
    fn joined(self, own: Interval, wave: usize) -> Self {
        let further = own.hi() > self.abscissa.hi();
        let (lo, hi) =
            (self.abscissa.lo().clone().max(own.lo().clone()), self.abscissa.hi().clone().max(own.hi().clone()));
        let abscissa = Interval::between(lo, hi, own.precision());
        TransverseSpectrum { abscissa, wave: if further { wave } else { self.wave }, ..self }
    }
}

/// The quotient by `s - root`, exactly.
fn divided<T: Ring + PartialEq>(cubic: &[Complex<T>], root: &Complex<T>) -> Result<Vec<Complex<T>>, ArithmeticError> {
    let mut quotient: Vec<Complex<T>> = Vec::with_capacity(cubic.len());
    for c in cubic.iter().rev() {
        let carried = quotient.last().map_or_else(|| c.clone(), |above| above.clone() * root + c);
        quotient.push(carried);
    }
    let remainder = quotient.pop();
    quotient.reverse();
    match remainder {
        Some(rest) if rest == rest.zero() => Ok(quotient),
        _ => Err(ArithmeticError::Domain("modes that have their neutral eigenvalues")),
    }
}

fn enclosed(z: &Complex<RealCyclotomic>) -> Result<Complex<Interval>, ArithmeticError> {
    Ok(Complex::new(z.re.enclose(PRECISION)?, z.im.enclose(PRECISION)?))
}
