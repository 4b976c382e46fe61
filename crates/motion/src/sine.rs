//! Sines and cosines of many angles at once, by code that the compiler vectorises.
//!
//! **Error.** `x - k pi/2` with `pi/2` in three parts of 33 bits: the products are exact for `k < 2^20`, the first difference is exact, and
//! two roundings and the part left out move the rest `r`, `|r| < 0.79`, by less than `2^-53`. The polynomials (those of fdlibm,
//! Sun Microsystems 1993) are within `2^-58` of the functions, their rounding stays below `2 ulp`, and so the results are within
//! [`SINE_ERROR`].

use super::CHUNK;
use std::f64::consts::FRAC_2_PI;

/// Bound of the absolute error of the sines and cosines.
pub const SINE_ERROR: f64 = 2.0 * f64::EPSILON;

/// Up to this size of the angle, in radians, the fast code is used; beyond, that of the standard library.
pub const LARGEST_FAST_ANGLE: f64 = 8e5;

const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21];

/// Adding it rounds to an integer, which then stands in the lowest bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

#[inline(always)]
fn polynomials(r: f64) -> (f64, f64) {
    let z = r * r;
    let s = -2.505_076_025_340_686_3e-8 + z * 1.589_690_995_211_55e-10;
    let s = 8.333_333_333_322_49e-3 + z * (-1.984_126_982_985_795e-4 + z * (2.755_731_370_707_006_8e-6 + z * s));
    let s = r + r * (z * (-1.666_666_666_666_663_2e-1 + z * s));
    let c = 2.087_572_321_298_175e-9 + z * -1.135_964_755_778_819_5e-11;
    let c = -1.388_888_888_887_411e-3 + z * (2.480_158_728_947_673e-5 + z * (-2.755_731_435_139_066_3e-7 + z * c));
    let c = 1.0 - z * (0.5 - z * (4.166_666_666_666_66e-2 + z * c));
    (s, c)
}

#[inline(always)]
fn sin_cos(x: f64) -> (f64, f64) {
    let shifted = x * FRAC_2_PI + ROUND;
    let (k, quadrant) = (shifted - ROUND, shifted.to_bits());
    let r = ((x - k * HALF_PI[0]) - k * HALF_PI[1]) - k * HALF_PI[2];
    let (s, c) = polynomials(r);
    let (s, c) = (s.to_bits(), c.to_bits());
    // Odd quadrants exchange the two; the second bit is the sign.
    let odd = 0u64.wrapping_sub(quadrant & 1);
    let sine = ((s & !odd) | (c & odd)) ^ ((quadrant & 2) << 62);
    let cosine = ((c & !odd) | (s & odd)) ^ ((quadrant.wrapping_add(1) & 2) << 62);
    (f64::from_bits(sine), f64::from_bits(cosine))
}

struct Chunk<'a> {
    angles: &'a [f64],
    sines: &'a mut [f64],
    cosines: &'a mut [f64],
}

impl pulp::WithSimd for Chunk<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        for ((x, s), c) in self.angles.iter().zip(self.sines.iter_mut()).zip(self.cosines.iter_mut()) {
            (*s, *c) = sin_cos(*x);
        }
    }
}

/// The sines and cosines of all angles (radians), within [`SINE_ERROR`] up to [`LARGEST_FAST_ANGLE`]. The three slices must be of
/// the same length; what is longer is left alone. The results are the same on every processor.
pub fn sin_cos_of(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    let arch = pulp::Arch::new();
    for ((angles, sines), cosines) in angles.chunks(CHUNK).zip(sines.chunks_mut(CHUNK)).zip(cosines.chunks_mut(CHUNK)) {
        // NaN goes the slow way too.
        if angles.iter().all(|x| x.abs() <= LARGEST_FAST_ANGLE) {
            arch.dispatch(Chunk { angles, sines, cosines });
        } else {
            angles.iter().zip(sines).zip(cosines).for_each(|((x, s), c)| (*s, *c) = x.sin_cos());
        }
    }
}
