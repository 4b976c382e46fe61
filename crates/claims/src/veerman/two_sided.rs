//! veerman.lem2 and veerman.lem2_eigvec: tracking the cars in front and behind.

use super::{complex_gains, imaginary, negative_gains, parts};
use crate::prelude::*;
use models::platoon::{Communication, Gains, accelerations, gamma};
use rand_chacha::rand_core::Rng;

type Matrix2<T> = [[Complex<T>; 2]; 2];

fn times<T: Ring>(a: &Matrix2<T>, b: &Matrix2<T>) -> Matrix2<T> {
    let entry = |i: usize, j: usize| a[i][0].clone() * &b[0][j] + a[i][1].clone() * &b[1][j];
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}

/// The companion matrix `C = [[0, 1], [corner, 2 gamma]]` to a positive power.
fn companion_power<T: Ring>(gamma: &Complex<T>, corner: i64, power: u64) -> Matrix2<T> {
    let c = [[gamma.zero(), gamma.one()], [gamma.integer(corner), gamma.clone() + gamma]];
    (1..power).fold(c.clone(), |product, _| times(&c, &product))
}

/// `a_{N+1} = numerator/Tr C^(N + 1 + shift)` with `C = [[0, 1], [corner, 2 gamma]]`.
#[derive(Clone, Copy)]
pub struct LastAmplitudeVariant {
    numerator: i64,
    shift: i64,
    corner: i64,
}

/// From the claimed amplitude of the last car, equation (2) gives those in front one after the other; the leader's
/// must come out as 1.
fn leader_is_one(variant: &LastAmplitudeVariant, followers: u64) -> Identity<'_> {
    Identity::of(move |[f, g, w]| {
        let gamma = gamma(&Gains { f: f.clone(), g: g.clone() }, w)?;
        let power = (followers as i64 + variant.shift).max(1) as u64;
        let c = companion_power(&gamma, variant.corner, power);
        let trace = c[0][0].clone() + &c[1][1];
        let (gains, iw) = (complex_gains(f, g), imaginary(w));
        // Scaled by the trace: the last car has the numerator, the leader must have the trace.
        let mut amplitudes = vec![trace.integer(variant.numerator)];
        for _ in 0..followers {
            amplitudes.insert(0, car_in_front(&gains, &iw, &amplitudes)?);
        }
        let leader = amplitudes.swap_remove(0);
        Ok((parts([leader]), parts([trace])))
    })
    .within(negative_gains)
}

/// The amplitude in front of `amplitudes[0]`, solved from its equation: the force is affine in it.
fn car_in_front<T: Field>(
    gains: &Gains<Complex<T>>,
    iw: &Complex<T>,
    amplitudes: &[Complex<T>],
) -> Result<Complex<T>, ArithmeticError> {
    // Only the own car and the one behind matter; the one behind gives the own car a middle place.
    let cars = &amplitudes[..amplitudes.len().min(2)];
    let rates: Vec<Complex<T>> = cars.iter().map(|a| a.clone() * iw).collect();
    let force = |front: Complex<T>| {
        let rate = front.clone() * iw;
        accelerations(Communication::FrontAndBack, gains, (&front, &rate), cars, &rates).swap_remove(0)
    };
    let at_zero = force(iw.zero());
    let slope = force(iw.one()) - &at_zero;
    (rates[0].clone() * iw - at_zero).over(&slope)
}

/// `2/(mu_-^M + mu_+^M)` is `2/Tr C^M` for `gamma = (mu + 1/mu)/2`.
fn trace_by_roots(corner: i64, followers: u64) -> Identity<'static> {
    Identity::new(2, move |at| {
        let (mu, inverse, gamma, _) = roots(at)?;
        let c = companion_power(&gamma, corner, followers);
        let trace = c[0][0].clone() + &c[1][1];
        let sum = mu.power(followers) + inverse.power(followers);
        Ok((parts([trace]), parts([sum])))
    })
}

type Roots<T> = (Complex<T>, Complex<T>, Complex<T>, Complex<T>);

/// `mu_+`, `mu_-`, `gamma` and `sqrt(gamma² - 1)` parametrised by `mu_+`: every `gamma` arises so, and exchanging the
/// roots exchanges the branch of the square root.
fn roots<T: Field>(at: &[T]) -> Result<Roots<T>, ArithmeticError> {
    let [re, im] = at else { return Err(ArithmeticError::Domain("two variables")) };
    let mu = Complex::new(re.clone(), im.clone());
    let inverse = mu.recip()?;
    let half = re.ratio(1, 2);
    let gamma = (mu.clone() + &inverse).scale(&half);
    let root = (mu.clone() - &inverse).scale(&half);
    Ok((mu, inverse, gamma, root))
}

