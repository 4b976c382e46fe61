//! What a `sos` says in the words of who asked: `for all x in [0, 1], y in R: x + y > 1 or 4*x*y <= 1`. Where all comparisons but one are false, that one has to be what is certified.

use crate::Refusal;
use crate::read::Reader;
use crate::sos::{Polynomial, add, times};
use num_bigint::{BigInt, Sign};

const MOST_COMPARISONS: usize = 32;
const MOST_DEPTH: usize = 64;
const MOST_EXPONENT: usize = 100;

/// A polynomial over a positive number.
struct Quotient {
    over: Polynomial,
    under: BigInt,
}

/// `over` compared with 0: at least, above, or other than.
struct Comparison {
    over: Polynomial,
    relation: &'static str,
}

struct Parser<'a, 'r, 'l> {
    reader: &'r mut Reader<'l>,
    rest: &'a str,
    names: Vec<&'a str>,
    depth: usize,
}

/// Refuses unless the statement follows from the goal, which holds where the constraints are at least 0.
pub fn check(
    reader: &mut Reader,
    text: &str,
    variables: usize,
    constraints: &[Polynomial],
    (goal, relation): (&Polynomial, &str),
) -> Result<(), Refusal> {
    let mut parser = Parser { reader, rest: text, names: Vec::new(), depth: 0 };
    let mut assumed = parser.ranges()?;
    parser.require(parser.names.len() == variables, "the statement has another number of variables")?;
    let clause = parser.clause()?;
    let proved = clause.iter().position(|own| match own.relation {
        ">=" => is_multiple(&own.over, goal),
        ">" => relation == ">" && is_multiple(&own.over, goal),
        _ => relation == ">" && (is_multiple(&own.over, goal) || is_multiple(&negated(&own.over), goal)),
    });
    let Some(proved) = proved else { return Err(reader.refusal("the statement has no comparison that is the goal")) };
    for (_, other) in clause.into_iter().enumerate().filter(|(place, _)| *place != proved) {
        // Where it is false: at most 0, or 0.
        if other.relation == "!=" {
            assumed.push(other.over.clone());
        }
        assumed.push(negated(&other.over));
    }
    let known = constraints.iter().all(|own| assumed.iter().any(|other| is_multiple(other, own)));
    reader.require(known, "a constraint does not follow from the statement")
}

fn negated(p: &Polynomial) -> Polynomial {
    p.iter().map(|(exponents, c)| (exponents.clone(), -c)).collect()
}

/// Whether one is a positive number times the other.
fn is_multiple(a: &Polynomial, b: &Polynomial) -> bool {
    let (Some((_, p)), Some((_, q))) = (a.first_key_value(), b.first_key_value()) else { return a == b };
    let same = p.sign() == q.sign() && a.len() == b.len();
    same && a.iter().zip(b).all(|((m, x), (n, y))| m == n && x * q == y * p)
}

impl<'a> Parser<'a, '_, '_> {
    fn require(&self, holds: bool, reason: &str) -> Result<(), Refusal> {
        self.reader.require(holds, reason)
    }

