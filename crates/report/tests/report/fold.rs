//! Texts for narrow terminals.

use report::folded;

#[test]
fn folded_lines_keep_to_the_width() {
    let text = "short\n  a line that is indented and too long for it\n\nxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\n";
    let narrow = folded(text, 20);
    assert!(narrow.lines().all(|line| line.len() <= 20), "{narrow}");
    assert!(narrow.starts_with("short\n  a line that is\n    indented") && narrow.contains("\n\n"), "{narrow}");
    let letters = |text: &str| text.split_whitespace().collect::<String>();
    assert_eq!(letters(&narrow), letters(text));
    assert_eq!(folded(text, 80), text);
}
