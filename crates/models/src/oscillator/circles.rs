//! Circular formations: centres, spacing potential and the controls that bring particles onto one circle: (3), (17), (20), (22),
//! (29), the beacon and the reference phase.

use super::laplacian::{misalignment, phase_potential, quadratic_form};
use super::moments::{kind, mean, quarter_turn};
use super::network::Interaction;
use super::state::State;
use super::steering::{laplacian_control, sine_of_difference};
use arithmetic::{ArithmeticError, Complex, Dual, Field, Real, Ring};

/// Natural frequency and gains of the circular controls.
#[derive(Debug, Clone, PartialEq)]
pub struct CircularGains<T> {
    /// `omega_0`, not zero.
    pub omega: T,
    /// `K_0` of the spacing control.
    pub spacing: T,
    /// `K_1` of the orientation control.
    pub orientation: T,
}

impl<T: Ring> CircularGains<T> {
    /// The same gains for a state with derivatives, which they do not take part in.
    pub fn constant(&self) -> CircularGains<Dual<T>> {
        let constant = |gain: &T| Dual::constant(gain.clone());
        CircularGains {
            omega: constant(&self.omega),
            spacing: constant(&self.spacing),
            orientation: constant(&self.orientation),
        }
    }
}

/// `c_k = r_k + i e^{i theta_k}/omega_0` (3), `N` of them.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] for `omega_0 = 0`.
pub fn circle_centres<T: Field>(omega: &T, state: &State<T>) -> Result<Vec<Complex<T>>, ArithmeticError> {
    let radius = omega.recip()?;
    Ok(state.positions.iter().zip(&state.phasors).map(|(r, z)| centre(&radius, r, z)).collect())
}

/// The centre of the circle of one particle, whose radius is `1/omega_0`: `r + i z/omega_0`.
#[inline(always)]
pub(super) fn centre<T: Ring>(radius: &T, r: &Complex<T>, z: &Complex<T>) -> Complex<T> {
    Complex { re: r.re.clone() - z.im.clone() * radius, im: r.im.clone() + z.re.clone() * radius }
}

/// `<z, c - other>`: how far the centre of a particle is ahead of another one, or of a beacon, along its heading.
#[inline(always)]
pub(super) fn ahead<T: Ring>(z: &Complex<T>, centre: &Complex<T>, other: &Complex<T>) -> T {
    let (x, y) = (centre.re.clone() - &other.re, centre.im.clone() - &other.im);
    z.re.clone() * &x + z.im.clone() * &y
}

/// The largest distance of a circle centre (3) from the mean of them.
///
/// # Errors
/// [`ArithmeticError`] for `omega_0 = 0` or no particles.
pub fn centre_spread<T: Real + PartialOrd>(omega: &T, state: &State<T>) -> Result<T, ArithmeticError> {
    let centres = circle_centres(omega, state)?;
    let middle = mean(&centres)?;
    centres.into_iter().try_fold(omega.zero(), |most, c| {
        let distance = (c - &middle).norm_squared().sqrt()?;
        Ok(if distance > most { distance } else { most })
    })
}

/// The circular formation around the origin with these phasors: `r_k = -i e^{i theta_k}/omega_0`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] for `omega_0 = 0`.
pub fn circular_formation<T: Field>(omega: &T, phasors: &[Complex<T>]) -> Result<State<T>, ArithmeticError> {
    let radius = -omega.recip()?;
    let positions = phasors.iter().map(|z| quarter_turn(z).scale(&radius)).collect();
    Ok(State { positions, phasors: phasors.to_vec() })
}

/// `S = (1/(2N)) <c, L c>` (17).
///
/// # Errors
/// [`ArithmeticError`] for `omega_0 = 0` or no particles.
pub fn spacing_potential<T: Field>(
    omega: &T,
    network: &impl Interaction,
    state: &State<T>,
) -> Result<T, ArithmeticError> {
    quadratic_form(network, &circle_centres(omega, state)?)
}

/// `<e^{i theta_k}, L_k x>`, `N` of them.
pub fn heading_components<T: Field>(network: &impl Interaction, phasors: &[Complex<T>], x: &[Complex<T>]) -> Vec<T> {
    phasors.iter().zip(network.laplacian_of(x)).map(|(z, lx)| z.dot(&lx)).collect()
}

