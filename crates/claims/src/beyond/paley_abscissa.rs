//! beyond.paley.abscissa: how fast the symmetric circular formations of Theorem 3 are reached, and exactly when they are stable.

use super::paley_modes::{Altered, Law, invariant_modes};
use crate::prelude::*;
use algebra::spectrum::Polynomial;
use arithmetic::{Sign, Signed};
use models::oscillator::{FourierFormation, TransverseSpectrum, without_symmetries};
use rand_chacha::rand_core::Rng;

/// Bits to which the abscissa of an exact characteristic polynomial is enclosed.
const BITS: u32 = 64;
/// Numbers of particles whose divisors are all tried.
const ORDERS: [usize; 6] = [12, 5, 8, 18, 24, 30];

/// What the statement says.
#[derive(Clone, Copy)]
pub struct AbscissaVariant {
    altered: Altered,
    /// Whether the eigenvalues of translations are left out, beside that of the rotation.
    translations: bool,
    /// The least of the numbers that are to be positive, beside `K_0`.
    condition: fn(gains: &[Rational], particles: usize) -> Option<Rational>,
    /// The abscissa for Figure 4 times `10^10`, by `M = 1, 2, 3` and the others, rounded.
    figure_4: [i64; 4],
    /// Under (22), for twelve particles.
    aligned: [Aligned; 6],
}

/// What is claimed of the phases `2 pi m k/12` under (22).
#[derive(Clone, Copy)]
struct Aligned {
    /// On the ring with `K_0 = N w0`, otherwise all-to-all with `K_0 = w0`; `w0 = 1/10`.
    ring: bool,
    /// `10 K_1`.
    gain: i64,
    wave: usize,
    /// How many eigenvalues are 0.
    zeros: usize,
    /// The abscissa of the others times `10^10`, rounded.
    abscissa: i64,
}

impl Aligned {
    const RING: Self = Aligned { ring: true, gain: 3, wave: 5, zeros: 1, abscissa: -45_001_538 };
    const COMPLETE: Self = Aligned { ring: false, gain: 2, wave: 1, zeros: 10, abscissa: -153_051_399 };
    const ALL: [Self; 6] = [
        Aligned { gain: -3, wave: 0, abscissa: -68_228_870, ..Aligned::RING },
        Aligned::RING,
        Aligned { wave: 6, abscissa: -62_033_862, ..Aligned::RING },
        Aligned { gain: -2, wave: 0, zeros: 1, abscissa: -53_355_402, ..Aligned::COMPLETE },
        Aligned::COMPLETE,
        Aligned { wave: 6, zeros: 11, abscissa: -500_000_000, ..Aligned::COMPLETE },
    ];

    fn formation(&self) -> FourierFormation {
        let omega = rational(1, 10);
        let (reach, spacing) = if self.ring { (1, rational(6, 5)) } else { (6, omega.clone()) };
        FourierFormation::new(12, 1..=reach, self.wave, (&omega, &spacing)).with_alignment(&rational(self.gain, 10))
    }
}

/// The least of `(K_r + K_(M-r))/2 - K_M`, and `-K_M` if `M < N`; `None` for one particle.
fn least_curvature(gains: &[Rational], particles: usize) -> Option<Rational> {
    let last = gains.last()?;
    let below = gains.split_last().map_or(&[][..], |(_, below)| below);
    let between = below.iter().zip(below.iter().rev()).map(|(a, b)| (a + b) / rational(2, 1) - last);
    between.chain((gains.len() < particles).then(|| -last.clone())).min()
}

/// The signs of Theorem 3, where they are asked for.
fn signs_of_theorem_3(gains: &[Rational], particles: usize) -> Option<Rational> {
    let (last, below) = gains.split_last()?;
    (particles > 1).then(|| below.iter().cloned().chain([-last.clone()]).min())?
}

fn divisors(particles: usize) -> impl Iterator<Item = usize> {
    (1..=particles).filter(move |m| particles.is_multiple_of(*m))
}

/// `K_m` below `M` and `K_M`.
fn gains(clusters: usize, (below, last): (&Rational, &Rational)) -> Vec<Rational> {
    (1..=clusters).map(|m| if m < clusters { below.clone() } else { last.clone() }).collect()
}

/// A pattern with spacing offsets from 1 to `reach`.
struct Instance {
    particles: usize,
    reach: usize,
    omega: Rational,
    spacing: Rational,
    gains: Vec<Rational>,
}

impl Instance {
    /// A stable splay state with `K_1 + K_2 > 2 K_3` and `K_2 < K_3 = 0`.
    fn beyond_the_signs() -> Self {
        let gains = [2, -1, 0].map(|k| rational(k, 1)).to_vec();
        Instance { particles: 3, reach: 1, omega: rational(1, 10), spacing: rational(1, 10), gains }
    }

