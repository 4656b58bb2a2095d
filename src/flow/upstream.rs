//! The flow DAG against its direction.

use super::closure::Subset;
use super::subdivision::{FlowElement, Subdivision};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use std::mem;

/// For each element those from which it is reached in one step: the elements of which it is a side, and those that flow into it.
///
/// Invariants: `of_vertex` has a row of edges for each vertex, `of_edge` a row of faces for each edge; the vertices that flow into an edge are ends of
/// it, the edges that flow into a face are sides of it.
pub(super) struct Upstream<'a> {
    its: &'a Subdivision,
    of_vertex: Transposed,
    of_edge: Transposed,
}

impl<'a> Upstream<'a> {
    pub fn new(its: &'a Subdivision, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let ends = its.edges.iter().flatten().copied();
        let sides = its.rim_edges.iter().copied();
        let faces = (0..its.rim_vertices.len() as u32)
            .flat_map(|face| std::iter::repeat_n(face, its.rim_of(face).len()));
        let edges = (0..its.edges.len() as u32).flat_map(|edge| [edge; 2]);
        let vertices = its.edge_of_vertex.len();
        let of_vertex = Transposed::new(vertices, ends, edges, room, run)?;
        let of_edge = Transposed::new(its.edges.len(), sides, faces, room, run)?;
        Ok(Upstream { its, of_vertex, of_edge })
    }

    /// Adds to a set some elements, and all from which they are reached.
    pub fn add_to(
        &self,
        set: &mut Subset,
        elements: impl IntoIterator<Item = FlowElement>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let mut seen = 0;
        let mut waiting = Vec::new();
        for element in run.watch(elements) {
            room.push(&mut waiting, element?)?;
            while let Some(element) = waiting.pop() {
                seen += 1;
                if seen % 4096 == 0 {
                    run.poll()?;
                }
                if set.insert(element) {
                    self.before(element, &mut waiting, room)?;
                }
            }
        }
        Ok(())
    }

    /// Adds to a list the elements from which one is reached in one step.
    pub fn before(
        &self,
        element: FlowElement,
        list: &mut Vec<FlowElement>,
        room: &mut Room<'_>,
    ) -> Result<()> {
        match element {
            FlowElement::Vertex(v) => {
                let edges = self.of_vertex.row(v);
                room.grow(list, edges.len())?;
                list.extend(edges.iter().map(|&edge| FlowElement::Edge(edge)));
            }
            FlowElement::Edge(e) => {
                let faces = self.of_edge.row(e);
                room.grow(list, faces.len() + 2)?;
                list.extend(faces.iter().map(|&face| FlowElement::Face(face)));
                let ends = self.its.edges[e as usize].into_iter().filter(|&v| v != NONE);
                let flowing = ends.filter(|&v| self.its.edge_of_vertex[v as usize] == e);
                list.extend(flowing.map(FlowElement::Vertex));
            }
            FlowElement::Face(f) => {
                let rim = self.its.rim_of(f);
                room.grow(list, rim.len())?;
                let flowing = rim.iter().filter(|&&e| self.its.face_of_edge[e as usize] == f);
                list.extend(flowing.map(|&edge| FlowElement::Edge(edge)));
            }
        }
        Ok(())
    }
}

/// Rows by what the entries of other rows point to.
struct Transposed {
    offsets: Vec<u32>,
    entries: Vec<u32>,
}

impl Transposed {
    /// Given how many rows there are, for each entry the row where it belongs, and the entry.
    fn new(
        count: usize,
        rows: impl Iterator<Item = u32> + Clone,
        entries: impl Iterator<Item = u32>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut offsets = room.filled(count + 1, 0u32)?;
        for row in run.watch(rows.clone()) {
            if let Some(count) = offsets.get_mut(row? as usize) {
                *count += 1;
            }
        }
        // Where each row ends; filled from its end to its beginning.
        let mut sum = 0;
        for end in &mut offsets {
            sum += mem::take(end);
            *end = sum;
        }
        let mut list = room.filled(sum as usize, NONE)?;
        for pair in run.watch(rows.zip(entries)) {
            let (row, entry) = pair?;
            if let Some(end) = offsets.get_mut(row as usize) {
                *end -= 1;
                list[*end as usize] = entry;
            }
        }
        Ok(Transposed { offsets, entries: list })
    }

    fn row(&self, i: u32) -> &[u32] {
        &self.entries[self.offsets[i as usize] as usize..self.offsets[i as usize + 1] as usize]
    }
}
