//! Samples: checked, merged where they coincide, and put into spatial order.

mod bounds;
mod build;
mod far_box;
mod hilbert;
pub(crate) mod order;

pub use bounds::Bounds;
pub use far_box::FAR_BOX_FACTOR;
pub use far_box::FAR_BOX_LEN;

pub(crate) use build::check_coordinates;

use crate::error::Result;
use crate::index::NONE;
use crate::job::{Job, Run, Stage};
use std::sync::OnceLock;

/// The largest absolute coordinate: 2^200.
///
/// With [`COORDINATE_MIN`] it keeps the exact predicates, products of five coordinate
/// differences at most, within the range of an f64 (Shewchuk 1997, section 5, for insphere).
pub const COORDINATE_MAX: f64 = f64::from_bits((1023 + 200) << 52);
/// The smallest absolute coordinate other than zero: 2^-160.
pub const COORDINATE_MIN: f64 = f64::from_bits((1023 - 160) << 52);
/// The most points: 2^28, so that the cells stay below 2^30 on surfaces and in volumes alike.
pub const POINT_LIMIT: usize = 1 << 28;

/// What to do with rows that are not numbers, and the like.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PointsOptions {
    /// Leave out rows with a NaN or an infinity instead of failing. They map to [`NONE`].
    pub skip_non_finite: bool,
}

/// A set of distinct points in spatial order, with the map from the input's rows.
///
/// Vertices are numbered along a Hilbert curve through the bounding box (see `points/order.rs`), ties
/// by the lexicographic order of the coordinates: the numbering depends on the set alone.
///
/// Invariants: no two vertices are equal; every coordinate is finite and 0 or within
/// [`COORDINATE_MIN`, `COORDINATE_MAX`] in absolute value, and never -0; `row_of_vertex[v]` is the
/// first row equal to vertex `v`; `vertex_of_row[r]` is [`NONE`] exactly for rows left out.
#[derive(Clone, Debug)]
pub struct Points {
    coords: Vec<[f64; 3]>,
    vertex_of_row: Vec<u32>,
    row_of_vertex: Vec<u32>,
    duplicate_count: usize,
    skipped_count: usize,
    bounds: Bounds,
    /// Made from the other maps when it is first asked for: nearly always nobody does.
    duplicate_of: OnceLock<Vec<u32>>,
}

/// Equal in all that was read, whatever has been asked for since.
impl PartialEq for Points {
    fn eq(&self, other: &Self) -> bool {
        self.coords == other.coords
            && self.vertex_of_row == other.vertex_of_row
            && self.row_of_vertex == other.row_of_vertex
            && self.skipped_count == other.skipped_count
    }
}

impl Points {
    /// Checks, merges and orders the given rows.
    ///
    /// Errors: [`crate::Status::NonFinite`] and [`crate::Status::CoordinateRange`] with the row,
    /// [`crate::Status::TooFewPoints`] when no row is left, [`crate::Status::LimitExceeded`] past
    /// [`POINT_LIMIT`]. Cost: O(n log n).
    pub fn new(rows: &[[f64; 3]], options: PointsOptions, job: &Job) -> Result<Self> {
        Points::by_row(rows.len(), |row| rows[row], options, job)
    }

    /// [`Points::new`] of rows wherever they are, given how many they are and each by its number.
    ///
    /// Each row is asked for several times, by several threads, and must be the same each time.
    pub fn by_row(
        count: usize,
        row: impl Fn(usize) -> [f64; 3] + Sync,
        options: PointsOptions,
        job: &Job,
    ) -> Result<Self> {
        let row = |i| Some(row(i));
        job.run(&[(Stage::Order, 1.0)], |run| Points::by_row_in(count, row, options, run))
    }

    /// [`Points::by_row`] as a stage of a larger build; a row that is `None` is left out unseen.
    pub(crate) fn by_row_in(
        count: usize,
        row: impl Fn(usize) -> Option<[f64; 3]> + Sync,
        options: PointsOptions,
        run: &Run<'_>,
    ) -> Result<Self> {
        build::build(count, row, options, run)
    }

    /// The distinct points in spatial order, in input units.
    pub fn coords(&self) -> &[[f64; 3]] {
        &self.coords
    }

    /// The number of distinct points.
    pub fn len(&self) -> usize {
        self.coords.len()
    }

    /// Whether there is no point; never so for a set that [`Points::new`] made.
    pub fn is_empty(&self) -> bool {
        self.coords.is_empty()
    }

    /// The number of input rows.
    pub fn row_count(&self) -> usize {
        self.vertex_of_row.len()
    }

    /// The vertex of each input row; [`NONE`] for a row left out.
    pub fn vertex_of_row(&self) -> &[u32] {
        &self.vertex_of_row
    }

    /// The first input row of each vertex.
    pub fn row_of_vertex(&self) -> &[u32] {
        &self.row_of_vertex
    }

    /// For each input row the first row with the same coordinates, or [`NONE`] where the row is
    /// itself the first, or was left out.
    ///
    /// Made at the first call, in O(n); empty if there is no memory for it.
    pub fn duplicate_of(&self) -> &[u32] {
        self.duplicate_of.get_or_init(|| {
            let mut first = Vec::new();
            if first.try_reserve_exact(self.row_count()).is_ok() {
                first.extend((0..).zip(&self.vertex_of_row).map(|(row, &vertex)| match vertex {
                    NONE => NONE,
                    vertex => match self.row_of_vertex[vertex as usize] {
                        first if first == row => NONE,
                        first => first,
                    },
                }));
            }
            first
        })
    }

    /// The number of rows that repeat an earlier one.
    pub fn duplicate_count(&self) -> usize {
        self.duplicate_count
    }

    /// The number of rows left out.
    pub fn skipped_count(&self) -> usize {
        self.skipped_count
    }

    /// What the arrays take.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self.coords()) + 4 * self.row_count() + 4 * self.len()
    }

    /// The smallest box that holds every point.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }
}
