//! Flow closures: what can be reached from some elements of a flow its.

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
        // How many faces of the set each edge has, and how many edges each vertex; the exclusive or tells the last one.
        let mut faces_of = room.filled(self.has_edge.len(), (0u32, 0u32))?;
        for face in
            run.watch((0..self.has_face.len() as u32).filter(|&f| self.has_face[f as usize]))
        {
            let face = face?;
            for &edge in its.rim_of(face) {
                let (count, last) = &mut faces_of[edge as usize];
                (*count, *last) = (*count + 1, *last ^ face);
            }
        }
        let mut edges_of = room.filled(self.has_vertex.len(), (0u32, 0u32))?;
        for edge in
            run.watch((0..self.has_edge.len() as u32).filter(|&e| self.has_edge[e as usize]))
        {
            let edge = edge?;
            for v in its.edges[edge as usize].into_iter().filter(|&v| v != NONE) {
                let (count, last) = &mut edges_of[v as usize];
                (*count, *last) = (*count + 1, *last ^ edge);
            }
        }
        let mut free: Vec<u32> = Vec::new();
        for (edge, &(count, _)) in (0..).zip(&faces_of) {
            if count == 1 {
                room.push(&mut free, edge)?;
            }
        }
        let mut done = 0;
        let drop_edge = |subset: &mut Subset, edges_of: &mut Vec<(u32, u32)>, edge: u32| {
            subset.has_edge[edge as usize] = false;
            for v in its.edges[edge as usize].into_iter().filter(|&v| v != NONE) {
                let (count, last) = &mut edges_of[v as usize];
                (*count, *last) = (*count - 1, *last ^ edge);
            }
        };
        while let Some(edge) = free.pop() {
            done += 1;
            if done % 4096 == 0 {
                run.poll()?;
            }
            let (count, face) = faces_of[edge as usize];
            if count != 1 || kept.has_edge[edge as usize] || kept.has_face[face as usize] {
                continue;
            }
            self.has_face[face as usize] = false;
            drop_edge(self, &mut edges_of, edge);
            for &side in its.rim_of(face) {
                let (count, last) = &mut faces_of[side as usize];
                (*count, *last) = (*count - 1, *last ^ face);
                if *count == 1 {
                    room.push(&mut free, side)?;
                }
            }
        }
        for (vertex, &(count, _)) in (0..).zip(&edges_of) {
            if count == 1 && self.has_vertex[vertex as usize] {
                room.push(&mut free, vertex)?;
            }
        }
        while let Some(vertex) = free.pop() {
            done += 1;
            if done % 4096 == 0 {
                run.poll()?;
            }
            let (count, edge) = edges_of[vertex as usize];
            let is_loose = count == 1 && faces_of[edge as usize].0 == 0;
            if !is_loose || kept.has_vertex[vertex as usize] || kept.has_edge[edge as usize] {
                continue;
            }
            self.has_vertex[vertex as usize] = false;
            drop_edge(self, &mut edges_of, edge);
            for v in its.edges[edge as usize].into_iter().filter(|&v| v != NONE) {
                if edges_of[v as usize].0 == 1 {
                    room.push(&mut free, v)?;
                }
            }
        }
        Ok(())
    }
}
