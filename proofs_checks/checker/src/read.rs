//! Reading: printable ASCII in lines, words apart by one space, numbers in decimal without leading zeros.

use crate::Refusal;
use crate::budget::{Budget, bits};
use crate::matrix::Matrix;
use num_bigint::{BigInt, Sign};

const MOST_BYTES: usize = 4 << 20;
const MOST_DIGITS: usize = 10_000;

/// A fraction as it was written, with a positive denominator.
#[derive(Clone)]
pub struct Fraction<'a> {
    pub numerator: BigInt,
    pub denominator: BigInt,
    pub text: &'a str,
}

impl Fraction<'_> {
    pub fn is_positive(&self) -> bool {
        self.numerator.sign() == Sign::Plus
    }

    pub fn is_less_than(&self, other: &Fraction) -> bool {
        &self.numerator * &other.denominator < &other.numerator * &self.denominator
    }
}

/// The lines of a certificate, one after the other.
pub struct Reader<'a> {
    lines: Vec<&'a str>,
    at: usize,
    budget: Budget,
}

impl<'a> Reader<'a> {
    pub fn new(bytes: &'a [u8], work: u64) -> Result<Self, Refusal> {
        let refusal = |line: usize, reason: &str| Err(Refusal { line, reason: reason.to_string() });
        if bytes.len() > MOST_BYTES {
            return refusal(1, "the file is longer than 4 MiB");
        }
        let line_of = |at: usize| 1 + bytes[..at].iter().filter(|&&byte| byte == b'\n').count();
        if let Some(at) = bytes.iter().position(|&byte| byte != b'\n' && !(b' '..=b'~').contains(&byte)) {
            return refusal(line_of(at), "a byte that is not printable ASCII");
        }
        let Some(text) = std::str::from_utf8(bytes).ok().and_then(|text| text.strip_suffix('\n')) else {
            return refusal(line_of(bytes.len()), "the last line does not end");
        };
        Ok(Reader { lines: text.split('\n').collect(), at: 0, budget: Budget::new(work) })
    }

    /// A refusal at the line that was read last.
    pub fn refusal(&self, reason: impl Into<String>) -> Refusal {
        Refusal { line: self.at.max(1), reason: reason.into() }
    }

    /// Refuses unless something is so.
    pub fn require(&self, holds: bool, reason: &str) -> Result<(), Refusal> {
        if holds { Ok(()) } else { Err(self.refusal(reason)) }
    }

    /// Pays for products of numbers of these lengths before they are computed.
    pub fn pay(&mut self, products: usize, bits: u64, other_bits: u64) -> Result<(), Refusal> {
        let covered = self.budget.covers(products, bits, other_bits);
        self.require(covered, "checking it would take too long")
    }

    /// Pays for and computes a product of matrices that fit.
    pub fn times(&mut self, left: &Matrix, right: &Matrix) -> Result<Matrix, Refusal> {
        let products = left.rows.saturating_mul(left.cols).saturating_mul(right.cols);
        self.pay(products.saturating_add(1), left.bits(), right.bits())?;
        Ok(left.times(right))
    }

