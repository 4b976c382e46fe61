//! Frequency responses as engineers look at them: moduli and phases at given frequencies, enclosed, and curves for a plot, in floating point.

use super::banded::BandedPlatoon;
use super::cars::Platoon;
use arithmetic::{
    ArithmeticError, Complex, Field, Interval, Number, Rational, Real, Ring, Sign, Signed, significant_digits,
};
use num_traits::ToPrimitive;

/// A complex amplitude by its modulus and its phase.
#[derive(Debug, Clone)]
pub struct Polar {
    /// The modulus.
    pub amplitude: Interval,
    /// The phase in radians, from above -pi to pi; around pi where the sign of a small imaginary part is not known. Nothing where the amplitude may be zero.
    pub phase: Option<Interval>,
}

impl Polar {
    /// Modulus and phase of an enclosed number.
    ///
    /// # Errors
    /// Those of roots of enclosures.
    pub fn of(z: &Complex<Interval>) -> Result<Self, ArithmeticError> {
        let amplitude = z.norm_squared().sqrt()?;
        let phase = match (z.re.sign(), z.im.sign()) {
            (Some(Sign::Positive), _) => Some(z.im.over(&z.re)?.atan()?),
            (_, Some(Sign::Positive)) => Some(half_pi(&z.re) - z.re.over(&z.im)?.atan()?),
            (_, Some(Sign::Negative)) => Some(-half_pi(&z.re) - z.re.over(&z.im)?.atan()?),
            (Some(Sign::Negative), _) => Some(z.re.pi() + z.im.over(&z.re)?.atan()?),
            _ => None,
        };
        Ok(Polar { amplitude, phase })
    }
}

fn half_pi(like: &Interval) -> Interval {
    like.pi().scaled(-1)
}

/// Bits at which an enclosure that is still too wide is given up.
const MOST_BITS: u32 = 1 << 15;

/// Modulus and phase at an angular frequency `w >= 0`, rad/s, to so many significant digits; `response` gives the amplitudes over intervals of the
/// precision of their argument.
///
/// # Errors
/// [`ArithmeticError`] where the response does not exist; of what cannot be told from a pole, too.
pub fn enclosed(
    w: &Rational,
    digits: u32,
    response: impl Fn(&Interval) -> Result<Vec<Complex<Interval>>, ArithmeticError>,
) -> Result<Vec<Polar>, ArithmeticError> {
    let mut bits = 4 * digits + 64;
    loop {
        let at = |bits: u32| response(&Interval::from_rational(w, bits))?.iter().map(Polar::of).collect();
        let found: Result<Vec<Polar>, ArithmeticError> = at(bits);
        let is_sharp = |x: &Interval| significant_digits(x) >= digits || x.width().is_zero();
        // A phase near zero has fewer digits than bits; what matters is its width in radians.
        let is_narrow = |x: &Interval| is_sharp(x) || significant_digits(&(x.clone() + x.integer(8))) >= digits;
        let is_enough = |polar: &Polar| is_sharp(&polar.amplitude) && polar.phase.as_ref().is_none_or(is_narrow);
        match found {
            Ok(all) if bits >= MOST_BITS || all.iter().all(is_enough) => return Ok(all),
            Err(error) if bits >= MOST_BITS => return Err(error),
            _ => bits *= 2,
        }
    }
}

impl Platoon<Rational> {
    /// Moduli and phases of all followers at an angular frequency `w >= 0`, rad/s, to so many significant digits. Cost: `M³` products.
    ///
    /// # Errors
    /// As [`enclosed`].
    pub fn enclosed_response(&self, w: &Rational, digits: u32) -> Result<Vec<Polar>, ArithmeticError> {
        enclosed(w, digits, |w| self.map(|q| w.rational(q)).response(w))
    }

