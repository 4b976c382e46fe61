//! Numbers of a law that are intervals: each stands behind the state as one more number, which does not move.

use super::MotionSubject;
use super::numbers::{Start, point};
use arithmetic::{Complex, Field, FloatInterval, Rational, Ring};
use models::oscillator::{Orientation, Spacing, Steering};
use models::platoon::Platoon;
use motion::enclose::Expanded;

/// Which numbers of a built-in law stand behind the state, in this order: names as in the scenario, entries of lists from 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constants<'a>(pub &'a [(String, Option<usize>)]);

impl Constants<'_> {
    /// The state, and what stands behind it.
    pub fn split<'s, T>(&self, state: &'s [T]) -> (&'s [T], &'s [T]) {
        state.split_at(state.len().saturating_sub(self.0.len()))
    }

    fn find<'s, T>(&self, (name, entry): (&str, Option<usize>), state: &'s [T]) -> Option<&'s T> {
        let place = self.0.iter().position(|(known, own)| (known.as_str(), *own) == (name, entry))?;
        self.split(state).1.get(place)
    }

    /// A number of the law: what stands behind the state, or what is known of it.
    pub fn number<T: Field>(&self, name: &str, known: &Rational, state: &[T]) -> Option<T> {
        let found = self.find((name, None), state).cloned();
        found.or_else(|| Some(state.first()?.rational(known)))
    }

    fn entry<T: Field>(&self, (name, entry): (&str, usize), known: &Rational, state: &[T]) -> Option<T> {
        let found = self.find((name, Some(entry)), state).cloned();
        found.or_else(|| Some(state.first()?.rational(known)))
    }

    /// A vector of the law.
    pub fn vector<T: Field>(&self, name: &str, known: [&Rational; 2], state: &[T]) -> Option<[T; 2]> {
        Some([self.entry((name, 0), known[0], state)?, self.entry((name, 1), known[1], state)?])
    }

    /// What turns particles and phases, without the orientation controls that are not enclosed.
    pub fn steering<T: Field>(
        &self,
        (frequency, gain, spacing): (&Rational, &Rational, &Spacing<Rational>),
        state: &[T],
    ) -> Option<Steering<T>> {
        let spacing = match spacing {
            // The middle of the interval may be 0.
            Spacing::None => self.find(("K0", None), state).map_or(Spacing::None, |gain| Spacing::Circle(gain.clone())),
            Spacing::Circle(gain) => Spacing::Circle(self.number("K0", gain, state)?),
            Spacing::Beacon(gain, place) => {
                let [x, y] = self.vector("beacon", [&place.re, &place.im], state)?;
                Spacing::Beacon(self.number("K0", gain, state)?, Complex::new(x, y))
            }
        };
        let orientation = Orientation::Laplacian(self.number("K1", gain, state)?);
        Some(Steering { frequency: self.number("omega0", frequency, state)?, orientation, spacing })
    }

    /// Puts numbers of the law that are intervals into a platoon's start: `y_k = x_k + spacing k` by another spacing than that of the middle, and the
    /// amplitude of the swing, which stands behind deviations and rates.
    pub fn set_out(&self, middle: &Rational, state: &mut [Expanded], cars: usize) {
        if let Some(spacing) = self.find(("spacing", None), state).cloned() {
            let further = spacing.clone() - spacing.rational(middle);
            for (k, y) in state.iter_mut().take(cars).enumerate() {
                *y = y.clone() + further.clone() * further.integer(k as i64);
            }
        }
        if let Some(amplitude) = self.find(("leader.amplitude", None), state).cloned() {
            state[2 * cars] = amplitude;
        }
    }

    /// A platoon, whose gains are one number for all followers, or one for each.
    pub fn platoon<T: Field>(&self, platoon: &Platoon<Rational>, state: &[T]) -> Option<Platoon<T>> {
        let of = |name: &str, car: usize, known: &Rational| {
            self.find((name, None), state).cloned().or_else(|| self.entry((name, car), known, state))
        };
        let gains = platoon.gains().iter().enumerate();
        let gains = gains.map(|(car, own)| Some([of("f", car, &own.f)?, of("g", car, &own.g)?]));
        platoon.with_gains(gains.collect::<Option<Vec<_>>>()?)
    }
}

impl MotionSubject<'_> {
    /// The numbers of a built-in law that are intervals.
    pub(super) fn constants(&self) -> Constants<'_> {
        Constants(&self.constants)
    }

    /// Their intervals, in the same order.
    pub(super) fn ranges(&self) -> Vec<FloatInterval> {
        let constants = self.wide.iter().filter(|(list, ..)| matches!(list, Start::Constant { .. }));
        constants.map(|(.., lo, hi)| point(lo).hull(&point(hi))).collect()
    }
}

/// The names of those among the numbers that are intervals.
pub(super) fn names_of(wide: &[(Start, usize, usize, Rational, Rational)]) -> Vec<(String, Option<usize>)> {
    let name = |(list, entry, ..): &(Start, usize, usize, Rational, Rational)| match list {
        Start::Constant { name, listed } => Some((name.clone(), listed.then_some(*entry))),
        _ => None,
    };
    wide.iter().filter_map(name).collect()
}
