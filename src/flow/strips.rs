//! The faces of the subdivision: strips of Voronoi facets between cuts.

use super::outline::{Corner, Outline};
use super::source::Source;
use super::subdivision::{Made, Subdivision};
use crate::error::Result;
use crate::index::NONE;
use crate::job::Room;
use std::ops::Range;

/// The rims of some faces.
#[derive(Default)]
pub(super) struct Rims {
    pub ends: Vec<u32>,
    pub vertices: Vec<u32>,
    pub edges: Vec<u32>,
    /// Edges and the faces that they flow into.
    pub entered: Vec<(u32, u32)>,
}

/// A path of vertices and the edges between them.
#[derive(Default)]
struct Path {
    vertices: Vec<u32>,
    edges: Vec<u32>,
}

/// The faces of one facet: strips between its cuts.
#[derive(Default)]
pub(super) struct Strips {
    outline: Outline,
    near: Path,
    far: Path,
}

impl Strips {
    pub fn trace(
        &mut self,
        its: &Subdivision,
        Made { source, cuts, .. }: &Made<'_>,
        facet: u32,
        rims: &mut Rims,
        room: &mut Room<'_>,
    ) -> Result<()> {
        self.outline.trace(source, facet)?;
        let near = self.outline.near;
        let sides = self.outline.sides.len();
        self.near.walk(its, source, &self.outline, 0..near, room)?;
        self.far.walk(its, source, &self.outline, near..sides, room)?;
        let first_face = its.faces_of_facet[facet as usize];
        if near == 0 {
            // The walk has come back to where it began.
            rims.add(&self.far.vertices[..self.far.edges.len()], &self.far.edges, room)?;
            return rims.end(room);
        }
        let [first_cut, _] = cuts.of_facet[facet as usize];
        let cuts = cuts.of(facet);
        let cells = source.dual.triangulation().cells().len() as u32;
        let cut_edge = |i: usize| its.triangle_of_edge.len() as u32 + first_cut + i as u32;
        // From the last cut to the first: the far side is walked counterclockwise.
        let mut far_begin = 0;
        let mut ranges = room.vec(cuts.len() + 1)?;
        for cut in cuts.iter().rev() {
            let exit = if cut.to == NONE { NONE } else { cells + cut.to };
            let steps = self.far.vertices[far_begin..].iter().position(|&v| v == exit);
            let far_end = far_begin + steps.unwrap_or(0);
            ranges.push((far_begin, far_end));
            far_begin = far_end;
        }
        ranges.push((far_begin, self.far.edges.len()));
        ranges.reverse();
        let mut near_begin = 0;
        for (strip, (begin, end)) in ranges.into_iter().enumerate() {
            let entry = cuts.get(strip).map(|cut| its.vertex_of(source, cut.from));
            let near_end = match entry {
                Some(entry) => {
                    let steps = self.near.vertices[near_begin..].iter().position(|&v| v == entry);
                    near_begin + steps.unwrap_or(0)
                }
                None => self.near.edges.len(),
            };
            let near = near_begin..near_end;
            room.grow(&mut rims.entered, near.len())?;
            let face = first_face + strip as u32;
            rims.entered.extend(self.near.edges[near.clone()].iter().map(|&edge| (edge, face)));
            rims.add(&self.near.vertices[near.clone()], &self.near.edges[near], room)?;
            if let Some(entry) = entry {
                rims.add(&[entry], &[cut_edge(strip)], room)?;
            }
            near_begin = near_end;
            rims.add(&self.far.vertices[begin..end], &self.far.edges[begin..end], room)?;
            if strip > 0 {
                rims.add(&self.far.vertices[end..=end], &[cut_edge(strip - 1)], room)?;
            }
            rims.end(room)?;
        }
        Ok(())
    }
}

impl Rims {
    fn add(&mut self, vertices: &[u32], edges: &[u32], room: &mut Room<'_>) -> Result<()> {
        room.grow(&mut self.vertices, vertices.len())?;
        room.grow(&mut self.edges, edges.len())?;
        self.vertices.extend_from_slice(vertices);
        self.edges.extend_from_slice(edges);
        Ok(())
    }

    fn end(&mut self, room: &mut Room<'_>) -> Result<()> {
        room.push(&mut self.ends, self.vertices.len() as u32)
    }
}

impl Path {
    /// Becomes the walk along some sides of an outline.
    fn walk(
        &mut self,
        its: &Subdivision,
        source: &Source<'_>,
        outline: &Outline,
        sides: Range<usize>,
        room: &mut Room<'_>,
    ) -> Result<()> {
        self.vertices.clear();
        self.edges.clear();
        let vertex = |corner| match corner {
            Corner::Cell(cell) => cell,
            Corner::Ray(_) => NONE,
        };
        self.vertices.push(vertex(outline.corners[sides.start % outline.corners.len()]));
        for side in sides {
            let triangle = outline.sides[side];
            if triangle == NONE {
                // The point at infinity, where the walk is already.
                continue;
            }
            let [lesser, _] = source.triangles.sides[triangle as usize];
            let [begin, end] = [0, 1].map(|i| its.edges_of_triangle[triangle as usize + i]);
            room.grow(&mut self.vertices, (end - begin) as usize)?;
            room.grow(&mut self.edges, (end - begin) as usize)?;
            let runs_on = outline.corners[side] == Corner::Cell(lesser);
            if runs_on {
                for edge in begin..end {
                    self.edges.push(edge);
                    self.vertices.push(its.edges[edge as usize][1]);
                }
            } else {
                for edge in (begin..end).rev() {
                    self.edges.push(edge);
                    self.vertices.push(its.edges[edge as usize][0]);
                }
            }
        }
        Ok(())
    }
}
