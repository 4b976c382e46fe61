//! Many steps at once on a network that stays, whatever the velocities: by Chebyshev polynomials of the transition matrix.
//!
//! `P` has real eigenvalues in `[-1, 1]` and is symmetric for the scalar product of its stationary distribution, so `|T_j(P) u|` is at most
//! `|u|` in that norm. The coefficients of `P^k` are the probabilities of the places of a walk of `k` steps, those of `1 + .. + P^(k-1)` its
//! expected numbers of visits; beyond `m` they add up to less than `2 exp(-m²/2k)` (`notes/exact_flocks.md`).

use super::balls::Balls;
use super::links::weight;
use super::words::Words;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use rayon::prelude::*;

/// Fewer steps are as quick one by one.
pub(super) const SHORTEST_LEAP: u64 = 2048;

/// More steps are made in several leaps.
pub(super) const LONGEST_LEAP: u64 = 1 << 24;

/// Numbers that one task works on.
const TASK: usize = 2048;

/// Bits beyond those of a number.
const GUARD: u64 = 64;

/// The coefficients of `z^k` and of `1 + z + .. + z^(k-1)` by the Chebyshev polynomials up to a degree.
struct Coefficients<const L: usize> {
    powers: Vec<Words<L>>,
    /// Over `2^scale`.
    sums: Vec<Words<L>>,
    scale: u32,
}

impl<const L: usize> Coefficients<L> {
    fn new(steps: u64, degree: u64) -> Self {
        let bits = 64 * L as u64 + GUARD;
        let highest = degree - (steps - degree) % 2;
        // Binomial coefficients from the last place inwards, up to a factor.
        let mut walk = vec![BigInt::ZERO; degree as usize + 1];
        let mut number = BigInt::from(1) << bits;
        for place in (0..=highest).rev().step_by(2) {
            walk[place as usize] = if place == 0 { number.clone() } else { &number * 2 };
            number = number * (steps + place) / (steps + 2 - place);
        }
        let total: BigInt = walk.iter().sum();
        walk.iter_mut().for_each(|c| *c = (&*c << bits) / &total);
        let scale = u64::BITS - steps.leading_zeros();
        let (mut beyond, mut moment) = (BigInt::ZERO, BigInt::ZERO);
        let mut sums = Vec::with_capacity(walk.len());
        for (place, c) in walk.iter().enumerate().rev() {
            // The sum of (i - place) c_i over all i beyond this place.
            moment += &beyond;
            let visits = if place == 0 { moment.clone() } else { &moment * 2 };
            sums.push(Words::fraction(&visits, &(BigInt::from(1) << (bits + u64::from(scale)))));
            beyond += c;
        }
        sums.reverse();
        let unit = BigInt::from(1) << bits;
        Coefficients { powers: walk.iter().map(|c| Words::fraction(c, &unit)).collect(), sums, scale }
    }
}

/// Beyond this degree less than `2^-7` of the last bit of so many limbs is left.
pub(super) fn degree_for(steps: u64, limbs: usize) -> u64 {
    (2.0 * steps as f64 * (64 * limbs + 8) as f64 * std::f64::consts::LN_2).sqrt().ceil() as u64 + 1
}

/// A connected part before a leap.
struct Start<const L: usize> {
    mean: Vec<Words<L>>,
    /// What is left of the velocities is enlarged by this power of two.
    shift: u32,
    /// A bound of the root of the sum of `1/c_i`.
    root: f64,
}

