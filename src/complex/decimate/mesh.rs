//! Triangles that change: who is at a vertex, which edges may be contracted, and contracting them.

use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};

/// The most triangles round an edge that is contracted: a vertex of a great number of them would make
/// each contraction as dear as all of them.
const MOST: usize = 1024;

/// Triangles and the corners at each vertex.
///
/// Invariants: a triangle that is gone has no vertex but `NONE`; the list of a vertex has all its corners, and
/// perhaps some of triangles that are gone. Corner `3 t + k` is vertex `k` of triangle `t`.
pub(super) struct Mesh {
    pub(super) triangles: Vec<[u32; 3]>,
    /// How many are not gone.
    pub(super) count: usize,
    head: Vec<u32>,
    next: Vec<u32>,
    /// Vertices that stay: where the surface is no manifold, or where loose edges and cells are.
    pub(super) fixed: Vec<bool>,
    pub(super) boundary: Vec<bool>,
    /// How often a vertex has changed.
    pub(super) stamp: Vec<u32>,
}

/// The triangles at both ends of an edge.
#[derive(Default)]
pub(super) struct Star {
    pub(super) first: Vec<u32>,
    pub(super) second: Vec<u32>,
    near_first: Vec<u32>,
    near_second: Vec<u32>,
}

impl Mesh {
    /// Takes triangles whose vertices differ, and vertices that stay. Cost: O(n log n).
    pub(super) fn new(
        triangles: Vec<[u32; 3]>,
        fixed: Vec<bool>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let vertices = fixed.len();
        let mut mesh = Mesh {
            count: triangles.len(),
            head: room.filled(vertices, NONE)?,
            next: room.filled(3 * triangles.len(), NONE)?,
            boundary: room.filled(vertices, false)?,
            stamp: room.filled(vertices, 0)?,
            triangles,
            fixed,
        };
        for corner in run.watch((0..mesh.next.len()).rev()) {
            let corner = corner?;
            let v = mesh.triangles[corner / 3][corner % 3] as usize;
            mesh.next[corner] = mesh.head[v];
            mesh.head[v] = corner as u32;
        }
        let (mut star, mut near, mut set) = (Vec::new(), Vec::new(), Vec::new());
        for v in run.watch(0..vertices as u32) {
            mesh.classify(v?, &mut star, &mut near, &mut set);
        }
        Ok(mesh)
    }

    /// Finds out whether a vertex is on the boundary, and whether its triangles are one fan.
    fn classify(
        &mut self,
        v: u32,
        star: &mut Vec<u32>,
        near: &mut Vec<(u32, u32)>,
        set: &mut Vec<u32>,
    ) {
        self.gather(v, star);
        near.clear();
        set.clear();
        set.extend(0..star.len() as u32);
        for (&t, i) in star.iter().zip(0..) {
            near.extend(self.triangles[t as usize].into_iter().filter(|&w| w != v).map(|w| (w, i)));
        }
        near.sort_unstable();
        let root = |set: &mut [u32], mut i: u32| {
            while set[i as usize] != i {
                set[i as usize] = set[set[i as usize] as usize];
                i = set[i as usize];
            }
            i
        };
        let mut fans = star.len();
        for sides in near.chunk_by(|a, b| a.0 == b.0) {
            match *sides {
                [_] => self.boundary[v as usize] = true,
                [(_, i), (_, j)] => {
                    let (i, j) = (root(set, i), root(set, j));
                    set[i.max(j) as usize] = i.min(j);
                    fans -= usize::from(i != j);
                }
                _ => self.fixed[v as usize] = true,
            }
        }
        self.fixed[v as usize] |= fans > 1;
    }

    /// The triangles at a vertex. What is gone leaves the vertex's list.
    pub(super) fn gather(&mut self, v: u32, star: &mut Vec<u32>) {
        star.clear();
        let (mut corner, mut last) = (self.head[v as usize], NONE);
        while corner != NONE {
            let (t, next) = (corner / 3, self.next[corner as usize]);
            if self.triangles[t as usize][0] != NONE {
                star.push(t);
                last = corner;
            } else if last == NONE {
                self.head[v as usize] = next;
            } else {
                self.next[last as usize] = next;
            }
            corner = next;
        }
    }

