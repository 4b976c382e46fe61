//! The slow twin: a walk through the syntax tree for each agent, without sharing anything, against the compiled program; over random expressions.

use super::laws::{Lists, second_order};
use arithmetic::random::{generator, uniform};
use arithmetic::rational;
use expressions::{Blocks, Everyone, Hearing, Kind, Law, LawText, Node, NodeKind, Parameter, Relation, parse_property};
use rand_chacha::ChaCha8Rng;

/// What a walk has found.
#[derive(Debug, Clone, PartialEq)]
enum Found {
    Numbers(Vec<f64>),
    Truth(bool),
}

struct Walk<'a> {
    lists: &'a [Vec<usize>],
    state: &'a [f64],
}

impl Walk<'_> {
    fn numbers(&self, node: &Node, bound: &[(String, usize)]) -> Vec<f64> {
        match self.found(node, bound) {
            Found::Numbers(list) => list,
            Found::Truth(_) => panic!("{node} is no number"),
        }
    }

    fn number(&self, node: &Node, bound: &[(String, usize)]) -> f64 {
        self.numbers(node, bound)[0]
    }

    fn truth(&self, node: &Node, bound: &[(String, usize)]) -> bool {
        self.found(node, bound) == Found::Truth(true)
    }

    fn found(&self, node: &Node, bound: &[(String, usize)]) -> Found {
        let all = |list: Vec<f64>| Found::Numbers(list);
        match &node.kind {
            NodeKind::Number(q) => all(vec![num_traits::ToPrimitive::to_f64(q).unwrap()]),
            NodeKind::Negated(body) => all(self.numbers(body, bound).iter().map(|x| -x).collect()),
            NodeKind::Sum(terms) => all(terms
                .iter()
                .map(|(minus, term)| {
                    self.numbers(term, bound).iter().map(|x| if *minus { -x } else { *x }).collect::<Vec<f64>>()
                })
                .reduce(|a, b| a.iter().zip(&b).map(|(x, y)| x + y).collect())
                .unwrap()),
            NodeKind::Product(factors) => all(factors
                .iter()
                .map(|(divides, factor)| {
                    let list = self.numbers(factor, bound);
                    if *divides { list.iter().map(|x| 1.0 / x).collect() } else { list }
                })
                .reduce(|a, b| match (a.len(), b.len()) {
                    (1, _) => b.iter().map(|x| x * a[0]).collect(),
                    _ => a.iter().map(|x| x * b[0]).collect(),
                })
                .unwrap()),
            NodeKind::Power(base, exponent) => all(vec![self.number(base, bound).powf(self.number(exponent, bound))]),
            NodeKind::Relation(first, others) => {
                let mut left = self.number(first, bound);
                Found::Truth(others.iter().all(|(relation, node)| {
                    let right = self.number(node, bound);
                    let holds = match relation {
                        Relation::Less => left < right,
                        Relation::AtMost => left <= right,
                        Relation::Greater => left > right,
                        Relation::AtLeast => left >= right,
                        Relation::Equal => left == right,
                        Relation::Different => left != right,
                    };
                    left = right;
                    holds
                }))
            }
            NodeKind::Not(body) => Found::Truth(!self.truth(body, bound)),
            NodeKind::And(list) => Found::Truth(list.iter().all(|node| self.truth(node, bound))),
            NodeKind::Or(list) => Found::Truth(list.iter().any(|node| self.truth(node, bound))),
            NodeKind::Name { name, arguments, .. } => self.named(name, arguments, bound),
            other => panic!("{other:?}"),
        }
    }

    fn named(&self, name: &str, arguments: &[Node], bound: &[(String, usize)]) -> Found {
        let agents = self.lists.len();
        if ["sum", "mean", "count", "largest"].contains(&name) || name == "max" && arguments.len() == 2 {
            let (agent, filter) = match &arguments[0].kind {
                NodeKind::Where(agent, filter) => (agent.to_string(), Some(filter.as_ref())),
                _ => (arguments[0].to_string(), None),
            };
            let inside = |j: usize| [bound, &[(agent.clone(), j)]].concat();
            let heard = &self.lists[bound.last().unwrap().1];
            let chosen: Vec<usize> =
                heard.iter().copied().filter(|&j| filter.is_none_or(|f| self.truth(f, &inside(j)))).collect();
            if name == "count" {
                let holds = |j: &&usize| arguments.get(1).is_none_or(|f| self.truth(f, &inside(**j)));
                return Found::Numbers(vec![chosen.iter().filter(holds).count() as f64]);
            }
            let values: Vec<Vec<f64>> = chosen.iter().map(|&j| self.numbers(&arguments[1], &inside(j))).collect();
            if name == "max" {
                return Found::Numbers(vec![values.iter().map(|list| list[0]).fold(f64::NEG_INFINITY, f64::max)]);
            }
            let sum = values.iter().cloned().reduce(|a, b| a.iter().zip(&b).map(|(x, y)| x + y).collect());
            // Both kinds of expressions that are drawn have a sum of none.
            let Some(sum) = sum else {
                let some = self.numbers(&arguments[1], &inside(0)).len();
                return Found::Numbers(vec![0.0; some]);
            };
            let parts = if name == "mean" { values.len() as f64 } else { 1.0 };
            return Found::Numbers(sum.iter().map(|x| x / parts).collect());
        }
        let list = |k: usize| self.numbers(&arguments[k], bound);
        let one = |x: f64| Found::Numbers(vec![x]);
        match name {
            "norm2" => one(list(0).iter().map(|x| x * x).sum()),
            "dot" => one(list(0).iter().zip(list(1)).map(|(x, y)| x * y).sum()),
            "cross" => one(list(0)[0] * list(1)[1] - list(0)[1] * list(1)[0]),
            "sin" => one(list(0)[0].sin()),
            "abs" => one(list(0)[0].abs()),
            "exp" => one(list(0)[0].exp()),
            "if" => self.found(&arguments[if self.truth(&arguments[0], bound) { 1 } else { 2 }], bound),
            _ => {
                let (base, index) = name.split_once('[').map_or((name, None), |(a, b)| (a, b.strip_suffix(']')));
                let of = |name: &str| bound.iter().rev().find(|(known, _)| known == name).unwrap().1;
                let agent = index.map_or(bound[0].1, of);
                let start = if base == "x" { 0 } else { 2 * agents };
                Found::Numbers(self.state[start + 2 * agent..start + 2 * agent + 2].to_vec())
            }
        }
    }
}

