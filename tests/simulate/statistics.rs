//! Wilson's interval.

use flockproof::simulate::Share;

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
    assert_eq!(Share::new(7, 12).to_string(), "7 of 12 runs (95%: 0.32 to 0.81)");
    assert_eq!(Share::new(9, 9).enclosure(), "[0.701, 1.000]");
}
