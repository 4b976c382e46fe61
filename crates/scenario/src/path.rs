//! Places of numbers in a file: `state.velocities[1][2]`, with indices from 1.

use std::fmt;

/// One step into a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Step {
    /// To the value of a key.
    Key(String),
    /// To an entry of a list, from 0.
    Index(usize),
}

/// A place in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Path {
    text: String,
    steps: Vec<Step>,
}

impl Path {
    /// Reads a place; nothing where the text is none.
    pub fn parse(text: &str) -> Option<Self> {
        let mut steps = Vec::new();
        for part in text.split('.') {
            let (key, mut rest) = part.find('[').map_or((part, ""), |at| part.split_at(at));
            steps.push(Step::Key(key.to_string()));
            while !rest.is_empty() {
                let (index, after) = rest.strip_prefix('[')?.split_once(']')?;
                steps.push(Step::Index(index.parse::<usize>().ok()?.checked_sub(1)?));
                rest = after;
            }
        }
        Some(Path { text: text.to_string(), steps })
    }

    /// The steps from the top of the file.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::{Path, Step};

    #[test]
    fn places_are_read() {
        let steps = Path::parse("state.velocities[1][12]").expect("a place").steps().to_vec();
        let key = |name: &str| Step::Key(name.to_string());
        assert_eq!(steps, [key("state"), key("velocities"), Step::Index(0), Step::Index(11)]);
        for text in ["a[0]", "a[", "a[1", "a[1]b", "a[x]", "a[-1]"] {
            assert_eq!(Path::parse(text), None, "{text}");
        }
    }
}