struct Draw {
    random: ChaCha8Rng,
}

impl Draw {
    fn pick<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[(uniform(&mut self.random) * list.len() as f64) as usize]
    }

    fn chance(&mut self, p: f64) -> bool {
        uniform(&mut self.random) < p
    }

    /// A vector in terms of these agents.
    fn vector(&mut self, agents: &[&str], depth: usize) -> String {
        if depth == 0 || self.chance(0.2) {
            let agent = self.pick(agents);
            let base = self.pick(&["x", "v"]);
            return if agent == "i" && self.chance(0.5) { base.to_string() } else { format!("{base}[{agent}]") };
        }
        let (less, next) = (depth - 1, ["j", "k", "l"][(agents.len() - 1).min(2)]);
        match self.pick(&["sum", "difference", "times", "over", "gather", "if"]) {
            "sum" => format!("{} + {}", self.vector(agents, less), self.vector(agents, less)),
            "difference" => format!("{} - ({})", self.vector(agents, less), self.vector(agents, less)),
            "times" => format!("({})*({})", self.number(agents, less), self.vector(agents, less)),
            "over" => format!("({})/(1 + norm2({}))", self.vector(agents, less), self.vector(agents, less)),
            "if" => {
                let condition = self.condition(agents, less);
                format!("if({condition}, {}, {})", self.vector(agents, less), self.vector(agents, less))
            }
            _ if agents.len() > 3 => self.vector(agents, 0),
            _ => {
                let inner = [agents, &[next]].concat();
                let filter =
                    if self.chance(0.4) { format!(" where {}", self.condition(&inner, less)) } else { String::new() };
                let word = self.pick(&["sum", "mean"]);
                format!("{word}({next}{filter}, {})", self.vector(&inner, less))
            }
        }
    }

    fn number(&mut self, agents: &[&str], depth: usize) -> String {
        if depth == 0 {
            return self.pick(&["1", "2", "1/3", "-1/2"]).to_string();
        }
        let less = depth - 1;
        match self.pick(&["dot", "cross", "norm2", "sin", "sum", "abs", "count"]) {
            "dot" => format!("dot({}, {})", self.vector(agents, less), self.vector(agents, less)),
            "cross" => format!("cross({}, {})", self.vector(agents, less), self.vector(agents, less)),
            "norm2" => format!("norm2({})", self.vector(agents, less)),
            "sin" => format!("sin({})", self.number(agents, less)),
            "abs" => format!("abs({})", self.number(agents, less)),
            "sum" => format!("{} - ({})", self.number(agents, less), self.number(agents, less)),
            _ if agents.len() > 3 => self.number(agents, 0),
            _ => {
                let next = ["j", "k", "l"][(agents.len() - 1).min(2)];
                let inner = [agents, &[next]].concat();
                let condition = self.condition(&inner, less);
                format!("count({next}, {condition})")
            }
        }
    }

    fn condition(&mut self, agents: &[&str], depth: usize) -> String {
        let relation = self.pick(&["<", ">", "<=", "!="]);
        let one = format!("{} {relation} {}", self.number(agents, depth), self.number(agents, depth));
        match self.pick(&["one", "one", "not", "and", "or"]) {
            "not" => format!("not ({one})"),
            "and" => format!("({one} and {} < 1)", self.number(agents, depth)),
            "or" => format!("({one} or {} > 0)", self.number(agents, depth)),
            _ => one,
        }
    }
}

