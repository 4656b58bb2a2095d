//! The Voronoi faces within the labelled solid, and what of them the flow cannot collapse.

use super::Flow;
use super::closure::Subset;
use super::outline::Outline;
use super::simplex::{Simplex, VoronoiSet};
use super::source::Source;
use super::subdivision::Subdivision;
use crate::complex::DisjointSets;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::medial::Side;

/// The Voronoi faces that have inner cells all round them: dual to the simplices inside the labelled solid, and so of its homotopy type.
pub(super) fn inner(
    flow: &Flow,
    source: &Source<'_>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<VoronoiSet> {
    let mut inner = VoronoiSet::filled(source, false, room)?;
    let is_inner = |face: Simplex| source.side_of(&flow.labels, face) == Side::Inner;
    for (face, is_in) in (0..).zip(run.watch(&mut inner.facets)) {
        *is_in? = is_inner(Simplex::Edge(face));
    }
    for (face, is_in) in (0..).zip(run.watch(&mut inner.edges)) {
        *is_in? = is_inner(Simplex::Triangle(face));
    }
    for (face, is_in) in (0..).zip(run.watch(&mut inner.vertices)) {
        *is_in? = is_inner(Simplex::Cell(face));
    }
    for facet in openings(flow, source, room, run)? {
        inner.facets[facet as usize] = false;
    }
    Ok(inner)
}

/// The faces of a set that have critical points, and those that flow out of it: from these the flow reaches whatever it does not collapse.
pub(super) fn seeds<'a>(
    flow: &'a Flow,
    source: &'a Source<'a>,
    set: &'a VoronoiSet,
) -> impl Iterator<Item = Simplex> + 'a {
    let drivers = source.drivers;
    let edges = (0..).zip(&drivers.longest).filter(|&(triangle, &facet): &(u32, _)| {
        set.edges[triangle as usize] && facet != NONE && !set.facets[facet as usize]
    });
    let cells = (0..).zip(&set.vertices).filter(move |&(cell, &is_in): &(u32, _)| {
        is_in && {
            let driver = drivers.of_cell(source.triangles, cell);
            !set.has(driver)
        }
    });
    let critical = flow.critical.simplices().iter().copied().filter(|&face| set.has(face));
    critical
        .chain(edges.map(|(triangle, _)| Simplex::Triangle(triangle)))
        .chain(cells.map(|(cell, _)| Simplex::Cell(cell)))
}

/// What of the inner Voronoi faces is left beside the whole faces round a core, and has to be cut.
pub(super) struct Rest {
    /// The faces that nothing takes off: with those round the core they have the homotopy type of the labelled solid.
    pub faces: VoronoiSet,
    /// The faces from which the flow reaches all that it does not collapse of those round the core: critical ones, those that flow out, and the sides of what is left.
    pub seeds: Vec<Simplex>,
}

/// Collapses the inner Voronoi faces to whole faces round a core: those that the flow of some faces comes to. Nothing is cut for it, so that it costs the same whatever the flow runs
/// through.
pub(super) fn rest(
    flow: &Flow,
    source: &Source<'_>,
    inner: &VoronoiSet,
    core: impl Iterator<Item = Simplex> + Clone,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Rest> {
    let core = core.filter(|&face| inner.has(face));
    let round = VoronoiSet::closed(source, core.clone(), inner, room, run)?;
    let all = seeds(flow, source, inner).chain(core);
    let mut faces = VoronoiSet::closed(source, all, inner, room, run)?;
    faces.collapse(source, &round, room, run)?;
    faces.subtract(&round);
    // All of them is kept.
    faces.whole.clone_from(&faces.facets);
    let mut from = Vec::new();
    for seed in seeds(flow, source, inner).filter(|&seed| round.has(seed)) {
        room.push(&mut from, seed)?;
    }
    let mut outline = Outline::default();
    for facet in run.watch((0..).zip(&faces.facets).filter(|(_, is_in)| **is_in)) {
        outline.trace(source, facet?.0)?;
        for &side in
            outline.sides.iter().filter(|&&side| side != NONE && round.edges[side as usize])
        {
            room.push(&mut from, Simplex::Triangle(side))?;
        }
    }
    let t = source.dual.triangulation();
    for edge in run.watch((0..).zip(&faces.edges).filter(|(_, is_in)| **is_in)) {
        let ends = source.triangles.cells(t, edge?.0).into_iter().filter(|&cell| cell != NONE);
        for cell in ends.filter(|&cell| round.vertices[cell as usize]) {
            room.push(&mut from, Simplex::Cell(cell))?;
        }
    }
    Ok(Rest { faces, seeds: from })
}

/// The elements of a subdivision that lie in a set of Voronoi faces.
pub(super) fn elements(
    its: &Subdivision,
    source: &Source<'_>,
    set: &VoronoiSet,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Subset> {
    let mut subset = Subset::new(its, room)?;
    subset.has_vertex[..set.vertices.len()].copy_from_slice(&set.vertices);
    for triangle in run.watch(0..source.triangles.len() as u32) {
        let triangle = triangle?;
        if set.edges[triangle as usize] {
            for edge in its.edges_of(triangle) {
                subset.has_edge[edge as usize] = true;
                for v in its.edges[edge as usize].into_iter().filter(|&v| v != NONE) {
                    subset.has_vertex[v as usize] = true;
                }
            }
        }
    }
    for facet in run.watch(0..source.facets.len() as u32) {
        let facet = facet?;
        if set.facets[facet as usize] {
            for face in its.faces_of(facet) {
                subset.has_face[face as usize] = true;
                // Those within the facet.
                for &edge in its.rim_of(face) {
                    subset.has_edge[edge as usize] = true;
                }
            }
        }
    }
    Ok(subset)
}

/// Critical facets through which the Voronoi cells of samples inside the solid, which no surface has, open into each other and to those of the surface's
/// samples: a shortest forest. Without them each such cell were a void.
fn openings(
    flow: &Flow,
    source: &Source<'_>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let t = source.dual.triangulation();
    let samples = t.coords().len() as u32;
    // All others are one.
    let mut set = room.collect(0..samples)?;
    for cell in run.watch(0..t.cells().len()) {
        let cell = cell?;
        for (slot, &v) in t.cells()[cell].iter().enumerate() {
            let at_hull = (0..4).any(|i| i != slot && t.neighbors()[cell][i] == NONE);
            if at_hull || !flow.labels.is_inner()[cell] {
                set[v as usize] = samples;
            }
        }
    }
    let facets = source.facets;
    let mut openings: Vec<(f64, u32)> = Vec::new();
    for (simplex, &distance) in flow.critical.simplices().iter().zip(flow.critical.distances()) {
        if let Simplex::Edge(facet) = *simplex {
            let [p, q] = facets.edges()[facet as usize].map(|v| set[v as usize]);
            if p != q {
                room.push(&mut openings, (distance, facet))?;
            }
        }
    }
    openings.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut sets = DisjointSets::new(samples as usize + 1, run)?;
    openings.retain(|&(_, facet)| {
        let [p, q] = facets.edges()[facet as usize].map(|v| set[v as usize]);
        sets.join(p, q)
    });
    room.collect(openings.into_iter().map(|(_, facet)| facet))
}
