//! `rate(e)` against dual numbers along the flow, and properties taken apart.

use super::laws::second_order;
use arithmetic::random::{generator, uniform};
use arithmetic::{Dual, Rational, rational};
use expressions::{Clauses, Everyone, Kind, LawError, LawText, Relation, Time, parse_property};

fn statement(text: &LawText, agents: usize, property: &str) -> Result<Clauses, LawError> {
    text.statement(agents, &parse_property(property).unwrap())
}

fn aligned() -> LawText {
    let mut text = second_order(&[], "sum(j, (v[j] - v)/(1 + norm2(x[j] - x))^(1/4)) - x/10", &[]);
    text.observables = vec![
        ("momentum".to_string(), "sum(i, v[i])".to_string()),
        ("energy".to_string(), "sum(i, norm2(v[i]))/2 + sum(i, mean(j, sqrt(1 + norm2(x[i] - x[j]))))".to_string()),
        ("mixed".to_string(), "sum(i, exp(x[i].1/3)*sin(v[i].2) + heading(vector(2 + x[i].1, v[i].1)) + log(2 + norm2(v[i]))/(3 + cos(x[i].2)))".to_string()),
        ("pieces".to_string(), "sum(i where x[i].1 > 0, v[i].1*abs(x[i].2)) + max(v[1].1, x[2].2) + sum(i, if(v[i].2 < x[i].1, x[i].1^3, -x[i].1))".to_string()),
    ];
    text
}

#[test]
fn rates_are_derivatives_along_the_flow() {
    let (text, agents) = (aligned(), 3);
    let law = text.compile(agents).unwrap();
    let mut random = generator("expressions", "rates", 0);
    for (name, place) in [("energy", 2), ("mixed", 3), ("pieces", 4)] {
        let clauses = statement(&text, agents, &format!("rate({name}) < 0")).unwrap();
        for _ in 0..20 {
            let state: Vec<f64> = (0..4 * agents).map(|_| 2.0 * uniform(&mut random) - 1.0).collect();
            let rates = law.rates(&0.0, &state, &Everyone(agents)).unwrap();
            let moving: Vec<Dual<f64>> =
                state.iter().zip(&rates).map(|(x, r)| Dual { value: *x, derivative: *r }).collect();
            let time = Dual { value: 0.0, derivative: 1.0 };
            let wanted = law.observe(&time, &moving, &Everyone(agents))[place].as_ref().unwrap().derivative;
            let found = clauses[0][0].value(&0.0, &state, &Everyone(agents)).unwrap();
            assert!((found - wanted).abs() < 1e-12 * (1.0 + wanted.abs()), "{name}: {found} for {wanted}");
        }
    }
    let clauses = statement(&text, agents, "rate(momentum) = 0 and rate(momentum.1) <= 0").unwrap();
    assert_eq!(clauses.iter().map(Vec::len).collect::<Vec<_>>(), [1, 1, 1]);
}

#[test]
fn changes_over_a_step_are_exact() {
    let text = LawText {
        time: Time::Discrete,
        dimension: 1,
        state: vec![("x".to_string(), Kind::Number)],
        rates: vec![("x".to_string(), "x/2 + mean(j, x[j])/2".to_string())],
        observables: vec![("spread".to_string(), "sum(i, (x[i] - mean(k, x[k]))^2)".to_string())],
        ..LawText::default()
    };
    let state: Vec<Rational> = [3, -1, 7].into_iter().map(|n| rational(n, 2)).collect();
    let (law, zero) = (text.compile(3).unwrap(), rational(0, 1));
    let next = law.rates(&zero, &state, &Everyone(3)).unwrap();
    let spread = |state: &[Rational]| law.observe(&zero, state, &Everyone(3))[0].clone().unwrap();
    let clauses = statement(&text, 3, "rate(spread) <= 0 and rate(rate(spread)) >= 0").unwrap();
    let change = clauses[0][0].value(&zero, &state, &Everyone(3)).unwrap();
    assert_eq!(change, spread(&next) - spread(&state));
    let after = law.rates(&zero, &next, &Everyone(3)).unwrap();
    let second = clauses[1][0].value(&zero, &state, &Everyone(3)).unwrap();
    assert_eq!(second, spread(&after) - spread(&next) * rational(2, 1) + spread(&state));
}

#[test]
fn where_a_piece_ends_there_is_no_rate() {
    let text = aligned();
    let clauses = statement(&text, 2, "rate(sum(i where x[i].1 > 0, v[i].1)) = 0 or rate(abs(x[1].1)) = 0").unwrap();
    assert_eq!((clauses.len(), clauses[0].len()), (1, 2));
    let state = [0.0, 1.0, 2.0, 3.0, 1.0, 1.0, 1.0, 1.0];
    assert!(clauses[0].iter().all(|own| own.value(&0.0, &state, &Everyone(2)).is_err()));
    let moved = [0.5, 1.0, 2.0, 3.0, 1.0, 1.0, 1.0, 1.0];
    assert!(clauses[0].iter().all(|own| own.value(&0.0, &moved, &Everyone(2)).is_ok()));
}

#[test]
fn properties_are_clauses() {
    let text = aligned();
    let relations = |property: &str| -> Vec<Vec<Relation>> {
        let clauses = statement(&text, 2, property).unwrap();
        clauses.iter().map(|clause| clause.iter().map(|own| own.relation).collect()).collect()
    };
    use Relation::{AtMost, Different, Equal, Greater, Less};
    assert_eq!(relations("0 < energy <= 1"), [vec![Less], vec![AtMost]]);
    assert_eq!(relations("energy <= 1 implies rate(energy) <= 0"), [vec![Greater, AtMost]]);
    assert_eq!(relations("not (momentum = 0)"), [vec![Different, Different]]);
    assert_eq!(relations("not (momentum != 0)"), [vec![Equal], vec![Equal]]);
    assert_eq!(relations("(energy < 1 and mixed < 1) or energy > 2"), [vec![Less, Greater], vec![Less, Greater]]);
    let refused = |property: &str| statement(&text, 2, property).unwrap_err().to_string();
    assert!(refused("momentum < 0").contains("a number is expected"));
    assert!(refused("energy").contains("a comparison is expected"));
    assert!(refused("rate(max(j, x[j].1)) < 0").contains("no rate where two agree"));
    assert!(refused("rate(energy > 0) < 0").contains("a number or a vector is expected"));
    assert!(refused("enrgy > 0").contains("nearest known name is `energy`"));
    let mut circular = aligned();
    circular.rates[1].1 = "rate(v)".to_string();
    assert!(circular.compile(2).unwrap_err().to_string().contains("a law cannot ask for rates"));
}