    fn line(&mut self) -> Result<&'a str, Refusal> {
        let line = self.lines.get(self.at).copied();
        self.at += 1;
        line.ok_or_else(|| self.refusal("the file ends too early"))
    }

    /// What follows a keyword on its line.
    pub fn value(&mut self, keyword: &str) -> Result<&'a str, Refusal> {
        let value = self.line()?.strip_prefix(keyword).and_then(|rest| rest.strip_prefix(' '));
        value.ok_or_else(|| self.refusal(format!("a line `{keyword} ..` is expected")))
    }

    /// As [`Reader::value`], where the next line starts with the keyword.
    pub fn value_if_any(&mut self, keyword: &str) -> Option<&'a str> {
        let value = self.lines.get(self.at)?.strip_prefix(keyword)?.strip_prefix(' ')?;
        self.at += 1;
        Some(value)
    }

    /// The line `for CLAIM RESULT`, where it stands: two names of letters, digits, `_`, `-` and `.`.
    pub fn belongs(&mut self) -> Result<Option<(String, String)>, Refusal> {
        let Some(value) = self.value_if_any("for") else { return Ok(None) };
        let is_name =
            |word: &str| !word.is_empty() && word.bytes().all(|b| b.is_ascii_alphanumeric() || b"_-.".contains(&b));
        match value.split_once(' ') {
            Some((claim, result)) if is_name(claim) && is_name(result) => Ok(Some((claim.into(), result.into()))),
            _ => Err(self.refusal("a line `for CLAIM RESULT` is expected")),
        }
    }

    /// The last line.
    pub fn end(&mut self) -> Result<(), Refusal> {
        let line = self.line()?;
        self.require(line == "end", "a line `end` is expected")?;
        if self.at == self.lines.len() {
            return Ok(());
        }
        self.at += 1;
        Err(self.refusal("something follows the line `end`"))
    }

    pub fn integer(&self, word: &str) -> Result<BigInt, Refusal> {
        let digits = word.strip_prefix('-').unwrap_or(word);
        let canonical = !digits.is_empty()
            && digits.bytes().all(|byte| byte.is_ascii_digit())
            && (!digits.starts_with('0') || word == "0");
        self.require(canonical, "an integer in decimal is expected")?;
        self.require(digits.len() <= MOST_DIGITS, "a number of more than 10000 digits")?;
        word.parse().map_err(|_| self.refusal("an integer in decimal is expected"))
    }

    /// A number from `least` to `most`.
    pub fn count_of(&self, word: &str, least: usize, most: usize) -> Result<usize, Refusal> {
        let count: Option<usize> = self.integer(word)?.try_into().ok();
        let outside = || self.refusal(format!("a number from {least} to {most} is expected"));
        count.filter(|count| (least..=most).contains(count)).ok_or_else(outside)
    }

    /// A line with a keyword and a number from `least` to `most`.
    pub fn count(&mut self, keyword: &str, least: usize, most: usize) -> Result<usize, Refusal> {
        let word = self.value(keyword)?;
        self.count_of(word, least, most)
    }

    /// `p` or `p/q`.
    pub fn fraction_of(&self, text: &'a str) -> Result<Fraction<'a>, Refusal> {
        let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
        let (numerator, denominator) = (self.integer(numerator)?, self.integer(denominator)?);
        self.require(denominator.sign() == Sign::Plus, "a denominator is not positive")?;
        Ok(Fraction { numerator, denominator, text })
    }

    pub fn fraction(&mut self, keyword: &str) -> Result<Fraction<'a>, Refusal> {
        let text = self.value(keyword)?;
        self.fraction_of(text)
    }

    /// A line `keyword P Q` with P < Q.
    pub fn range(&mut self, keyword: &str) -> Result<(Fraction<'a>, Fraction<'a>), Refusal> {
        let value = self.value(keyword)?;
        let (low, high) = value.split_once(' ').ok_or_else(|| self.refusal("two numbers are expected"))?;
        let (low, high) = (self.fraction_of(low)?, self.fraction_of(high)?);
        self.require(low.is_less_than(&high), "the first number is not the smaller one")?;
        Ok((low, high))
    }

    /// A line `keyword over D`, then the numerators, a line for each row.
    pub fn matrix(&mut self, keyword: &str, rows: usize, cols: usize) -> Result<Matrix, Refusal> {
        let denominator = self.value(keyword)?.strip_prefix("over ");
        let denominator = denominator.ok_or_else(|| self.refusal(format!("`{keyword} over D` is expected")))?;
        let denominator = self.integer(denominator)?;
        self.require(denominator.sign() == Sign::Plus, "the denominator is not positive")?;
        let mut entries = Vec::new();
        for _ in 0..rows {
            let line = self.line()?;
            let before = entries.len();
            for word in line.split(' ') {
                entries.push(self.integer(word)?);
            }
            self.require(entries.len() - before == cols, &format!("a row of {cols} numbers is expected"))?;
        }
        Ok(Matrix { rows, cols, entries, denominator })
    }

    /// As [`Reader::matrix`], row-stochastic.
    pub fn stochastic(&mut self, keyword: &str, rows: usize, cols: usize) -> Result<Matrix, Refusal> {
        let above = self.at + 1;
        let matrix = self.matrix(keyword, rows, cols)?;
        self.pay(rows * cols, bits(&matrix.entries), 0)?;
        for i in 0..rows {
            let row = matrix.row(i);
            let refuse = |reason: &str| Err(Refusal { line: above + 1 + i, reason: reason.to_string() });
            if row.iter().any(|x| x.sign() == Sign::Minus) {
                return refuse("a negative entry");
            }
            if row.iter().sum::<BigInt>() != matrix.denominator {
                return refuse("the row does not sum to one");
            }
        }
        Ok(matrix)
    }
}
