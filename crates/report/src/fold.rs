//! Texts as narrow as a terminal.

use textwrap::core::display_width;
use textwrap::{Options, WordSeparator, WordSplitter, fill};

/// The text with lines of at most this width; what goes on stands two columns further in.
pub fn folded(text: &str, width: usize) -> String {
    let mut lines = String::new();
    for line in text.split_inclusive('\n') {
        let (body, end) = line.strip_suffix('\n').map_or((line, ""), |body| (body, "\n"));
        if display_width(body) <= width {
            lines += line;
            continue;
        }
        let indent = body.len() - body.trim_start_matches(' ').len();
        let indent = " ".repeat((indent + 2).min(width / 2));
        let options = Options::new(width)
            .subsequent_indent(&indent)
            .word_separator(WordSeparator::AsciiSpace)
            .word_splitter(WordSplitter::NoHyphenation);
        lines += &(fill(body, options) + end);
    }
    lines
}
