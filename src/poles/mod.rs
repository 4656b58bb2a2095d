//! Poles: for each sample the farthest Voronoi vertices on either side of the surface.
//!
//! Amenta, Choi, Kolluri 2001, *The Power Crust*, sections 3.2 and 5.1; Amenta, Bern 1999 for a
//! sample alone, whose poles may be at infinity. See `docs/algorithms/poles.md`.

mod angle;
mod export;
mod feature_size;
mod merge;
mod omit;
mod select;
mod tangent;
mod touch;
mod validate;

pub(crate) use feature_size::distances;
pub(crate) use merge::{least_cells, least_rays};
pub use omit::{Omit, PolesOptions};
pub(crate) use select::{FirstPoles, Selection, seen_from};
pub(crate) use tangent::TangentPlane;

use crate::complex::{Hierarchy, Rows};
use crate::dual::{Dual, DualOptions, LANES, offsets, unit};
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, PART, Room, Run, Stage, parts};
use crate::points::{Bounds, COORDINATE_MIN, FAR_BOX_LEN, Points, order};
use crate::triangulation::Triangulation;
use std::sync::{Arc, OnceLock};

/// The largest coordinate of a pole in absolute value, 2^400; what lies farther is moved there.
const POLE_MAX: f64 = f64::from_bits((1023 + 400) << 52);

/// The poles of a sample, alone or with the far box.
///
/// The *first pole* of a sample is the farthest vertex of its Voronoi cell: the one with the largest
/// squared radius, of equal ones the one with the lexicographically least centre, then the least cell.
/// The *second pole* is the farthest of those whose direction makes an obtuse angle with that of the
/// first. Distances are compared by their squares, correctly rounded, and angles exactly, for the exact
/// centres: among samples an ulp apart rounded ones tell nothing. Where the Voronoi cell is
/// unbounded (a sample on the hull, without far box) the first pole is at infinity, in the direction of
/// the mean of the unit directions of the cell's unbounded edges, as it stands in `normals`. Poles of misshapen Voronoi cells are left
/// out if that is asked for ([`Omit`]); their samples have none then.
///
/// Invariants: a pole is one Voronoi vertex, even where several samples choose it or several cells
/// share it (their spheres are the same, exactly); `cell_of_pole` is the least such cell; poles are
/// numbered along a Hilbert curve through their centres, ties by coordinates, then by cell; every
/// pole is that of a sample; the points of the far box have no poles and are in no count. Centres are
/// correctly rounded, but for coordinates moved into the range of exact predicates: below 2^-160
/// to 0, above 2^400 to 2^400.
#[derive(Clone, Debug)]
pub struct Poles {
    triangulation: Arc<Triangulation>,
    options: PolesOptions,
    lambda: f64,
    balls: Vec<[f64; 4]>,
    radii_squared: Vec<f64>,
    cell_of_pole: Vec<u32>,
    touches_far_box: Vec<bool>,
    pole_of_sample: Vec<[u32; 2]>,
    samples_on_balls: Rows,
    object_angles: Vec<f64>,
    normals: Vec<[f64; 3]>,
    /// The centres of the balls, for [`Poles::feature_size`]; made when that is first asked.
    hierarchy: OnceLock<Hierarchy<1>>,
}

impl Poles {
    /// The poles of the sample S, chosen among the Voronoi vertices of S and the far box Z
    /// ([`Points::with_far_box`]), so that every sample has a first pole.
    ///
    /// Errors: [`Status::TooFewPoints`] below four distinct points, [`Status::Degenerate`] where
    /// all lie in a plane, [`Status::CoordinateRange`] where there is no room for Z, and those
    /// of the job; with poles to be left out, those of [`Poles::new`]. Cost: nearly all that of a Delaunay triangulation.
    pub fn with_far_box(points: &Arc<Points>, options: PolesOptions, job: &Job) -> Result<Self> {
        let plan = [(Stage::Triangulate, 0.7), (Stage::Dual, 0.2), (Stage::Poles, 0.1)];
        job.run(&plan, |run| Poles::with_far_box_in(points, options, run))
    }

