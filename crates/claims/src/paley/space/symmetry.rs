//! paley.beacon.form, paley.drift: the beacon, and a drift common to all particles.

use super::instances::{StateIdentity, scattered_phasors, state_identity, sum_of_squares};
use crate::prelude::*;
use models::oscillator::{
    CircularGains, Neighbours, State, beacon_control, beacon_potential, circle_centres, circular_control,
    circular_formation, linearisation, quarter_turn, stability,
};

/// The control with `sign gain`; the potential is `share/N` times the squared distances.
#[derive(Clone, Copy)]
pub struct BeaconVariant {
    sign: i64,
    share: (i64, i64),
}

fn beacon(variant: &BeaconVariant, particles: usize) -> StateIdentity<'_> {
    StateIdentity::of(particles, move |[omega, gain, x, y], state| {
        let (particles, beacon) = (particles as i64, Complex::new(x.clone(), y.clone()));
        let signed = gain.clone() * gain.integer(variant.sign);
        let control = beacon_control(omega, &signed, &beacon, state)?;
        let total: Vec<Probe> = control.iter().map(|u| u.clone() + omega).collect();
        let moving = state.moving(&total, &[]);
        let like = Dual::constant(omega.clone());
        let fixed = Complex::new(Dual::constant(x.clone()), Dual::constant(y.clone()));
        let rate = beacon_potential(&like, &fixed, &moving)?.derivative;
        let arms: Vec<_> = circle_centres(omega, state)?.into_iter().map(|c| c - &beacon).collect();
        let forward: Vec<Probe> = state.phasors.iter().zip(&arms).map(|(z, e)| z.dot(e)).collect();
        let squares = arms.iter().fold(omega.zero(), |sum, e| sum + e.norm_squared());
        let (p, q) = variant.share;
        let mut left = vec![beacon_potential(omega, &beacon, state)?, rate];
        let mut right = vec![
            squares * omega.ratio(p, q * particles),
            -(sum_of_squares(&forward, omega) * gain * omega.ratio(1, particles)),
        ];
        // The rate of <z, c - c_0> where it vanishes is omega <i z, c - c_0>, which does not vanish too unless c = c_0.
        let centres = circle_centres(&like, &moving)?;
        for (k, (z, e)) in state.phasors.iter().zip(&arms).enumerate() {
            left.push(moving.phasors[k].dot(&(centres[k].clone() - &fixed)).derivative);
            right.push(total[k].clone() * quarter_turn(z).dot(e) - forward[k].clone() * gain);
            left.push(e.norm_squared());
            right.push(forward[k].square() + quarter_turn(z).dot(e).square());
        }
        Ok((left, right))
    })
    .allowing(|constants| constants[1] > rational(0, 1))
}

pub fn beacon_form() -> Record<BeaconVariant> {
    Record::new(
        "paley.beacon.form",
        "A sum of squares is zero iff every term is. cdot_k = -K e^{i theta_k} sigma_k with sigma_k = <e^{i \
         theta_k}, c_k - c_0>, so the potential has the rate -(K/N) sum sigma_k^2; where sigma_k = 0 its \
         rate is w0 <i e^{i theta_k}, c_k - c_0>, not zero unless c_k = c_0: the potential decreases \
         strictly until c = c_0 1, and LaSalle gives c_k -> c_0 for every initial state.",
        BeaconVariant { sign: 1, share: (1, 2) },
        examine_beacon_form,
    )
    .clauses(&[
        "(1/(2N)) ||c - c_0 1||^2 is zero if and only if c_k = c_0 for all k.",
        "The spacing control forces this potential to decrease monotonically.",
        "It fixes the center of the circular formation to c_0.",
    ])
    .reading(
        "The spacing control is what (20) becomes for this potential: u_k^spac = w0 K <e^{i th_k}, c_k - \
         c_0> with K = K_0/N; the statement holds for every K > 0.",
    )
    .altered("the control with the other sign", |v| v.sign = -1)
    .altered("no control", |v| v.sign = 0)
    .altered("1/N instead of 1/(2N)", |v| v.share = (1, 1))
}

fn examine_beacon_form(variant: &BeaconVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let names = ["w0", "K", "Re c_0", "Im c_0"];
    let part = |n: usize| format!("potential, its rate, no rest where it is stationary, N = {n}");
    let identities = (1..=3).map(|particles| {
        state_identity(beacon(variant, particles), &names, &part(particles), run).checks("steps 2 and 3").on([1, 2])
    });
    let detail = "linearised around the beacon: zeros for the phases only, the centres return exponentially; both \
     signs of w0";
    let returns = run.instances("fixes the centre to c_0", detail, [(1, 10), (-3, 1)], |(p, q)| {
        let omega = rational(p, q);
        let state = circular_formation(&omega, &scattered_phasors(2)?)?;
        let rows = linearisation(&state, &omega, |state| {
            let like = Dual::constant(omega.clone());
            let origin = Complex::real(like.zero());
            beacon_control(&like, &like.ratio(variant.sign, 10), &origin, state)
        })?;
        let found = stability(&rows, &omega, false)?;
        let stays = found.stable && found.zeros == 2;
        let gain = rational(variant.sign, 10);
        let law = "u_k - w0 = w0 K <e^{i th_k}, c_k - c_0>";
        Ok((!stays).then(|| {
            format!("two particles around the beacon, w0 = {omega}, {law} with K = {gain}: the centres do not return")
        }))
    })?;
    let argued = argued(&[1, 2, 3], "every start", "notes/paley_particles.md, Beacon and drift, steps 1-4");
    Run::all([Ok(returns.on([3])).checks("the conclusion")].into_iter().chain(identities).chain([argued]))
}

