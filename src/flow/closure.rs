//! Flow closures: what can be reached from some elements of a flow complex.

use super::collapse::{Flags, collapse};
use super::subdivision::{FlowElement, Subdivision};
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use std::mem;

/// A set of elements of a flow complex, with each its sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Subset {
    pub has_vertex: Vec<bool>,
    pub has_edge: Vec<bool>,
    pub has_face: Vec<bool>,
}

impl Subset {
    /// The empty set.
    pub fn new(its: &Subdivision, room: &mut Room<'_>) -> Result<Self> {
        Subset::filled(its, false, room)
    }

    /// All elements, or none.
    pub fn filled(its: &Subdivision, value: bool, room: &mut Room<'_>) -> Result<Self> {
        Ok(Subset {
            has_vertex: room.filled(its.edge_of_vertex.len(), value)?,
            has_edge: room.filled(its.edges.len(), value)?,
            has_face: room.filled(its.rim_vertices.len(), value)?,
        })
    }

    /// The elements, ascending.
    pub fn list(&self, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<FlowElement>> {
        let mut list = Vec::new();
        for (i, has) in (0..).zip(run.watch(&self.has_vertex)) {
            if *has? {
                room.push(&mut list, FlowElement::Vertex(i))?;
            }
        }
        for (i, has) in (0..).zip(run.watch(&self.has_edge)) {
            if *has? {
                room.push(&mut list, FlowElement::Edge(i))?;
            }
        }
        for (i, has) in (0..).zip(run.watch(&self.has_face)) {
            if *has? {
                room.push(&mut list, FlowElement::Face(i))?;
            }
        }
        Ok(list)
    }

    fn flag(&mut self, element: FlowElement) -> &mut bool {
        match element {
            FlowElement::Vertex(v) => &mut self.has_vertex[v as usize],
            FlowElement::Edge(e) => &mut self.has_edge[e as usize],
            FlowElement::Face(f) => &mut self.has_face[f as usize],
        }
    }

    /// Adds an element alone; `false` if the set had it.
    pub fn insert(&mut self, element: FlowElement) -> bool {
        !mem::replace(self.flag(element), true)
    }

    /// Adds the sides of what is in the set.
    pub fn close(&mut self, its: &Subdivision) {
        for face in (0..self.has_face.len()).filter(|&face| self.has_face[face]) {
            let rim = its.rim_of(face as u32);
            rim.iter().for_each(|&edge| self.has_edge[edge as usize] = true);
        }
        for edge in (0..self.has_edge.len()).filter(|&edge| self.has_edge[edge]) {
            let ends = its.edges[edge].into_iter().filter(|&v| v != NONE);
            ends.for_each(|v| self.has_vertex[v as usize] = true);
        }
    }

    /// Takes an element off, alone.
    pub fn remove(&mut self, element: FlowElement) {
        *self.flag(element) = false;
    }

    /// Adds elements, and all that can be reached from them: what the flow does not leave. Within another set the flow ends
    /// where it leaves that. The point at infinity is no element.
    pub fn add(
        &mut self,
        its: &Subdivision,
        elements: impl IntoIterator<Item = FlowElement>,
        within: Option<&Subset>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let mut waiting = Vec::new();
        for element in run.watch(elements) {
            room.push(&mut waiting, element?)?;
            let mut seen = 0;
            while let Some(element) = waiting.pop() {
                seen += 1;
                if seen % 4096 == 0 {
                    run.poll()?;
                }
                if !self.insert(element) {
                    continue;
                }
                match element {
                    FlowElement::Vertex(v) => {
                        let edge = its.edge_of_vertex[v as usize];
                        let flows = edge != NONE
                            && within.is_none_or(|within| within.has_edge[edge as usize]);
                        if flows {
                            room.push(&mut waiting, FlowElement::Edge(edge))?;
                        }
                    }
                    FlowElement::Edge(e) => {
                        let ends = its.edges[e as usize].into_iter().filter(|&v| v != NONE);
                        room.grow(&mut waiting, 3)?;
                        waiting.extend(ends.map(FlowElement::Vertex));
                        let face = its.face_of_edge[e as usize];
                        let flows = face != NONE
                            && within.is_none_or(|within| within.has_face[face as usize]);
                        waiting.extend(flows.then_some(FlowElement::Face(face)));
                    }
                    FlowElement::Face(f) => {
                        let rim = its.rim_of(f);
                        room.grow(&mut waiting, rim.len())?;
                        waiting.extend(rim.iter().map(|&e| FlowElement::Edge(e)));
                    }
                }
            }
        }
        Ok(())
    }

    /// Takes off pairs of an element and a side that no other element has, as long as there are any outside a set that is kept: what is left has
    /// the same homotopy type.
    pub fn collapse(
        &mut self,
        its: &Subdivision,
        kept: &Subset,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let Subset { has_vertex, has_edge, has_face } = self;
        let set = Flags { vertices: has_vertex, edges: has_edge, faces: has_face };
        let is_kept = |element: FlowElement| match element {
            FlowElement::Vertex(v) => kept.has_vertex[v as usize],
            FlowElement::Edge(e) => kept.has_edge[e as usize],
            FlowElement::Face(f) => kept.has_face[f as usize],
        };
        let ends_of = |edge: u32| its.edges[edge as usize];
        collapse(set, is_kept, |face| its.rim_of(face), ends_of, room, run)
    }
}