/// The rates by blocks.
fn in_blocks(law: &Law, state: &[f64], hearing: &dyn Hearing) -> Vec<f64> {
    let mut rates = vec![0.0; state.len()];
    let again = rates.clone();
    let mut blocks = Blocks::rates(law, hearing.heard(0).is_none());
    blocks.write_rates(law, (0.0, state), hearing, &mut rates).unwrap();
    // Nothing is left in the working space.
    let mut second = again;
    blocks.write_rates(law, (0.0, state), hearing, &mut second).unwrap();
    assert!(rates.iter().zip(&second).all(|(a, b)| a.to_bits() == b.to_bits()));
    rates
}

/// Those within some distance on a circle of numbers, in an order of their own.
fn around(agents: usize, reach: usize) -> Lists {
    let list = |i: usize| (1..=reach).flat_map(|d| [(i + d) % agents, (i + agents - d) % agents]).collect();
    Lists((0..agents).map(list).collect())
}

#[test]
fn blocks_of_large_flocks_as_one_number_after_the_other() {
    let mut compared = 0;
    for case in 0..60 {
        let mut draw = Draw { random: generator("expressions", "blocks", case) };
        let text = draw.vector(&["i"], 3);
        let agents = [60, 70, 300, 530][(case % 4) as usize];
        let state: Vec<f64> = (0..4 * agents).map(|_| 2.0 * uniform(&mut draw.random) - 1.0).collect();
        let law = second_order(&[], &text, &[]).compile(agents).unwrap();
        let near: [Box<dyn Hearing>; 3] =
            [Box::new(Everyone(agents)), Box::new(around(agents, 3)), Box::new(around(agents, 27))];
        let deep = text.matches("(j").count() > 0 && (text.contains("(k") || text.contains("(l"));
        for hearing in near.iter().skip(usize::from(deep)) {
            let (found, wanted) = match law.rates(&0.0, &state, hearing.as_ref()) {
                Ok(wanted) => (in_blocks(&law, &state, hearing.as_ref()), wanted),
                Err(_) => continue,
            };
            let largest = wanted.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
            for (found, wanted) in found.iter().zip(&wanted).filter(|(_, wanted)| wanted.is_finite()) {
                compared += 1;
                assert!((found - wanted).abs() < 1e-9 * largest, "{text}: {found} for {wanted}");
            }
        }
    }
    assert!(compared > 10_000, "{compared}");
}

