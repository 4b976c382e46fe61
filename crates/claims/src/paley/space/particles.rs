//! paley.eq3, paley.energy, paley.releq, paley.Rball: what single particles, shapes and circular motion do.

use super::instances::{StateIdentity, scattered_phasors, state_identity, sum_of_squares};
use crate::prelude::*;
use models::oscillator::{State, circle_centres, circular_formation, mean, quarter_turn, shape_dimension};

/// The rates of change of complex numbers, real parts and imaginary parts in turn.
fn rates<T: Ring>(numbers: &[Complex<Dual<T>>]) -> Vec<T> {
    numbers.iter().flat_map(|z| [z.re.derivative.clone(), z.im.derivative.clone()]).collect()
}

fn parts<T: Ring>(z: &Complex<T>) -> [T; 2] {
    [z.re.clone(), z.im.clone()]
}

/// `c = r + centre i e^{i theta}/omega`, radius `|omega|^-radius`, counterclockwise for `turn omega > 0`.
#[derive(Clone, Copy)]
pub struct CircleVariant {
    centre: i64,
    radius: u64,
    turn: i64,
}

fn circle(variant: &CircleVariant) -> StateIdentity<'_> {
    StateIdentity::of(1, move |[omega], state| {
        let moving = state.moving(std::slice::from_ref(omega), &[]);
        let printed = &circle_centres(&Dual::constant(omega.clone()), &moving)?[0];
        let factor = Dual::constant(omega.integer(variant.centre));
        let centre = (printed.clone() - &moving.positions[0]).scale(&factor) + &moving.positions[0];
        let (r, z) = (&state.positions[0], &state.phasors[0]);
        let arm = r.clone() - &Complex::new(centre.re.value.clone(), centre.im.value.clone());
        let mut left = rates(&[centre]);
        left.push(arm.norm_squared() * omega.power(2 * variant.radius));
        left.push(quarter_turn(&arm).dot(z));
        // Without steering the velocity does not change.
        left.extend(rates(&state.moving(&[omega.zero()], &[]).phasors));
        let turning = arm.norm_squared() * omega * omega.integer(variant.turn);
        Ok((left, vec![omega.zero(), omega.zero(), omega.one(), turning, omega.zero(), omega.zero()]))
    })
}

pub fn circle_of_particle() -> Record<CircleVariant> {
    Record::new(
        "paley.eq3",
        "u = 0: the velocity e^{i theta} is constant. u = w0: cdot = e^{i theta} + w0^-1 i (i w0 e^{i \
         theta}) = 0, |r - c| = 1/|w0|, and the angular velocity about c is <i(r - c), rdot>/|r - c|^2 = \
         w0: counterclockwise for w0 > 0, clockwise for w0 < 0.",
        CircleVariant { centre: 1, radius: 1, turn: 1 },
        examine_circle_of_particle,
    )
    .clauses(&[
        "u_k = 0 gives straight-line motion in the initial direction.",
        "u_k = w0, constant and not zero, gives motion around a circle of radius |w0|^{-1} with center c_k \
         = r_k + w0^{-1} i e^{i th_k}.",
        "The motion is counterclockwise if w0 > 0 and clockwise if w0 < 0.",
    ])
    .altered("c = r - i e^{i theta}/w0", |v| v.centre = -1)
    .altered("radius 1/w0^2", |v| v.radius = 2)
    .altered("clockwise for w0 > 0", |v| v.turn = -1)
}

fn examine_circle_of_particle(variant: &CircleVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    Ok(state_identity(
        circle(variant),
        &["w0"],
        "centre at rest, radius, sense of rotation; straight line for u = 0",
        run,
    )?
    .on([1, 2, 3])
    .for_all())
}

/// The acceleration is `factor u i^turns rdot`.
#[derive(Clone, Copy)]
pub struct AccelerationVariant {
    factor: i64,
    turns: u32,
}

