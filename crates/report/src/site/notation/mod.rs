//! Formulas of the ledger's plain notation as MathML: `e^{i th_k}`, `sum_{k=1}^m lambda_k^t`, `|v| <= 1/2`.
//!
//! The texts of the ledger are read by people on a terminal too, so they stay plain. Here they are read once more: a letter, a
//! Greek name or anything with an index begins a formula, operators join it, and a word of prose ends it. What stands
//! between two `$` is a formula as a whole. Where the reading is not sure the text stays as it is.

mod mathml;
mod tokens;

use crate::page::escape;
use tokens::{Class, Node, classes, tree};

/// A text as HTML.
pub(super) fn typeset(text: &str) -> String {
    let mut out = String::new();
    for (k, part) in text.split('$').enumerate() {
        if k % 2 == 1 {
            out.push_str(&mathml::formula(part, &tree(part)));
        } else {
            prose(part, &mut out);
        }
    }
    out
}

/// A text as markup.
pub(super) fn set(text: &str) -> maud::Markup {
    maud::PreEscaped(typeset(text))
}

/// Prose with the formulas that are found in it.
fn prose(text: &str, out: &mut String) {
    let nodes = tree(text);
    let classes = classes(text, &nodes);
    let mut at = 0;
    while at < nodes.len() {
        let end = run(&classes, at);
        let part = &nodes[at..end.max(at + 1)];
        if end > at && is_worth_setting(text, part) {
            out.push_str(&mathml::formula(text, part));
        } else if part.len() == 1 && part[0].group().is_some() {
            // The prose in brackets has formulas of its own.
            out.push_str(&escape(part[0].open(text)));
            prose(&text[part[0].start + 1..part[0].end - 1], out);
            out.push_str(&escape(part[0].close(text)));
        } else {
            let plain = &text[part[0].start..part[part.len() - 1].end];
            if [",", ".", ";", ":", ")"].contains(&plain) && out.ends_with("</math>") {
                keep_together(out);
                out.push_str(&format!("{plain}</span>"));
            } else {
                out.push_str(&escape(plain));
            }
        }
        at = end.max(at + 1);
    }
}

/// No line is broken between the last formula and the sign of punctuation that follows it.
fn keep_together(out: &mut String) {
    if let Some(start) = out.rfind("<math>") {
        out.insert_str(start, "<span class=\"nb\">");
    }
}

/// Where the formula ends that begins at a node; the same place if none does.
fn run(classes: &[Class], at: usize) -> usize {
    let mut end = at;
    for (k, class) in classes.iter().enumerate().skip(at) {
        match class {
            Class::Operand => end = k + 1,
            Class::Sign if end > at || k == at => {}
            Class::Space if end > at => {}
            _ => break,
        }
    }
    end
}

/// Numbers alone are left as they are.
fn is_worth_setting(text: &str, nodes: &[Node]) -> bool {
    nodes.iter().any(|node| node.is_symbolic(text))
}

#[cfg(test)]
mod tests {
    use super::typeset;

    #[test]
    fn an_x_between_two_operands_is_a_sign_and_else_a_letter() {
        assert!(typeset("v_i x a_i").contains('×'));
        for text in ["x^T L x is the sum of squares", "(I - P) x is bounded", "L x"] {
            let set = typeset(text);
            assert!(!set.contains('×') && set.contains("<mi>x</mi>"), "{set}");
        }
    }
}