/// The centres gain `sign f`, where particle `k` drifts with `f` (or `k f`); with a beacon or without.
#[derive(Clone, Copy)]
pub struct DriftVariant {
    sign: i64,
    common: bool,
    beacon: bool,
}

fn carried_along(variant: &DriftVariant, network: Neighbours) -> StateIdentity<'_> {
    StateIdentity::of(network.particles(), move |[omega, spacing, orientation, x, y], state| {
        let field = Complex::new(x.clone(), y.clone());
        let of_particle = |k: usize| field.scale(&x.integer(if variant.common { 1 } else { k as i64 + 1 }));
        let drift: Vec<Complex<Probe>> = (0..network.particles()).map(of_particle).collect();
        let steering = law(variant, &network, [omega, spacing, orientation], state)?;
        let (with, without) = (state.moving(&steering, &drift), state.moving(&steering, &[]));
        let constant = |x: &Probe| Dual::constant(x.clone());
        let lifted = [constant(omega), constant(spacing), constant(orientation)];
        let lifted = [&lifted[0], &lifted[1], &lifted[2]];
        // The controls do not feel the drift,
        let mut left: Vec<Probe> = law(variant, &network, lifted, &with)?.into_iter().map(|u| u.derivative).collect();
        let mut right: Vec<Probe> =
            law(variant, &network, lifted, &without)?.into_iter().map(|u| u.derivative).collect();
        // and every circle centre is carried along by it.
        let carried = field.scale(&x.integer(variant.sign));
        let centres = circle_centres(lifted[0], &with)?.into_iter().zip(circle_centres(lifted[0], &without)?);
        for (with, without) in centres {
            left.extend([with.re.derivative, with.im.derivative]);
            right.extend([without.re.derivative + &carried.re, without.im.derivative + &carried.im]);
        }
        Ok((left, right))
    })
}

fn law<T: Field>(
    variant: &DriftVariant,
    network: &Neighbours,
    [omega, spacing, orientation]: [&T; 3],
    state: &State<T>,
) -> Result<Vec<T>, ArithmeticError> {
    let gains = CircularGains { omega: omega.clone(), spacing: spacing.clone(), orientation: orientation.clone() };
    let control = circular_control(&gains, network, network, state)?;
    if !variant.beacon {
        return Ok(control);
    }
    let pulled = beacon_control(omega, spacing, &Complex::real(omega.integer(10)), state)?;
    Ok(control.into_iter().zip(pulled).map(|(u, pull)| u + pull).collect())
}

pub fn common_drift() -> Record<DriftVariant> {
    Record::new(
        "paley.drift",
        "The shape controls depend on relative positions and phases only, which a drift f common to all \
         does not change: r(t) - f t, theta(t) is a solution without drift, and conversely: for every gain \
         and graph the motion is the one without drift, carried along with the velocity f. On a connected \
         undirected graph V (paley.eq21) keeps the relative centres bounded and u_k - w0 tends to 0, so that \
         the centres travel with the mean velocity f, all together; with K_0 <= 0 there need not be a \
         collective that travels. Where a circular formation is reached, its centre moves as c_0 + f t, in \
         the direction of the field (-0.1: 6.28 to the left in a turn of 62.8, the circle having radius \
         10).",
        DriftVariant { sign: 1, common: true, beacon: false },
        examine_common_drift,
    )
    .reading("Under (22) with K_0 > 0, on a connected undirected graph.")
    .altered("against the field", |v| v.sign = -1)
    .altered("different drifts", |v| v.common = false)
    .altered("with a beacon", |v| v.beacon = true)
}

fn examine_common_drift(variant: &DriftVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let names = ["w0", "K_0", "K_1", "Re f", "Im f"];
    let networks = [
        ("two", Neighbours::complete(2)),
        ("three in a row", Neighbours::from_fn(3, |k, j| k.abs_diff(j) == 1)),
        ("ring of four", Neighbours::circulant(4, &[1])),
    ];
    let section = "notes/paley_particles.md, Beacon and drift, steps 5-7";
    let argued = argued(&[1], "any number of particles, every connected graph", section);
    let identities = networks.into_iter().take(run.cases(2, 3)).map(|(name, network)| {
        state_identity(
            carried_along(variant, network),
            &names,
            &format!("the drift carries the motion along, {name}"),
            run,
        )
        .checks("step 5")
    });
    Run::all(identities.chain([argued]))
}
