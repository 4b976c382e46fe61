//! Histograms with equal bins.

/// Counts in equal bins between two ends; the last bin contains its upper end.
#[derive(Debug, Clone, PartialEq)]
pub struct Histogram {
    /// Lower and upper end.
    pub range: (f64, f64),
    /// A count for each bin.
    pub counts: Vec<u64>,
    /// Values below the range and above it.
    pub outside: (u64, u64),
}

impl Histogram {
    /// An empty histogram.
    pub fn new(low: f64, high: f64, bins: usize) -> Self {
        Histogram { range: (low, high), counts: vec![0; bins.max(1)], outside: (0, 0) }
    }

    /// The histogram of some values.
    pub fn of(low: f64, high: f64, bins: usize, values: impl IntoIterator<Item = f64>) -> Self {
        let mut histogram = Histogram::new(low, high, bins);
        values.into_iter().for_each(|x| histogram.add(x));
        histogram
    }

    /// Counts a value; what is not a number is in no bin and outside on no side, so it is not counted.
    pub fn add(&mut self, x: f64) {
        if x.is_nan() {
            return;
        }
        // Potentials reach the ends of their range up to rounding.
        const ROUNDING: f64 = 1e-12;
        let (low, high) = self.range;
        let place = (x - low) / (high - low);
        if place < -ROUNDING {
            self.outside.0 += 1;
        } else if place > 1.0 + ROUNDING {
            self.outside.1 += 1;
        } else {
            let bins = self.counts.len();
            self.counts[((place.max(0.0) * bins as f64) as usize).min(bins - 1)] += 1;
        }
    }

    /// Adds the counts of another histogram with the same bins.
    pub fn merge(&mut self, other: &Histogram) {
        self.counts.iter_mut().zip(&other.counts).for_each(|(a, b)| *a += b);
        self.outside = (self.outside.0 + other.outside.0, self.outside.1 + other.outside.1);
    }

    /// How many values were counted.
    pub fn total(&self) -> u64 {
        self.counts.iter().sum::<u64>() + self.outside.0 + self.outside.1
    }

    /// Lower end, upper end, count and share of each bin.
    pub fn bins(&self) -> impl Iterator<Item = (f64, f64, u64, f64)> + '_ {
        let (low, high) = self.range;
        let bins = self.counts.len() as f64;
        let total = self.total().max(1) as f64;
        let edge = move |i: usize| low + (high - low) * i as f64 / bins;
        self.counts.iter().enumerate().map(move |(i, &count)| (edge(i), edge(i + 1), count, count as f64 / total))
    }

    /// The outline of the shares, for plotting.
    pub fn outline(&self) -> Vec<(f64, f64)> {
        let mut points = vec![(self.range.0, 0.0)];
        points.extend(self.bins().flat_map(|(from, to, _, share)| [(from, share), (to, share)]));
        points.push((self.range.1, 0.0));
        points
    }
}