    fn random(random: &mut impl Rng) -> Self {
        let mut draw = |n: usize| (random.next_u64() % n as u64) as usize;
        let particles = 2 + draw(7);
        let clusters: Vec<usize> = divisors(particles).collect();
        let clusters = clusters[draw(clusters.len())];
        let gains = (0..clusters).map(|_| rational(draw(9) as i64 - 4, 4)).collect();
        let omega = [rational(1, 10), rational(-1, 2), rational(2, 1)][draw(3)].clone();
        let spacing = [rational(1, 10), rational(3, 2), rational(-1, 5)][draw(3)].clone();
        let reach = [1, particles / 2][draw(2)];
        Instance { particles, reach, omega, spacing, gains }
    }
}

impl AbscissaVariant {
    /// The spectrum without what this variant leaves out.
    fn spectrum(&self, formation: &FourierFormation) -> Result<Option<TransverseSpectrum>, CheckError> {
        Ok(formation.without(|q| {
            let forced = formation.neutral(q).into_iter();
            forced.filter(|root| self.translations || root.im.sign() == Some(Sign::Zero)).collect()
        })?)
    }

    /// Exponentially stable up to symmetry exactly where the condition says so; unstable where a number of it is negative.
    fn signs(&self, run: &Run) -> Result<Outcome, CheckError> {
        let cases = run.cases(60, 600);
        let mut random = run.random(0);
        let mut stable = 0;
        for case in 0..cases {
            run.checkpoint()?;
            // The first shows that K_2 may be negative and below K_3.
            let Instance { particles, reach, omega, spacing, gains } =
                if case == 0 { Instance::beyond_the_signs() } else { Instance::random(&mut random) };
            let clusters = gains.len();
            let formation = FourierFormation::new(particles, 1..=reach, particles / clusters, (&omega, &spacing));
            let Some(found) = self.spectrum(&formation.with_moments(&gains))? else { continue };
            let least = (self.condition)(&gains, particles).map(|least| least.min(spacing.clone()));
            let claimed = least.as_ref().and_then(Signed::sign);
            let decays = found.zeros <= 1 && found.abscissa.is_certainly_negative();
            let grows = found.abscissa.is_certainly_positive();
            if decays != (claimed == Some(Sign::Positive)) || claimed == Some(Sign::Negative) && !grows {
                let what = format!(
                    "({clusters},{particles}), spacing network C_{particles}(1..{reach}), w0 = {omega}, K_0 = \
                     {spacing}, K_m = {}: abscissa {}, 0 removed {} times",
                    list(&gains),
                    interval_value(&found.abscissa, 6),
                    found.zeros
                );
                return Ok(Outcome::fails(what, certified("exactly when stable", "enclosed abscissa")));
            }
            stable += usize::from(decays);
        }
        let detail = format!(
            "sign of the enclosed abscissa for random gains of both signs, on C_N and all-to-all, N up to 8: \
             {stable} stable; for all N, M and connected networks by the inertia theorem of \
             notes/paley_particles.md; step 3"
        );
        let argued = "notes/paley_particles.md, Spectral abscissa at symmetric formations, step 3";
        Ok(Outcome::Holds(vec![
            Evidence::argued("every connected network and all gains", argued).on([1]),
            certified("exactly when stable", detail).cases(cases).on([1]),
        ]))
    }

    /// The abscissae of synchronised and balanced formations under (22).
    fn synchronised_and_balanced(&self, run: &mut Run) -> Result<Outcome, CheckError> {
        for claimed in &self.aligned {
            run.checkpoint()?;
            let network = if claimed.ring { "C_12" } else { "all-to-all" };
            let name = format!("(22) {network}, m = {}, K_1 = {}/10", claimed.wave, claimed.gain);
            let Some(found) = self.spectrum(&claimed.formation())? else { continue };
            let right = found.zeros == claimed.zeros && is_sharp(&found.abscissa);
            if !right || !rounds_to(&found.abscissa, claimed.abscissa) {
                let what = format!(
                    "{name}: the abscissa lies in {}, zeros {}",
                    interval_value(&found.abscissa, 12),
                    found.zeros
                );
                return Ok(Outcome::fails(what, certified("synchronised and balanced", "enclosures")));
            }
            run.value(&format!("abscissa {name}"), interval_value(&found.abscissa, 15));
        }
        let detail = "cubics of beyond.paley.circulant_spectrum, zeros divided out exactly, relative width below 10^-9";
        let evidence = certified("synchronised and balanced", detail).on([4]).for_all();
        holds(evidence.cases(self.aligned.len()))
    }

