//! Shares found in samples.

/// The 95% confidence interval of a share of which `found` of `of` cases were seen (Wilson 1927); all of `[0, 1]` for no cases.
pub fn wilson(found: usize, of: usize) -> (f64, f64) {
    // The 97.5% quantile of the normal distribution.
    const Z: f64 = 1.959_963_984_540_054;
    if of == 0 {
        return (0.0, 1.0);
    }
    let (n, p) = (of as f64, found as f64 / of as f64);
    let middle = (p + Z * Z / (2.0 * n)) / (1.0 + Z * Z / n);
    let half = Z / (1.0 + Z * Z / n) * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
    // At the ends the bound is exact but for rounding.
    let (low, high) = ((middle - half).max(0.0), (middle + half).min(1.0));
    (if found == 0 { 0.0 } else { low }, if found == of { 1.0 } else { high })
}