pub fn last_amplitude() -> Record<LastAmplitudeVariant> {
    Record::new(
        "veerman.lem2",
        "The middle cars give a_{k-1} = 2 gamma a_k - a_{k+1} and the last one a_{M-1} = gamma a_M. So a_{M-j} = T_j(gamma) a_M \
         with the Chebyshev polynomials, and a_0 = 1 gives a_M = 1/T_M(gamma) = 2/Tr C^M, for every M by induction. For \
         f, g < 0 and w != 0 gamma is not real while the zeros of T_M are; at w = 0 T_M(1) = 1 (notes/veerman.md).",
        LastAmplitudeVariant { numerator: 2, shift: 0, corner: -1 },
        examine_last_amplitude,
    )
    .clauses(&[
        "If only the agents immediately preceding and trailing are tracked, a_{N+1} = 2/Tr C^{N+1}.",
        "Tr C^{N+1} = mu_-^{N+1} + mu_+^{N+1}.",
    ])
    .altered("numerator 1", |v| v.numerator = 1)
    .altered("the exponent N", |v| v.shift = -1)
    .altered("the exponent N + 2", |v| v.shift = 1)
    .altered("determinant -1", |v| v.corner = 1)
}

fn examine_last_amplitude(variant: &LastAmplitudeVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const IDENTITIES: u64 = 6;
    let mut results = Vec::new();
    for followers in 1..=IDENTITIES {
        let part = format!("equation (2) solved from the last car to the leader, {followers} followers");
        results.push(run.identity(&leader_is_one(variant, followers), &["f", "g", "w"], &part).on([1]));
        let part = format!("Tr C^M = mu_-^M + mu_+^M, M = {followers}");
        results.push(run.identity(&trace_by_roots(variant.corner, followers), &["Re mu", "Im mu"], &part).on([2]));
    }
    results.push(exact_instances(variant, run).on([1]));
    Run::all(results)
}

/// Longer platoons at exact points with f, g < 0, w = 0 among them.
fn exact_instances(variant: &LastAmplitudeVariant, run: &Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(1);
    let cases = [1, 2, 3, 7, 20, 41].into_iter().flat_map(|followers| (0..3).map(move |w| (followers, w)));
    let detail = "up to 41 followers; f in -1/7, ..., -50/7, g in -1/9, ..., -50/9 at random, w = 0, 1/5, 2/5";
    run.instances("longer platoons", detail, cases, |(followers, frequency)| {
        let mut gain = |denominator| rational(-1 - i64::from(random.next_u32() % 50), denominator);
        let at = [gain(7), gain(9), rational(frequency, 5)];
        let (leader, expected) = leader_is_one(variant, followers).at(&at)?;
        let [f, g, w] = &at;
        Ok((leader != expected).then(|| format!("{followers} followers, f = {f}, g = {g}, w = {w}")))
    })
}

/// What the proof prints, with the signs and exponents that could be wrong.
#[derive(Clone, Copy)]
pub struct DerivationVariant {
    /// `C = [[0, 1], [corner, 2 gamma]]`.
    corner: i64,
    /// `1 - gamma mu_+ = -sign sqrt(gamma² - 1) mu_+`.
    sign: i64,
    /// `c_+ = mu_-^(N + shift)/(mu_-^(N + 1) + mu_+^(N + 1))`.
    shift: u64,
}

/// The recurrence and the last car's condition satisfy equation (2).
fn recurrence(variant: &DerivationVariant) -> Identity<'_> {
    Identity::of(move |[f, g, w, front_re, front_im, own_re, own_im]| {
        let gamma = gamma(&Gains { f: f.clone(), g: g.clone() }, w)?;
        let (gains, iw) = (complex_gains(f, g), imaginary(w));
        let front = Complex::new(front_re.clone(), front_im.clone());
        let own = Complex::new(own_re.clone(), own_im.clone());
        let behind = gamma.integer(variant.corner) * &front + (gamma.clone() + &gamma) * &own;
        let last = front.over(&gamma)?;
        let residual = |cars: &[Complex<Probe>]| {
            let rates: Vec<Complex<Probe>> = cars.iter().map(|a| a.clone() * &iw).collect();
            let leader = (&front, &(front.clone() * &iw));
            let forces = accelerations(Communication::FrontAndBack, &gains, leader, cars, &rates);
            (rates[0].clone() * &iw, forces[0].clone())
        };
        let (middle_rate, middle_force) = residual(&[own, behind]);
        let (last_rate, last_force) = residual(&[last]);
        Ok((parts([middle_rate, last_rate]), parts([middle_force, last_force])))
    })
    .within(negative_gains)
}