    /// The abscissae for gains of the figures and of paley.thm3.stab.
    fn enclosures(&self, run: &mut Run) -> Result<Outcome, CheckError> {
        let fails = |what: String| Ok(Outcome::fails(what, certified("abscissae", "enclosures")));
        let mut formations = 0;
        for (index, (omega, below, last)) in
            [((1, 10), (1, 5), (-1, 25)), ((1, 10), (4, 1), (-1, 3)), ((-2, 1), (4, 1), (-1, 3))]
                .into_iter()
                .enumerate()
        {
            let [omega, below, last] = [omega, below, last].map(|(p, q)| rational(p, q));
            // The large ones take most of the time.
            let most = if index == 0 { ORDERS.len() } else { run.cases(3, ORDERS.len()) };
            for &particles in &ORDERS[..most] {
                for clusters in divisors(particles) {
                    run.checkpoint()?;
                    let circular = (&omega, &rational(1, 10));
                    let gains = gains(clusters, (&below, &last));
                    let formation = FourierFormation::pattern(clusters, particles, circular, &gains);
                    let Some(found) = formation.map(|f| self.spectrum(&f)).transpose()?.flatten() else { continue };
                    formations += 1;
                    let name = format!("({clusters},{particles}), w0 = {omega}, K_m = {below}, K_M = {last}");
                    if found.zeros != 1 || !is_sharp(&found.abscissa) {
                        return fails(format!(
                            "{name}: {}, zeros {}",
                            interval_value(&found.abscissa, 12),
                            found.zeros
                        ));
                    }
                    if index > 0 {
                        continue;
                    }
                    if !rounds_to(&found.abscissa, self.figure_4[clusters.min(4) - 1]) {
                        return fails(format!("{name}: the abscissa lies in {}", interval_value(&found.abscissa, 12)));
                    }
                    if particles == 12 {
                        run.value(&format!("abscissa({clusters},12)"), interval_value(&found.abscissa, 15));
                    }
                }
            }
        }
        let detail = "relative width below 10^-9, all M, N = 12, 5, 8, 18, 24, 30 for Figure 4, N = 12, 5, 8 (full runs: \
         all) for two other sets of gains: Routh's table of the shifted cubics";
        holds(certified("abscissae", detail).cases(formations).on([3]).for_all())
    }
}

/// Negative, and known to nine digits.
fn is_sharp(x: &Interval) -> bool {
    let (lo, hi) = x.to_rationals();
    x.is_certainly_negative() && hi.clone() - lo <= -hi / rational(1_000_000_000, 1)
}

fn rounds_to(x: &Interval, claimed: i64) -> bool {
    let scale = rational(10_000_000_000, 1);
    let near = |end: Rational| (end * &scale).round() == rational(claimed, 1);
    let (lo, hi) = x.to_rationals();
    near(lo) && near(hi)
}

/// The abscissae from exact characteristic polynomials of the whole linearisation, where the phasors are rational.
fn whole_matrices(variant: &AbscissaVariant, run: &Run) -> Result<Outcome, CheckError> {
    let orders: &[usize] = if run.cases(0, 1) == 1 { &[2, 3, 4, 8, 12] } else { &[2, 3, 4] };
    let (omega, spacing) = (rational(1, 10), rational(1, 10));
    let mut cases = 0;
    for &particles in orders {
        for clusters in divisors(particles).filter(|m| [1, 2, 4].contains(m)) {
            run.checkpoint()?;
            let gains = gains(clusters, (&rational(1, 5), &rational(-1, 25)));
            let law = Law { particles, reach: particles / 2, omega: omega.clone(), spacing: spacing.clone(), gains };
            let (zeros, rest): (usize, Polynomial) = without_symmetries(&law.rational_linearisation()?, &omega, true)?;
            let whole = rest.abscissa(BITS);
            let by_modes = variant.spectrum(&law.formation())?;
            cases += 1;
            let agree = match (&whole, &by_modes) {
                (None, None) => true,
                (Some(whole), Some(modes)) => zeros == modes.zeros && whole.overlaps(&modes.abscissa),
                _ => false,
            };
            if !agree {
                let what =
                    format!("({clusters},{particles}): the modes and the whole matrix do not have the same abscissa");
                return Ok(Outcome::fails(what, exact("whole matrices", "characteristic polynomial")));
            }
        }
    }
    let detail = "the same abscissae from exact characteristic polynomials of the law's derivative by duals, M = 1, \
     2, 4, N up to 4 (12 in full runs); steps 1 and 2";
    holds(certified("whole matrices", detail).cases(cases).on([2, 3]))
}

