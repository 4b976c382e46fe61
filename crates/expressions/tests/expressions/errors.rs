//! What is refused, in which words and where.

use super::laws::second_order;
use expressions::{Kind, LawText};

fn refusal(rate: &str) -> (String, Option<usize>) {
    let error = second_order(&[("far(i)", "norm(x[i])")], rate, &[]).compile(3).map(|_| ()).unwrap_err();
    (format!("{} {}: {error}", error.table, error.key), error.at)
}

#[test]
fn each_error_names_what_is_wrong_and_where() {
    for (rate, words, at) in [
        ("v + y", "rates v: there is no name `y`", Some(4)),
        ("v[j]", "there is no agent `j`", Some(0)),
        ("sum(j, v[k])", "there is no agent `k`; the nearest known name is `i`", Some(7)),
        ("1", "a vector is expected here, but it is a number", Some(0)),
        ("v + 1", "a vector is expected here, but it is a number", Some(4)),
        ("v * x", "`dot(a, b)` is a number", Some(4)),
        ("v.3", "a component from 1 to 2", Some(0)),
        ("K.1 * v", "`K`, the same for all agents", Some(0)),
        ("sum(i, v[i])", "the agent `i` is already bound", Some(4)),
        ("sum(j)", "`sum` takes an agent and an expression, not 1", Some(0)),
        ("mean(j, v[j]) * far(j)", "there is no agent `j`", Some(20)),
        ("nrom(v) * v", "there is no function `nrom`; the nearest known name is `norm`", Some(0)),
        ("if(v, v, x)", "something true or false is expected here, but it is a vector", Some(3)),
        ("always[0, 1](v)", "are for properties", Some(0)),
        ("v[4]", "an agent from 1 to 3", Some(0)),
        ("sqrt(v, v)", "`sqrt` takes one argument, not 2", Some(0)),
        ("v +", "is expected here, but it is the end", None),
    ] {
        let (found, place) = refusal(rate);
        assert!(found.contains(words), "{rate}: {found}");
        assert!(at.is_none() || place == at, "{rate}: {place:?}");
    }
}

#[test]
fn definitions_in_circles_and_names_given_twice() {
    let circle = [("a(i)", "b(i)"), ("b(i)", "a(i)")];
    let error = second_order(&circle, "a(i) * v", &[]).compile(2).map(|_| ()).unwrap_err();
    assert_eq!((error.key.as_str(), error.to_string().as_str()), ("b(i)", "the definition of `a` uses itself"));
    let error = second_order(&[("x", "1")], "v", &[]).compile(2).map(|_| ()).unwrap_err();
    assert!(error.to_string().contains("given twice"));
    let error = second_order(&[("sum", "1")], "v", &[]).compile(2).map(|_| ()).unwrap_err();
    assert!(error.to_string().contains("word of the language"));
    let error = second_order(&[], "v", &[("total", "sum(j, v)")]).compile(2).map(|_| ()).unwrap_err();
    assert_eq!((error.table, error.at), ("observables", Some(7)));
    assert!(error.to_string().contains("of which agent is `v`"));
    let missing = LawText { dimension: 1, state: vec![("x".to_string(), Kind::Number)], ..LawText::default() };
    assert!(missing.compile(2).map(|_| ()).unwrap_err().to_string().contains("the rate of `x` is missing"));
    let nested = format!("{}v{}", "(".repeat(10_000), ")".repeat(10_000));
    assert!(refusal(&nested).0.contains("nested more than"));
}

#[test]
fn angles_are_not_added_to_lengths() {
    let law = |rate: &str| {
        let state = vec![("x".to_string(), Kind::Vector), ("theta".to_string(), Kind::Angle)];
        let rates = vec![("x".to_string(), "vector(1, 0)".to_string()), ("theta".to_string(), rate.to_string())];
        let law = LawText { dimension: 2, position: Some("x".to_string()), state, rates, ..LawText::default() };
        law.compile(2).map(|_| ()).map_err(|error| error.to_string())
    };
    for rate in ["theta + x.1", "x.2 - theta", "sum(j, theta[j] - (x[j].1 - x.1))"] {
        assert_eq!(law(rate), Err("an angle and a length are not added".to_string()), "{rate}");
    }
    for rate in ["theta + 2*x.1", "theta + pi/2", "heading(x) - theta"] {
        assert_eq!(law(rate), Ok(()), "{rate}");
    }
}
