//! Elementary collapses: pairs of an element and a free side of it taken off.

use super::subdivision::FlowElement;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};

/// Which elements of a complex of vertices, edges and faces are in a closed set.
pub(super) struct Flags<'a> {
    pub vertices: &'a mut [bool],
    pub edges: &'a mut [bool],
    pub faces: &'a mut [bool],
}

/// For each side how many elements of the set have it, and the exclusive or of these, which tells the last one.
type Owners = Vec<(u32, u32)>;

/// Takes off a face and an edge that no other face has, then an edge of no face and a vertex that no other edge has, as long as there are any of which neither is kept: what is left
/// has the same homotopy type.
pub(super) fn collapse<'a>(
    set: Flags<'_>,
    is_kept: impl Fn(FlowElement) -> bool,
    rim_of: impl Fn(u32) -> &'a [u32],
    ends_of: impl Fn(u32) -> [u32; 2],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<()> {
    let is_edge_kept = |edge: u32| is_kept(FlowElement::Edge(edge));
    let mut faces_of: Owners = room.filled(set.edges.len(), (0, 0))?;
    for face in run.watch((0..set.faces.len() as u32).filter(|&f| set.faces[f as usize])) {
        let face = face?;
        rim_of(face).iter().for_each(|&edge| add(&mut faces_of, edge, face));
    }
    let mut edges_of: Owners = room.filled(set.vertices.len(), (0, 0))?;
    for edge in run.watch((0..set.edges.len() as u32).filter(|&e| set.edges[e as usize])) {
        let edge = edge?;
        let ends = ends_of(edge).into_iter().filter(|&v| v != NONE);
        ends.for_each(|v| add(&mut edges_of, v, edge));
    }
    let mut free: Vec<u32> = Vec::new();
    for (edge, &(count, _)) in (0..).zip(&faces_of) {
        if count == 1 {
            room.push(&mut free, edge)?;
        }
    }
    let drop_edge = |edges: &mut [bool], edges_of: &mut Owners, edge: u32| {
        edges[edge as usize] = false;
        let ends = ends_of(edge).into_iter().filter(|&v| v != NONE);
        ends.for_each(|v| remove(edges_of, v, edge));
    };
    let mut done = 0;
    while let Some(edge) = free.pop() {
        done += 1;
        if done % 4096 == 0 {
            run.poll()?;
        }
        let (count, face) = faces_of[edge as usize];
        if count != 1 || is_edge_kept(edge) || is_kept(FlowElement::Face(face)) {
            continue;
        }
        set.faces[face as usize] = false;
        drop_edge(set.edges, &mut edges_of, edge);
        for &side in rim_of(face) {
            remove(&mut faces_of, side, face);
            if faces_of[side as usize].0 == 1 {
                room.push(&mut free, side)?;
            }
        }
    }
    for (vertex, &(count, _)) in (0..).zip(&edges_of) {
        if count == 1 && set.vertices[vertex as usize] {
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
        if !is_loose || is_kept(FlowElement::Vertex(vertex)) || is_edge_kept(edge) {
            continue;
        }
        set.vertices[vertex as usize] = false;
        drop_edge(set.edges, &mut edges_of, edge);
        for v in ends_of(edge).into_iter().filter(|&v| v != NONE) {
            if edges_of[v as usize].0 == 1 {
                room.push(&mut free, v)?;
            }
        }
    }
    Ok(())
}

fn add(owners: &mut Owners, side: u32, owner: u32) {
    let (count, last) = &mut owners[side as usize];
    (*count, *last) = (*count + 1, *last ^ owner);
}

fn remove(owners: &mut Owners, side: u32, owner: u32) {
    let (count, last) = &mut owners[side as usize];
    (*count, *last) = (*count - 1, *last ^ owner);
}