pub fn pattern_abscissa() -> Record<AbscissaVariant> {
    let printed = AbscissaVariant {
        altered: Altered::NOT,
        translations: true,
        condition: least_curvature,
        figure_4: [-312_191_180, -312_191_180, -47_433_127, -41_665_656],
        aligned: Aligned::ALL,
    };
    let altered = |altered| AbscissaVariant { altered, ..printed };
    Record::new(
        "beyond.paley.abscissa",
        "theta_k = 2 pi k/M is the Fourier column m = N/M. The Hessian of (25) there is circulant, with h_q \
         = (K_r + K_(M-r))/2 - K_M at q = rm, 0 < r < M, h_0 = 0 and -K_M at the other q; by the inertia \
         theorem the pattern is stable iff K_0 and all h_q but h_0 are positive. Each Fourier mode of (a, \
         b, phi), c_k = (a_k + i b_k) e^{i theta_k}, is invariant, with C_q, D_q the half sum and half \
         difference of the Laplacian eigenvalues m + q, m - q. 0 is a root at q = 0 (rotation), i w0 at q = \
         m and -i w0 at q = -m (translations): divided out exactly. The others are enclosed by Routh's \
         table of shifted cubics (notes/paley_particles.md).",
        printed,
        examine_pattern_abscissa,
    )
    .stated("sharpens paley, Theorem 3; text on synchronised and balanced formations; Figures 3, 4", "")
    .clauses(&[
        "N >= 2, M divides N, w0 != 0. Under (5) with (20) on a connected undirected graph and minus the gradient of (25), the circular \
         (M,N)-pattern is exponentially stable up to rotation and translation iff K_0 > 0, K_r + K_(M-r) > 2 K_M for 0 < r < M, and K_M < 0 \
         if M < N.",
        "Its linearisation in the turning frame all-to-all has the eigenvalues 0 and ± i w0 of the symmetries, each once, and otherwise the \
         roots of the cubics s^3 + (k_0 C_q + h_q) s^2 + (w0^2 - i w0 k_0 D_q) s + h_q w0^2, q = 0, ..., N-1, without them; here k_0 = \
         K_0/N, m = N/M, C_q and D_q = (l_(m+q) ± l_(m-q))/2 with l_j = 0 for j = 0 modulo N and l_j = N for the other j, and h_0 = 0, h_q \
         = (K_r + K_(M-r))/2 - K_M for q = rm, 0 < r < M, h_q = -K_M for the other q.",
        "For N = 12, all-to-all, w0 = K_0 = 0.1, K_m = 0.2 for m < M, K_M = -0.04 the largest real part of an eigenvalue other than these 0 \
         and ± i w0 is, to ten decimals, -0.0312191180 for M = 1, 2, -0.0047433127 for M = 3, -0.0041665656 for M = 4, 6, 12; the same for \
         the M that divide N = 5, 8, 18, 24, 30, the last number for every M >= 4.",
        "Under (22), N = 12, w0 = 0.1, in the turning frame, the largest real parts of the eigenvalues other than 0 and the pair ± i w0 of \
         the translations are, to ten decimals: on C_12 with K_0 = 1.2 synchronised -0.0068228870 (K_1 = -0.3), splay m = 5 -0.0045001538 \
         and m = 6 -0.0062033862 (K_1 = 0.3); all-to-all with K_0 = 0.1 synchronised -0.0053355402 (K_1 = -0.2), and at balanced phases, \
         where 0 is an eigenvalue N - 2 times (N - 1 times at M = 2), splay -0.0153051399 and M = 2 -0.0500000000 (K_1 = 0.2).",
    ])
    .control("without D_q", altered(Altered { twist: 0, ..Altered::NOT }))
    .control("K_M with the other sign in h_q", altered(Altered { last: -1, ..Altered::NOT }))
    .control("with the translations", AbscissaVariant { translations: false, ..printed })
    .control("iff K_m > 0 > K_M", AbscissaVariant { condition: signs_of_theorem_3, ..printed })
    .control(
        "M = 3 as M = 4",
        AbscissaVariant { figure_4: [-312_191_180, -312_191_180, -41_665_656, -41_665_656], ..printed },
    )
    .control(
        "balanced phases as if isolated all-to-all",
        AbscissaVariant { aligned: [Aligned { zeros: 1, ..Aligned::COMPLETE }; 6], ..printed },
    )
    .control(
        "the splay state on the ring with K_1 < 0",
        AbscissaVariant { aligned: [Aligned { gain: -3, ..Aligned::RING }; 6], ..printed },
    )
}

fn examine_pattern_abscissa(variant: &AbscissaVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // The parts that take long come last: most controls do not reach them.
    let argued = "notes/paley_particles.md, Spectral abscissa at symmetric formations, steps 1 to 4";
    let argued = Evidence::argued("the spectrum, all M and N", argued).on([2]);
    Run::all((0..6).map(|part| match part {
        0 => variant.signs(run),
        1 => variant.synchronised_and_balanced(run),
        2 => variant.enclosures(run),
        3 => Ok(invariant_modes(&variant.altered, run)?.on([2])),
        4 => whole_matrices(variant, run),
        _ => holds(argued.clone()),
    }))
}