/// Laws of angles: what is taken apart and computed ahead is what the law says, whoever hears whom.
#[test]
fn sines_of_differences_are_taken_apart() {
    let rates = [
        "sum(j, sin(theta[j] - theta))",
        "mean(j, cos(2*(theta - theta[j]) + 1/3))",
        "sum(j, sin(theta[j] - theta - lag[j])*weight[j] - cos(-(theta + theta[j])))",
        "sum(j, weight*weight[j]*sin(theta[j] - theta)*cos(theta) - 2*sin(theta[j])*sin(3*theta))",
        "sum(j, sin(theta[j] - theta)^2)",
        "sum(j, sin(theta[j] - theta)/(2 + cos(theta[j])))",
        "sum(j, sin(theta[j] - theta + sum(k, weight[k]*sin(theta[k] - theta[j]))))",
        "sum(j where cos(theta[j]) > 0, sin(theta[j] - theta))",
        "max(j, sin(theta[j] - theta)) + sin(mean(k, theta[k]) - theta)",
        "sum(j, sum(k, sin(theta[j] - theta[k] + theta)))",
        "sum(j, (theta[j] - theta)*sin(theta[j] - theta))",
        "sum(j, sin(theta[1] - theta[j]) + t*cos(theta[j] - theta))",
        "sum(j, 2*sin(theta[j])*cos(theta[j]) - sin(theta[j] - theta))",
        "sum(j, sin(theta[j] - theta)*mean(k, cos(theta[k])))",
        "sum(k, sin(theta[k] - theta)) + sum(j, mean(k, sin(theta[k] - theta[j])/exp(theta[j])))",
    ];
    let measured = [
        ("coherence", "(agents + sum(i, sum(j, cos(theta[j] - theta[i]))))/2"),
        ("turning", "sum(i, weight[i]*mean(j, sin(theta[i] - theta[j] - lag[i])))"),
        ("largest", "max(i, abs(sum(j, sin(theta[j])/(2 + cos(theta[j])) - sin(theta[i]))))"),
    ];
    let mut random = generator("expressions", "angles", 0);
    for agents in [1, 2, 3, 70, 300_usize] {
        let mut listed = || (0..agents).map(|_| rational((100.0 * uniform(&mut random)) as i64, 100)).collect();
        let parameters = ["lag", "weight"].map(|name| (name.to_string(), Parameter::Each(listed())));
        for rate in rates {
            let text = LawText {
                dimension: 1,
                state: vec![("theta".to_string(), Kind::Angle)],
                parameters: parameters.to_vec(),
                rates: vec![("theta".to_string(), rate.to_string())],
                observables: measured.map(|(name, text)| (name.to_string(), text.to_string())).to_vec(),
                ..LawText::default()
            };
            let law = text.compile(agents).unwrap_or_else(|error| panic!("{rate}: {error}"));
            let state: Vec<f64> = (0..agents).map(|_| 8.0 * uniform(&mut random) - 4.0).collect();
            let lists: [Box<dyn Hearing>; 2] =
                [Box::new(Everyone(agents)), Box::new(around(agents, agents.min(3) - 1))];
            for hearing in lists.iter().skip(usize::from(agents == 300 && rate.contains("(k,"))) {
                let Ok(wanted) = law.rates(&0.0, &state, hearing.as_ref()) else { continue };
                for (found, wanted) in in_blocks(&law, &state, hearing.as_ref()).iter().zip(&wanted) {
                    let size = (agents * agents) as f64;
                    assert!((found - wanted).abs() < 1e-13 * size, "{rate}, {agents} agents: {found} for {wanted}");
                }
                let mut blocks = Blocks::observables(&law, hearing.heard(0).is_none());
                let wanted = law.observe(&0.0, &state, hearing.as_ref());
                let Ok(found) = blocks.observe(0.0, &state, hearing.as_ref()) else { continue };
                for (found, wanted) in found.iter().zip(&wanted) {
                    let (size, wanted) = ((agents * agents) as f64, wanted.clone().unwrap());
                    assert!((found - wanted).abs() < 1e-13 * size, "{agents} agents: {found} for {wanted}");
                }
            }
        }
    }
}