    /// [`Poles::with_far_box`] as a stage of a larger build.
    pub(crate) fn with_far_box_in(
        points: &Arc<Points>,
        options: PolesOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        Triangulation::check_solid(points, run)?;
        let mut room = Room::new(run);
        let boxed = Arc::new(points.with_far_box_in(run)?);
        room.keep(boxed.bytes())?;
        let triangulation = Arc::new(Triangulation::delaunay_in(&boxed, run)?);
        room.keep(triangulation.bytes() - boxed.bytes())?;
        let dual = Dual::new_in(&triangulation, DualOptions::default(), run)?;
        room.keep(dual.bytes())?;
        Poles::new_in(&dual, options, run)
    }

    /// What the arrays take, those of the triangulation included.
    pub(crate) fn bytes(&self) -> usize {
        (size_of_val(self.balls()) + size_of_val(self.radii_squared()) + 13 * self.len())
            + (size_of_val(self.pole_of_sample()) + size_of_val(self.normals()))
            + 4 * (self.len() + self.samples_on_balls.indices().len())
            + self.triangulation.bytes()
    }

    /// Chooses the poles of every sample from the Voronoi diagram of the sample, or of the sample
    /// with the far box.
    ///
    /// Errors: [`Status::InvalidArgument`] for a power diagram and for options out of range, [`Status::TooFewPoints`] where
    /// all poles would be left out, and those of the job. Cost: O(m) for m cells.
    pub fn new(dual: &Dual, options: PolesOptions, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Poles, 1.0)], |run| Poles::new_in(dual, options, run))
    }

    /// [`Poles::new`] as a stage of a larger build.
    pub(crate) fn new_in(dual: &Dual, options: PolesOptions, run: &Run<'_>) -> Result<Self> {
        run.enter(Stage::Poles)?;
        check_unweighted(dual)?;
        let t = dual.triangulation();
        let samples = sample_count(t.points());
        let mut room = Room::new(run);
        let least_cell = merge::least_cells(dual, &mut room, run)?;
        let mut selection = select_in(dual, &mut room, run)?;
        let lambda = omit::omit(dual, &mut selection, options, &mut room, run)?;
        let Selection { first, second, normals } = selection;
        let mut numbers = room.filled(t.cells().len(), NONE)?;
        let cell_of_pole = number(dual, &least_cell, [&first, &second], &mut numbers, run)?;
        let mut touches_far_box = room.filled(cell_of_pole.len(), false)?;
        mark_far(t, samples, &least_cell, &numbers, &mut touches_far_box, run)?;
        let pole = |&cell: &u32| match cell {
            NONE => NONE,
            cell => numbers[least_cell[cell as usize] as usize],
        };
        let pairs = first.iter().zip(&second).map(|(p, q)| [pole(p), pole(q)]);
        let pole_of_sample = room.collect(pairs)?;
        let pole_of_cell = |cell: usize| numbers[least_cell[cell] as usize];
        let samples_on_balls =
            touch::samples_on_balls(t, samples, cell_of_pole.len(), pole_of_cell, &mut room, run)?;
        let ball = |&cell: &u32| {
            let [x, y, z] = position(dual, cell);
            [x, y, z, dual.radii_squared()[cell as usize].sqrt()]
        };
        let balls = room.collect(cell_of_pole.iter().map(ball))?;
        let object_angles =
            angle::object_angles(t.coords(), &balls, &samples_on_balls, &mut room, run)?;
        Ok(Poles {
            triangulation: t.clone(),
            options,
            lambda,
            balls,
            radii_squared: room
                .collect(cell_of_pole.iter().map(|&c| dual.radii_squared()[c as usize]))?,
            cell_of_pole,
            touches_far_box,
            pole_of_sample,
            samples_on_balls,
            object_angles,
            normals,
            hierarchy: OnceLock::new(),
        })
    }

    /// The triangulation of the sample, with the far box if there is one.
    pub fn triangulation(&self) -> &Arc<Triangulation> {
        &self.triangulation
    }

    /// What was asked for.
    pub fn options(&self) -> &PolesOptions {
        &self.options
    }

    /// The lambda by which poles were left out, given or estimated; 0 if that was not asked for.
    pub fn lambda(&self) -> f64 {
        self.lambda
    }

    /// Whether the poles were chosen with the far box.
    pub fn has_far_box(&self) -> bool {
        self.triangulation.coords().len() == self.sample_count() + FAR_BOX_LEN
    }

    /// The number of poles, p.
    pub fn len(&self) -> usize {
        self.balls.len()
    }

    /// Whether there is no finite pole.
    pub fn is_empty(&self) -> bool {
        self.balls.is_empty()
    }

    /// The number of samples, n: the first vertices of the triangulation.
    pub fn sample_count(&self) -> usize {
        self.pole_of_sample.len()
    }

    /// The polar balls, p x 4: centre and radius, in input units. The radius is the square root of
    /// [`Poles::radii_squared`], rounded.
    pub fn balls(&self) -> &[[f64; 4]] {
        &self.balls
    }

    /// The squared radii of the polar balls, correctly rounded.
    pub fn radii_squared(&self) -> &[f64] {
        &self.radii_squared
    }

    /// The cell of the triangulation whose circumcentre each pole is; the least one, if several
    /// cells share their sphere.
    pub fn cell_of_pole(&self) -> &[u32] {
        &self.cell_of_pole
    }

    /// Whether a cell of each pole has a vertex of the far box; always `false` without far box.
    pub fn touches_far_box(&self) -> &[bool] {
        &self.touches_far_box
    }

    /// The first and the second pole of each sample, n x 2; [`NONE`] for a first pole at infinity, where
    /// there is no second one, and for those left out.
    pub fn pole_of_sample(&self) -> &[[u32; 2]] {
        &self.pole_of_sample
    }

    /// The samples on each polar ball, ascending: those whose Voronoi cells meet at the pole. There are four of them, or
    /// more where samples are cospherical, or fewer where the ball touches the far box.
    pub fn samples_on_balls(&self) -> &Rows {
        &self.samples_on_balls
    }

    /// The object angle of each pole, in [0, pi] radians: the largest angle at its centre between two samples on its ball.
    /// Corners of the far box are no samples; with fewer than two samples on the ball it is 0.
    ///
    /// So Stolpner and Whitesides define it (*Medial axis approximation with bounded error*, 2009, section V) for the points of
    /// the boundary that are nearest to a point of the medial axis; where these are more than two, the largest angle counts. Half of it is
    /// the medial angle of Dey and Zhao (2004, section 3).
    pub fn object_angles(&self) -> &[f64] {
        &self.object_angles
    }

    /// The unit direction from each sample to its first pole, n x 3, an estimate of the surface's
    /// normal. It is *not* oriented: it points outward at some samples and inward at others.
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.normals
    }
}

