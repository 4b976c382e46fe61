use campaign::draws::{Draws, shrunk};

#[test]
fn a_stream_depends_on_version_text_and_case() {
    let stream = |version: &str, text: &str, case: u64| {
        let mut draws = Draws::random(version, text, case);
        (0..8).map(|_| draws.below(1 << 40)).collect::<Vec<_>>()
    };
    let first = stream("1", "a", 0);
    assert_eq!(first, stream("1", "a", 0));
    for other in [stream("2", "a", 0), stream("1", "b", 0), stream("1", "a", 1)] {
        assert_ne!(first, other);
    }
}

#[test]
fn what_was_taken_gives_the_same_again() {
    let make = |draws: &mut Draws| (draws.between(3, 9), draws.once_in(3), *draws.choice(&[1, 2, 3]), draws.below(0));
    let mut random = Draws::random("1", "again", 3);
    let made = make(&mut random);
    assert_eq!(make(&mut Draws::given(random.taken())), made);
    assert_eq!(make(&mut Draws::given(&[])), (3, false, 1, 0));
}

/// Lists that contain two numbers above 10 somewhere: the smallest of them is found.
#[test]
fn shrinking_finds_the_simplest() {
    let start: Vec<u64> = (0..60).map(|k| k * 7919 % 100).collect();
    let fails = |list: &[u64]| list.iter().filter(|x| **x > 10).count() >= 2;
    assert_eq!(shrunk(&start, 5000, fails), [11, 11]);
    // Nothing simpler is tried than allowed.
    assert_eq!(shrunk(&start, 0, fails), start);
}

/// A count followed by as many numbers: one of them is 5 or more.
#[test]
fn shrinking_lowers_counts() {
    let fails = |list: &[u64]| {
        let mut draws = Draws::given(list);
        let count = draws.below(20);
        (0..count).any(|_| draws.below(100) >= 5)
    };
    let start = [12, 3, 4, 1, 2, 3, 4, 2, 99, 4, 3, 2, 1];
    assert_eq!(shrunk(&start, 5000, fails), [1, 5]);
}
