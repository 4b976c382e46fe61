//! Whether a graph can be drawn in the plane without crossings.
//!
//! Demoucron, Malgrange and Pertuiset (1964): a block is drawn piece by piece. The pieces of what is not drawn yet hang on vertices that are drawn; each
//! must go into one face that has all of them on its border. If some piece has no such face, the graph is not planar; one with a single face goes first,
//! and otherwise any will do. Cost: at most the square of the edges.

use crate::graph::Graph;

impl Graph {
    /// Whether it can be drawn in the plane without crossings.
    pub fn is_planar(&self) -> bool {
        let (order, edges) = (self.order(), self.edges().len());
        // The two graphs of Kuratowski have nine edges or more; by Euler no planar graph has more than 3 n - 6.
        if order <= 4 || edges <= 8 {
            return true;
        }
        edges <= 3 * order - 6 && self.blocks().into_iter().all(|block| block.len() <= 8 || is_planar_block(&block))
    }

    /// The edges of each maximal part that no single vertex holds together (Tarjan), without recursion.
    fn blocks(&self) -> Vec<Vec<(usize, usize)>> {
        let order = self.order();
        let (mut number, mut low, mut count) = (vec![0; order], vec![0; order], 0);
        let (mut open, mut blocks) = (Vec::new(), Vec::new());
        for start in 0..order {
            if number[start] > 0 {
                continue;
            }
            count += 1;
            (number[start], low[start]) = (count, count);
            // A vertex, where it was come from, and which of its neighbours is next.
            let mut stack = vec![(start, usize::MAX, 0)];
            while let Some((v, parent, next)) = stack.last_mut() {
                let (v, parent) = (*v, *parent);
                if let Some(&w) = self.neighbours(v).get(*next) {
                    *next += 1;
                    let w = w as usize;
                    if number[w] == 0 {
                        count += 1;
                        (number[w], low[w]) = (count, count);
                        open.push((v, w));
                        stack.push((w, v, 0));
                    } else if w != parent && number[w] < number[v] {
                        open.push((v, w));
                        low[v] = low[v].min(number[w]);
                    }
                    continue;
                }
                stack.pop();
                if parent == usize::MAX {
                    continue;
                }
                low[parent] = low[parent].min(low[v]);
                if low[v] >= number[parent] {
                    let first = open.iter().rposition(|&edge| edge == (parent, v)).unwrap_or(0);
                    blocks.push(open.split_off(first));
                }
            }
        }
        blocks
    }
}

/// A part that is not drawn yet: the drawn vertices that it hangs on, and the others.
struct Piece {
    ends: Vec<usize>,
    inner: Vec<usize>,
}

fn is_planar_block(edges: &[(usize, usize)]) -> bool {
    let mut names: Vec<usize> = edges.iter().flat_map(|&(i, j)| [i, j]).collect();
    names.sort_unstable();
    names.dedup();
    let place = |v: usize| names.binary_search(&v).unwrap_or(0);
    let order = names.len();
    let mut near = vec![Vec::new(); order];
    for (i, j) in edges.iter().map(|&(i, j)| (place(i), place(j))) {
        near[i].push(j);
        near[j].push(i);
    }
    if edges.len() > 3 * order.max(3) - 6 {
        return false;
    }
    let Some(cycle) = cycle(&near) else { return true };
    let mut drawn = Drawn::new(order, &cycle);
    loop {
        let pieces = drawn.pieces(&near);
        if pieces.is_empty() {
            return true;
        }
        let mut chosen: Option<(&Piece, usize, usize)> = None;
        for piece in &pieces {
            let fitting = |face: &Vec<usize>| piece.ends.iter().all(|v| face.contains(v));
            let mut faces = (0..drawn.faces.len()).filter(|&k| fitting(&drawn.faces[k]));
            let Some(first) = faces.next() else { return false };
            let others = faces.count();
            if chosen.is_none_or(|(_, _, least)| others < least) {
                chosen = Some((piece, first, others));
            }
        }
        let Some((piece, face, _)) = chosen else { return true };
        // Every piece of a block hangs on two vertices or more.
        let Some(path) = piece.path(&near) else { return false };
        drawn.add(&path, face);
    }
}