impl<const L: usize> Balls<L> {
    /// So many steps on a network that stays; whether it was done.
    pub fn leap(&mut self, steps: u64) -> bool {
        let degree = degree_for(steps, L);
        if self.room < steps || degree >= steps || self.has_no_room() {
            return false;
        }
        let parts = self.network.component_numbers();
        let Some(starts) = self.starts(&parts) else { return false };
        let of = |place: usize| &starts[parts.0[place / self.dimension] as usize];
        let coefficients = Coefficients::<L>::new(steps, degree);
        let rest = |place: usize| self.velocities[place].minus(of(place).mean[place % self.dimension]);
        let mut now: Vec<Words<L>> = (0..self.velocities.len()).map(|k| rest(k).raised(of(k).shift)).collect();
        let mut before = now.clone();
        let mut powers: Vec<Words<L>> = now.iter().map(|w| w.share(&coefficients.powers[0])).collect();
        let mut sums: Vec<Words<L>> = now.iter().map(|w| w.share(&coefficients.sums[0])).collect();
        let mut next = now.clone();
        for (j, (power, sum)) in coefficients.powers.iter().zip(&coefficients.sums).enumerate().skip(1) {
            self.average_from(&now, &mut next);
            // T_(j+1) = 2 z T_j - T_(j-1), but T_1 = z.
            let columns = next.par_chunks_mut(TASK).zip(before.par_chunks(TASK));
            let totals = powers.par_chunks_mut(TASK).zip(sums.par_chunks_mut(TASK));
            columns.zip(totals).for_each(|((next, before), (powers, sums))| {
                for (((w, old), p), q) in next.iter_mut().zip(before).zip(powers).zip(sums) {
                    if j > 1 {
                        *w = w.plus(*w).minus(*old);
                    }
                    if *power != Words::ZERO {
                        *p = p.plus(w.share(power));
                    }
                    *q = q.plus(w.share(sum));
                }
            });
            std::mem::swap(&mut before, &mut now);
            std::mem::swap(&mut now, &mut next);
        }
        let ends: Option<Vec<(Words<L>, Words<L>)>> = (0..now.len())
            .map(|place| {
                let (start, scale) = (of(place), coefficients.scale);
                let mean = start.mean[place % self.dimension];
                let way = match start.shift.checked_sub(scale) {
                    Some(down) => sums[place].shifted(down),
                    None => sums[place].raised(scale - start.shift),
                };
                let straight = Words::from_integer(&(mean.to_integer() * steps))?;
                Some((self.positions[place].plus(straight).plus(way), mean.plus(powers[place].shifted(start.shift))))
            })
            .collect();
        let Some(ends) = ends else { return false };
        // In the units of the enlarged numbers, as steps 3 and 4 of the notes: roundings of the recurrence, of the sums, and what is cut off.
        let enlarged = |start: &Start<L>| {
            let (m, l) = (degree as f64 + 1.0, L as f64);
            (start.root * (l + 2.0) * m * m + m * (l + 3.0) + 2.0 * start.root) * 1.001
        };
        let unit = |start: &Start<L>| 2f64.powi(-(start.shift as i32));
        let most = |scale: u32| {
            starts.iter().map(|start| enlarged(start) * unit(start)).fold(0.0, f64::max) * 2f64.powi(scale as i32)
        };
        let (speed, way) = (most(0), most(coefficients.scale));
        self.keep(ends, steps, ((speed + 2.0) as u128, (way + 2.0) as u128));
        true
    }

    /// Means and room of all parts; `None` where a weight or the room is missing.
    fn starts(&self, parts: &(Vec<u32>, usize)) -> Option<Vec<Start<L>>> {
        let mut members = vec![Vec::new(); parts.1];
        parts.0.iter().enumerate().for_each(|(i, &part)| members[part as usize].push(i));
        let start = |members: Vec<usize>| {
            let mean = self.mean(&members)?;
            let mut total = 0.0;
            for &i in members.iter().filter(|_| members.len() > 1) {
                total += 1.0 / weight(&self.network, &self.weights, i, &BigInt::ZERO).ok()?.to_f64()?;
            }
            let root = (total * (1.0 + 1e-9)).sqrt() + 1.0;
            let neighbours = members.iter().map(|&i| self.network.degree(i)).max().unwrap_or(0);
            let bits = |&i: &usize| {
                let rest = |k: usize| self.velocities[i * self.dimension + k].minus(mean[k]);
                (0..self.dimension).map(|k| rest(k).bits()).max().unwrap_or(0)
            };
            let longest = members.iter().map(bits).max().unwrap_or(0);
            // Numbers grow by the root, sums of them by the number of neighbours, and twice that is taken.
            let more = (root * (neighbours as f64 + 1.0) * 16.0).log2().ceil() as u32;
            let shift = (64 * L as u32 - 1).checked_sub(longest + more)?;
            Some(Start { mean, shift, root })
        };
        members.into_iter().map(start).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::{Rational, rational};

    /// Chebyshev polynomials at 1/3, and what the coefficients make of them, against powers and their sums: for even and odd numbers.
    #[test]
    fn coefficients_make_powers_and_their_sums() {
        for steps in [1000, 1001, 4096] {
            let degree = degree_for(steps, 2);
            let coefficients = Coefficients::<2>::new(steps, degree);
            let unit = Rational::new(BigInt::from(1), BigInt::from(1) << 128);
            for z in [rational(1, 1), rational(-1, 1), rational(1, 3), rational(-99, 100)] {
                let (mut before, mut now) = (rational(1, 1), z.clone());
                let (mut power, mut sum) = (rational(0, 1), rational(0, 1));
                for (p, q) in coefficients.powers.iter().zip(&coefficients.sums) {
                    power += Rational::from_integer(p.unsigned()) * &unit * &before;
                    sum += Rational::from_integer(q.unsigned()) * &unit * &before;
                    // Exact numbers would get long.
                    let next = round(&(&now * &z * rational(2, 1) - &before));
                    (before, now) = (now, next);
                }
                let exact = (0..steps).fold((rational(1, 1), rational(0, 1)), |(p, q), _| (round(&(&p * &z)), q + p));
                let off = |a: Rational, b: Rational| (a - b).to_f64().expect("a number").abs();
                let scale = Rational::from_integer(BigInt::from(1) << coefficients.scale);
                assert!(off(power, exact.0) < 1e-33, "{steps} {z}");
                assert!(off(sum * scale, exact.1) < 1e-28, "{steps} {z}");
            }
        }
    }

    fn round(x: &Rational) -> Rational {
        let unit: BigInt = BigInt::from(1) << 300;
        Rational::new((x * Rational::from_integer(unit.clone())).floor().to_integer(), unit)
    }
}
