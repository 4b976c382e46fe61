//! Files of flocks: what is read, and what is refused in which words.

use arithmetic::rational;
use models::averaging::read::{Model, read_flock};
use models::averaging::{Hysteresis, Weights};

const D: &str =
    r#"{"model": "D", "weights": "vicsek", "positions": [[0, "1/3"], [2, 2]], "velocities": [[0, 1], [1, 0]]}"#;
const K: &str = r#"{"model": "K", "speed": "1/10", "headings": ["0", "1/2"], "positions": [[0, 1], [2, 3]]}"#;

#[test]
fn fields_are_read_as_they_are_written() {
    let with = |more: &str| D.replace("}", &format!(", {more}}}"));
    for (weights, known) in [
        ("\"vicsek\"", Weights::Vicsek),
        ("\"lazy\"", Weights::Lazy),
        ("{\"c\": [\"1/3\", 0.5]}", Weights::Given(vec![rational(1, 3), rational(1, 2)])),
    ] {
        let file = read_flock(&D.replace("\"vicsek\"", weights)).expect("a flock");
        let Model::D { start, control: None } = file.model else { panic!("{file:?}") };
        assert_eq!((start.weights, start.hysteresis, file.ids), (known, Hysteresis::None, None));
    }
    let ids = |text: &str| read_flock(text).expect("a flock").ids;
    // Names that are no texts are kept as they are written.
    assert_eq!(ids(&with("\"ids\": [\"left\", 7]")), Some(vec!["left".to_string(), "7".to_string()]));
    assert_eq!(ids(K), None);
    // One bird alone, of which the dimension is known.
    let alone =
        r#"{"model": "D", "dimension": 3, "weights": "lazy", "positions": [[0, 1, 2]], "velocities": [[0, 1, 2]]}"#;
    let Model::D { start, .. } = read_flock(alone).expect("a flock").model else { panic!("{alone}") };
    assert_eq!(start.positions, [[0, 1, 2].map(|x| rational(x, 1))]);
}

#[test]
fn files_are_refused_in_words() {
    let rows = "should be a list with one list of coordinates for each bird";
    for (text, from, to, said) in [
        (D, "[[0, \"1/3\"], [2, 2]]", "7", format!("`positions` {rows}")),
        (D, "[2, 2]", "2", format!("`positions` {rows}")),
        (D, "[[0, 1], [1, 0]]", "{}", format!("`velocities` {rows}")),
        (D, "[[0, 1], [1, 0]]", "[[0, 1], null]", format!("`velocities` {rows}")),
        (D, "\"vicsek\"", "{\"c\": [1, 1], \"d\": 1}", "`weights` should be \"lazy\", \"vicsek\" or".to_string()),
        (D, "}", ", \"control\": 1}", "`control` should be a list of the rows of a matrix".to_string()),
        (D, "}", ", \"hysteresis\": \"-1/2\"}", "negative".to_string()),
        (K, "[2, 3]", "[2, 3, 4]", "bird 2".to_string()),
        (K, "[2, 3]", "[2]", "bird 2".to_string()),
        (K, "[0, 1]", "[0]", "bird 1".to_string()),
    ] {
        let error = read_flock(&text.replace(from, to)).expect_err(to).to_string();
        assert!(error.contains(&said), "{error}: it does not say {said}");
    }
    let three = read_flock(&K.replace("[2, 3]", "[2, 3, 4]")).expect_err("three coordinates").to_string();
    assert!(three.contains('2') && three.contains('3'), "{three}");
}
