//! paley.sync.par, paley.eq7, paley.eq8.ext, paley.eq8_10: synchrony, the order parameter and the potential U_1.

use super::common::{
    all_equal, complete, holds, identity_of_phases, laplacian, named, names, phasors, squared_lengths,
};
use super::common::{at, turns, up_to_rotation};
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, CosineField, Dual, Field, Rational, Ring, Sign, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::oscillator::{
    State, gradient_control, laplacian_control, mean, moment, moment_gradient, moment_potential, pairwise_control,
    phase_gradient, rate_of_change, symmetric_pattern,
};

/// paley.sync.par.
pub struct Synchronised;

/// The common rate of synchronised phases, given `omega_0`.
#[derive(Clone, Copy)]
pub struct RateVariant(fn(&Rational) -> Rational);

impl Claim for Synchronised {
    type Variant = RateVariant;

    fn id(&self) -> &str {
        "paley.sync.par"
    }

    fn derivation(&self) -> &str {
        "The definition of a parallel formation asks for thetadot_k = 0. Phase locking gives equal rates only: under (6) with a control that \
         vanishes at equal phases, such as (9) and (14), the common rate is omega_0, and for omega_0 != 0 all particles turn together on \
         circles. Figure 1(c) of the paper shows just that and its caption says that it is no relative equilibrium of (1)-(2)."
    }

    fn printed(&self) -> RateVariant {
        RateVariant(|_| rational(0, 1))
    }

    fn repair(&self) -> Option<Repair<RateVariant>> {
        Some(Repair {
            fault: Fault::False, clauses: Vec::new(),
            statement: "A synchronised arrangement implies that the particles have a common direction at all times, which turns at their \
                        common rate, omega_0 under (6) with (9) or (14); the formation is parallel if and only if that rate is zero."
                .to_string(),
            variant: RateVariant(Rational::clone),
        })
    }

    fn controls(&self) -> Vec<Control<RateVariant>> {
        vec![
            Control::new("the rate 2 omega_0", RateVariant(|omega| omega * rational(2, 1))),
            Control::new("the rate -omega_0", RateVariant(|omega| -omega)),
            Control::new("the rate |omega_0|", RateVariant(num_traits::Signed::abs)),
        ]
    }

    fn examine(&self, variant: &RateVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut cases = 0;
        for particles in 2..=5usize {
            run.checkpoint()?;
            let together = phasors(&vec![rational(2, 3); particles])?;
            let path = laplacian(&named(&format!("path:{particles}"))?)?;
            for (omega, gain) in [(0, 1), (0, -1), (1, -1), (1, 1), (-2, -1), (-2, 3)] {
                let (omega, gain) = (rational(omega, 1), rational(gain, 1));
                let laws = [gradient_control(&gain, &together)?, laplacian_control(&gain, &path, &together)?];
                for rates in laws.map(|control| control.into_iter().map(|u| u + &omega).collect::<Vec<_>>()) {
                    cases += 1;
                    let claimed = (variant.0)(&omega);
                    if !all_equal(&rates) || rates[0] != claimed {
                        return Ok(Outcome::fails(
                            format!(
                                "N = {particles}, equal phases, omega_0 = {omega}, K_1 = {gain}: the phases are locked and turn at the \
                                 rate {}, not {claimed}",
                                rates[0]
                            ),
                            Evidence::new(Grade::Exact, "synchronised phases", "the law (6) at equal phases"),
                        ));
                    }
                }
            }
        }
        holds([Evidence::new(
            Grade::Exact,
            "common direction and rate",
            "(6) with (9), and with (14) on paths, at equal phases, N = 2 to 5; sines of differences vanish for all N",
        )
        .cases(cases)])
    }
}

/// paley.eq7.
pub struct OrderParameter;

/// `p = factor (1/N) sum e^{i theta}`, turned by so many quarters.
#[derive(Clone, Copy)]
pub struct OrderVariant {
    factor: (i64, i64),
    quarters: u64,
}

/// `Rdot = p` and `1 - |p|^2 = (1/(2 N^2)) sum_{k,j} |z_k - z_j|^2`.
struct Velocity {
    particles: usize,
    variant: OrderVariant,
}

impl RationalIdentity for Velocity {
    fn variables(&self) -> usize {
        self.particles
    }

    fn components(&self) -> Vec<String> {
        ["Re Rdot", "Im Rdot", "1 - |p|^2"].map(String::from).to_vec()
    }

    fn sides<T: Field>(&self, t: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let z = phasors(t)?;
        let like = t[0].one();
        let i = Complex::new(like.zero(), like.clone());
        let p =
            mean(&z)?.scale(&like.ratio(self.variant.factor.0, self.variant.factor.1)) * i.power(self.variant.quarters);
        let still = State { positions: vec![Complex::real(like.zero()); z.len()], phasors: z.clone() };
        let velocity = mean(&still.moving(&vec![like.zero(); z.len()], &[]).positions)?;
        let spread = squared_lengths(&complete(z.len()), &z, &like) * like.ratio(1, 2 * (z.len() * z.len()) as i64);
        let deficit = like - p.norm_squared();
        Ok((vec![velocity.re.derivative, velocity.im.derivative, deficit], vec![p.re, p.im, spread]))
    }
}

