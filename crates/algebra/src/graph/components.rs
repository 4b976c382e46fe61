//! Connected components of a list of edges, in almost linear time.

/// The number of the connected component of each of `0..order`, in the order of their smallest vertices, and how many there are. Edges to vertices that
/// are not there are left out. Cost: the number of edges and vertices, up to a logarithm.
pub fn component_numbers(order: usize, edges: impl IntoIterator<Item = (usize, usize)>) -> (Vec<usize>, usize) {
    let mut parent: Vec<usize> = (0..order).collect();
    for (i, j) in edges.into_iter().filter(|&(i, j)| i.max(j) < order) {
        let (i, j) = (root(&mut parent, i), root(&mut parent, j));
        // The smallest vertex of a component is its root.
        parent[i.max(j)] = i.min(j);
    }
    let (mut numbers, mut count) = (vec![0; order], 0);
    for vertex in 0..order {
        let root = root(&mut parent, vertex);
        numbers[vertex] = if root == vertex { count } else { numbers[root] };
        count += usize::from(root == vertex);
    }
    (numbers, count)
}

/// The connected components, each sorted, in that order.
pub fn components(order: usize, edges: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let (numbers, count) = component_numbers(order, edges.iter().copied());
    let mut members = vec![Vec::new(); count];
    numbers.into_iter().zip(0..).for_each(|(number, vertex)| members[number].push(vertex));
    members
}

/// The root of a vertex; the way there is halved.
fn root(parent: &mut [usize], mut vertex: usize) -> usize {
    while parent[vertex] != vertex {
        parent[vertex] = parent[parent[vertex]];
        vertex = parent[vertex];
    }
    vertex
}
