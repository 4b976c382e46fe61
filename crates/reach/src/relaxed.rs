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

    /// Systems of two states and a third that stands still, with `row A = -rate row` in every mode.
    struct Drawn {
        motions: Vec<Motion>,
        rates: Vec<Rational>,
        start: Vec<Range>,
        row: Vec<Rational>,
    }

    impl Drawn {
        fn new(tape: &[i64]) -> Self {
            let mut tape = tape.iter().copied().cycle();
            let mut next = move || tape.next().unwrap_or(0);
            let mut row = q(&[next(), next(), next()]);
            if row[0].is_zero() {
                row[0] = Rational::ONE;
            }
            let (mut motions, mut rates) = (Vec::new(), Vec::new());
            for _ in 0..1 + next().rem_euclid(3) {
                let rate = rational(next() + i64::from(next() > 0), 2);
                let below = q(&[next(), next(), next()]);
                let above = |j: usize| -(&rate * &row[j] + &row[1] * &below[j]) / &row[0];
                let a = vec![vec![above(0), above(1), rational(next(), 1)], below, q(&[0, 0, 0])];
                let push = Push {
                    input: 0,
                    centre: rational(next(), 2),
                    radius: rational(next().abs(), 1),
                    column: q(&[next(), next(), 0]),
                };
                motions.push(Motion { a, drift: q(&[next(), next(), 0]), pushes: vec![push] });
                rates.push(rate);
            }
            let mut range = || {
                let lo = rational(next(), 1);
                Range { hi: &lo + rational(next().abs(), 2), lo }
            };
            Drawn { motions, rates, start: vec![range(), range(), range()], row }
        }

        fn value(&self, x: &[Rational]) -> Rational {
            self.row.iter().zip(x).map(|(c, x)| c * x).sum()
        }

        fn corner(&self, which: usize) -> Vec<Rational> {
            let end =
                |(i, range): (usize, &Range)| if which >> i & 1 == 0 { range.lo.clone() } else { range.hi.clone() };
            self.start.iter().enumerate().map(end).collect()
        }

        /// The least and the greatest `f` of a mode, from the rate of the value where the states that move are 0.
        fn forcing(&self, mode: usize, x: &[Rational]) -> [Rational; 2] {
            let motion = &self.motions[mode];
            let stands = |i: usize| self.motions.iter().all(|motion| motion.stands(i));
            let held: Vec<Rational> = (0..3).map(|i| if stands(i) { x[i].clone() } else { Rational::ZERO }).collect();
            let push = &motion.pushes[0];
            let of = |u: Rational| {
                let speed = |i: usize| {
                    let moved: Rational = motion.a[i].iter().zip(&held).map(|(a, x)| a * x).sum();
                    moved + &motion.drift[i] + &push.column[i] * &u
                };
                self.value(&[speed(0), speed(1), speed(2)]) + &self.rates[mode] * self.value(&held)
            };
            let (a, b) = (of(&push.centre - &push.radius), of(&push.centre + &push.radius));
            if a <= b { [a, b] } else { [b, a] }
        }

        /// The value after a while in a mode, exactly: `factor` above 1 stands for the time `log factor / |rate|`, or where the rate is 0 for itself.
        fn after(&self, y: &Rational, mode: usize, f: &Rational, factor: &Rational) -> Rational {
            let rate = &self.rates[mode];
            if rate.is_zero() {
                return y + f * factor;
            }
            let shrink = if rate.is_positive() { factor.recip() } else { factor.clone() };
            let rest = f / rate;
            (y - &rest) * shrink + rest
        }
    }

    proptest::proptest! {
        #![proptest_config(proptest::prelude::ProptestConfig { cases: 400, ..Default::default() })]

        /// No exactly followed motion is above the bound, one comes within a thousandth of it, so that less is refuted, and what is not attained is never met.
        #[test]
        fn bounds_are_those_of_motions_that_are_followed_exactly(tape in proptest::collection::vec(-3i64..4, 97)) {
            let drawn = Drawn::new(&tape);
            let found = relaxed(&drawn.motions, &drawn.start, &drawn.row);
            let (mut best, mut limit): (Option<Rational>, Option<Rational>) = (None, None);
            let modes = drawn.motions.len();
            for which in 0..8 {
                let x = drawn.corner(which);
                let begun = drawn.value(&x);
                let forcing: Vec<[Rational; 2]> = (0..modes).map(|mode| drawn.forcing(mode, &x)).collect();
                let mut values = vec![begun.clone()];
                // At random: modes, times, inputs.
                let mut y = begun.clone();
                for step in tape.chunks(3).take(20) {
                    let mode = step[0].rem_euclid(modes as i64) as usize;
                    let f = &forcing[mode][usize::from(step[step.len() - 1] > -2)];
                    y = drawn.after(&y, mode, f, &rational(8 + step[0] + step[1].abs(), 4));
                    values.push(y.clone());
                }
                // As far up as one mode leads, and from there as far as another does.
                let far = rational(1_000_000_000, 1);
                for (first, second) in (0..modes).flat_map(|i| (0..modes).map(move |j| (i, j))) {
                    let y = drawn.after(&begun, first, &forcing[first][1], &far);
                    values.push(drawn.after(&y, second, &forcing[second][1], &far));
                    values.push(y);
                }
                for mode in (0..modes).filter(|&mode| drawn.rates[mode].is_positive()) {
                    limit = limit.max(Some(&forcing[mode][1] / &drawn.rates[mode]));
                }
                limit = limit.max(Some(begun.clone()));
                if let Some(found) = &found {
                    for y in &values {
                        proptest::prop_assert!(*y <= found.most, "{y} > {found:?}");
                        proptest::prop_assert!(*y < found.most || found.most == found.begun, "{y} is attained: {found:?}");
                        proptest::prop_assert!(!found.stays || *y == begun, "{y} moves: {found:?}");
                    }
                    proptest::prop_assert!(begun <= found.begun);
                }
                best = best.max(values.into_iter().max());
            }
            let best = best.unwrap_or_default();
            match &found {
                Some(found) => proptest::prop_assert!(best > &found.most - rational(1, 1000), "{best} far below {found:?}"),
                // What does not decay and has no bound grows beyond every limit.
                None if drawn.rates.iter().all(|rate| !rate.is_negative()) => proptest::prop_assert!(Some(best) > limit),
                None => {}
            }
        }
    }
}
