//! The boundary of a union of balls: facets of its samples' Delaunay triangulation.

use super::exposed::Exposed;
use super::thin::{Sample, Scale, thinned};
use super::{Balls, BoundaryOptions, creases, patches};
use crate::complex::{Attribute, Complex, ComplexParts, DisjointSets, Element, Rows, Values};
use crate::dual::{Dual, DualOptions};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{PART, Room, Run, Stage};
use crate::points::{COORDINATE_MAX, COORDINATE_MIN, Points, PointsOptions};
use crate::triangulation::Triangulation;
use std::sync::Arc;

/// Cells that one thread labels between two reports, and between two polls.
const CELLS: usize = PART / 16;
const BATCH: usize = 64;
/// How deep in a ball a sample may be, beside its coordinates: by rounding.
const BARE: f64 = 1e-13;

pub(super) fn boundary(balls: &Balls, options: BoundaryOptions, run: &Run<'_>) -> Result<Complex> {
    let sizes = Scale(match options.spacing {
        0.0 => 0.01 * balls.bounds().diagonal(),
        spacing if spacing > 0.0 && spacing <= COORDINATE_MAX => spacing,
        spacing => {
            let message = format!("a spacing of {spacing} is no length");
            return Err(Error::new(Status::InvalidArgument, message));
        }
    });
    let mut room = Room::new(run);
    let samples = samples(balls, sizes, &mut room, run)?;
    let row = |i: usize| Some(samples[i].point);
    let points = Points::by_row_in(samples.len(), row, PointsOptions::default(), run)?;
    let delaunay = Arc::new(Triangulation::delaunay_in(&Arc::new(points), run)?);
    let is_inner = label(balls, sizes, &samples, &delaunay, &mut room, run)?;
    run.enter(Stage::Extract)?;
    extract(&samples, &delaunay, &is_inner, &mut room, run)
}

/// Points of the boundary, as dense as the spacing asks for.
fn samples(balls: &Balls, sizes: Scale, room: &mut Room<'_>, run: &Run<'_>) -> Result<Vec<Sample>> {
    let mut own = Room::new(run);
    let exposed = Exposed::new(balls, &mut own, run)?;
    run.enter(Stage::Sample)?;
    let mut samples = Vec::new();
    creases::samples(&exposed, sizes, &mut samples, room, run)?;
    patches::samples(&exposed, sizes, &mut samples, room, run)?;
    // Of balls that are the same but for rounding, so is what is next to which.
    let is_bare = run.in_parallel(samples.chunks(CELLS).collect(), |samples| {
        run.poll()?;
        let depth = |sample: &Sample| {
            let largest = sample.point.into_iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            BARE * largest.max(balls.radii[sample.ball as usize])
        };
        let is_bare = |sample: &Sample| !balls.hierarchy.holds(sample.point, depth(sample));
        Ok(samples.iter().map(is_bare).collect::<Vec<_>>())
    })?;
    let mut is_bare = is_bare.into_iter().flatten();
    samples.retain(|_| is_bare.next() == Some(true));
    thinned(&mut samples, sizes, &mut own, run)?;
    for sample in &mut samples {
        // What is so near to 0 is out of the range of coordinates.
        sample.point = sample.point.map(|x| if x.abs() < COORDINATE_MIN { 0.0 } else { x });
    }
    Ok(samples)
}