/// Eigenvectors, the relation of gamma and mu, and the boundary conditions with `c_+`; `mu_+^N = p` is a free variable, so
/// that one identity serves every N.
fn roots_of_c(variant: &DerivationVariant) -> Identity<'_> {
    Identity::of(move |[mu_re, mu_im, p_re, p_im]| {
        let (plus, minus, gamma, root) = roots(&[mu_re.clone(), mu_im.clone()])?;
        let one = gamma.one();
        let (mut left, mut right) = (Vec::new(), Vec::new());
        let mut equate = |a: Complex<Probe>, b: Complex<Probe>| {
            left.extend([a.re, a.im]);
            right.extend([b.re, b.im]);
        };
        let c = companion_power(&gamma, variant.corner, 1);
        for (mu, sign) in [(&plus, -1), (&minus, 1)] {
            let [first, second] = [0, 1].map(|i| c[i][0].clone() + c[i][1].clone() * mu);
            equate(first, mu.clone());
            equate(second, mu.square());
            equate(one.clone() - gamma.clone() * mu, one.integer(sign * variant.sign) * &root * mu);
        }
        let plus_n = Complex::new(p_re.clone(), p_im.clone());
        let minus_n = plus_n.recip()?;
        let (plus_next, minus_next) = (plus_n.clone() * &plus, minus_n.clone() * &minus);
        let numerator = if variant.shift == 1 { &minus_next } else { &minus_n };
        let share = numerator.over(&(minus_next.clone() + &plus_next))?;
        let other = one.clone() - &share;
        // C^N (a_0, a_1) = c_+ mu_+^N (1, mu_+) + (1 - c_+) mu_-^N (1, mu_-) = (a_N, a_{N+1}), and a_N = gamma a_{N+1}.
        let before = share.clone() * plus_n + other.clone() * minus_n;
        let last = share * plus_next + other * minus_next;
        equate(before, gamma * last);
        Ok((left, right))
    })
}

pub fn derivation() -> Record<DerivationVariant> {
    Record::new(
        "veerman.lem2_eigvec",
        "mu_+ mu_- = 1 and mu_+ + mu_- = 2 gamma, so C (1, mu) = (mu, -1 + 2 gamma mu) = mu (1, mu). With s² = gamma² - 1, \
         1 - gamma mu_+ = -s² - gamma s = -s mu_+. The last car's condition a_N = gamma a_{N+1} then gives \
         c_+ mu_+^{N+1} = (1 - c_+) mu_-^{N+1} for s != 0, that is w != 0. At w = 0 the two roots are 1, C has one eigenvector \
         only, every c_+ gives a_k = 1, and the printed formula gives 1/2.",
        DerivationVariant { corner: -1, sign: 1, shift: 1 },
        |variant, run| {
            let names = ["f", "g", "w", "Re a_{k-1}", "Im a_{k-1}", "Re a_k", "Im a_k"];
            let part = "the recurrence with C and a_{N+1} = a_N/gamma satisfy equation (2)";
            let recurrence = run.identity(&recurrence(variant), &names, part)?.on([1, 2]).for_all();
            let names = ["Re mu_+", "Im mu_+", "Re mu_+^N", "Im mu_+^N"];
            let part = "eigenvectors, 1 - gamma mu, c_+ and the boundary conditions, for every N";
            let roots = run.identity(&roots_of_c(variant), &names, part)?.on([3, 4, 5]).for_all();
            Run::all([Ok(recurrence), Ok(roots)])
        },
    )
    .reading("c_+ and 1 - c_+ are the shares of mu_+^k and mu_-^k in a_k.")
    .clauses(&[
        "For system (2), (a_k, a_{k+1})^T = C (a_{k-1}, a_k)^T with C = [[0,1],[-1,2 gamma]].",
        "With a_0 = 1, the last car says a_{N+1} = gamma^{-1} a_N.",
        "With mu_+- = gamma +- sqrt(gamma^2 - 1) the eigenvectors of C are (1, mu_+-)^T.",
        "(1 - gamma mu_+-) = -+ sqrt(gamma^2 - 1) mu_+-.",
        "c_+ = mu_-^{N+1}/(mu_-^{N+1} + mu_+^{N+1}).",
    ])
    .altered("the corner +1 in C", |v| v.corner = 1)
    .altered("the opposite sign of the square root", |v| v.sign = -1)
    .altered("mu_-^N in c_+", |v| v.shift = 0)
}