/// The error of a power diagram, which has no poles.
fn check_unweighted(dual: &Dual) -> Result<()> {
    match dual.triangulation().is_weighted() {
        true => Err(Error::new(
            Status::InvalidArgument,
            "poles need the dual of a Delaunay triangulation, not of a regular one",
        )),
        false => Ok(()),
    }
}

/// The cells of each sample's poles, and the unit direction to its first one, as a part of a larger build.
///
/// Errors: [`Status::InvalidArgument`] for a power diagram, and those of the job.
pub(crate) fn select_in(dual: &Dual, room: &mut Room<'_>, run: &Run<'_>) -> Result<Selection> {
    check_unweighted(dual)?;
    let t = dual.triangulation();
    let samples = sample_count(t.points());
    let mut selection = Selection::new(dual, samples, room, run)?;
    let chunks = parts(samples).into_iter().zip(selection.normals.chunks_mut(PART)).collect();
    run.in_steps(chunks, [0.6, 0.7], |(range, normals)| {
        directions(t, &selection.first[range.clone()], range.start, normals, run)
    })?;
    Ok(selection)
}

/// The centre of a cell, as far as that is within the range of exact predicates.
pub(crate) fn position(dual: &Dual, cell: u32) -> [f64; 3] {
    dual.centers()[cell as usize].map(|x| match x.abs() < COORDINATE_MIN {
        true => 0.0,
        false => x.clamp(-POLE_MAX, POLE_MAX),
    })
}