/// Phases that are equal, or a hair's breadth apart, are compared and divided by as they are.
#[test]
fn small_differences_of_phases_keep_their_digits() {
    let state = [2.3, 2.3, 2.3 + 1e-9, 0.1, 0.1];
    for rate in [
        "sum(j where cos(theta[j] - theta) < 1, 1/(1 - cos(theta[j] - theta)))",
        "count(j, sin(theta[j] - theta) = 0)",
        "sum(j where abs(theta[j] - theta) > 0, 1/abs(theta[j] - theta))",
        "sum(j where sin(theta[j] - theta) != 0, 1/sin(theta[j] - theta)) + sum(j where theta[j] = theta, 1)",
        "if(sum(j, sin(theta[j] - theta)) = 0, 1, 2)",
        "1/(1 + 1000000000000*sum(j, sin(theta[j] - theta))^2)",
    ] {
        let text = LawText {
            dimension: 1,
            state: vec![("theta".to_string(), Kind::Angle)],
            rates: vec![("theta".to_string(), rate.to_string())],
            ..LawText::default()
        };
        for state in [&state[..], &state[..2]] {
            let law = text.compile(state.len()).unwrap_or_else(|error| panic!("{rate}: {error}"));
            let everyone = Everyone(state.len());
            let (found, wanted) = (in_blocks(&law, state, &everyone), law.rates(&0.0, state, &everyone).unwrap());
            for (found, wanted) in found.iter().zip(&wanted) {
                assert!((found - wanted).abs() <= 1e-14 * wanted.abs(), "{rate}: {found} for {wanted}");
            }
        }
    }
}

/// Loops that stand inside of others, whose numbers do not depend on the agent there.
#[test]
fn loops_that_stand_inside_of_others_without_need() {
    let angles = LawText {
        dimension: 1,
        state: vec![("theta".to_string(), Kind::Angle)],
        define: vec![("pull(a, b)".to_string(), "sin(theta[b] - theta[a])*mean(m, cos(theta[m]))".to_string())],
        rates: vec![("theta".to_string(), "sum(j, pull(i, j))".to_string())],
        ..LawText::default()
    };
    let defined = [("push(a, b)", "(x[b] - x[a])*sum(m, norm2(v[m] - v[a]))")];
    let places = second_order(&defined, "sum(j, sum(k, push(j, k)))", &[]);
    for (text, numbers) in [(angles, 1), (places, 4)] {
        let law = text.compile(7).unwrap();
        let state: Vec<f64> = (0..7 * numbers).map(|k| f64::from(k as u8).sin()).collect();
        for hearing in [&Everyone(7) as &dyn Hearing, &around(7, 2)] {
            let (found, wanted) = (in_blocks(&law, &state, hearing), law.rates(&0.0, &state, hearing).unwrap());
            for (found, wanted) in found.iter().zip(&wanted) {
                assert!((found - wanted).abs() < 1e-12 * (1.0 + wanted.abs()), "{found} for {wanted}");
            }
        }
    }
}