    /// The vertices next to one, ascending.
    pub(super) fn neighbours(&mut self, v: u32, star: &mut Vec<u32>, near: &mut Vec<u32>) {
        self.gather(v, star);
        self.around(v, star, near);
    }

    fn around(&self, v: u32, star: &[u32], near: &mut Vec<u32>) {
        near.clear();
        near.extend(star.iter().flat_map(|&t| self.triangles[t as usize]).filter(|&w| w != v));
        near.sort_unstable();
        near.dedup();
    }

    /// Whether an edge has one triangle. Edges between vertices on the boundary are looked for in their triangles.
    pub(super) fn is_boundary(&self, u: u32, v: u32) -> bool {
        self.boundary[u as usize]
            && self.boundary[v as usize]
            && self.corners(u).filter(|corner| self.has(corner / 3, v)).count() == 1
    }

    /// The corners in the list of a vertex.
    fn corners(&self, v: u32) -> impl Iterator<Item = u32> {
        let some = |corner: u32| (corner != NONE).then_some(corner);
        let first = some(self.head[v as usize]);
        std::iter::successors(first, move |&corner| some(self.next[corner as usize]))
    }

    fn has(&self, t: u32, v: u32) -> bool {
        self.triangles[t as usize].contains(&v)
    }

    /// Whether contracting an edge leaves the topology as it is, and its star: the vertices next to both ends are
    /// those of the edge's triangles, and no two triangles become the same (the link condition: Dey,
    /// Edelsbrunner, Guha, Nekhayev 1999, a vertex at infinity closing the boundaries).
    pub(super) fn contractible(&mut self, u: u32, v: u32, star: &mut Star) -> bool {
        if self.fixed[u as usize] || self.fixed[v as usize] {
            return false;
        }
        self.gather(u, &mut star.first);
        self.gather(v, &mut star.second);
        let Star { first, second, near_first, near_second } = star;
        if first.len() + second.len() > MOST {
            return false;
        }
        let mut wings = [NONE; 2];
        let mut sides = 0;
        for &t in first.iter().filter(|&&t| self.has(t, v)) {
            let wing = self.triangles[t as usize].into_iter().find(|&w| w != u && w != v);
            if sides < 2 {
                wings[sides] = wing.unwrap_or(NONE);
            }
            sides += 1;
        }
        if sides == 0 || sides > 2 || wings[0] == wings[1] {
            return false;
        }
        self.around(u, first, near_first);
        self.around(v, second, near_second);
        let common = near_first.iter().filter(|w| near_second.binary_search(w).is_ok()).count();
        if common != sides {
            return false;
        }
        let both =
            |star: &[u32], a: u32, b: u32| star.iter().any(|&t| self.has(t, a) && self.has(t, b));
        let one = |star: &[u32], a: u32| star.iter().filter(|&&t| self.has(t, a)).count() == 1;
        if sides == 2 {
            let [a, b] = wings;
            let pinches = self.boundary[u as usize] && self.boundary[v as usize];
            let doubles = both(first, a, b) && both(second, a, b);
            !pinches && !doubles
        } else {
            !(one(first, wings[0]) && one(second, wings[0]))
        }
    }

    /// Contracts an edge to its end `u`, given its star; the triangles of the edge are gone.
    pub(super) fn contract(&mut self, u: u32, v: u32, star: &Star) {
        for &t in &star.second {
            let triangle = &mut self.triangles[t as usize];
            if triangle.contains(&u) {
                *triangle = [NONE; 3];
                self.count -= 1;
                continue;
            }
            for (w, corner) in triangle.iter_mut().zip(3 * t..) {
                if *w == v {
                    *w = u;
                    self.next[corner as usize] = self.head[u as usize];
                    self.head[u as usize] = corner;
                }
            }
        }
        self.head[v as usize] = NONE;
        self.boundary[u as usize] |= self.boundary[v as usize];
        self.stamp[u as usize] += 1;
        self.stamp[v as usize] += 1;
    }
}
