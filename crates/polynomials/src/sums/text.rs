//! A certificate as a file for the separate checker: integers only, the kind `sos` of `proofs_checks/README.md`.

use super::certificate::{Certificate, Square};
use crate::multivariate::Multivariate;
use arithmetic::{Rational, common_denominator, content, rational};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use std::fmt::Write;

type Polynomial = Multivariate<Rational>;

/// A polynomial as a positive number times one with integer coefficients without a common factor.
fn primitive(p: &Polynomial) -> (Rational, Polynomial) {
    let coefficients: Vec<Rational> = p.terms().map(|(_, c)| c.clone()).collect();
    if coefficients.is_empty() {
        return (rational(1, 1), p.clone());
    }
    let denominator = common_denominator(&coefficients);
    let integers: Vec<BigInt> = coefficients.iter().map(|c| c.numer() * (&denominator / c.denom())).collect();
    let factor = Rational::new(content(&integers).abs(), denominator);
    (factor.clone(), p.scaled(&factor.recip()))
}

/// `c,e1,..,en` for each term, or `zero`.
fn words(p: &Polynomial, variables: usize) -> String {
    let term = |(monomial, c): (&Vec<u32>, &Rational)| {
        let exponents = (0..variables).map(|k| monomial.get(k).copied().unwrap_or(0));
        std::iter::once(c.to_string()).chain(exponents.map(|e| e.to_string())).collect::<Vec<_>>().join(",")
    };
    let all: Vec<String> = p.terms().map(term).collect();
    if all.is_empty() { "zero".to_string() } else { all.join(" ") }
}

impl Certificate {
    /// How many variables there are.
    fn variables(&self) -> usize {
        if let Some(statement) = &self.statement {
            return statement.variables;
        }
        let all = self.constraints.iter().chain(&self.equalities).chain(&self.cofactors).chain([&self.goal]);
        let squares = self.terms.iter().flat_map(|(_, squares)| squares).chain(&self.multiplier).map(|(_, l)| l);
        all.chain(squares).map(Multivariate::arity).max().unwrap_or(0).max(1)
    }

    /// What is certified, in words that the checker composes again.
    pub fn claim(&self) -> String {
        if let Some(statement) = &self.statement {
            return statement.text.clone();
        }
        let shown = |p: &Polynomial| primitive(p).1.to_string();
        let names: Vec<String> = (1..=self.variables()).map(|k| format!("x{k}")).collect();
        let above = self.constraints.iter().map(|p| format!("{} >= 0", shown(p)));
        let assumed: Vec<String> = above.chain(self.equalities.iter().map(|p| format!("{} = 0", shown(p)))).collect();
        let condition = if assumed.is_empty() { String::new() } else { format!(" with {}", assumed.join(", ")) };
        let relation = if self.strict { ">" } else { ">=" };
        format!("for all real {}{condition}: {} {relation} 0", names.join(", "), shown(&self.goal))
    }

    /// The file.
    pub fn text(&self) -> String {
        let n = self.variables();
        let goal = primitive(&self.goal);
        let constraints: Vec<_> = self.constraints.iter().map(primitive).collect();
        let equalities: Vec<_> = self.equalities.iter().map(primitive).collect();
        // With the scaled polynomials: multiplier goal = sum weight product square + sum cofactor equality.
        let scaled = |(d, l): &Square, factor: &Rational| {
            let (by, l) = primitive(l);
            (d * &by * &by * factor, l)
        };
        let one = rational(1, 1);
        let multiplier: Vec<Square> = self.multiplier.iter().map(|square| scaled(square, &goal.0)).collect();
        let terms: Vec<(&Vec<usize>, Vec<Square>)> = self
            .terms
            .iter()
            .map(|(factors, squares)| {
                let factor = factors.iter().fold(one.clone(), |factor, &k| factor * &constraints[k].0);
                (factors, squares.iter().map(|square| scaled(square, &factor)).collect())
            })
            .collect();
        let cofactors: Vec<Polynomial> =
            self.cofactors.iter().zip(&equalities).map(|(p, (by, _))| p.scaled(by)).collect();
        let weights = multiplier.iter().chain(terms.iter().flat_map(|(_, list)| list)).map(|(d, _)| d.clone());
        let numbers: Vec<Rational> =
            weights.chain(cofactors.iter().flat_map(|p| p.terms().map(|(_, c)| c.clone()))).collect();
        let whole = Rational::from_integer(common_denominator(&numbers));
        let mut text = format!("flockproof-certificate 1 sos\nclaim {}\n", self.claim());
        let _ = self.statement.iter().try_for_each(|statement| writeln!(text, "says {}", statement.text));
        let _ = writeln!(text, "variables {n}");
        let listed = |text: &mut String, name: &str, own: &str, list: &[(Rational, Polynomial)]| {
            let _ = writeln!(text, "{name} {}", list.len());
            list.iter().for_each(|(_, p)| {
                let _ = writeln!(text, "{own} {}", words(p, n));
            });
        };
        listed(&mut text, "constraints", "constraint", &constraints);
        listed(&mut text, "equalities", "equality", &equalities);
        let _ = writeln!(text, "goal {}\nrelation {}", words(&goal.1, n), if self.strict { ">" } else { ">=" });
        let squares = |text: &mut String, name: &str, list: &[Square]| {
            let kept: Vec<&Square> = list.iter().filter(|(d, l)| !d.is_zero() && !l.is_zero()).collect();
            let _ = writeln!(text, "{name} {}", kept.len());
            for (d, l) in kept {
                // Of a root and its negative the one whose first coefficient is positive.
                let turned = l.terms().next().is_some_and(|(_, c)| c.is_negative());
                let root = if turned { -l.clone() } else { l.clone() };
                let _ = writeln!(text, "square {} {}", d * &whole, words(&root, n));
            }
        };
        squares(&mut text, "multiplier", &multiplier);
        let _ = writeln!(text, "terms {}", terms.len());
        for (factors, list) in &terms {
            let numbers: Vec<String> = factors.iter().map(|k| (k + 1).to_string()).collect();
            let _ =
                writeln!(text, "factors {}", if numbers.is_empty() { "none".to_string() } else { numbers.join(" ") });
            squares(&mut text, "squares", list);
        }
        for cofactor in &cofactors {
            let _ = writeln!(text, "cofactor {}", words(&cofactor.scaled(&whole), n));
        }
        text + "end\n"
    }
}
