//! Complexes whose topology is known.

use medax::Complex;
use medax::complex::{CellType, ComplexParts, Rows};

/// A small generator of test numbers (Steele, Lea, Flood 2014: splitmix64).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Builds a complex piece by piece; vertices lie at the origin unless set.
#[derive(Clone, Default)]
pub struct Builder {
    pub vertices: Vec<[f64; 3]>,
    pub faces: Vec<Vec<u32>>,
    pub edges: Vec<[u32; 2]>,
    pub cells: Vec<(CellType, Vec<u32>)>,
}

impl Builder {
    pub fn new(vertices: usize) -> Self {
        Builder { vertices: vec![[0.0; 3]; vertices], ..Builder::default() }
    }

    pub fn faces<const N: usize>(mut self, faces: &[[u32; N]]) -> Self {
        self.faces.extend(faces.iter().map(|f| f.to_vec()));
        self
    }

    pub fn edges(mut self, edges: &[[u32; 2]]) -> Self {
        self.edges.extend_from_slice(edges);
        self
    }

    pub fn tets(mut self, cells: &[[u32; 4]]) -> Self {
        self.cells.extend(cells.iter().map(|c| (CellType::Tetrahedron, c.to_vec())));
        self
    }

    /// Adds another complex, its vertices after these.
    pub fn and(mut self, other: &Builder) -> Self {
        let shift = self.vertices.len() as u32;
        self.vertices.extend_from_slice(&other.vertices);
        self.faces.extend(other.faces.iter().map(|f| f.iter().map(|v| v + shift).collect()));
        self.edges.extend(other.edges.iter().map(|e| e.map(|v| v + shift)));
        let shifted = |c: &[u32]| c.iter().map(|v| v + shift).collect();
        self.cells.extend(other.cells.iter().map(|(kind, c)| (*kind, shifted(c))));
        self
    }

    /// Replaces vertices by others; the numbers stay, so that the old ones become isolated.
    pub fn glue(mut self, pairs: &[(u32, u32)]) -> Self {
        let of = |v: u32| pairs.iter().find(|p| p.0 == v).map_or(v, |p| p.1);
        self.faces.iter_mut().for_each(|f| f.iter_mut().for_each(|v| *v = of(*v)));
        self.edges.iter_mut().for_each(|e| *e = e.map(of));
        self.cells.iter_mut().for_each(|c| c.1.iter_mut().for_each(|v| *v = of(*v)));
        self
    }

    /// Leaves out the vertices that nothing uses.
    pub fn compact(mut self) -> Self {
        let mut used: Vec<u32> = self.faces.iter().flatten().copied().collect();
        used.extend(self.cells.iter().flat_map(|c| &c.1));
        used.extend(self.edges.iter().flatten());
        used.sort_unstable();
        used.dedup();
        let of = |v: &mut u32| *v = used.binary_search(v).unwrap() as u32;
        self.faces.iter_mut().flatten().for_each(of);
        self.edges.iter_mut().flatten().for_each(of);
        self.cells.iter_mut().for_each(|c| c.1.iter_mut().for_each(of));
        self.vertices = used.iter().map(|&v| self.vertices[v as usize]).collect();
        self
    }

    pub fn place(mut self, at: impl Fn(usize) -> [f64; 3]) -> Self {
        self.vertices = (0..self.vertices.len()).map(at).collect();
        self
    }

    pub fn build(&self) -> Complex {
        Complex::new(self.parts()).unwrap()
    }

    pub fn parts(&self) -> ComplexParts {
        let mut parts = ComplexParts {
            vertices: self.vertices.clone(),
            edges: self.edges.clone(),
            ..ComplexParts::default()
        };
        let rows = |lists: Vec<&Vec<u32>>| {
            let mut rows = Rows::default();
            lists.iter().for_each(|list| rows.push(list).unwrap());
            rows
        };
        parts.faces = rows(self.faces.iter().collect());
        parts.cells = rows(self.cells.iter().map(|c| &c.1).collect());
        parts.cell_types = self.cells.iter().map(|c| c.0).collect();
        parts
    }
}

/// The four facets of a tetrahedron, outward when its vertices are positively oriented.
pub const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

pub fn tetrahedron() -> Builder {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    Builder::new(4).faces(&TETRAHEDRON).place(|i| corners[i])
}

/// An n x m grid of squares with opposite sides glued: `twist` turns the second gluing round.
/// `quads` says whether the squares stay whole.
pub fn wrapped_grid(n: u32, m: u32, twist: bool, quads: bool) -> Builder {
    let at = |i: u32, j: u32| match i / n {
        0 => i * m + j % m,
        _ if twist => (i % n) * m + (m - j % m) % m,
        _ => (i % n) * m + j % m,
    };
    let mut grid = Builder::new((n * m) as usize);
    for i in 0..n {
        for j in 0..m {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if quads {
                grid = grid.faces(&[[a, b, c, d]]);
            } else {
                grid.faces.extend([vec![a, b, c], vec![a, c, d]]);
            }
        }
    }
    grid
}

pub fn torus(n: u32, m: u32) -> Builder {
    wrapped_grid(n, m, false, false)
}