fn acceleration(variant: &AccelerationVariant) -> StateIdentity<'_> {
    StateIdentity::new(2, move |steering, state| {
        let moving = state.moving(steering, &[]);
        let acceleration = |(z, u): (&Complex<Probe>, &Probe)| {
            let turned = (0..variant.turns).fold(z.clone(), |z, _| quarter_turn(&z));
            turned.scale(&(u.integer(variant.factor) * u))
        };
        let claimed: Vec<Complex<Probe>> = state.phasors.iter().zip(steering).map(acceleration).collect();
        let mut left = rates(&moving.phasors);
        let mut right: Vec<Probe> = claimed.iter().flat_map(parts).collect();
        // d/dt |rdot|^2/2, and <rdot, rddot> with the claimed acceleration.
        for ((z, claimed), moving) in state.phasors.iter().zip(&claimed).zip(&moving.phasors) {
            left.extend([moving.norm_squared().derivative, z.dot(claimed)]);
            right.extend([z.re.zero(), z.re.zero()]);
        }
        Ok((left, right))
    })
}

pub fn kinetic_energy() -> Record<AccelerationVariant> {
    Record::new(
        "paley.energy",
        "rddot = (d/dt) e^{i theta} = i u e^{i theta} = u i rdot, and <z, u i z> = u Re(i |z|^2) = 0. Each \
         |rdot_k|^2 is constant, hence their sum.",
        AccelerationVariant { factor: 1, turns: 1 },
        examine_kinetic_energy,
    )
    .clauses(&[
        "For all k, rddot_k = u_k i rdot_k.",
        "The total kinetic energy is conserved: (d/dt)(1/2)|rdot_k|^2 = <rdot_k, rddot_k> = 0.",
    ])
    .altered("rddot = u rdot", |v| v.turns = 0)
    .altered("rddot = -u i rdot", |v| v.factor = -1)
    .altered("rddot = 2 u i rdot", |v| v.factor = 2)
}

fn examine_kinetic_energy(variant: &AccelerationVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // Each particle for itself, so that two stand for any number.
    state_identity(
        acceleration(variant),
        &["u_1", "u_2"],
        "acceleration, d/dt |rdot_k|^2/2 = <rdot_k, rddot_k> = 0",
        run,
    )
    .on([1, 2])
    .for_all()
}

/// `d/dt (r_kj e^{-i theta_k}) = -i u e^{-i theta_k} (c_k - c_j)`, centres for the rate `rate u`; the shape space has `fewer` dimensions
/// fewer. Without `same_circle` circles with any centres count.
#[derive(Clone, Copy)]
pub struct EquilibriumVariant {
    rate: (i64, i64),
    fewer: usize,
    same_circle: bool,
}

fn equilibrium(variant: &EquilibriumVariant) -> StateIdentity<'_> {
    StateIdentity::of(2, move |[u, other], state| {
        let zero = || u.zero();
        let (z, w) = (&state.phasors[0], &state.phasors[1]);
        // Both turn at the rate u.
        let left = rates(&[relative_position(&state.moving(&[u.clone(), u.clone()], &[]))]);
        let centres = circle_centres(&(u.clone() * u.ratio(variant.rate.0, variant.rate.1)), state)?;
        let arm = (centres[0].clone() - &centres[1]) * z.conj();
        let weight = if variant.same_circle { u.one() } else { zero() };
        let mut right = parts(&(-quarter_turn(&arm)).scale(&(u.clone() * weight))).to_vec();
        // Neither turns.
        let straight = rates(&[relative_position(&state.moving(&[zero(), zero()], &[]))]);
        right.extend(parts(&(z.conj() * (z.clone() - w))));
        // The shape moves with the shape variables alone: sdot = 1 - e^{-i theta_kj} - i u_k s.
        let turning = state.moving(&[u.clone(), other.clone()], &[]);
        let shape = z.conj() * (state.positions[0].clone() - &state.positions[1]);
        right.extend(parts(&(Complex::real(u.one()) - z.conj() * w - quarter_turn(&shape).scale(u))));
        // theta_kj is at rest exactly where the rates are equal.
        let difference = turning.phasors[0].clone() * turning.phasors[1].conj();
        right.push((u.clone() - other).square());
        let turned = rates(&[difference]);
        let left = [left, straight, rates(&[relative_position(&turning)]), vec![sum_of_squares(&turned, u)]].concat();
        Ok((left, right))
    })
}

