//! Rows whose value obeys an equation of its own: `row A = -rate row` in every mode. Their bound is exact, and told apart from values that are attained
//! (`notes/reach.md`, rows of their own).

use crate::prepared::Motion;
use crate::system::Range;
use arithmetic::Rational;
use num_traits::{Signed, Zero};

/// What the equation says.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Relaxed {
    /// No value is above it. Where it is above `begun`, no motion attains it.
    pub most: Rational,
    /// The greatest value at time 0, which is attained.
    pub begun: Rational,
    /// Whether the value never changes.
    pub stays: bool,
}

/// A mode: `y' = -rate y + f` with `f` between two numbers.
struct Equation {
    rate: Rational,
    forcing: Range,
}

/// What the equation of a row says of its greatest value, whatever the inputs and the switching; none where it has none of its own, or grows.
///
/// Let `b` be at least the greatest value at time 0, with `f <= rate b` in every mode. Then `z = b - y` has `z' >= -rate z`, and so never falls below 0; where it is
/// above 0 at time 0, it is so at all times.
pub(crate) fn relaxed(motions: &[Motion], start: &[Range], row: &[Rational]) -> Option<Relaxed> {
    let still: Vec<bool> = (0..row.len()).map(|i| motions.iter().all(|motion| motion.stands(i))).collect();
    let equations = motions.iter().map(|motion| equation(motion, start, row, &still)).collect::<Option<Vec<_>>>()?;
    let greatest = |(x, side): (&Rational, &Range)| (x * &side.lo).max(x * &side.hi);
    let begun: Rational = row.iter().zip(start).map(greatest).sum();
    let limits = equations.iter().filter(|own| own.rate.is_positive()).map(|own| &own.forcing.hi / &own.rate);
    let most = limits.fold(begun.clone(), Rational::max);
    let is_kept = equations.iter().all(|own| own.forcing.hi <= &own.rate * &most);
    let stays = equations.iter().all(|own| own.rate.is_zero() && own.forcing == Range::point(Rational::ZERO));
    is_kept.then_some(Relaxed { most, begun, stays })
}

/// The equation in one mode. States that stand still are inputs within their ranges.
fn equation(motion: &Motion, start: &[Range], row: &[Rational], still: &[bool]) -> Option<Equation> {
    let column = |j: usize| row.iter().zip(&motion.a).map(|(x, own)| x * &own[j]).sum::<Rational>();
    let driven: Vec<Rational> = (0..row.len()).map(column).collect();
    let moving = || (0..row.len()).filter(|&j| !still[j]);
    let rate = moving().find(|&j| !row[j].is_zero()).map_or(Rational::ZERO, |j| -(&driven[j] / &row[j]));
    if moving().any(|j| driven[j] != -(&rate * &row[j])) {
        return None;
    }
    let product = |column: &[Rational]| row.iter().zip(column).map(|(x, c)| x * c).sum::<Rational>();
    let mut forcing = Range::point(product(&motion.drift));
    let parts = motion
        .pushes
        .iter()
        .map(|push| (product(&push.column), &push.centre - &push.radius, &push.centre + &push.radius));
    let held = (0..row.len()).filter(|&j| still[j]).map(|j| {
        let factor = &driven[j] + &rate * &row[j];
        (factor, start[j].lo.clone(), start[j].hi.clone())
    });
    for (factor, lo, hi) in parts.chain(held) {
        let (a, b) = (&factor * lo, &factor * hi);
        forcing = Range { lo: forcing.lo + a.clone().min(b.clone()), hi: forcing.hi + a.max(b) };
    }
    Some(Equation { rate, forcing })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prepared::Push;
    use arithmetic::rational;

    fn q(list: &[i64]) -> Vec<Rational> {
        list.iter().map(|x| rational(*x, 1)).collect()
    }

    fn motion(a: &[&[i64]], column: &[i64]) -> Motion {
        let push = Push { input: 0, centre: rational(0, 1), radius: rational(1, 1), column: q(column) };
        Motion { a: a.iter().map(|row| q(row)).collect(), drift: q(&vec![0; a.len()]), pushes: vec![push] }
    }

    fn ranges(list: &[(i64, i64)]) -> Vec<Range> {
        list.iter().map(|(lo, hi)| Range { lo: rational(*lo, 1), hi: rational(*hi, 1) }).collect()
    }

    /// `y' = -2 y + 3 u`, `x' = -x + u`: of two modes the larger limit counts.
    #[test]
    fn rows_relax_to_the_larger_limit() {
        let modes = [motion(&[&[-1]], &[1]), motion(&[&[-2]], &[3])];
        let found = relaxed(&modes, &ranges(&[(0, 0)]), &q(&[1])).expect("an equation");
        assert_eq!((found.most, found.begun, found.stays), (rational(3, 2), rational(0, 1), false));
        let found = relaxed(&modes, &ranges(&[(-1, 2)]), &q(&[1])).expect("an equation");
        assert_eq!((found.most, found.begun), (rational(2, 1), rational(2, 1)));
    }

    /// What grows has no bound, and a row that leads to others has no equation.
    #[test]
    fn others_have_none() {
        assert_eq!(relaxed(&[motion(&[&[0]], &[1])], &ranges(&[(0, 0)]), &q(&[1])), None);
        assert_eq!(relaxed(&[motion(&[&[1]], &[1])], &ranges(&[(-1, 0)]), &q(&[1])), None);
        assert_eq!(relaxed(&[motion(&[&[-1, 1], &[0, -1]], &[0, 1])], &ranges(&[(0, 0), (0, 0)]), &q(&[1, 0])), None);
        // It grows away from below: x' = x + u from at most -2 never comes back to -2.
        let found = relaxed(&[motion(&[&[1]], &[1])], &ranges(&[(-3, -2)]), &q(&[1])).expect("an equation");
        assert_eq!(found.most, rational(-2, 1));
    }

    /// An unknown constant drives: `x' = -x + k`, `k` in [1, 2].
    #[test]
    fn unknown_constants_are_inputs() {
        let modes = [motion(&[&[-1, 1], &[0, 0]], &[0, 0])];
        let found = relaxed(&modes, &ranges(&[(0, 0), (1, 2)]), &q(&[1, 0])).expect("an equation");
        assert_eq!(found.most, rational(2, 1));
        let found = relaxed(&modes, &ranges(&[(0, 0), (1, 2)]), &q(&[0, 1])).expect("an equation");
        assert_eq!((found.most, found.stays), (rational(2, 1), true));
    }
}
