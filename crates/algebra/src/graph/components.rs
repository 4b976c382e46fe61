//! Connected components of a list of edges, in almost linear time.

/// The connected components of the graph on `0..order` with these edges, each sorted, in the order of their smallest vertex.
/// Edges to vertices that are not there are left out. Cost: the number of edges and vertices, up to a logarithm.
pub fn components(order: usize, edges: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let mut parent: Vec<usize> = (0..order).collect();
    for &(i, j) in edges.iter().filter(|&&(i, j)| i.max(j) < order) {
        let (i, j) = (root(&mut parent, i), root(&mut parent, j));
        // The smallest vertex of a component is its root.
        parent[i.max(j)] = i.min(j);
    }
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); order];
    for vertex in 0..order {
        let root = root(&mut parent, vertex);
        members[root].push(vertex);
    }
    members.retain(|members| !members.is_empty());
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
