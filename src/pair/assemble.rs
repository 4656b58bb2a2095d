//! Elements from the parts of the Voronoi diagram and of the surface.

use super::PairMesh;
use super::mend::Mended;
use super::parts::Parts;
use super::solid::Solid;
use crate::complex::{DisjointSets, Rows};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::sort::sort_by_key;

/// The pair-mesh, and the spheres whose cells cannot share one vertex, because an element or a side of it would be there twice.
pub(super) fn assemble(
    solid: &Solid,
    parts: &Parts,
    mended: &Mended<'_>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<(PairMesh, Vec<u32>)> {
    let mut assembly = Assembly::new(solid, parts, mended, room, run)?;
    assembly.add_pyramids(room, run)?;
    let pyramids = assembly.rings.len();
    assembly.add_between_edges(room, run)?;
    let tetrahedra = assembly.rings.len();
    assembly.add_over_triangles(room, run)?;
    assembly.check_sides(run)?;
    let Assembly { mut mesh, rings, faces, apart, .. } = assembly;
    (mesh.rings, mesh.faces, mesh.ends) = (rings, faces, [pyramids, tetrahedra]);
    Ok((mesh, apart))
}

struct Assembly<'a> {
    solid: &'a Solid,
    parts: &'a Parts,
    mended: &'a Mended<'a>,
    /// The inner vertex of each inner cell.
    vertex: Vec<u32>,
    /// The node of each corner of an inner cell, as 4 times its number and the slot.
    node: Vec<u32>,
    mesh: PairMesh,
    rings: Rows,
    faces: Rows,
    apart: Vec<u32>,
}

impl<'a> Assembly<'a> {
    /// Vertices and nodes, but for those in the middle of facets.
    fn new(
        solid: &'a Solid,
        parts: &'a Parts,
        mended: &'a Mended<'a>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let t = solid.dual.triangulation();
        let count = parts.cells.len();
        let mut mesh = PairMesh::empty();
        let mut number = room.filled(t.coords().len(), NONE)?;
        for v in run.watch(parts.triangles.as_flattened()) {
            number[*v? as usize] = 0;
        }
        for v in run.watch(0..number.len()) {
            let v = v?;
            if number[v] != NONE {
                number[v] = mesh.boundary.len() as u32;
                room.push(&mut mesh.boundary, t.coords()[v])?;
                room.push(&mut mesh.sample_of_boundary, solid.sample[v])?;
            }
        }
        let mut vertices = DisjointSets::new(count, run)?;
        let mut nodes = DisjointSets::new(4 * count, run)?;
        room.keep(5 * 4 * count)?;
        for item in run.watch((0..).zip(&parts.cells)) {
            let (cell, &of) = item?;
            let corners = t.cells()[of as usize];
            for &next in
                t.neighbors()[of as usize].iter().filter(|&&next| next != NONE && next < of)
            {
                let other = parts.number[next as usize];
                if other == NONE || !mended.are_one(cell, other) {
                    continue;
                }
                vertices.join(cell, other);
                for (v, slot) in t.cells()[next as usize].iter().zip(0..) {
                    if let Some(own) = corners.iter().position(|corner| corner == v) {
                        nodes.join(4 * cell + own as u32, 4 * other + slot);
                    }
                }
            }
        }
        let (mut vertex, mut node) = (room.vec(count)?, room.vec(4 * count)?);
        for item in run.watch((0..).zip(&parts.cells)) {
            let (cell, &of) = item?;
            let root = vertices.root(cell);
            if root == cell {
                vertex.push(mesh.inner.len() as u32);
                room.push(&mut mesh.inner, mended.place(cell))?;
                room.push(&mut mesh.voronoi, solid.dual.centers()[of as usize])?;
                // The cells of the rest are not those of the samples.
                let known = if solid.removed.is_empty() { of } else { NONE };
                room.push(&mut mesh.cell_of_inner, known)?;
            } else {
                vertex.push(vertex[root as usize]);
            }
            for (&v, corner) in t.cells()[of as usize].iter().zip(4 * cell..) {
                let root = nodes.root(corner);
                if root == corner {
                    node.push(mesh.nodes.len() as u32);
                    room.push(&mut mesh.nodes, [number[v as usize], vertex[cell as usize]])?;
                } else {
                    node.push(node[root as usize]);
                }
            }
        }
        let (rings, faces, apart) = (Rows::default(), Rows::default(), Vec::new());
        Ok(Assembly { solid, parts, mended, vertex, node, mesh, rings, faces, apart })
    }

    /// The node between a vertex of the triangulation and an inner cell that has it.
    fn node(&self, v: u32, cell: u32) -> u32 {
        let of = self.parts.cells[cell as usize];
        let corners = &self.solid.dual.triangulation().cells()[of as usize];
        let slot = corners.iter().position(|&corner| corner == v).unwrap_or(0);
        self.node[4 * cell as usize + slot]
    }

    fn push(&mut self, ring: &[u32], room: &mut Room<'_>) -> Result<()> {
        room.keep(4 * (ring.len() + 1))?;
        self.rings.push(ring)
    }

