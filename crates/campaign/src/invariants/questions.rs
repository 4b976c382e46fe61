//! Questions against a slow evaluator that shares no code with theirs: expressions in three-valued logic, quantities of graphs, verdicts on families.

use super::{Checked, Invariant, OrFails, Stop, Tested, require};
use crate::draws::Draws;
use arithmetic::{Rational, Unwatched, rational};
use num_traits::{Signed, Zero};
use question::{Question, Verdict, decide};

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "question.expressions",
        statement: "A property of numbers of ranges, however they are written, is false, without a value or true as point by point in three-valued logic.",
        control: "`true or missing` is taken to be missing",
        block: 50,
        check: expressions,
    },
    Invariant {
        id: "question.text",
        statement: "The canonical text of a property is read as the same property.",
        control: "the text is read without its brackets",
        block: 100,
        check: texts,
    },
    Invariant {
        id: "question.graphs",
        statement: "Edges, degrees, connection and diameter of a graph or digraph are those of its matrix, arcs each way or not.",
        control: "an arc each way counts as one edge",
        block: 100,
        check: graphs,
    },
    Invariant {
        id: "question.families",
        statement: "A property of edges and degrees holds for a family up to isomorphism where it holds for all of its labelled members.",
        control: "an edge is counted that is not there",
        block: 20,
        check: families,
    },
];

const NAMES: [&str; 3] = ["x", "y", "z"];

/// A number of the naive evaluator.
enum Term {
    Constant(Rational),
    Name(usize),
    Minus(Box<Term>),
    Abs(Box<Term>),
    Binary(char, Box<Term>, Box<Term>),
    Power(Box<Term>, i64),
    /// The larger of two, or the smaller.
    Extreme(bool, Box<Term>, Box<Term>),
}