/// `r_12 e^{-i theta_1}`.
fn relative_position<T: Ring>(state: &State<T>) -> Complex<T> {
    (state.positions[0].clone() - &state.positions[1]) * state.phasors[0].conj()
}

pub fn relative_equilibria() -> Record<EquilibriumVariant> {
    Record::new(
        "paley.releq",
        "The group of rotations and translations (dimension 3) acts freely, and the shape variables \
         separate its orbits: the Jacobian of the shape variables has rank 3N - 3. With s_kj = r_kj e^{-i \
         theta_k}: theta_kj is at rest iff u_k = u_j, and sdot_kj = 1 - e^{-i theta_kj} - i u_k s_kj \
         depends on the shape and the shape controls only. In an equilibrium of shape all u_k are one \
         constant u. For u = 0, sdot = e^{-i theta_k}(e^{i theta_k} - e^{i theta_j}) vanishes iff theta_k = \
         theta_j: parallel. For u != 0, sdot = -i u e^{-i theta_k}(c_k - c_j) vanishes iff the centres for \
         the rate u agree: circular. No third type. Equal circles with different centres are no relative \
         equilibrium.",
        EquilibriumVariant { rate: (1, 1), fewer: 3, same_circle: true },
        examine_relative_equilibria,
    )
    .clauses(&[
        "With shape controls the closed-loop dynamics evolve on shape space.",
        "Shape space has three fewer dimensions than the full configuration space.",
        "Parallel and circular formations are relative equilibria.",
        "There are no other relative equilibria.",
    ])
    .reading(
        "In circular formations c_k is the centre of the circle that is travelled: (3) with the common rate \
         of turning in the place of w0.",
    )
    .altered("equal rates suffice, whatever the centres", |v| v.same_circle = false)
    .altered("centres for another rate than the common one", |v| v.rate = (2, 1))
    .altered("two dimensions fewer", |v| v.fewer = 2)
}

fn examine_relative_equilibria(variant: &EquilibriumVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut states = Vec::new();
    for particles in 1..=run.cases(4, 6) {
        let phasors = scattered_phasors(particles)?;
        let positions = (0..particles as i64).map(|k| Complex::new(rational(k * k, 1), rational(3 * k, 2)));
        states.push(State { positions: positions.collect(), phasors: phasors.clone() });
        states.push(circular_formation(&rational(2, 1), &phasors)?);
        states.push(State { positions: vec![Complex::real(rational(0, 1)); particles], phasors });
    }
    let detail = "rank 3N - 3 of the exact Jacobian of the shape variables; spread, circular and coinciding \
     particles";
    let dimension = run.instances("three dimensions fewer", detail, states, |state| {
        let (particles, dimension) = (state.phasors.len(), shape_dimension(&state)?);
        let wrong = dimension != 3 * particles - variant.fewer;
        Ok(wrong.then(|| format!("N = {particles}: the shape has {dimension} dimensions of {}", 3 * particles)))
    })?;
    let section = "notes/paley_particles.md, Shape space, steps 1-5";
    let part = "rates of change of the shape; equilibria for u != 0 and u = 0";
    let rates = state_identity(equilibrium(variant), &["u", "u_2"], part, run).checks("steps 1 and 4").on([1, 3, 4]);
    Run::all([Ok(dimension.on([2])).checks("step 2"), rates, argued(&[1, 2, 3, 4], "any number of particles", section)])
}