    /// The pyramids over both sides of every facet.
    fn add_pyramids(&mut self, room: &mut Room<'_>, run: &Run<'_>) -> Result<()> {
        let parts = self.parts;
        let mut cells: Vec<u32> = Vec::new();
        for item in run.watch((0u32..).zip(&parts.facets)) {
            let (facet, &[a, b]) = item?;
            let ring = parts.rings.row(facet as usize);
            let before = ring.iter().cycle().skip(ring.len() - 1);
            cells.clear();
            let firsts = ring.iter().zip(before).filter(|&(&c, &b)| !self.mended.are_one(b, c));
            cells.extend(firsts.map(|(&cell, _)| cell));
            if cells.len() < 3 {
                continue;
            }
            if self.mended.has_middle(facet) {
                self.add_round_middle(facet, &cells, room)?;
                continue;
            }
            let corners: Vec<u32> = cells.iter().map(|&c| self.vertex[c as usize]).collect();
            let mut sorted = corners.clone();
            sorted.sort_unstable();
            if sorted.windows(2).any(|pair| pair[0] == pair[1]) {
                self.apart.extend(cells.iter().map(|&c| parts.sphere[c as usize]));
            }
            room.keep(4 * (corners.len() + 1))?;
            self.faces.push(&corners)?;
            let over_b: Vec<u32> = cells.iter().map(|&c| self.node(b, c)).collect();
            cells[1..].reverse();
            let over_a: Vec<u32> = cells.iter().map(|&c| self.node(a, c)).collect();
            self.push(&over_a, room)?;
            self.push(&over_b, room)?;
        }
        Ok(())
    }

    /// The tetrahedra over both sides of a facet that is divided round a vertex in its middle.
    fn add_round_middle(&mut self, facet: u32, cells: &[u32], room: &mut Room<'_>) -> Result<()> {
        let [a, b] = self.parts.facets[facet as usize];
        let middle = self.mesh.inner.len() as u32;
        let place = self.mended.middle(facet);
        room.push(&mut self.mesh.inner, place)?;
        room.push(&mut self.mesh.voronoi, place)?;
        room.push(&mut self.mesh.cell_of_inner, NONE)?;
        let to_middle = [a, b].map(|v| {
            let of_corner = self.mesh.nodes[self.node(v, cells[0]) as usize][0];
            [of_corner, middle]
        });
        let begin = self.mesh.nodes.len() as u32;
        for node in to_middle {
            room.push(&mut self.mesh.nodes, node)?;
        }
        for (&c, &d) in cells.iter().zip(cells.iter().cycle().skip(1)) {
            room.keep(4 * 4)?;
            self.faces.push(&[middle, self.vertex[c as usize], self.vertex[d as usize]])?;
            self.push(&[begin, self.node(a, d), self.node(a, c)], room)?;
            self.push(&[begin + 1, self.node(b, c), self.node(b, d)], room)?;
        }
        Ok(())
    }

    fn add_between_edges(&mut self, room: &mut Room<'_>, run: &Run<'_>) -> Result<()> {
        let parts = self.parts;
        for item in run.watch(parts.edges.iter().zip(parts.fans.iter())) {
            let (&[a, b], fan) = item?;
            for pair in fan.windows(2).filter(|pair| !self.mended.are_one(pair[0], pair[1])) {
                let [c, d] = [pair[0], pair[1]];
                let ring = [(a, c), (b, c), (b, d), (a, d)].map(|(v, cell)| self.node(v, cell));
                self.push(&ring, room)?;
            }
        }
        Ok(())
    }

    fn add_over_triangles(&mut self, room: &mut Room<'_>, run: &Run<'_>) -> Result<()> {
        let parts = self.parts;
        for item in run.watch(parts.triangles.iter().zip(&parts.behind)) {
            let (corners, &cell) = item?;
            let ring = corners.map(|v| self.node(v, cell));
            self.push(&ring, room)?;
        }
        Ok(())
    }

    /// Finds sides that two elements have the same way round.
    fn check_sides(&mut self, run: &Run<'_>) -> Result<()> {
        let mut room = Room::new(run);
        let mut sides: Vec<u64> = room.vec(self.rings.indices().len())?;
        for ring in run.watch(self.rings.iter()) {
            let ring = ring?;
            let ends = ring.iter().zip(ring.iter().cycle().skip(1));
            sides.extend(ends.map(|(&from, &to)| u64::from(from) << 32 | u64::from(to)));
        }
        sort_by_key(&mut sides, |&side| side, run)?;
        let of_node = |node: u64| self.mesh.nodes[node as usize][1];
        let twice = sides.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]);
        let vertices: Vec<u32> =
            twice.flat_map(|side| [side >> 32, side & u64::from(u32::MAX)].map(of_node)).collect();
        if !vertices.is_empty() {
            let cells = self.vertex.iter().zip(&self.parts.sphere);
            self.apart
                .extend(cells.filter(|(v, _)| vertices.contains(v)).map(|(_, &sphere)| sphere));
        }
        Ok(())
    }
}