/// A cycle of a block with more than one edge.
fn cycle(near: &[Vec<usize>]) -> Option<Vec<usize>> {
    let (mut path, mut place, mut next) = (vec![0], vec![None; near.len()], vec![0; near.len()]);
    place[0] = Some(0);
    while let Some(&v) = path.last() {
        let Some(&w) = near[v].get(next[v]) else {
            path.pop();
            continue;
        };
        next[v] += 1;
        match place[w] {
            Some(start) if path.len() >= 2 && path[path.len() - 2] != w => return Some(path.split_off(start)),
            Some(_) => {}
            None => {
                place[w] = Some(path.len());
                path.push(w);
            }
        }
    }
    None
}

/// What is drawn.
struct Drawn {
    vertices: Vec<bool>,
    edges: Vec<Vec<bool>>,
    /// The borders of the faces, cycles all of them.
    faces: Vec<Vec<usize>>,
}

impl Drawn {
    fn new(order: usize, cycle: &[usize]) -> Self {
        let mut drawn = Drawn {
            vertices: vec![false; order],
            edges: vec![vec![false; order]; order],
            faces: vec![cycle.to_vec(), cycle.to_vec()],
        };
        drawn.draw(cycle);
        drawn.draw(&[cycle[cycle.len() - 1], cycle[0]]);
        drawn
    }

    fn draw(&mut self, path: &[usize]) {
        path.iter().for_each(|&v| self.vertices[v] = true);
        for pair in path.windows(2) {
            self.edges[pair[0]][pair[1]] = true;
            self.edges[pair[1]][pair[0]] = true;
        }
    }

    /// Single edges between drawn vertices, and parts that hang together outside them.
    fn pieces(&self, near: &[Vec<usize>]) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let mut known = self.vertices.clone();
        for (i, ends) in near.iter().enumerate() {
            if self.vertices[i] {
                let missing = ends.iter().filter(|&&j| i < j && self.vertices[j] && !self.edges[i][j]);
                pieces.extend(missing.map(|&j| Piece { ends: vec![i, j], inner: Vec::new() }));
            } else if !known[i] {
                known[i] = true;
                let mut piece = Piece { ends: Vec::new(), inner: vec![i] };
                let mut next = 0;
                while let Some(&v) = piece.inner.get(next) {
                    next += 1;
                    for &w in &near[v] {
                        if self.vertices[w] {
                            piece.ends.push(w);
                        } else if !known[w] {
                            known[w] = true;
                            piece.inner.push(w);
                        }
                    }
                }
                piece.ends.sort_unstable();
                piece.ends.dedup();
                pieces.push(piece);
            }
        }
        pieces
    }

    /// Draws a path between two vertices of the border of a face, which it divides.
    fn add(&mut self, path: &[usize], face: usize) {
        self.draw(path);
        let border = self.faces.swap_remove(face);
        let (first, last) = (path[0], path[path.len() - 1]);
        let start = border.iter().position(|&v| v == first).unwrap_or(0);
        let turned: Vec<usize> = border[start..].iter().chain(&border[..start]).copied().collect();
        let end = turned.iter().position(|&v| v == last).unwrap_or(0);
        let inner = &path[1..path.len() - 1];
        // From the first vertex along the border to the last one, and back along the path; and the other way round.
        self.faces.push(turned[..=end].iter().chain(inner.iter().rev()).copied().collect());
        self.faces.push(turned[end..].iter().chain([&turned[0]]).chain(inner).copied().collect());
    }
}

impl Piece {
    /// A path through it from its first end to another one.
    fn path(&self, near: &[Vec<usize>]) -> Option<Vec<usize>> {
        let first = self.ends[0];
        if self.inner.is_empty() {
            return Some(self.ends.clone());
        }
        let mut before = vec![usize::MAX; near.len()];
        let mut queue: Vec<usize> = self.inner.iter().copied().filter(|&v| near[v].contains(&first)).take(1).collect();
        queue.iter().for_each(|&v| before[v] = first);
        let mut next = 0;
        while let Some(&v) = queue.get(next) {
            next += 1;
            if let Some(&end) = near[v].iter().find(|end| **end != first && self.ends.contains(end)) {
                let mut path = vec![end];
                let mut at = v;
                while at != first {
                    path.push(at);
                    at = before[at];
                }
                path.push(first);
                path.reverse();
                return Some(path);
            }
            for &w in near[v].iter().filter(|&&w| self.inner.contains(&w)) {
                if before[w] == usize::MAX {
                    before[w] = v;
                    queue.push(w);
                }
            }
        }
        None
    }
}