/// A truth of the naive evaluator.
enum Formula {
    Compare(&'static str, Term, Term),
    Not(Box<Formula>),
    Joint(&'static str, Box<Formula>, Box<Formula>),
}

fn term(draws: &mut Draws, names: usize, depth: usize) -> Term {
    let part = |draws: &mut Draws| Box::new(term(draws, names, depth.saturating_sub(1)));
    match if depth == 0 { draws.below(2) } else { draws.below(9) } {
        0 => Term::Constant(rational(draws.between(0, 6) as i64 - 3, draws.between(1, 2) as i64)),
        1 => Term::Name(draws.below(names as u64) as usize),
        2 => Term::Minus(part(draws)),
        3 => Term::Abs(part(draws)),
        4 => Term::Power(part(draws), draws.between(0, 5) as i64 - 2),
        5 => Term::Extreme(draws.once_in(2), part(draws), part(draws)),
        6 => Term::Binary('/', part(draws), part(draws)),
        _ => Term::Binary(*draws.choice(&['+', '-', '*']), part(draws), part(draws)),
    }
}

fn formula(draws: &mut Draws, names: usize, depth: usize) -> Formula {
    if depth == 0 || draws.once_in(4) {
        let relation = *draws.choice(&["=", "!=", "<", "<=", ">", ">="]);
        return Formula::Compare(relation, term(draws, names, 2), term(draws, names, 2));
    }
    let part = |draws: &mut Draws| Box::new(formula(draws, names, depth - 1));
    match draws.below(4) {
        0 => Formula::Not(part(draws)),
        _ => Formula::Joint(draws.choice::<&str>(&["and", "or", "implies"]), part(draws), part(draws)),
    }
}

impl Term {
    fn text(&self) -> String {
        match self {
            Term::Constant(q) => format!("({q})"),
            Term::Name(k) => NAMES[*k].to_string(),
            Term::Minus(a) => format!("(-{})", a.text()),
            Term::Abs(a) => format!("abs({})", a.text()),
            Term::Binary(sign, a, b) => format!("({} {sign} {})", a.text(), b.text()),
            Term::Power(a, k) => format!("({}^({k}))", a.text()),
            Term::Extreme(larger, a, b) => {
                format!("{}({}, {})", if *larger { "max" } else { "min" }, a.text(), b.text())
            }
        }
    }

    /// `None` where it has no value.
    fn value(&self, at: &[Rational]) -> Option<Rational> {
        let over = |a: Rational, b: Rational| if b.is_zero() { None } else { Some(a * b.recip()) };
        Some(match self {
            Term::Constant(q) => q.clone(),
            Term::Name(k) => at[*k].clone(),
            Term::Minus(a) => -a.value(at)?,
            Term::Abs(a) => a.value(at)?.abs(),
            Term::Binary(sign, a, b) => {
                let (a, b) = (a.value(at)?, b.value(at)?);
                match sign {
                    '+' => a + b,
                    '-' => a - b,
                    '*' => a * b,
                    _ => over(a, b)?,
                }
            }
            Term::Power(a, k) => {
                let a = a.value(at)?;
                let positive = (0..k.unsigned_abs()).fold(rational(1, 1), |product, _| product * &a);
                if *k < 0 { over(rational(1, 1), positive)? } else { positive }
            }
            Term::Extreme(larger, a, b) => {
                let (a, b) = (a.value(at)?, b.value(at)?);
                if (a < b) == *larger { b } else { a }
            }
        })
    }
}

impl Formula {
    fn text(&self) -> String {
        match self {
            Formula::Compare(relation, a, b) => format!("({} {relation} {})", a.text(), b.text()),
            Formula::Not(a) => format!("(not {})", a.text()),
            Formula::Joint(word, a, b) => format!("({} {word} {})", a.text(), b.text()),
        }
    }

    /// `None` where it has no value; `strict` where one part without a value takes the value of the whole.
    fn value(&self, at: &[Rational], strict: bool) -> Option<bool> {
        match self {
            Formula::Compare(relation, a, b) => {
                let (a, b) = (a.value(at)?, b.value(at)?);
                Some(match *relation {
                    "=" => a == b,
                    "!=" => a != b,
                    "<" => a < b,
                    "<=" => a <= b,
                    ">" => a > b,
                    _ => a >= b,
                })
            }
            Formula::Not(a) => a.value(at, strict).map(|a| !a),
            Formula::Joint(word, a, b) => {
                let (a, b) = (a.value(at, strict), b.value(at, strict));
                if strict && (a.is_none() || b.is_none()) {
                    return None;
                }
                // What decides alone, whatever the other one is.
                let (a, deciding) = match *word {
                    "and" => (a, false),
                    "or" => (a, true),
                    _ => (a.map(|a| !a), true),
                };
                if a == Some(deciding) || b == Some(deciding) {
                    return Some(deciding);
                }
                a.and(b).map(|_| !deciding)
            }
        }
    }
}

/// Text of a question about names with their ranges.
fn text(ranges: &[String], restriction: Option<&str>, property: &str) -> String {
    let family: String = NAMES.iter().zip(ranges).map(|(name, range)| format!("{name} = {range}\n")).collect();
    let restriction = restriction.map_or(String::new(), |text| format!("where = \"{text}\"\n"));
    format!(
        "[question]\nid = \"q\"\n[for]\n{family}{restriction}[holds]\nproperty = \"{property}\"\ncontrols = [\"1 < 0\"]\n"
    )
}

fn asked(text: &str) -> Result<Result<Verdict, String>, Stop> {
    let files = |name: &str| Err(format!("there is no file {name}"));
    let question = Question::read(text, &files).or_fails("the question is refused")?;
    Ok(decide(&question, &Unwatched).map(|answer| answer.verdict).map_err(|error| error.to_string()))
}

/// A range of numbers as a question has it, with its members.
fn range(draws: &mut Draws) -> (String, Vec<Rational>) {
    let from = draws.between(0, 6) as i64 - 4;
    let to = from + draws.between(0, 4) as i64;
    let members = (from..=to).map(|k| rational(k, 1)).collect();
    match draws.below(3) {
        0 => (format!("\"{from}..{to}\""), members),
        1 => (format!("\"integers({from}, {to})\""), members),
        _ => {
            let points: Vec<_> = members.into_iter().map(|k| k * rational(1, draws.between(1, 3) as i64)).collect();
            let texts: Vec<String> = points.iter().map(|q| format!("\"{q}\"")).collect();
            (format!("[{}]", texts.join(", ")), points)
        }
    }
}

fn expressions(draws: &mut Draws, tested: Tested) -> Checked {
    let names = draws.between(1, 3);
    let (texts, ranges): (Vec<String>, Vec<Vec<Rational>>) = (0..names).map(|_| range(draws)).unzip();
    let restriction = draws.once_in(3).then(|| formula(draws, names, 0));
    let property = formula(draws, names, 3);
    // Every name is used, by what is always true.
    let used: String = NAMES[..names].iter().map(|name| format!(" and {name} = {name}")).collect();
    let question =
        text(&texts, restriction.as_ref().map(Formula::text).as_deref(), &format!("{}{used}", property.text()));
    let (mut is_false, mut is_missing, mut kept_one) = (false, false, false);
    let mut places = vec![0; names];
    'members: loop {
        let at: Vec<Rational> = places.iter().zip(&ranges).map(|(k, range): (&usize, _)| range[*k].clone()).collect();
        let kept = restriction.as_ref().map_or(Some(true), |own| own.value(&at, tested.is_altered()));
        let value = property.value(&at, tested.is_altered());
        match (kept, value) {
            (Some(false), _) => {}
            (Some(true), Some(false)) => (is_false, kept_one) = (true, true),
            (Some(true), Some(true)) => kept_one = true,
            (None, Some(true)) => {}
            _ => is_missing = true,
        }
        for place in (0..names).rev() {
            places[place] += 1;
            if places[place] < ranges[place].len() {
                continue 'members;
            }
            places[place] = 0;
        }
        break;
    }
    // A control is refuted where a member is kept.
    let found = asked(&question)?;
    let right = match &found {
        Ok(Verdict::False) => is_false,
        Ok(Verdict::Holds) => !is_false && !is_missing,
        // Of boxes that `where` leaves out nobody says that they are empty; no control is refuted there.
        Ok(Verdict::Withheld) => !kept_one,
        Ok(Verdict::Undecided) => false,
        Err(_) => !is_false && (is_missing || !kept_one),
    };
    let naive = format!("naively: false {is_false}, missing {is_missing}, any {kept_one}");
    require(right, format!("{found:?}, but {naive}"), || question.clone())?;
    Ok(None)
}

fn texts(draws: &mut Draws, tested: Tested) -> Checked {
    let names = draws.between(1, 3);
    let ranges = vec!["\"1..2\"".to_string(); names];
    let used: String = NAMES[..names].iter().map(|name| format!(" and {name} = {name}")).collect();
    let first = text(&ranges, None, &format!("{}{used}", formula(draws, names, 3).text()));
    let canonical = |text: &str| -> Result<String, Stop> {
        let files = |name: &str| Err(format!("there is no file {name}"));
        Ok(Question::read(text, &files).or_fails("the question is refused")?.canonical())
    };
    let once = canonical(&first)?;
    let printed = once.lines().find_map(|line| line.strip_prefix("property = ")).unwrap_or_default().to_string();
    let printed = if tested.is_altered() { printed.replace(['(', ')'], "") } else { printed };
    let again = canonical(&text(&ranges, None, &printed))?;
    require(once == again, "another property is read", || format!("{first}\n{printed}"))?;
    Ok(None)
}

/// The matrix of a graph, `true` where there is an arc.
type Matrix = Vec<Vec<bool>>;

/// Number of edges or arcs, smallest and largest degree, and the diameter where every vertex can be reached.
fn measured(matrix: &Matrix, directed: bool) -> (usize, usize, usize, Option<usize>) {
    let order = matrix.len();
    let arcs: usize = matrix.iter().flatten().filter(|arc| **arc).count();
    let degrees: Vec<usize> = matrix.iter().map(|row| row.iter().filter(|arc| **arc).count()).collect();
    // By Floyd and Warshall.
    let mut distance: Vec<Vec<Option<usize>>> = vec![vec![None; order]; order];
    for i in 0..order {
        for j in 0..order {
            distance[i][j] = if i == j { Some(0) } else { matrix[i][j].then_some(1) };
        }
    }
    for k in 0..order {
        for i in 0..order {
            for j in 0..order {
                let through = distance[i][k].zip(distance[k][j]).map(|(a, b)| a + b);
                distance[i][j] = [distance[i][j], through].into_iter().flatten().min();
            }
        }
    }
    let diameter = distance.iter().flatten().try_fold(0, |most, own| own.map(|own| most.max(own)));
    let (least, most) = (degrees.iter().copied().min(), degrees.iter().copied().max());
    (if directed { arcs } else { arcs / 2 }, least.unwrap_or(0), most.unwrap_or(0), diameter)
}

fn graphs(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 6);
    let (directed, symmetric) = (draws.once_in(2), draws.once_in(2));
    let mut matrix: Matrix = vec![vec![false; order]; order];
    let pairs = (0..order).flat_map(|i| (0..order).map(move |j| (i, j))).filter(|(i, j)| i != j);
    for (i, j) in pairs {
        if directed && !symmetric {
            matrix[i][j] = draws.once_in(2);
        } else if i < j {
            matrix[i][j] = draws.once_in(2);
            matrix[j][i] = matrix[i][j];
        }
    }
    let listed = |(i, row): (usize, &Vec<bool>)| {
        let ends = row.iter().enumerate().filter(move |(j, arc)| **arc && (directed || i < *j));
        ends.map(move |(j, _)| format!("{}-{}", i + 1, j + 1)).collect::<Vec<_>>()
    };
    let arcs: Vec<String> = matrix.iter().enumerate().flat_map(listed).collect();
    let graph = format!("{}:{order}:{}", if directed { "arcs" } else { "edges" }, arcs.join(","));
    let is_one_edge = tested.is_altered() && (0..order).all(|i| (0..order).all(|j| matrix[i][j] == matrix[j][i]));
    let (edges, least, most, diameter) = measured(&matrix, directed && !is_one_edge);
    let connection = match diameter {
        Some(diameter) => format!("connected and diameter = {diameter}"),
        // A value that is missing does not matter beside one that decides.
        None => "not connected and (diameter > 0 or not connected)".to_string(),
    };
    let property =
        format!("n = {order} and edges = {edges} and min_degree = {least} and max_degree = {most} and {connection}");
    let question = format!(
        "[question]\nid = \"q\"\n[for]\ng = \"{graph}\"\n[holds]\nproperty = \"{property}\"\ncontrols = [\"edges < 0\"]\n"
    );
    let found = asked(&question)?;
    require(found == Ok(Verdict::Holds), format!("{found:?}"), || question.clone())?;
    Ok(None)
}