/// The number of samples: the points before the far box, which has no rows.
fn sample_count(points: &Points) -> usize {
    let rows = points.row_of_vertex();
    rows.iter().position(|&row| row == NONE).unwrap_or(rows.len())
}

/// The cells of the poles in their order, one for each Voronoi vertex that is chosen; their numbers
/// go into `numbers`, which must be [`NONE`] throughout.
fn number(
    dual: &Dual,
    least_cell: &[u32],
    chosen: [&[u32]; 2],
    numbers: &mut [u32],
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let mut room = Room::new(run);
    let mut cells = Vec::new();
    for cell in run.watch(chosen.into_iter().flatten().filter(|&&cell| cell != NONE)) {
        let least = least_cell[*cell? as usize];
        if numbers[least as usize] == NONE {
            numbers[least as usize] = 0;
            room.push(&mut cells, (position(dual, least), least))?;
        }
    }
    if let Some(bounds) = Bounds::of(cells.iter().map(|(center, _)| *center)) {
        order::sort(&mut cells, &bounds, run)?;
    }
    for (pole, (_, cell)) in cells.iter().enumerate() {
        numbers[*cell as usize] = pole as u32;
    }
    room.collect(cells.into_iter().map(|(_, cell)| cell))
}

/// Marks the poles of which any cell has a vertex that is not a sample.
fn mark_far(
    t: &Triangulation,
    samples: usize,
    least_cell: &[u32],
    numbers: &[u32],
    touches: &mut [bool],
    run: &Run<'_>,
) -> Result<()> {
    for cell in run.watch(t.cells().iter().zip(least_cell)) {
        let (corners, &least) = cell?;
        let pole = numbers[least as usize];
        if pole != NONE && corners.iter().any(|&v| v as usize >= samples) {
            touches[pole as usize] = true;
        }
    }
    Ok(())
}

/// The unit directions from samples, the first of them given, to the centres of the given cells of theirs; where
/// there is none nothing changes.
fn directions(
    t: &Triangulation,
    cells: &[u32],
    first: usize,
    directions: &mut [[f64; 3]],
    run: &Run<'_>,
) -> Result<()> {
    for begin in (0..cells.len()).step_by(LANES) {
        if begin % 1024 == 0 {
            run.poll()?;
        }
        let end = cells.len().min(begin + LANES);
        let any = cells[begin..end].iter().position(|&cell| cell != NONE);
        let Some(any) = any.map(|i| begin + i) else { continue };
        // Another one stands for those that are missing. From the exact difference: the centre itself may
        // round to the sample.
        let lanes: [usize; LANES] = std::array::from_fn(|l| match begin + l {
            i if i < end && cells[i] != NONE => i,
            _ => any,
        });
        let seen = lanes.map(|i| select::seen_from(t, (first + i) as u32, cells[i]));
        for (i, offset) in lanes.into_iter().zip(offsets(&seen)) {
            let flat = || {
                let cell = u64::from(cells[i]);
                Error::new(Status::Internal, "the cell is flat").at(ElementKind::Cell, cell)
            };
            directions[i] = unit(offset.ok_or_else(flat)?);
        }
    }
    Ok(())
}
