//! The root of a polynomial that is nearest to 1 from below, between 0 and 1: by Descartes' rule of signs on ever smaller pieces, from the
//! right (Collins and Akritas 1976).

use super::bernstein::{bernstein, halves, without_twos};
use super::{Polynomial, RealRoot};
use arithmetic::{Interval, Rational};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// Pieces that are not thinner are halved.
const MOST_HALVINGS: u64 = 96;

/// What there is below 1.
#[derive(Debug, Clone)]
pub enum Nearest {
    /// No root.
    None,
    /// A root, enclosed.
    Root(Interval),
    /// No root above the interval; in it there may be several, or complex ones close by.
    Unclear(Interval),
}

enum Part {
    Root(Rational),
    Piece { index: BigInt, level: u64, coefficients: Vec<BigInt> },
}

impl Polynomial {
    /// The largest root `x` with `0 < x < 1` of a polynomial that is not zero, to about so many bits.
    pub fn largest_root_below_one(&self, bits: u32) -> Nearest {
        let whole = Part::Piece { index: BigInt::ZERO, level: 0, coefficients: bernstein(self.coefficients()) };
        let mut open = vec![whole];
        while let Some(part) = open.pop() {
            let (index, level, coefficients) = match part {
                Part::Root(x) => return Nearest::Root(Interval::from_rational(&x, bits)),
                Part::Piece { index, level, coefficients } => (index, level, coefficients),
            };
            let at = |index: BigInt, level: u64| Rational::new(index, BigInt::from(1) << level);
            let ends = || (at(index.clone(), level), at(&index + 1, level));
            let is_end =
                coefficients.first().is_some_and(Zero::is_zero) || coefficients.last().is_some_and(Zero::is_zero);
            match changes(&coefficients) {
                0 => continue,
                1 if !is_end => {
                    let (lo, hi) = ends();
                    let mut root = RealRoot::between(lo, hi);
                    self.refine(&mut root, bits);
                    return Nearest::Root(root.enclosure(bits + 8));
                }
                _ if level > MOST_HALVINGS => {
                    let (lo, hi) = ends();
                    return Nearest::Unclear(Interval::hull_of_rationals(&lo, &hi, bits));
                }
                _ => {}
            }
            let (mut left, mut right) = halves(coefficients);
            without_twos(&mut [&mut left]);
            without_twos(&mut [&mut right]);
            let (index, level) = (BigInt::from(2) * index, level + 1);
            let middle = right[0].is_zero().then(|| Part::Root(at(&index + 1, level)));
            open.push(Part::Piece { index: index.clone(), level, coefficients: left });
            open.extend(middle);
            open.push(Part::Piece { index: index + 1, level, coefficients: right });
        }
        Nearest::None
    }

    /// The polynomial with the coefficients in the opposite order, whose roots other than 0 are the inverses.
    pub fn with_inverse_roots(&self) -> Self {
        Polynomial::new(self.coefficients().iter().rev().cloned().collect())
    }
}

/// Changes of sign in a list, zeros left out.
fn changes(list: &[BigInt]) -> usize {
    let signs: Vec<bool> = list.iter().filter(|c| !c.is_zero()).map(Signed::is_positive).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::rational;

    fn product(factors: &[&[i64]]) -> Polynomial {
        let mut all = vec![BigInt::from(1)];
        for factor in factors {
            let mut next = vec![BigInt::ZERO; all.len() + factor.len() - 1];
            for (i, a) in all.iter().enumerate() {
                factor.iter().enumerate().for_each(|(j, b)| next[i + j] += a * b);
            }
            all = next;
        }
        Polynomial::new(all)
    }

    #[test]
    fn roots_below_one_are_found_from_the_right() {
        let root = |factors: &[&[i64]]| match product(factors).largest_root_below_one(60) {
            Nearest::Root(x) => Some(x),
            Nearest::None => None,
            Nearest::Unclear(x) => panic!("{x}"),
        };
        for (p, q) in [(1, 3), (1, 2), (3, 4), (2, 3), (1, 1000), (999, 1000)] {
            // Also beside roots at 0, beyond 1, below 0, further left, and complex ones close by.
            for others in [&[][..], &[&[0, 1][..], &[-2, 1], &[5, 1], &[-1, 2000], &[1_000_001, -2_000_000, 1_000_000]]]
            {
                let found = root(&[others, &[&[-p, q][..]]].concat()).expect("a root");
                assert!(found.contains(&rational(p, q)) && found.width().to_f64() < 1e-15, "{p}/{q}: {found}");
            }
        }
        assert!(root(&[&[-2, 1], &[1, 1], &[0, 1], &[5, -4, 1]]).is_none() && root(&[&[7]]).is_none());
        let double = product(&[&[-1, 3], &[-1, 3]]).largest_root_below_one(60);
        assert!(matches!(double, Nearest::Unclear(x) if x.contains(&rational(1, 3))));
        let found = product(&[&[-3, 2], &[-5, 1]]).with_inverse_roots().largest_root_below_one(60);
        assert!(matches!(found, Nearest::Root(x) if x.contains(&rational(2, 3))));
    }
}