fn families(draws: &mut Draws, tested: Tested) -> Checked {
    let (family, largest) = *draws.choice(&[("all", 4), ("connected", 4), ("trees", 4), ("digraphs", 3)]);
    let directed = family == "digraphs";
    let order = draws.between(1, largest);
    let pairs: Vec<(usize, usize)> = (0..order)
        .flat_map(|i| (0..order).map(move |j| (i, j)))
        .filter(|(i, j)| i != j && (directed || i < j))
        .collect();
    let [a, b, c] = [(); 3].map(|()| draws.below(5) as usize);
    let mut holds = true;
    for code in 0..1u64 << pairs.len() {
        let mut matrix: Matrix = vec![vec![false; order]; order];
        for (_, &(i, j)) in pairs.iter().enumerate().filter(|(bit, _)| code >> bit & 1 == 1) {
            matrix[i][j] = true;
            matrix[j][i] |= !directed;
        }
        let (edges, least, most, diameter) = measured(&matrix, directed);
        let is_member = match family {
            "connected" => diameter.is_some(),
            "trees" => diameter.is_some() && edges + 1 == order,
            _ => true,
        };
        let counted = edges + usize::from(tested.is_altered());
        holds &= !is_member || (counted >= a || most <= b) && (diameter.is_none() || least + c >= most);
    }
    let property =
        format!("(edges >= {a} or max_degree <= {b}) and (connected implies min_degree + {c} >= max_degree)");
    let naive = if holds { Verdict::Holds } else { Verdict::False };
    let question = format!(
        "[question]\nid = \"q\"\n[for]\ng = \"{family}({order})\"\n[holds]\nproperty = \"{property}\"\ncontrols = [\"edges < 0\"]\n"
    );
    let found = asked(&question)?;
    require(found == Ok(naive), format!("{found:?}, naively {naive:?}"), || question.clone())?;
    Ok(None)
}
