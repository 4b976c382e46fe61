//! What is measured on a motion as functions of one number, where its state is known as quotients of polynomials in it, and as functions of the state and the time.

use super::at::At;
use super::exact::Holds;
use super::laws::{HeadingLaw, ParticleLaw, PhaseLaw, PlatoonLaw};
use super::{MotionSubject, Start};
use crate::names::Quantity;
use crate::number::Number as Known;
use crate::subject::measured::index_of;
use crate::timeline::{Curve, Field, Formulas, Piece};
use arithmetic::{Field as _, FloatInterval, Rational, Ring};
use models::double_integrator::{FixedNetwork, Pair};
use motion::System;
use motion::enclose::Expanded;
use num_traits::Zero;
use polynomials::{Extension, Function, Side, Symbolic};
use scenario::{Amount, ExactMotion, measure};

/// The states at the times of a piece, and the range of the number that they depend on.
pub(super) struct OnCurve<'m, 'c> {
    pub at: At<'m, 'c, Symbolic>,
    pub range: Side,
}

/// The numbers of the state as they are, their rates, and what they and the time range over.
pub(super) struct OnStates<'m, 'c> {
    at: At<'m, 'c, Symbolic>,
    rates: Vec<Symbolic>,
    region: Vec<Side>,
    enclosed: Vec<Expanded>,
}

impl Formulas for At<'_, '_, Symbolic> {
    fn number(&self, q: &Rational) -> Option<Symbolic> {
        Some(self.state.first()?.rational(q))
    }

    fn amount(&self, quantity: &Quantity, arguments: &[Known]) -> Option<Amount<Symbolic>> {
        let index = index_of(quantity, arguments).ok()?;
        let mut amount = measure(quantity.name, &self.view(index)?).ok()??;
        while let Amount::List(list) = amount {
            amount = list.into_iter().nth(index - 1)?;
        }
        Some(amount)
    }

    fn own(&self, name: &str) -> Option<Symbolic> {
        let ExactMotion::Own(own) = self.motion else { return None };
        own.with_links(self.pairs.as_deref().map_or(&[], Vec::as_slice)).number(name, &self.state)?.ok()
    }
}

/// Formulas of the states in it.
macro_rules! formulas {
    ($name:ident) => {
        impl Formulas for $name<'_, '_> {
            fn number(&self, q: &Rational) -> Option<Symbolic> {
                Formulas::number(&self.at, q)
            }

            fn amount(&self, quantity: &Quantity, arguments: &[Known]) -> Option<Amount<Symbolic>> {
                self.at.amount(quantity, arguments)
            }

            fn own(&self, name: &str) -> Option<Symbolic> {
                Formulas::own(&self.at, name)
            }
        }
    };
}

formulas!(OnCurve);
formulas!(OnStates);

impl Curve for OnCurve<'_, '_> {
    fn range(&self) -> &Side {
        &self.range
    }
}

impl Field for OnStates<'_, '_> {
    fn region(&self) -> &[Side] {
        &self.region
    }

    fn rates(&self) -> &[Symbolic] {
        &self.rates
    }

    /// Of one that depends on the time by intervals; of others as a polynomial in the start.
    fn least(&self, function: &Symbolic) -> Option<f64> {
        if function.depends_on().last().is_some_and(|last| last + 1 < self.region.len()) {
            let time = self.enclosed.first()?.zero();
            let states: Vec<Expanded> = self.enclosed.iter().cloned().chain([time]).collect();
            return Some(function.value(&states).ok()?.range().lo());
        }
        let number = |side: &Side| {
            Some(super::numbers::point(side.lo.as_ref()?).hull(&super::numbers::point(side.hi.as_ref()?)))
        };
        let numbers = self.region.iter().map(number).collect::<Option<Vec<FloatInterval>>>()?;
        Some(function.value(&numbers).ok()?.lo())
    }

    fn squares(&self) -> Option<Vec<Symbolic>> {
        Some(self.at.view(1)?.positions.squares().collect())
    }

    fn links(&self) -> &[Pair] {
        self.at.pairs.as_deref().map_or(&[], Vec::as_slice)
    }
}

impl<'c> MotionSubject<'c> {
    /// The states of a piece as they are, with their rates; nothing where links change in it.
    pub(super) fn on_states(&self, piece: &Piece) -> Option<OnStates<'_, 'c>> {
        let (enclosed, pairs) = self.modal().is_none().then(|| self.enclosed_at(piece).ok())??;
        let pairs = pairs?;
        let to = piece.to.clone()?;
        let starts = (piece.from.is_zero() && to.is_zero()).then(|| self.starts()).flatten();
        let mut region = starts.unwrap_or_else(|| enclosed.iter().map(|x| between(&x.range())).collect());
        region.push(Side::between(piece.from.clone(), to));
        let mut state = Extension::of_many_denominators(region.len()).arguments();
        let time = state.pop()?;
        let mut rates = self.rates(&time, &state, &pairs)?;
        rates.push(time.one());
        let at = At { subject: self, motion: &self.motion, holds: Holds::Conserved, state, pairs: Some(pairs) };
        (rates.len() == region.len()).then_some(OnStates { at, rates, region, enclosed })
    }

    fn rates(&self, time: &Symbolic, state: &[Symbolic], pairs: &[Pair]) -> Option<Vec<Symbolic>> {
        let rates = match &self.motion {
            ExactMotion::Velocities { potential, headings: None, .. } => {
                FixedNetwork { potential, edges: pairs }.rate(time, state)
            }
            ExactMotion::Velocities { potential, .. } => HeadingLaw { potential, edges: pairs }.rate(time, state),
            ExactMotion::Phases { frequency, gain, network, .. } => {
                PhaseLaw { frequency, gain, network, constants: self.constants() }.rate(time, state)
            }
            ExactMotion::Particles { frequency, gain, spacing, drift, network, .. } => {
                let (steering, constants) = ((frequency, gain, spacing), self.constants());
                ParticleLaw { steering, drift, network, constants }.rate(time, state)
            }
            ExactMotion::Own(own) => own.with_links(pairs).rate(time, state),
            ExactMotion::Platoon { platoon, swing, .. } => {
                PlatoonLaw { platoon, frequency: &swing.1, constants: self.constants() }.rate(time, state)
            }
            ExactMotion::Other(_) => return None,
        };
        rates.ok()
    }

    /// What the numbers of the start range over, where the state has no others.
    pub(super) fn starts(&self) -> Option<Vec<Side>> {
        let mut sides: Vec<Side>;
        match &self.motion {
            ExactMotion::Velocities { positions, velocities, headings: None, .. } => {
                let numbers = positions.concat().into_iter().chain(velocities.concat());
                sides = numbers.map(Side::point).collect();
                for (list, agent, coordinate, lo, hi) in &self.wide {
                    let first = match list {
                        Start::Positions => 0,
                        Start::Velocities => 2 * positions.len(),
                        _ => return None,
                    };
                    *sides.get_mut(first + 2 * agent + coordinate)? = Side::between(lo.clone(), hi.clone());
                }
            }
            ExactMotion::Own(own) => {
                sides = own.start.iter().cloned().map(Side::point).collect();
                for (list, agent, coordinate, lo, hi) in &self.wide {
                    let place = own.place(list.part(), *agent, *coordinate)?;
                    *sides.get_mut(place)? = Side::between(lo.clone(), hi.clone());
                }
            }
            _ => return None,
        }
        Some(sides)
    }
}

fn between(x: &FloatInterval) -> Side {
    let end = |x: f64| Rational::from_float(x);
    Side { lo: end(x.lo()), hi: end(x.hi()), integer: false }
}