/// `u_k = omega_0 (K_0/N) <e^{i theta_k}, L_k c>` (20), `N` of them.
///
/// # Errors
/// [`ArithmeticError`] for `omega_0 = 0` or no particles.
pub fn spacing_control<T: Field>(
    omega: &T,
    gain: &T,
    network: &impl Interaction,
    state: &State<T>,
) -> Result<Vec<T>, ArithmeticError> {
    let share = kind(&state.phasors)?.ratio(1, state.phasors.len() as i64) * gain * omega;
    let centres = circle_centres(omega, state)?;
    let components = heading_components(network, &state.phasors, &centres);
    Ok(components.into_iter().map(|component| component * &share).collect())
}

/// The control (5) with (14) on the orientation network and (20) on the spacing network, `N` entries. On one network it is
/// (22); on two it is what (29) should be.
///
/// # Errors
/// [`ArithmeticError`] for `omega_0 = 0` or no particles.
pub fn circular_control<T: Field>(
    gains: &CircularGains<T>,
    orientation: &impl Interaction,
    spacing: &impl Interaction,
    state: &State<T>,
) -> Result<Vec<T>, ArithmeticError> {
    let spacing = spacing_control(&gains.omega, &gains.spacing, spacing, state)?;
    let orientation = laplacian_control(&gains.orientation, orientation, &state.phasors)?;
    Ok(spacing.into_iter().zip(orientation).map(|(s, o)| s + o + &gains.omega).collect())
}

/// `u_k = omega_0 + (alignment/N) <i e^{i theta_k}, L_k^ori e^{i theta}> + omega_0 (spacing/N) <e^{i theta_k}, L_k^att r>`, the form of
/// (22) and (29), with two gains.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn relative_position_control<T: Field>(
    omega: &T,
    (alignment, orientation): (&T, &impl Interaction),
    (spacing, attraction): (&T, &impl Interaction),
    state: &State<T>,
) -> Result<Vec<T>, ArithmeticError> {
    let share = kind(&state.phasors)?.ratio(1, state.phasors.len() as i64);
    let turned = misalignment(orientation, &state.phasors);
    let forward = heading_components(attraction, &state.phasors, &state.positions);
    let terms = turned.into_iter().zip(forward);
    Ok(terms.map(|(t, f)| omega.clone() + (t * alignment + f * spacing * omega) * &share).collect())
}

/// `K_0 S + weight W_1`: (21) with `weight = K_1/omega_0`; it decreases under (22) with `weight = -K_1/omega_0^2`.
///
/// # Errors
/// [`ArithmeticError`] for `omega_0 = 0` or no particles.
pub fn composite_potential<T: Field>(
    omega: &T,
    (spacing, weight): (&T, &T),
    network: &impl Interaction,
    state: &State<T>,
) -> Result<T, ArithmeticError> {
    let s = spacing_potential(omega, network, state)?;
    Ok(s * spacing + phase_potential(network, &state.phasors, 1)? * weight)
}

/// `(1/(2N)) |c - c_0 1|^2`, zero where every particle circles the beacon `c_0`.
///
/// # Errors
/// [`ArithmeticError`] for `omega_0 = 0` or no particles.
pub fn beacon_potential<T: Field>(omega: &T, beacon: &Complex<T>, state: &State<T>) -> Result<T, ArithmeticError> {
    let share = kind(&state.phasors)?.ratio(1, 2 * state.phasors.len() as i64);
    let centres = circle_centres(omega, state)?;
    Ok(centres.iter().fold(share.zero(), |sum, c| sum + (c.clone() - beacon).norm_squared()) * share)
}

/// `u_k = omega_0 gain <e^{i theta_k}, c_k - c_0>`, under which the potential of the beacon does not increase, `N` entries.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] for `omega_0 = 0`.
pub fn beacon_control<T: Field>(
    omega: &T,
    gain: &T,
    beacon: &Complex<T>,
    state: &State<T>,
) -> Result<Vec<T>, ArithmeticError> {
    let share = gain.clone() * omega;
    let centres = circle_centres(omega, state)?;
    Ok(state.phasors.iter().zip(centres).map(|(z, c)| ahead(z, &c, beacon) * &share).collect())
}

/// The orientation control (14) with the last particle coupled to a reference phasor: `gain` times the gradient of
/// `W_1 + 1 - cos(theta_0 - theta_N)`, `N` entries.
///
/// # Errors
/// [`ArithmeticError::Domain`] for no particles.
pub fn reference_control<T: Field>(
    gain: &T,
    network: &impl Interaction,
    reference: &Complex<T>,
    phasors: &[Complex<T>],
) -> Result<Vec<T>, ArithmeticError> {
    let mut control = laplacian_control(gain, network, phasors)?;
    if let (Some(u), Some(z)) = (control.last_mut(), phasors.last()) {
        *u = u.clone() + sine_of_difference(z, reference) * gain;
    }
    Ok(control)
}
