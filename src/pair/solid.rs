//! The solid whose parts are paired: its cells, its surface, and no sample within.

use crate::dual::{Dual, DualOptions};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run, Stage};
use crate::labels::Labels;
use crate::points::{Points, PointsOptions};
use crate::triangulation::Triangulation;
use std::collections::HashMap;
use std::sync::Arc;

/// A triangulation whose cells are inner or outer, so that every vertex of an inner cell lies on the surface between the two.
pub(super) struct Solid {
    pub dual: Arc<Dual>,
    pub is_inner: Vec<bool>,
    /// The sample that each vertex of the triangulation is.
    pub sample: Vec<u32>,
    /// The samples inside the solid, which were removed, ascending.
    pub removed: Vec<u32>,
}

impl Solid {
    /// The solid of labels. Samples of which all cells are inner are removed and the rest is triangulated anew: triangles of the surface stay, since no
    /// sphere gets fuller (Shaham, Shamir, Cohen-Or, section 3, ask for a surface through all samples).
    pub fn new(
        dual: &Arc<Dual>,
        labels: &Labels,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let t = dual.triangulation();
        let is_inner = labels.is_inner();
        let surface = t.boundary_of(is_inner, room, run)?;
        if surface.is_empty() {
            return Err(Error::new(Status::Degenerate, "no cell of the triangulation is inner"));
        }
        let mut is_within = room.filled(t.coords().len(), false)?;
        for cell in run.watch(0..is_inner.len()) {
            let cell = cell?;
            if is_inner[cell] {
                t.cells()[cell].iter().for_each(|&v| is_within[v as usize] = true);
            }
        }
        for facet in run.watch(&surface) {
            let &[cell, i] = facet?;
            t.facet(cell, i as usize).iter().for_each(|&v| is_within[v as usize] = false);
        }
        let mut removed = Vec::new();
        for v in run.watch(0..is_within.len()) {
            let v = v?;
            if is_within[v] {
                room.push(&mut removed, v as u32)?;
            }
        }
        if removed.is_empty() {
            let sample = room.collect(0..t.coords().len() as u32)?;
            let is_inner = room.collect(is_inner.iter().copied())?;
            return Ok(Solid { dual: dual.clone(), is_inner, sample, removed });
        }
        let row = |v: usize| (!is_within[v]).then(|| t.coords()[v]);
        let points = Points::by_row_in(t.coords().len(), row, PointsOptions::default(), run)?;
        let rest = Arc::new(Triangulation::delaunay_in(&Arc::new(points), run)?);
        let rest = Arc::new(Dual::new_in(&rest, DualOptions { facets: true }, run)?);
        run.enter(Stage::Pair)?;
        let mut triangles = HashMap::new();
        for facet in run.watch(surface) {
            let [cell, i] = facet?;
            let corners = t.facet(cell, i as usize);
            let corners =
                corners.map(|v| rest.triangulation().points().vertex_of_row()[v as usize]);
            room.insert(&mut triangles, turned(corners), ())?;
        }
        let is_inner = inside(rest.triangulation(), &triangles, room, run)?;
        let sample = room.collect(rest.triangulation().points().row_of_vertex().iter().copied())?;
        Ok(Solid { dual: rest, is_inner, sample, removed })
    }
}

/// The same turn of three vertices, the least first.
fn turned(mut corners: [u32; 3]) -> [u32; 3] {
    let least = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
    corners.rotate_left(least);
    corners
}

/// Which cells lie behind some triangles that enclose them.
fn inside(
    t: &Triangulation,
    triangles: &HashMap<[u32; 3], ()>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<bool>> {
    let mut is_inner = room.filled(t.cells().len(), false)?;
    let mut waiting = Vec::new();
    let mut found = 0;
    for cell in run.watch(0..t.cells().len() as u32) {
        let cell = cell?;
        let behind = (0..4).filter(|&i| triangles.contains_key(&turned(t.facet(cell, i)))).count();
        if behind > 0 {
            found += behind;
            is_inner[cell as usize] = true;
            room.push(&mut waiting, cell)?;
        }
    }
    while let Some(cell) = waiting.pop() {
        run.poll()?;
        for (i, &next) in t.neighbors()[cell as usize].iter().enumerate() {
            if next != NONE
                && !is_inner[next as usize]
                && !triangles.contains_key(&turned(t.facet(cell, i)))
            {
                is_inner[next as usize] = true;
                room.push(&mut waiting, next)?;
            }
        }
    }
    match found == triangles.len() {
        true => Ok(is_inner),
        false => Err(Error::new(Status::Internal, "the surface has lost triangles")),
    }
}
