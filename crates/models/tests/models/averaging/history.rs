//! Networks over time: how many there are, when they change, and the one of the four birds.

use algebra::graph::Graph;
use models::averaging::{Hysteresis, NetworkHistory, Start};

#[test]
fn all_histories_are_there_and_constant_at_the_end() {
    for history in NetworkHistory::all(3, 2) {
        let last = history.constant_from();
        assert_eq!(history.graphs().len(), last);
        assert_eq!(history.at(last), history.at(last + 9));
        assert_eq!(history.changes(2, 9), last - 1, "two networks that differ, or one");
        assert_eq!(history.changes_within(&[0, 1, 2], 2, 9), last - 1);
    }
    assert_eq!(NetworkHistory::all(3, 2).count(), 64);
}

#[test]
fn the_four_birds_change_at_every_step_without_hysteresis() {
    let history = NetworkHistory::of_flock(&Start::four_birds(Hysteresis::None), 6).expect("an exact flock");
    assert_eq!(history.order(), 4);
    assert_eq!(history.changes(2, 6), 5);
}

#[test]
fn columns_grow_until_everybody_is_reached() {
    let path = NetworkHistory::all(3, 1).find(|h| *h.at(1) == Graph::path(3)).expect("the path is one of the eight");
    // From the end of the path of three: two birds at once, the third one step later.
    assert_eq!(path.growth_times(0, 1), [1, 2]);
    assert_eq!(path.growth_times(9, 1), [1]);
    assert_eq!(path.stabilisers(2).len(), 2);
}