impl Claim for OrderParameter {
    type Variant = OrderVariant;

    fn id(&self) -> &str {
        "paley.eq7"
    }

    fn derivation(&self) -> &str {
        "Rdot = (1/N) sum rdot_j = (1/N) sum e^{i theta_j} by (1). 1 - |p|^2 = (1/(2 N^2)) sum_{k,j} |z_k - z_j|^2 >= 0 with equality \
         exactly for equal phases. p = 0 at all times is Rdot = 0, that is, R is fixed; an arrangement that is balanced at one instant only has \
         Rdot = 0 at that instant."
    }

    fn printed(&self) -> OrderVariant {
        OrderVariant { factor: (1, 1), quarters: 0 }
    }

    fn controls(&self) -> Vec<Control<OrderVariant>> {
        vec![
            Control::new("twice the sum", OrderVariant { factor: (2, 1), quarters: 0 }),
            Control::new("p turned by a quarter", OrderVariant { factor: (1, 1), quarters: 1 }),
            Control::new("-p", OrderVariant { factor: (-1, 1), quarters: 0 }),
        ]
    }

    fn examine(&self, variant: &OrderVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let parts = (1..=4).map(|particles| {
            let part = format!("Rdot = p and 1 - |p|^2 as a sum of squares, N = {particles}");
            identity_of_phases(run, &Velocity { particles, variant: *variant }, &names(particles, &[]), &part)
        });
        let identities = Run::all(parts)?;
        Run::all([Ok(identities), holds([Evidence::new(Grade::Exact, "every N", "the two lines of the derivation")])])
    }
}

/// paley.eq8.ext.
pub struct Extremes;

/// Which arrangements maximise, from how many particles on, and how many particles a rotation leaves out.
#[derive(Clone, Copy)]
pub struct ExtremesVariant {
    swapped: bool,
    least_particles: u32,
    left_out: usize,
}

/// `U_1` does not change when all phases are turned by the same angle.
struct Rotation {
    particles: usize,
    left_out: usize,
}

impl RationalIdentity for Rotation {
    fn variables(&self) -> usize {
        self.particles + 1
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let all = phasors(at)?;
        let (turn, z) = all.split_last().ok_or(ArithmeticError::Domain("an angle"))?;
        let turned = self.particles - self.left_out;
        let rotated: Vec<Complex<T>> =
            z.iter().enumerate().map(|(k, z)| if k < turned { z.clone() * turn } else { z.clone() }).collect();
        Ok((vec![moment_potential(&rotated, 1)?], vec![moment_potential(z, 1)?]))
    }
}

impl Claim for Extremes {
    type Variant = ExtremesVariant;

    fn id(&self) -> &str {
        "paley.eq8.ext"
    }

    fn derivation(&self) -> &str {
        "|p| does not change when all phases turn together. 0 <= |p| <= 1 (eq. 7), with |p| = 1 exactly for equal phases and p = 0 exactly for \
         balanced ones, and both occur for N >= 2 (the splay state is balanced). N >= 2 throughout, as the paper says of its goals: one particle \
         has no balanced arrangement and U_1 = 1/2 is constant."
    }

    fn printed(&self) -> ExtremesVariant {
        ExtremesVariant { swapped: false, least_particles: 2, left_out: 0 }
    }

    fn controls(&self) -> Vec<Control<ExtremesVariant>> {
        let printed = self.printed();
        vec![
            Control::new("maximised by balanced arrangements", ExtremesVariant { swapped: true, ..printed }),
            Control::new("balanced arrangements for N = 1 too", ExtremesVariant { least_particles: 1, ..printed }),
            Control::new("one phase not turned", ExtremesVariant { left_out: 1, ..printed }),
        ]
    }

    fn examine(&self, variant: &ExtremesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let rotation = Rotation { particles: 3, left_out: variant.left_out };
        let rotation = run.identity(&rotation, &["t1", "t2", "t3", "turn"], "rotational invariance, N = 3")?;
        Run::all([Ok(rotation), extreme_values(variant, run)])
    }
}

