//! Formulas of the ledger's plain notation as MathML.

/// A text as HTML.
pub(super) fn typeset(text: &str) -> String {
    escape(text)
}

/// A text in HTML.
pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A text as markup.
pub(super) fn set(text: &str) -> maud::Markup {
    maud::PreEscaped(typeset(text))
}