/// The projective plane on six vertices.
pub fn projective_plane() -> Builder {
    Builder::new(6).faces(&[
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
        [0, 5, 1],
        [1, 2, 4],
        [2, 3, 5],
        [3, 4, 1],
        [4, 5, 2],
        [5, 1, 3],
    ])
}

/// A strip of n squares, closed to a ring; with `twist` a Moebius band.
pub fn band(n: u32, twist: bool) -> Builder {
    let at = |i: u32, side: u32| 2 * (i % n) + if twist && i == n { 1 - side } else { side };
    let mut band = Builder::new(2 * n as usize);
    for i in 0..n {
        band = band
            .faces(&[[at(i, 0), at(i + 1, 0), at(i + 1, 1)], [at(i, 0), at(i + 1, 1), at(i, 1)]]);
    }
    band
}

/// A box of unit cubes, those that `keep` chooses, each cut into six tetrahedra round its diagonal
/// (Freudenthal 1942), so that cubes match.
pub fn cubes(n: [u32; 3], keep: impl Fn([u32; 3]) -> bool) -> Builder {
    let size = n.map(|k| k + 1);
    let vertex = |p: [u32; 3]| (p[0] * size[1] + p[1]) * size[2] + p[2];
    let mut cubes = Builder::new(size.iter().product::<u32>() as usize).place(|i| {
        let i = i as u32;
        let (x, y, z) = (i / (size[1] * size[2]), i / size[2] % size[1], i % size[2]);
        [x, y, z].map(f64::from)
    });
    for i in 0..n.iter().product::<u32>() {
        let p = [i / (n[1] * n[2]), i / n[2] % n[1], i % n[2]];
        if !keep(p) {
            continue;
        }
        for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
            let mut q = p;
            let mut tet = vec![vertex(q)];
            for axis in order {
                q[axis] += 1;
                tet.push(vertex(q));
            }
            cubes.cells.push((CellType::Tetrahedron, tet));
        }
    }
    cubes.compact()
}

/// A disk whose rim runs along one circle of three vertices as often as `word` says, each time
/// forward (1) or backward (-1): [1, 1] is a projective plane, [1, 1, -1] a dunce hat.
pub fn wrapped_disk(word: &[i32]) -> Builder {
    let rim: Vec<u32> =
        word.iter().flat_map(|&w| if w > 0 { [0, 1, 2] } else { [0, 2, 1] }).collect();
    let n = rim.len() as u32;
    let mut disk = Builder::new(n as usize + 4);
    for i in 0..n {
        let next = (i + 1) % n;
        let (a, b) = (rim[i as usize], rim[next as usize]);
        let (p, q, centre) = (3 + i, 3 + next, 3 + n);
        disk = disk.faces(&[[a, b, p], [b, q, p], [p, q, centre]]);
    }
    disk
}

/// A sphere from an octahedron, its faces quartered so often.
pub fn sphere(radius: f64, depth: u32) -> Builder {
    let mut points: Vec<[f64; 3]> = Vec::new();
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let mut p = [0.0; 3];
            p[axis] = sign;
            points.push(p);
        }
    }
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for [i, j, k] in [[0, 0, 0], [0, 1, 1], [1, 0, 1], [1, 1, 0]] {
        faces.push([i, 2 + j, 4 + k]);
        faces.push([1 - i, 4 + 1 - k, 2 + 1 - j]);
    }
    let mut middles = std::collections::BTreeMap::new();
    for _ in 0..depth {
        let mut finer = Vec::new();
        for [a, b, c] in faces {
            let mut middle = |p: u32, q: u32| {
                *middles.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                    let [p, q] = [points[p as usize], points[q as usize]];
                    let m: [f64; 3] = std::array::from_fn(|i| p[i] + q[i]);
                    let length = m.iter().map(|x| x * x).sum::<f64>().sqrt();
                    points.push(m.map(|x| x / length));
                    points.len() as u32 - 1
                })
            };
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        faces = finer;
    }
    let n = points.len();
    Builder::new(n).faces(&faces).place(|i| points[i].map(|x| radius * x))
}

/// The facets that bound one cell only, turned outward: the surface of a solid.
pub fn outer_facets(solid: &Builder) -> Builder {
    let mut count = std::collections::BTreeMap::<Vec<u32>, (usize, Vec<u32>)>::new();
    for (_, c) in &solid.cells {
        let p = |i: usize| solid.vertices[c[i] as usize];
        let edge = |i: usize| -> [f64; 3] { std::array::from_fn(|k| p(i)[k] - p(0)[k]) };
        let (u, v, w) = (edge(1), edge(2), edge(3));
        let det = u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]);
        for f in TETRAHEDRON {
            let mut ring = f.map(|i| c[i as usize]).to_vec();
            if det < 0.0 {
                ring.reverse();
            }
            let mut key = ring.clone();
            key.sort_unstable();
            count.entry(key).or_insert((0, ring)).0 += 1;
        }
    }
    let mut surface = Builder { vertices: solid.vertices.clone(), ..Builder::default() };
    surface.faces = count.into_values().filter(|e| e.0 == 1).map(|e| e.1).collect();
    surface.compact()
}
