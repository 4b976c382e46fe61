//! The minimum of a function of one variable by golden sections.

/// The place and the least value of `f` in `[a, b]`, right where `f` has one minimum there: after `most` sections, or once the bracket
/// is no longer than `width` times the size of its ends.
///
/// # Errors
/// Those of `f`.
pub fn golden<E>(
    (mut a, mut b): (f64, f64),
    most: usize,
    width: f64,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<(f64, f64), E> {
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    let (mut c, mut d) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut at_c, mut at_d) = (f(c)?, f(d)?);
    for _ in 0..most {
        if b - a <= width * (a.abs() + b.abs()) {
            break;
        }
        if at_c < at_d {
            (b, d, at_d) = (d, c, at_c);
            c = b - ratio * (b - a);
            at_c = f(c)?;
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + ratio * (b - a);
            at_d = f(d)?;
        }
    }
    Ok(if at_c < at_d { (c, at_c) } else { (d, at_d) })
}
