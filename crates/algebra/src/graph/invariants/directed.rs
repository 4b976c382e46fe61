//! Directed graphs: roots and periods. `out[i]` are the ends of the arcs from `i`, loops among them.

use super::distances::distances;
use num_integer::Integer;

/// Whether some vertex is reached from all others along arcs: in a network in which arcs lead to those who are sensed, whether there is somebody whom
/// all follow in the end. Cost: vertices times arcs.
pub fn is_rooted(out: &[Vec<u32>]) -> bool {
    let mut into = vec![Vec::new(); out.len()];
    for (i, ends) in (0u32..).zip(out) {
        ends.iter().for_each(|&j| into[j as usize].push(i));
    }
    (0..out.len()).any(|root| distances(&into, root).iter().all(Option::is_some))
}

/// The greatest common divisor of the lengths of all closed walks, where every vertex is reached from every other; `None` otherwise, and where there is
/// no closed walk. An edge is a closed walk of length 2.
pub fn period(out: &[Vec<u32>]) -> Option<usize> {
    let depth = distances(out, 0).into_iter().collect::<Option<Vec<usize>>>().filter(|depth| !depth.is_empty())?;
    let all_return = (0..out.len()).all(|start| distances(out, start)[0].is_some());
    let arcs = out.iter().enumerate().flat_map(|(i, ends)| ends.iter().map(move |&j| (i, j as usize)));
    let divisor = arcs.fold(0, |divisor: usize, (i, j)| divisor.gcd(&(depth[i] + 1).abs_diff(depth[j])));
    (all_return && divisor > 0).then_some(divisor)
}
