//! The influences of several neighbours on one agent, as series in time.

use super::law::{IndividualLaw, Moving};
use super::path::Path;
use crate::{Jet, Lanes};
use arithmetic::ArithmeticError;
use pulp::Simd;
use std::f64::consts::TAU;

/// No processor has more lanes.
const MOST_LANES: usize = 16;

/// One whom an agent is linked with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Neighbour {
    pub agent: usize,
    /// Whole turns that the law adds to this one's angle.
    pub turns: f64,
}

/// The law over series, with as many neighbours at a time as a vector of the processor has lanes. What they add comes in their order, whatever
/// the number of lanes.
pub struct Influences<'a, L, const F: usize, const M: usize, const K: usize> {
    pub law: &'a L,
    pub own: &'a Path<F>,
    pub neighbours: &'a [Neighbour],
    /// Where the series of an agent is.
    pub path: &'a dyn Fn(usize) -> &'a Path<F>,
}

impl<L: IndividualLaw<F, M>, const F: usize, const M: usize, const K: usize> pulp::WithSimd
    for Influences<'_, L, F, M, K>
{
    type Output = Result<[Jet<f64, K>; M], ArithmeticError>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let splat = |x: f64| Lanes::splat(simd, x);
        let constant = |x: f64| Jet::<_, K>::constant(splat(x));
        let own: Moving<Jet<_, K>, F> = self.own.series(splat);
        let mut total = [Jet([0.0; K]); M];
        let mut lanes = [0.0; MOST_LANES];
        for some in self.neighbours.chunks(Lanes::<S>::WIDTH) {
            // A lane too many holds the first one again.
            let mut others = [(self.path)(some[0].agent); MOST_LANES];
            let mut turns = [TAU * some[0].turns; MOST_LANES];
            for ((other, turns), one) in others.iter_mut().zip(&mut turns).zip(some) {
                (*other, *turns) = ((self.path)(one.agent), TAU * one.turns);
            }
            let mut other = own;
            for c in 0..2 {
                for k in 0..=K {
                    let theirs = Lanes::load(simd, &others.map(|path| path.place[c][k]));
                    if k < K {
                        other.position[c].0[k] = theirs;
                    }
                    if k > 0 {
                        other.velocity[c].0[k - 1] = theirs * splat(k as f64);
                    }
                }
            }
            for c in 0..F {
                for k in 0..K {
                    other.further[c].0[k] = Lanes::load(simd, &others.map(|path| path.further[c][k]));
                }
            }
            if let Some(angle) = other.further.first_mut() {
                angle.0[0] = angle.0[0] + Lanes::load(simd, &turns);
            }
            let influence = self.law.pair(&own, &other, constant)?;
            for (total, influence) in total.iter_mut().zip(&influence) {
                for (total, part) in total.0.iter_mut().zip(&influence.0) {
                    part.store(&mut lanes);
                    lanes.iter().take(some.len()).for_each(|part| *total += part);
                }
            }
        }
        Ok(total)
    }
}
