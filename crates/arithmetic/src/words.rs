//! Words over a finite alphabet, for families that are gone through one by one.

/// All words of this length over `0..letters`, the first letter changing fastest.
///
/// ```
/// let all: Vec<Vec<usize>> = flockproof_arithmetic::words(2, 2).collect();
/// assert_eq!(all, [[0, 0], [1, 0], [0, 1], [1, 1]]);
/// ```
pub fn words(letters: usize, length: usize) -> impl Iterator<Item = Vec<usize>> {
    let first = (letters > 0 || length == 0).then(|| vec![0; length]);
    std::iter::successors(first, move |word| {
        let place = word.iter().position(|letter| letter + 1 < letters)?;
        let mut next = word.clone();
        next[..place].fill(0);
        next[place] += 1;
        Some(next)
    })
}
