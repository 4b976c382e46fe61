//! Ranges, ticks and their labels.

use super::Axis;

/// An axis with its range settled: data to the unit interval.
#[derive(Debug, Clone)]
pub(super) struct Scale {
    pub low: f64,
    pub high: f64,
    pub logarithmic: bool,
    /// Numbers with labels.
    pub major: Vec<(f64, String)>,
    /// Numbers with a short line only.
    pub minor: Vec<f64>,
}

impl Scale {
    /// The scale of `axis` for these numbers, with about `wanted` ticks.
    pub fn new(axis: &Axis, numbers: impl Iterator<Item = f64>, wanted: usize) -> Self {
        let usable = numbers.filter(|x| x.is_finite() && (!axis.logarithmic || *x > 0.0));
        let (low, high) = usable.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        let (low, high) = axis.range.unwrap_or_else(|| padded(low, high, axis.logarithmic));
        let mut scale = Scale { low, high, logarithmic: axis.logarithmic, major: Vec::new(), minor: Vec::new() };
        let (major, minor) = match &axis.ticks {
            Some(ticks) => (ticks.clone(), Vec::new()),
            None if axis.logarithmic => logarithmic_ticks(low, high, wanted),
            None => (linear_ticks(low, high, wanted), Vec::new()),
        };
        let inside = |x: &f64| (-1e-9..=1.0 + 1e-9).contains(&scale.place(*x));
        let major: Vec<f64> = major.into_iter().filter(inside).collect();
        let minor = minor.into_iter().filter(inside).collect();
        scale.major = labels(&major, axis.logarithmic);
        scale.minor = minor;
        scale
    }

    /// Where a number lies, 0 at the low end and 1 at the high end.
    pub fn place(&self, x: f64) -> f64 {
        if self.logarithmic {
            (x / self.low).ln() / (self.high / self.low).ln()
        } else {
            (x - self.low) / (self.high - self.low)
        }
    }
}

/// A little room around the data.
fn padded(low: f64, high: f64, logarithmic: bool) -> (f64, f64) {
    if low > high {
        return if logarithmic { (0.1, 1.0) } else { (0.0, 1.0) };
    }
    if logarithmic {
        let room = (high / low).powf(0.04).max(1.05);
        return (low / room, high * room);
    }
    let room = if high > low { 0.04 * (high - low) } else { 0.5 * high.abs().max(1.0) };
    (low - room, high + room)
}

fn linear_ticks(low: f64, high: f64, wanted: usize) -> Vec<f64> {
    let raw = (high - low) / wanted.max(2) as f64;
    let decade = 10f64.powf(raw.log10().floor());
    let step =
        [1.0, 2.0, 2.5, 5.0].iter().map(|m| m * decade).find(|step| *step >= raw * 0.999).unwrap_or(10.0 * decade);
    let (first, last) = ((low / step - 1e-9).ceil() as i64, (high / step + 1e-9).floor() as i64);
    (first..=last).map(|k| k as f64 * step).collect()
}

/// Powers of ten where there are enough of them, otherwise 1, 2, 5 times them.
fn logarithmic_ticks(low: f64, high: f64, wanted: usize) -> (Vec<f64>, Vec<f64>) {
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    let decades = (high / low).log10();
    let at = |digits: &[i32], every: i32| -> Vec<f64> {
        let powers = (first..=last).filter(|k| k.rem_euclid(every) == 0);
        powers.flat_map(|k| digits.iter().map(move |d| f64::from(*d) * 10f64.powi(k)).collect::<Vec<_>>()).collect()
    };
    let every = ((decades / (wanted.max(2) + 1) as f64).ceil() as i32).max(1);
    let fine = [2, 3, 4, 5, 6, 7, 8, 9];
    if decades < 1.0 {
        return (linear_ticks(low, high, wanted), Vec::new());
    }
    if decades < 2.5 {
        return (at(&[1, 2, 5], 1), at(&fine, 1));
    }
    (at(&[1], every), if every == 1 { at(&fine, 1) } else { at(&[1], 1) })
}

/// Labels with as many decimals as the ticks need; powers of ten where the numbers are far from one.
fn labels(ticks: &[f64], logarithmic: bool) -> Vec<(f64, String)> {
    let largest = ticks.iter().fold(0f64, |m, x| m.max(x.abs()));
    let smallest = ticks.iter().filter(|x| x.abs() > 1e-12 * largest).fold(f64::INFINITY, |m, x| m.min(x.abs()));
    let far = if logarithmic { largest > 2e4 || smallest < 1e-3 } else { !(1e-3..1e5).contains(&largest) };
    let decimals = |numbers: &[f64]| {
        let exact = |places: &usize| {
            let unit = 10f64.powi(*places as i32);
            numbers.iter().all(|x| ((x * unit).round() - x * unit).abs() < 1e-6 * (x.abs() * unit).max(1e-3))
        };
        (0..8).find(exact).unwrap_or(8)
    };
    let common = decimals(ticks);
    let label = |x: f64| match () {
        () if far => scientific(x),
        // On a logarithmic axis each label has its own decimals.
        () if logarithmic => plain(x, decimals(&[x])),
        () => plain(x, common),
    };
    ticks.iter().map(|&x| (x, label(x))).collect()
}

fn plain(x: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", x.abs());
    if x < 0.0 && text.contains(|c: char| ('1'..='9').contains(&c)) { format!("−{text}") } else { text }
}

/// A marker that the drawing turns into a raised exponent: `10^-3`.
fn scientific(x: f64) -> String {
    if x == 0.0 {
        return "0".to_string();
    }
    let exponent = x.abs().log10().floor() as i32;
    let mantissa = x / 10f64.powi(exponent);
    let (mantissa, exponent) =
        if mantissa.abs() > 9.9999 { (mantissa / 10.0, exponent + 1) } else { (mantissa, exponent) };
    let power = format!("10^{exponent}").replace('-', "−");
    if (mantissa - 1.0).abs() < 1e-6 {
        power
    } else {
        format!("{}·{power}", format!("{:.1}", mantissa).trim_end_matches(".0").replace('-', "−"))
    }
}
