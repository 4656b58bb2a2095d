//! Pruning: candidate triangles that end in sharp edges.

use super::sheet::Sheet;
use crate::error::Result;
use crate::job::{Room, Run};
use crate::triangulation::Triangulation;
use crate::vector::{Vec3, dot, sub};

/// The vertices whose stars a thread looks at in one go.
const STARS: usize = 1 << 10;

/// Which triangles are left when those with sharp edges at well sampled vertices are gone.
///
/// An edge is *sharp* if it has one triangle, or two successive ones round it make an angle of more than 3 pi / 2 (Amenta, Choi, Dey, Leekha 2002,
/// section 4): that is so just where all its triangles lie within less than pi / 2. Triangles with such an edge go, which may make
/// others sharp. A surface with a boundary would go as a whole; so only vertices that keep an *umbrella* by themselves, some
/// triangles without a sharp edge at that vertex, have triangles removed (Dey, Giesen 2001, section 5, remove none at the boundary; the
/// umbrella is the authors' own test of what is not boundary). A vertex that has none, or loses it as others remove its triangles, counts as
/// boundary from then on, `is_inner` being cleared. Rounds look at all vertices at once, so that the order does not matter.
pub(super) fn prune(
    t: &Triangulation,
    sheet: &Sheet<'_>,
    is_inner: &mut [bool],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<bool>> {
    let mut kept = room.filled(sheet.len(), true)?;
    let mut next: Vec<u32> = Vec::new();
    for v in (0..is_inner.len() as u32).filter(|&v| is_inner[v as usize]) {
        room.push(&mut next, v)?;
    }
    while !next.is_empty() {
        run.poll()?;
        let found = run.in_parallel(next.chunks(STARS).collect(), |vertices| {
            let mut star = Star::default();
            let mut found = Vec::new();
            for &v in vertices {
                run.poll()?;
                star.read(t, sheet, &kept, v);
                star.shrink();
                if !star.kept.contains(&true) {
                    found.push((v, None));
                    continue;
                }
                let gone = star.facets.iter().zip(&star.kept).filter(|(_, kept)| !**kept);
                found.extend(gone.map(|(&facet, _)| (v, Some(facet))));
            }
            Ok(found)
        })?;
        next.clear();
        for (v, facet) in found.into_iter().flatten() {
            match facet {
                None => is_inner[v as usize] = false,
                Some(facet) if kept[facet as usize] => {
                    kept[facet as usize] = false;
                    for &corner in &sheet.corners[facet as usize] {
                        room.push(&mut next, corner)?;
                    }
                }
                Some(_) => {}
            }
        }
        next.retain(|&v| is_inner[v as usize]);
        next.sort_unstable();
        next.dedup();
    }
    Ok(kept)
}

/// Removes flaps: triangles that have an edge to themselves, and another with two triangles at least besides.
///
/// They hang on a surface that goes on without them. Where neither end of the free edge is well sampled nothing else removes them; the papers
/// have no such step. Of several flaps on one edge the first go first.
pub(super) fn cut_flaps(
    sheet: &Sheet<'_>,
    kept: &mut [bool],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<()> {
    let mut counts = room.filled(sheet.edge_count(), 0u32)?;
    for facet in run.watch(sheet.edge_of_side.iter().zip(kept.iter())) {
        let (edges, &kept) = facet?;
        for &edge in edges.iter().filter(|_| kept) {
            counts[edge as usize] += 1;
        }
    }
    let mut stack = room.collect((0..sheet.len() as u32).rev())?;
    let mut done = 0;
    while let Some(facet) = stack.pop() {
        done += 1;
        if done % 4096 == 0 {
            run.poll()?;
        }
        let of_edges = sheet.edge_of_side[facet as usize].map(|edge| counts[edge as usize]);
        let is_flap = of_edges.contains(&1) && of_edges.iter().any(|&count| count > 2);
        if kept[facet as usize] && is_flap {
            kept[facet as usize] = false;
            for edge in sheet.edge_of_side[facet as usize] {
                counts[edge as usize] -= 1;
                for &side in sheet.sides_of_edge(edge).iter().filter(|_| counts[edge as usize] == 1)
                {
                    room.push(&mut stack, side / 4)?;
                }
            }
        }
    }
    Ok(())
}

/// The triangles round one vertex.
#[derive(Default)]
struct Star {
    /// The triangles that are still there, and which of them this vertex keeps.
    facets: Vec<u32>,
    kept: Vec<bool>,
    /// For each triangle twice the number of the edge, and the third vertex seen from ours; those of one edge together.
    sides: Vec<(u32, u32, Vec3)>,
    /// The direction of the edge of each side.
    along: Vec<Vec3>,
    /// Where each edge's sides begin; one more entry than edges.
    edges: Vec<u32>,
}

impl Star {
    fn read(&mut self, t: &Triangulation, sheet: &Sheet<'_>, kept: &[bool], vertex: u32) {
        let place = |v: u32| t.coords()[v as usize];
        let from = |v: u32| sub(place(v), place(vertex));
        self.facets.clear();
        self.sides.clear();
        let star = sheet.star(vertex).iter().map(|&corner| [corner / 4, corner % 4]);
        for [facet, corner] in star.filter(|&[facet, _]| kept[facet as usize]) {
            let corners = sheet.corners[facet as usize];
            let [q, r] = [1, 2].map(|k| corners[(corner as usize + k) % 3]);
            let place = self.facets.len() as u32;
            self.facets.push(facet);
            self.sides.push((q, place, from(r)));
            self.sides.push((r, place, from(q)));
        }
        self.kept.clear();
        self.kept.resize(self.facets.len(), true);
        self.sides.sort_unstable_by_key(|&(other, facet, _)| (other, facet));
        self.edges.clear();
        self.along.clear();
        for (i, &(other, _, _)) in self.sides.iter().enumerate() {
            if i == 0 || self.sides[i - 1].0 != other {
                self.edges.push(i as u32);
            }
            self.along.push(from(other));
        }
        self.edges.push(self.sides.len() as u32);
    }

    /// Removes triangles with sharp edges at the vertex until there are none.
    fn shrink(&mut self) {
        let count = self.edges.len() - 1;
        let mut edge_of: Vec<[u32; 2]> = vec![[u32::MAX; 2]; self.facets.len()];
        for edge in 0..count {
            for side in self.edges[edge]..self.edges[edge + 1] {
                let of = &mut edge_of[self.sides[side as usize].1 as usize];
                of[usize::from(of[0] != u32::MAX)] = edge as u32;
            }
        }
        let mut stack: Vec<u32> = (0..count as u32).collect();
        while let Some(edge) = stack.pop() {
            if !self.is_sharp(edge as usize) {
                continue;
            }
            for side in self.edges[edge as usize]..self.edges[edge as usize + 1] {
                let facet = self.sides[side as usize].1 as usize;
                if self.kept[facet] {
                    self.kept[facet] = false;
                    stack.extend(edge_of[facet].iter().filter(|&&other| other != edge));
                }
            }
        }
    }

    /// Whether the triangles left at an edge lie within less than a right angle round it: any two of them do.
    fn is_sharp(&self, edge: usize) -> bool {
        let range = self.edges[edge] as usize..self.edges[edge + 1] as usize;
        let along = self.along[range.start];
        let square = dot(along, along);
        let sides = &self.sides[range];
        let kept = |side: &&(u32, u32, Vec3)| self.kept[side.1 as usize];
        sides.iter().enumerate().filter(|(_, side)| kept(side)).all(|(i, a)| {
            sides[..i].iter().filter(kept).all(|b| {
                // The parts normal to the edge, times its squared length.
                dot(a.2, b.2) * square - dot(a.2, along) * dot(b.2, along) > 0.0
            })
        })
    }
}