fn extreme_values(variant: &ExtremesVariant, run: &Run) -> Result<Outcome, CheckError> {
    const PARTS: usize = 6;
    let fails = |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "extremes", "exact values of U_1")));
    for particles in variant.least_particles..=12 {
        let splay = symmetric_pattern(particles, particles).unwrap_or_default();
        let value = moment_potential(&splay, 1)?;
        if value.sign() != Some(Sign::Zero) {
            return fails(format!("N = {particles}: the splay state is not balanced"));
        }
    }
    let field = CosineField::new(PARTS as u32);
    let mut cases = 0;
    for particles in 2..=4usize {
        run.checkpoint()?;
        for exponents in up_to_rotation(particles, PARTS) {
            let z = at(&field, &exponents);
            let (value, p) = (moment_potential(&z, 1)?, moment(&z, 1)?);
            let largest = value.ratio(particles as i64, 2);
            let (balanced, together) = (p == p.zero(), all_equal(&z));
            let (low, high) = if variant.swapped { (together, balanced) } else { (balanced, together) };
            let is_least = value.sign() == Some(Sign::Zero);
            let above = (value.clone() - &largest).sign();
            cases += 1;
            if value.sign() == Some(Sign::Negative)
                || above == Some(Sign::Positive)
                || is_least != low
                || (above == Some(Sign::Zero)) != high
            {
                return fails(format!("N = {particles}, {}: U_1 = {value:?}", turns(&exponents, PARTS)));
            }
        }
    }
    holds([
        Evidence::new(Grade::Exact, "balanced arrangements exist", "the splay state, N = 2 to 12"),
        Evidence::new(
            Grade::Exhaustive,
            "extremes",
            "all arrangements of 2 to 4 phases at multiples of 1/6 turn; |p| between 0 and 1 for all N by eq. 7",
        )
        .cases(cases),
    ])
}

/// paley.eq8_10.
pub struct GradientLaw;

/// Signs and factors of the gradient, the sum over pairs and the decrease.
#[derive(Clone, Copy)]
pub struct GradientVariant {
    gradient: (i64, i64),
    sine: i64,
    decrease: (i64, i64),
}

/// The displays between (8) and (10); variables are the phases, `K_1` and `omega_0`.
struct GradientIdentity {
    particles: usize,
    variant: GradientVariant,
}

impl RationalIdentity for GradientIdentity {
    fn variables(&self) -> usize {
        self.particles + 2
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [t @ .., gain, omega] = at else { return Err(ArithmeticError::Domain("phases, K_1, omega_0")) };
        let z = phasors(t)?;
        let slopes = phase_gradient(&z, |z| moment_potential(z, 1))?;
        let sum = slopes.iter().fold(gain.zero(), |sum, slope| sum + slope);
        let rates: Vec<T> = gradient_control(gain, &z)?.into_iter().map(|u| u + omega).collect();
        let decrease = rate_of_change(&z, &rates, |z: &[Complex<Dual<T>>]| moment_potential(z, 1))?;

        let v = &self.variant;
        let printed = moment_gradient(&z, 1)?;
        let pairs = pairwise_control(gain, &complete(z.len()), &z)?;
        let squares = printed.iter().fold(gain.zero(), |sum, slope| sum + slope.square());
        let left = slopes.into_iter().chain([sum]).chain(rates).chain([decrease]);
        let right = printed
            .iter()
            .map(|slope| slope.clone() * gain.ratio(v.gradient.0, v.gradient.1))
            .chain([gain.zero()])
            .chain(pairs.into_iter().map(|pair| pair * gain.integer(v.sine) + omega))
            .chain([squares * gain * gain.ratio(v.decrease.0, v.decrease.1)]);
        Ok((left.collect(), right.collect()))
    }
}

impl Claim for GradientLaw {
    type Variant = GradientVariant;

    fn id(&self) -> &str {
        "paley.eq8_10"
    }

    fn derivation(&self) -> &str {
        "dp/dtheta_k = i e^{i theta_k}/N gives the gradient; the sum is N <i p, p> = 0. <i e^{i theta_k}, e^{i theta_j}> = -sin theta_kj gives \
         (10). Along (6) the rate of U_1 is grad U_1 (omega_0 1 - K_1 grad U_1), and grad U_1 is orthogonal to 1."
    }

    fn printed(&self) -> GradientVariant {
        GradientVariant { gradient: (1, 1), sine: 1, decrease: (-1, 1) }
    }

    fn controls(&self) -> Vec<Control<GradientVariant>> {
        let printed = self.printed();
        vec![
            Control::new("the opposite gradient", GradientVariant { gradient: (-1, 1), ..printed }),
            Control::new("sin theta_jk in (10)", GradientVariant { sine: -1, ..printed }),
            Control::new("Udot with the opposite sign", GradientVariant { decrease: (1, 1), ..printed }),
            Control::new("half the decrease", GradientVariant { decrease: (-1, 2), ..printed }),
        ]
    }

    fn examine(&self, variant: &GradientVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let parts = (2..=3).map(|particles| {
            let part = format!("gradient, its sum, (10) and the rate of U_1, N = {particles}");
            let identity = GradientIdentity { particles, variant: *variant };
            identity_of_phases(run, &identity, &names(particles, &["K1", "omega0"]), &part)
        });
        let identities = Run::all(parts)?;
        Run::all([Ok(identities), holds([Evidence::new(Grade::Exact, "every N", "the lines of the derivation")])])
    }
}