/// With `u = rate omega` the centre of mass stays within `radius/|omega|` of the mean centre, or of its own place at the start.
#[derive(Clone, Copy)]
pub struct BallVariant {
    rate: i64,
    radius: (i64, i64),
    from_start: bool,
}

/// On `N` particles.
fn ball(variant: &BallVariant, particles: usize) -> StateIdentity<'_> {
    StateIdentity::of(particles, move |[omega], state| {
        let rate = omega.integer(variant.rate) * omega;
        let moving = state.moving(&vec![rate; particles], &[]);
        let centre = mean(&circle_centres(&Dual::constant(omega.clone()), &moving)?)?;
        let arm = mean(&state.positions)? - &mean(&circle_centres(omega, state)?)?;
        // 1 - |p|^2 is a sum of squares.
        let pairs = (0..particles).flat_map(|j| (0..j).map(move |k| (j, k)));
        let spread = pairs.fold(omega.zero(), |sum, (j, k)| {
            sum + (state.phasors[j].clone() - &state.phasors[k]).norm_squared()
                * omega.ratio(1, (particles * particles) as i64)
        });
        let mut left = rates(&[centre]);
        left.push(arm.norm_squared() * omega.square() + spread);
        Ok((left, vec![omega.zero(), omega.zero(), omega.one()]))
    })
}

pub fn centre_of_mass_ball() -> Record<BallVariant> {
    Record::new(
        "paley.Rball",
        "In circular motion the circle centres rest, R - mean(c) = -(i/w0) p_theta, and w0^2 |R - mean(c)|^2 \
         = |p_theta|^2 = 1 - sum_{j<k} |e^{i theta_j} - e^{i theta_k}|^2/N^2 <= 1. The radius is attained \
         by synchronised phases. It is no statement about the approach to the formation, in which mean(c) \
         moves.",
        BallVariant { rate: 1, radius: (1, 1), from_start: false },
        examine_centre_of_mass_ball,
    )
    .reading(
        "In circular motion, u_k = w0; not during the approach to it, in which the mean of the circle \
         centres moves.",
    )
    .altered("radius 99/100 of it", |v| v.radius = (99, 100))
    .altered("particles that turn at 2 w0", |v| v.rate = 2)
    .altered("a ball around the centre of mass at the start", |v| v.from_start = true)
}

fn examine_centre_of_mass_ball(variant: &BallVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // The bound 1 of |p| is attained by synchronised phases.
    let omega = rational(1, 10);
    let phasors = vec![scattered_phasors(2)?[1].clone(); 3];
    let start = mean(&circular_formation(&omega, &phasors)?.positions)?;
    let radius = rational(variant.radius.0, variant.radius.1) / &omega;
    if variant.from_start {
        let half_turn: Vec<_> = phasors.iter().map(|z| -z.clone()).collect();
        let away = (mean(&circular_formation(&omega, &half_turn)?.positions)? - &start).norm_squared();
        if away > &radius * &radius {
            let what = format!("w0 = {omega}, synchronised: half a turn later |R - R(0)|^2 = {away}");
            return Ok(Outcome::fails(what, exact("a fixed ball", "an exact circular formation")));
        }
    }
    let arm = start.norm_squared();
    let exact = |detail| exact("the radius", detail);
    if arm > &radius * &radius {
        let what = format!("w0 = {omega}, synchronised: |R - c_0|^2 = {arm} is more than {}", &radius * &radius);
        return Ok(Outcome::fails(what, exact("an exact circular formation")));
    }
    let part = |n: usize| format!("mean centre at rest, distance |p|/|w0| <= 1/|w0|, N = {n}");
    let identities = (1..=4).map(|n| state_identity(ball(variant, n), &["w0"], &part(n), run));
    let sharp = holds(exact("attained by three synchronised particles"));
    Run::all(identities.chain([sharp]))
}
