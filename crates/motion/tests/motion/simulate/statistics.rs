//! Intervals of shares and means.

use motion::{Sample, Share};

/// The ends of Wilson's interval are the probabilities at which the share is 1.96 standard deviations away: tested as such.
#[test]
fn ends_are_roots_of_the_test() {
    for of in [1, 2, 7, 40, 1000] {
        for found in [0, 1, of / 2, of - 1, of] {
            let share = Share::new(found, of);
            let (low, high) = share.interval();
            assert!(
                (0.0..=1.0).contains(&low)
                    && (0.0..=1.0).contains(&high)
                    && low <= share.value()
                    && share.value() <= high
            );
            for end in [low, high].into_iter().filter(|end| *end > 0.0 && *end < 1.0) {
                let deviations = (share.value() - end) / (end * (1.0 - end) / of as f64).sqrt();
                assert!((deviations.abs() - 1.959_963_984_540_054).abs() < 1e-9, "{found} of {of}: {deviations}");
            }
        }
    }
}

#[test]
fn edges() {
    assert_eq!(Share::default().interval(), (0.0, 1.0));
    assert_eq!(Share::new(0, 9).interval().0, 0.0);
    assert_eq!(Share::new(9, 9).interval().1, 1.0);
    assert_eq!(Share::count([1, 2, 3, 4], |k| k > 1), Share::new(3, 4));
    assert_eq!(Share::new(7, 12).to_string(), "7 of 12 runs (95%: 0.31 to 0.81)");
    assert_eq!(Share::new(9, 9).enclosure(), "[0.700, 1.000]");
}

/// Student's quantile against tables (two-sided 5%), and the interval of a small sample by hand.
#[test]
fn means_have_the_interval_of_student() {
    for (count, quantile) in [(8, 2.3646), (11, 2.2281), (21, 2.0860), (201, 1.9719)] {
        // As many 1 as -1, and a 0 where the count is odd: the variance is known.
        let numbers: Vec<f64> = (0..count)
            .map(|k| match k {
                0 if count % 2 == 1 => 0.0,
                k if k % 2 == 0 => 1.0,
                _ => -1.0,
            })
            .collect();
        let variance = (count - count % 2) as f64 / (count - 1) as f64;
        let (low, high) = Sample::new(numbers).interval();
        let expected = quantile * (variance / count as f64).sqrt();
        assert!((high - expected).abs() < 1e-3 && (low + expected).abs() < 1e-3, "{count}: {low} {high} {expected}");
    }
}

#[test]
fn few_numbers_and_equal_ones() {
    assert_eq!(Sample::new([1.0; 7]).is_above(0.0), None);
    assert_eq!(Sample::new([1.0; 8]).interval(), (1.0, 1.0));
    assert_eq!(Sample::new([1.0; 8]).is_above(1.0), Some(false));
    assert_eq!(Sample::new([1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 2.0]).is_above(1.0), Some(true));
    assert_eq!(Sample::new([1.0, -2.0, 1.0, -2.0, 1.0, 2.0, 1.0, 2.0]).is_above(0.0), None);
    assert_eq!(Sample::default().mean(), 0.0);
}
