//! Poles: of each sample's Voronoi cell the farthest vertex, and the farthest one on the other
//! side (Amenta, Bern 1999; Amenta, Choi, Kolluri 2001, sections 3.2 and 5.1).

mod feature_size;
mod select;
mod validate;

use crate::dual::circumcenter;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Run, Stage};
use crate::points::{COORDINATE_MIN, FAR_BOX_LEN, Points};
use crate::predicates::{Sign, insphere};
use crate::triangulation::Triangulation;
use select::Picks;
use std::sync::Arc;

/// Poles' coordinates are clamped to this absolute value, 2^400.
const POLE_MAX: f64 = f64::from_bits((1023 + 400) << 52);

/// The poles of a sample and their balls.
///
/// A pole is a Voronoi vertex, however many samples choose it and however many cells share it
/// (the cells of more than four cospherical samples do). Poles are numbered by the spatial rank
/// of their centres, then by cell. Sample `i` is vertex `i` of the [`Points`] that were given.
///
/// Invariants: `balls[p][3]` is the root of `radii_squared[p]`; both are correctly rounded, and
/// so are centres, up to the clamping of what lies outside [2^-160, 2^400]; `cell_of_pole[p]`
/// is the least chosen cell with that centre; no two poles are the same Voronoi vertex; each pole is the
/// first or second pole of a sample.
#[derive(Clone, Debug)]
pub struct Poles {
    triangulation: Arc<Triangulation>,
    sample_count: usize,
    balls: Vec<[f64; 4]>,
    radii_squared: Vec<f64>,
    cell_of_pole: Vec<u32>,
    touches_far_box: Vec<bool>,
    pole_of_sample: Vec<[u32; 2]>,
    normals: Vec<[f64; 3]>,
}

impl Poles {
    /// The poles of the sample S, chosen among the Voronoi vertices of S and the far box Z, so that
    /// every cell is bounded.
    ///
    /// The first pole is the farthest Voronoi vertex of the sample's cell, by correctly rounded
    /// squared distance; of equal ones the lexicographically least centre, then the least cell.
    /// The second is the farthest of those that make an obtuse angle with the first, decided
    /// exactly on the rounded centres. Errors: [`Status::TooFewPoints`] below four distinct points,
    /// [`Status::Degenerate`] where all lie in a plane, [`Status::CoordinateRange`] where there
    /// is no room for Z, and those of the job. Cost: one Delaunay triangulation, then
    /// O(cells log cells).
    pub fn with_far_box(points: &Arc<Points>, job: &Job) -> Result<Self> {
        let plan = [(Stage::Triangulate, 0.7), (Stage::Poles, 0.3)];
        job.run(&plan, |run| Poles::with_far_box_in(points, run))
    }

    /// [`Poles::with_far_box`] as a stage of a larger build.
    pub(crate) fn with_far_box_in(points: &Arc<Points>, run: &Run<'_>) -> Result<Self> {
        Triangulation::check_solid(points, run)?;
        let boxed = Arc::new(points.with_far_box()?);
        let triangulation = Arc::new(Triangulation::delaunay_in(&boxed, run)?);
        run.enter(Stage::Poles)?;
        let count = triangulation.cells().len();
        let mut centers: Vec<[f64; 3]> = run.try_vec(count)?;
        let mut radii_squared: Vec<f64> = run.try_vec(count)?;
        for (id, cell) in triangulation.cells().iter().enumerate() {
            if id % 1024 == 0 {
                run.tick(id / 2, count)?;
            }
            let center = circumcenter(cell.map(|v| triangulation.coords()[v as usize]))
                .ok_or_else(|| Error::new(Status::Internal, "a cell of a triangulation is flat"))?;
            centers.push(center.position.map(clamp));
            radii_squared.push(center.radius_squared);
        }
        let incidence = triangulation.incidence_in(run)?;
        let picks = Picks::new(&triangulation, &incidence, &centers, &radii_squared, run)?;
        Poles::number(triangulation, picks, &centers, &radii_squared, run)
    }