    /// The amplitudes of these followers as functions of the frequency, in floating point.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the response does not exist, or there is no such car.
    pub fn float_response<'a>(
        &self,
        cars: &'a [usize],
    ) -> impl Fn(f64) -> Result<Vec<Complex<f64>>, ArithmeticError> + use<'a> {
        let (banded, floats) = (BandedPlatoon::of(self), self.map(|q| q.to_f64().unwrap_or(f64::NAN)));
        move |w| {
            let all = banded.response_of_cars(floats.gains(), w)?;
            let car =
                |k: &usize| all.get(k.wrapping_sub(1)).cloned().ok_or(ArithmeticError::Domain("a car of the platoon"));
            cars.iter().map(car).collect()
        }
    }
}

/// A point of several curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// The angular frequency, rad/s.
    pub w: f64,
    /// The modulus of each.
    pub amplitudes: Vec<f64>,
    /// The phase of each in radians, followed from the first sample on, whose phases are from above -pi to pi.
    pub phases: Vec<f64>,
}

/// Most samples of a curve.
const MOST_SAMPLES: usize = 20_000;

/// Samples from `low` to `high`, both positive, so close that phases do not turn by more than an eighth of a circle and amplitudes do not
/// change by more than a tenth from one to the next, as long as the floats tell; and close at the frequencies `near`, where peaks are.
///
/// # Errors
/// Those of `response`.
pub fn sampled(
    (low, high): (f64, f64),
    near: &[f64],
    response: impl Fn(f64) -> Result<Vec<Complex<f64>>, ArithmeticError>,
) -> Result<Vec<Sample>, ArithmeticError> {
    const FIRST: usize = 480;
    let ratio = (high / low).powf(1.0 / FIRST as f64);
    let mut places: Vec<f64> = (0..=FIRST).map(|k| low * ratio.powi(k as i32)).collect();
    let around = |w: &f64| (-24..=24).map(|k| w * 1.002f64.powi(k)).collect::<Vec<_>>();
    places.extend(near.iter().flat_map(around).filter(|w| (low..=high).contains(w)));
    places.sort_by(f64::total_cmp);
    places.dedup();
    let mut points: Vec<(f64, Vec<Complex<f64>>)> = Vec::with_capacity(places.len());
    for w in places {
        let next = response(w)?;
        // Halves between the last point and this one until they are close.
        let mut waiting = vec![(w, next)];
        while let Some((w, value)) = waiting.pop() {
            let far = points.last().is_some_and(|(before, last)| {
                w / before > 1.0 + 1e-9 && last.iter().zip(&value).any(|(a, b)| is_far(a, b))
            });
            match points.last() {
                Some((before, _)) if far && points.len() + waiting.len() < MOST_SAMPLES => {
                    let middle = (before * w).sqrt();
                    waiting.push((w, value));
                    waiting.push((middle, response(middle)?));
                }
                _ => points.push((w, value)),
            }
        }
    }
    Ok(followed(points))
}

/// Whether a quotient is more than an eighth of a circle or a tenth of its size away from one.
fn is_far(a: &Complex<f64>, b: &Complex<f64>) -> bool {
    let quotient = b.over(a).unwrap_or_else(|_| Complex::real(1.0));
    let size = quotient.re.hypot(quotient.im);
    size.is_finite() && size > 0.0 && (quotient.im.atan2(quotient.re).abs() > 0.785 || !(0.9..1.1).contains(&size))
}

/// Moduli and phases, these followed from point to point.
fn followed(points: Vec<(f64, Vec<Complex<f64>>)>) -> Vec<Sample> {
    let turn = 2.0 * std::f64::consts::PI;
    let mut last: Vec<f64> = Vec::new();
    let sample = |(w, values): (f64, Vec<Complex<f64>>)| {
        let phase = |(k, z): (usize, &Complex<f64>)| {
            let own = z.im.atan2(z.re);
            last.get(k).map_or(own, |before| own + turn * ((before - own) / turn).round())
        };
        let phases: Vec<f64> = values.iter().enumerate().map(phase).collect();
        last.clone_from(&phases);
        Sample { w, amplitudes: values.iter().map(|z| z.re.hypot(z.im)).collect(), phases }
    };
    points.into_iter().map(sample).collect()
}