/// Whether the circumcentre of each cell lies in the union.
///
/// So a facet between two labels is dual to a Voronoi edge that crosses the boundary, and its corners are the samples nearest to where it does: no farther than the spacing.
fn label(
    balls: &Balls,
    sizes: Scale,
    samples: &[Sample],
    delaunay: &Arc<Triangulation>,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<bool>> {
    let dual = Dual::new_in(delaunay, DualOptions::default(), run)?;
    run.enter(Stage::Label)?;
    let mut is_inner = room.filled(delaunay.cells().len(), false)?;
    let cells = delaunay.cells().chunks(CELLS).zip(dual.centers().chunks(CELLS));
    let parts = cells.zip(is_inner.chunks_mut(CELLS)).collect();
    run.in_steps(parts, [0.0, 1.0], |((cells, centers), is_inner)| {
        for (i, ((cell, &center), is_inner)) in cells.iter().zip(centers).zip(is_inner).enumerate()
        {
            if i % BATCH == 0 {
                run.poll()?;
            }
            // The balls of the corners hold most centres that are held at all.
            let own = cell.map(|v| samples[delaunay.row_of_vertex()[v as usize] as usize].ball);
            *is_inner = own.iter().any(|&ball| balls.ball_holds(ball, center))
                || balls.hierarchy.holds(center, 0.0);
        }
        Ok(())
    })?;
    let mut is_thick = room.vec(is_inner.len())?;
    for cell in run.watch(delaunay.cells().iter().zip(dual.radii_squared())) {
        let (corners, &radius_squared) = cell?;
        let level = |v: u32| samples[delaunay.row_of_vertex()[v as usize] as usize].level;
        let level = corners.iter().map(|&v| level(v)).max().unwrap_or(0);
        is_thick.push(radius_squared >= sizes.spacing(level).powi(2));
    }
    for side in [false, true] {
        settle(delaunay, &mut is_inner, side, &is_thick, run)?;
    }
    Ok(is_inner)
}

/// Gives the other side what of one side is cut off from all that is thick, and from outside: it is finer than the samples can tell, and comes and goes with their places.
fn settle(
    t: &Triangulation,
    is_inner: &mut [bool],
    side: bool,
    is_thick: &[bool],
    run: &Run<'_>,
) -> Result<()> {
    let mut room = Room::new(run);
    let mut parts = DisjointSets::new(is_inner.len(), run)?;
    let mut is_kept = room.collect(is_thick.iter().copied())?;
    for cell in run.watch((0..is_inner.len()).filter(|&cell| is_inner[cell] == side)) {
        let cell = cell?;
        for next in t.neighbors()[cell] {
            match next {
                NONE => is_kept[cell] |= !side,
                next if is_inner[next as usize] == side => {
                    parts.join(cell as u32, next);
                }
                _ => {}
            }
        }
    }
    for cell in run.watch((0..is_inner.len()).filter(|&cell| is_inner[cell] == side)) {
        let cell = cell?;
        let root = parts.root(cell as u32) as usize;
        is_kept[root] |= is_kept[cell];
    }
    for cell in run.watch(0..is_inner.len()) {
        let cell = cell?;
        if is_inner[cell] == side && !is_kept[parts.root(cell as u32) as usize] {
            is_inner[cell] = !side;
        }
    }
    Ok(())
}

/// The facets between inner cells and others, outside counting as one; with vertices as many as it has sheets at a sample.
///
/// A facet goes on across each of its sides on the next facet round the inner cells there. So every side has two facets, and a sample where solids only touch is as many vertices.
fn extract(
    samples: &[Sample],
    t: &Triangulation,
    is_inner: &[bool],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Complex> {
    let is_bare = |cell: u32, slot: usize| {
        let next = t.neighbors()[cell as usize][slot];
        next == NONE || !is_inner[next as usize]
    };
    // The number of the first facet of each inner cell; others have none.
    let mut first = room.filled(is_inner.len(), 0u32)?;
    let mut facets = Vec::new();
    for cell in run.watch(0..is_inner.len()) {
        let cell = cell?;
        first[cell] = facets.len() as u32;
        if is_inner[cell] {
            for slot in (0..4).filter(|&slot| is_bare(cell as u32, slot)) {
                room.push(&mut facets, (cell as u32, slot))?;
            }
        }
    }
    if facets.len() > (u32::MAX / 3) as usize {
        return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 1 corners"));
    }
    let number = |cell: u32, slot: usize| {
        first[cell as usize] as usize + (0..slot).filter(|&slot| is_bare(cell, slot)).count()
    };
    let mut sheets = DisjointSets::new(3 * facets.len(), run)?;
    let mut triangles: Vec<[u32; 3]> = room.vec(facets.len())?;
    for facet in run.watch(facets.iter().enumerate()) {
        let (facet, &(cell, slot)) = facet?;
        let corners = t.facet(cell, slot);
        triangles.push(corners);
        for i in 0..3 {
            let (cell, slot) = across(t, is_inner, (cell, slot), corners[(i + 2) % 3]);
            let other = number(cell, slot);
            for (place, v) in t.facet(cell, slot).into_iter().enumerate() {
                // The two ends of the side.
                if let Some(k) = corners.iter().position(|&w| w == v && w != corners[(i + 2) % 3]) {
                    sheets.join((3 * facet + k) as u32, (3 * other + place) as u32);
                }
            }
        }
    }
    let (mut vertices, mut of_balls) = (Vec::new(), Vec::new());
    let mut vertex_of = room.filled(3 * facets.len(), NONE)?;
    for corner in 0..vertex_of.len() {
        let root = sheets.root(corner as u32) as usize;
        if root == corner {
            let sample = triangles.as_flattened()[corner];
            vertex_of[corner] = vertices.len() as u32;
            room.push(&mut vertices, t.coords()[sample as usize])?;
            let row = t.row_of_vertex()[sample as usize];
            room.push(&mut of_balls, samples[row as usize].ball)?;
        }
        vertex_of[corner] = vertex_of[root];
    }
    let parts = ComplexParts {
        vertices,
        faces: Rows::uniform_in(vertex_of.as_chunks::<3>().0.to_vec(), room)?,
        attributes: vec![Attribute::new("ball", Element::Vertex, 1, Values::U32(of_balls))?],
        ..ComplexParts::default()
    };
    Complex::new_in(parts, run)
}

/// The next facet of the boundary round the side opposite a corner of one, through inner cells: the cell inside, and the slot opposite.
fn across(
    t: &Triangulation,
    is_inner: &[bool],
    (mut cell, slot): (u32, usize),
    mut corner: u32,
) -> (u32, usize) {
    let mut opposite = t.cells()[cell as usize][slot];
    loop {
        let corners = &t.cells()[cell as usize];
        let slot = corners.iter().position(|&v| v == corner).unwrap_or(0);
        let next = t.neighbors()[cell as usize][slot];
        if next == NONE || !is_inner[next as usize] {
            return (cell, slot);
        }
        // The next cell has the side and what was opposite, and one more.
        let others = corners.iter().fold(corner, |bits, v| bits ^ v);
        let beyond = t.cells()[next as usize].iter().fold(others, |bits, v| bits ^ v);
        (cell, corner, opposite) = (next, opposite, beyond);
    }
}