    /// Merges the chosen cells into Voronoi vertices and numbers these.
    fn number(
        triangulation: Arc<Triangulation>,
        picks: Picks,
        centers: &[[f64; 3]],
        radii_squared: &[f64],
        run: &Run<'_>,
    ) -> Result<Self> {
        let sample_count = picks.cells.len();
        let mut chosen: Vec<u32> = picks.cells.as_flattened().to_vec();
        chosen.retain(|&cell| cell != NONE);
        chosen.sort_unstable();
        chosen.dedup();
        let position = |&cell: &u32| centers[cell as usize];
        let ranked = Points::new_in(chosen.iter().map(position), Default::default(), run)?;
        let rank_of = |i: usize| ranked.vertex_of_row()[i];
        let mut order: Vec<u32> = (0..chosen.len() as u32).collect();
        order.sort_unstable_by_key(|&i| (rank_of(i as usize), i));
        run.enter(Stage::Poles)?;
        let mut poles = Poles {
            triangulation,
            sample_count,
            balls: Vec::new(),
            radii_squared: Vec::new(),
            cell_of_pole: Vec::new(),
            touches_far_box: Vec::new(),
            pole_of_sample: Vec::new(),
            normals: picks.normals,
        };
        let mut pole_of_chosen = vec![NONE; chosen.len()];
        for place in order.chunk_by(|&i, &j| rank_of(i as usize) == rank_of(j as usize)) {
            run.poll()?;
            let first = poles.len();
            for &i in place {
                let cell = chosen[i as usize];
                let same = (first..poles.len())
                    .find(|&pole| poles.share_sphere(poles.cell_of_pole[pole], cell));
                let pole = same.unwrap_or_else(|| {
                    let [x, y, z] = centers[cell as usize];
                    let squared = radii_squared[cell as usize];
                    poles.balls.push([x, y, z, squared.sqrt()]);
                    poles.radii_squared.push(squared);
                    poles.cell_of_pole.push(cell);
                    poles.touches_far_box.push(false);
                    poles.len() - 1
                });
                let corners = poles.triangulation.cells()[cell as usize];
                poles.touches_far_box[pole] |= corners.iter().any(|&v| v as usize >= sample_count);
                pole_of_chosen[i as usize] = pole as u32;
            }
        }
        let pole_of = |cell: u32| chosen.binary_search(&cell).map_or(NONE, |i| pole_of_chosen[i]);
        poles.pole_of_sample = picks.cells.iter().map(|pair| pair.map(pole_of)).collect();
        Ok(poles)
    }

    /// Whether two cells are parts of one Delaunay polytope: all their vertices lie on one sphere.
    fn share_sphere(&self, one: u32, other: u32) -> bool {
        let cells = self.triangulation.cells();
        let at = |v: u32| &self.triangulation.coords()[v as usize];
        let [a, b, c, d] = cells[one as usize].map(at);
        cells[other as usize]
            .iter()
            .all(|&v| cells[one as usize].contains(&v) || insphere(a, b, c, d, at(v)) == Sign::Zero)
    }

    /// The triangulation whose cells' circumcentres the poles are: of S and Z.
    pub fn triangulation(&self) -> &Arc<Triangulation> {
        &self.triangulation
    }

    /// Whether the poles were chosen with the far box.
    pub fn has_far_box(&self) -> bool {
        self.triangulation.coords().len() == self.sample_count + FAR_BOX_LEN
    }

    /// The number of samples; Z does not count.
    pub fn sample_count(&self) -> usize {
        self.sample_count
    }

    /// The number of poles.
    pub fn len(&self) -> usize {
        self.balls.len()
    }

    /// Whether there is no pole.
    pub fn is_empty(&self) -> bool {
        self.balls.is_empty()
    }

    /// The polar balls: centre and radius, in input units.
    pub fn balls(&self) -> &[[f64; 4]] {
        &self.balls
    }

    /// The squared radius of each polar ball, rounded once.
    pub fn radii_squared(&self) -> &[f64] {
        &self.radii_squared
    }

    /// The cell of the triangulation whose circumcentre each pole is.
    pub fn cell_of_pole(&self) -> &[u32] {
        &self.cell_of_pole
    }

    /// Whether the Delaunay cell of each pole has a corner of the far box.
    pub fn touches_far_box(&self) -> &[bool] {
        &self.touches_far_box
    }

    /// The first and second pole of each sample; [`NONE`] where there is none, or it is at infinity.
    pub fn pole_of_sample(&self) -> &[[u32; 2]] {
        &self.pole_of_sample
    }

    /// The unit vector from each sample towards its first pole: normal to the surface, on
    /// either side of it.
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.normals
    }
}

/// A centre's coordinate within the range in which the predicates on poles are exact.
fn clamp(x: f64) -> f64 {
    if x.abs() < COORDINATE_MIN { 0.0 } else { x.clamp(-POLE_MAX, POLE_MAX) }
}