#[test]
fn threads_change_no_byte() {
    let law =
        second_order(&[], "sum(j, (v[j] - v)/(1 + norm2(x[j] - x))^(1/4)) + mean(k, x[k])", &[]).compile(900).unwrap();
    let mut random = generator("expressions", "threads", 0);
    let state: Vec<f64> = (0..3600).map(|_| uniform(&mut random)).collect();
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| [in_blocks(&law, &state, &Everyone(900)), in_blocks(&law, &state, &around(900, 20))])
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn what_is_not_taken_needs_no_value_in_blocks_either() {
    let text = "sum(j where x[j].1 != x.1, (x[j] - x)/(x[j].1 - x.1)) + if(x.1 = 0, x, x/x.1)";
    let law = second_order(&[], text, &[]).compile(4).unwrap();
    let state: Vec<f64> = [0, 1, 0, 2, 1, 1, 3, 1, 0, 0, 0, 0, 0, 0, 0, 0].map(f64::from).to_vec();
    assert_eq!(in_blocks(&law, &state, &Everyone(4)), law.rates(&0.0, &state, &Everyone(4)).unwrap());
    let law = second_order(&[], "sum(j, (x[j] - x)/(x[j].1 - x.1))", &[]).compile(4).unwrap();
    let (mut rates, mut blocks) = (vec![0.0; 16], Blocks::rates(&law, true));
    let fault = blocks.write_rates(&law, (0.0, &state), &Everyone(4), &mut rates).unwrap_err();
    assert_eq!(fault, law.rates(&0.0, &state, &Everyone(4)).unwrap_err());
}

#[test]
fn random_expressions_as_by_a_walk_through_the_tree() {
    let lists = [
        vec![vec![1, 2, 3], vec![0], vec![], vec![0, 2]],
        vec![vec![1, 2, 3], vec![0, 2, 3], vec![0, 1, 3], vec![0, 1, 2]],
    ];
    let mut compared = 0;
    for case in 0..600 {
        let mut draw = Draw { random: generator("expressions", "twin", case) };
        let text = draw.vector(&["i"], 4);
        let lists = &lists[(case % 2) as usize];
        let state: Vec<f64> = (0..16).map(|_| 2.0 * uniform(&mut draw.random) - 1.0).collect();
        let node = parse_property(&text).unwrap();
        // The canonical text is the same expression.
        assert_eq!(parse_property(&node.to_string()).unwrap().to_string(), node.to_string());
        let law = second_order(&[], &text, &[]).compile(4).unwrap_or_else(|error| panic!("{text}: {error}"));
        let rates = law.rates(&0.0, &state, &Lists(lists.clone())).unwrap_or_else(|error| panic!("{text}: {error}"));
        let blocks = in_blocks(&law, &state, &Lists(lists.clone()));
        let walk = Walk { lists, state: &state };
        for agent in 0..4 {
            let wanted = walk.numbers(&node, &[("i".to_string(), agent)]);
            for c in 0..2 {
                let (found, wanted) = (rates[8 + 2 * agent + c], wanted[c]);
                let size = 1.0 + wanted.abs();
                if size.is_finite() && size < 1e6 {
                    compared += 1;
                    assert!((found - wanted).abs() < 1e-9 * size, "{text}: {found} for {wanted} (agent {agent})");
                    let found = blocks[8 + 2 * agent + c];
                    assert!(
                        (found - wanted).abs() < 1e-9 * size,
                        "{text}: {found} in blocks for {wanted} (agent {agent})"
                    );
                }
            }
        }
    }
    assert!(compared > 4000, "{compared}");
}

/// Headings of the state are held, where a whole turn makes a difference.
#[test]
fn headings_are_held_where_they_jump() {
    let held = |rate: &str| {
        let law = second_order(&[], &format!("vector({rate}, 0)"), &[]).compile(4).unwrap();
        Blocks::held_rates(&law, false).headings().len()
    };
    for smooth in [
        "sum(j, sin(heading(v[j]) - heading(v)))",
        "cos(3*heading(v) + x.1)",
        "sum(j, sin(sum(k, heading(v[k]) - heading(v[j]))))",
        "heading(vector(v.2 + 1, v.1))",
    ] {
        assert_eq!(held(smooth), 0, "{smooth}");
    }
    for jumps in [
        "heading(v)",
        "heading(vector(v.2, v.1))",
        "sin(heading(v)/2)",
        "sin(x.1*heading(v))",
        "sin(sum(j, heading(v[j]))/3)",
        "if(heading(v) < 1, 1, 2)",
        "sum(j, if(heading(v[j]) < 1, 1, 0))",
        "sin(if(x.1 < 1, 1, 2)*heading(v))",
        "max(j, heading(v[j]))",
    ] {
        assert_eq!(held(jumps), 1, "{jumps}");
    }
}