    fn eat(&mut self, token: &str) -> bool {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn expect(&mut self, token: &str) -> Result<(), Refusal> {
        let eaten = self.eat(token);
        self.require(eaten, &format!("`{token}` is expected in the statement"))
    }

    /// A word of letters, digits and the signs of names of numbers in a file.
    fn word(&mut self) -> Result<&'a str, Refusal> {
        self.rest = self.rest.trim_start();
        let inside = |c: char| c.is_ascii_alphanumeric() || "_.[]".contains(c);
        let length = self.rest.find(|c| !inside(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(length);
        self.require(word.starts_with(|c: char| c.is_ascii_alphabetic()), "a name is expected in the statement")?;
        self.rest = rest;
        Ok(word)
    }

    /// `for all x in [p, q], y in R:` as polynomials that are at least 0.
    fn ranges(&mut self) -> Result<Vec<Polynomial>, Refusal> {
        self.expect("for all ")?;
        let mut ends = Vec::new();
        loop {
            let name = self.word()?;
            let fresh = !self.names.contains(&name);
            self.require(fresh, "a name of the statement comes twice")?;
            self.names.push(name);
            self.expect("in ")?;
            if self.eat("[") {
                let lo = self.signed_number()?;
                self.expect(",")?;
                let hi = self.signed_number()?;
                self.expect("]")?;
                ends.push(Some((lo, hi)));
            } else {
                self.expect("R")?;
                ends.push(None);
            }
            if !self.eat(",") {
                break;
            }
        }
        self.expect(":")?;
        let (n, mut all) = (self.names.len(), Vec::new());
        for (k, end) in ends.into_iter().enumerate() {
            let Some(((lo, under), (hi, over))) = end else { continue };
            let line = |slope: BigInt, constant: BigInt| {
                let mut p = Polynomial::new();
                let mut exponents = vec![0; n];
                add(&mut p, exponents.clone(), constant);
                exponents[k] = 1;
                add(&mut p, exponents, slope);
                p
            };
            all.extend([line(under, -lo), line(-over, hi)]);
        }
        Ok(all)
    }

    /// Numerator and denominator.
    fn number(&mut self) -> Result<(BigInt, BigInt), Refusal> {
        let over = self.digits()?;
        let under = if self.eat("/") { self.digits()? } else { BigInt::from(1) };
        self.require(under.sign() == Sign::Plus, "a denominator of the statement is 0")?;
        Ok((over, under))
    }

    fn signed_number(&mut self) -> Result<(BigInt, BigInt), Refusal> {
        let negative = self.eat("-");
        let (over, under) = self.number()?;
        Ok((if negative { -over } else { over }, under))
    }

    fn digits(&mut self) -> Result<BigInt, Refusal> {
        self.rest = self.rest.trim_start();
        let length = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(length);
        self.rest = rest;
        self.reader.integer(digits)
    }

    fn clause(&mut self) -> Result<Vec<Comparison>, Refusal> {
        let mut clause = vec![self.comparison()?];
        while self.eat("or ") {
            self.require(clause.len() < MOST_COMPARISONS, "the statement has too many comparisons")?;
            clause.push(self.comparison()?);
        }
        let over = self.rest.trim().is_empty();
        self.require(over, "the end of the statement is expected")?;
        Ok(clause)
    }

    fn comparison(&mut self) -> Result<Comparison, Refusal> {
        let left = self.sum()?;
        let relations = [">=", "<=", "!=", ">", "<"];
        let relation = relations.into_iter().find(|relation| self.eat(relation));
        let Some(relation) = relation else {
            return Err(self.reader.refusal("a comparison is expected in the statement"));
        };
        let right = self.sum()?;
        let (relation, above, below) = match relation {
            "<=" => (">=", right, left),
            "<" => (">", right, left),
            other => (other, left, right),
        };
        Ok(Comparison { over: self.plus(above, below, true)?.over, relation })
    }

    fn sum(&mut self) -> Result<Quotient, Refusal> {
        let mut sum = self.product()?;
        loop {
            let negative = if self.eat("+") {
                false
            } else if self.eat("-") {
                true
            } else {
                return Ok(sum);
            };
            let next = self.product()?;
            sum = self.plus(sum, next, negative)?;
        }
    }

    fn product(&mut self) -> Result<Quotient, Refusal> {
        let mut product = self.factor()?;
        while self.eat("*") {
            let next = self.factor()?;
            product = self.times(&product, &next)?;
        }
        Ok(product)
    }

    fn factor(&mut self) -> Result<Quotient, Refusal> {
        self.depth += 1;
        self.require(self.depth <= MOST_DEPTH, "the statement is nested too deeply")?;
        let found = self.unguarded_factor();
        self.depth -= 1;
        found
    }

    fn unguarded_factor(&mut self) -> Result<Quotient, Refusal> {
        if self.eat("-") {
            let body = self.factor()?;
            return Ok(Quotient { over: negated(&body.over), under: body.under });
        }
        let base = self.primary()?;
        if !self.eat("^") {
            return Ok(base);
        }
        let exponent: Option<usize> = self.digits()?.try_into().ok();
        let exponent = exponent.filter(|exponent| (1..=MOST_EXPONENT).contains(exponent));
        let Some(exponent) = exponent else { return Err(self.reader.refusal("an exponent from 1 to 100 is expected")) };
        let mut power = Quotient { over: base.over.clone(), under: base.under.clone() };
        for _ in 1..exponent {
            power = self.times(&power, &base)?;
        }
        Ok(power)
    }

    fn primary(&mut self) -> Result<Quotient, Refusal> {
        if self.eat("(") {
            let body = self.sum()?;
            self.expect(")")?;
            return Ok(body);
        }
        let mut exponents = vec![0; self.names.len()];
        let mut over = Polynomial::new();
        if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            let (c, under) = self.number()?;
            // 1/2^2 is read in two ways.
            self.require(
                under == BigInt::from(1) || !self.rest.trim_start().starts_with('^'),
                "a power of a fraction needs brackets",
            )?;
            add(&mut over, exponents, c);
            return Ok(Quotient { over, under });
        }
        let word = self.word()?;
        let Some(place) = self.names.iter().position(|name| *name == word) else {
            return Err(self.reader.refusal("the statement has a name without a range"));
        };
        exponents[place] = 1;
        add(&mut over, exponents, BigInt::from(1));
        Ok(Quotient { over, under: BigInt::from(1) })
    }

    fn plus(&mut self, a: Quotient, b: Quotient, negative: bool) -> Result<Quotient, Refusal> {
        let constant = |c: &BigInt| Polynomial::from([(vec![0; self.names.len()], c.clone())]);
        let (by_a, by_b) = (constant(&b.under), constant(&a.under));
        let mut over = times(self.reader, &a.over, &by_a)?;
        let other = times(self.reader, &b.over, &by_b)?;
        other.into_iter().for_each(|(exponents, c)| add(&mut over, exponents, if negative { -c } else { c }));
        Ok(Quotient { over, under: a.under * b.under })
    }

    fn times(&mut self, a: &Quotient, b: &Quotient) -> Result<Quotient, Refusal> {
        self.reader.pay(1, crate::budget::bits([&a.under]), crate::budget::bits([&b.under]))?;
        let over = times(self.reader, &a.over, &b.over)?;
        let small = over.keys().flatten().all(|exponent| *exponent <= MOST_EXPONENT);
        self.require(small, "an exponent of the statement is above 100")?;
        Ok(Quotient { over, under: &a.under * &b.under })
    }
}
