//! Figures
//!
//! Curves and points in the plane: polygons with holes, open polylines, points, circles.
//!
//! The chains of a figure are the rings of its polygons, the polylines, the points, in this order and each in the order in which
//! they were given; circles stand apart. Parts are numbered alike: the polygons, the polylines, the points, the circles. Outer
//! rings end up counterclockwise, holes clockwise. Whether curves cross is decided exactly. Coordinates must be 0 or have an absolute value
//! from 2^-160 to 2^200.

use super::boundary;
use super::handle::{self, medax_figure, medax_job};
use super::options::{self, Report, sized_struct};
use super::status::medax_status;
use super::validation::{self, medax_validation};
use super::view::{self, Out, medax_view_f64, medax_view_rows, medax_view_u32};
use crate::error::{Error, Result, Status};
use crate::figure::{ChainKind, Crossings, Figure, FigureOptions, FigureParts, Normalised};
use crate::index::NONE;
use crate::io::{self, FeatureChoice, ReadFigureOptions};
use std::ffi::c_char;
use std::ptr;
use std::sync::Arc;

/// What a chain of a figure is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_chain_kind {
    /// The outer ring of a polygon: an edge from each vertex to the next, and from the last to the first.
    Outer = 0,
    /// A hole of a polygon, a ring like the outer one.
    Hole = 1,
    /// An open polyline: an edge from each vertex to the next.
    Polyline = 2,
    /// A single vertex.
    Point = 3,
}

const _: () = assert!(ChainKind::Outer as u32 == medax_chain_kind::Outer as u32);
const _: () = assert!(ChainKind::Hole as u32 == medax_chain_kind::Hole as u32);
const _: () = assert!(ChainKind::Polyline as u32 == medax_chain_kind::Polyline as u32);
const _: () = assert!(ChainKind::Point as u32 == medax_chain_kind::Point as u32);

/// What becomes of curves that cross or touch, and of polygons in the wrong place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_crossings {
    /// They are an error.
    Refuse = 0,
    /// They are counted. What is inside is then where a ray crosses rings and circles an odd number of times.
    Accept = 1,
}

impl From<Crossings> for medax_crossings {
    fn from(crossings: Crossings) -> Self {
        match crossings {
            Crossings::Refuse => medax_crossings::Refuse,
            Crossings::Accept => medax_crossings::Accept,
        }
    }
}

fn figure_options(crossings: u32) -> Result<FigureOptions> {
    let known = [Crossings::Refuse, Crossings::Accept].into_iter();
    known
        .map(|crossings| FigureOptions { crossings })
        .find(|options| medax_crossings::from(options.crossings) as u32 == crossings)
        .ok_or_else(|| {
            Error::new(Status::InvalidArgument, format!("{crossings} is no medax_crossings"))
        })
}

/// The arrays from which #medax_figure_create makes a figure. Each may be NULL if its count is 0; the defaults are nothing at all,
/// and crossings refused.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_figure_parts {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// `ring_vertex_count` x 2 coordinates: one ring after the other. A ring may end with its first vertex or not, and
    /// turn either way.
    pub ring_vertices: *const f64,
    /// The number of vertices of all rings.
    pub ring_vertex_count: usize,
    /// `ring_count + 1` rows of `ring_vertices`: where each ring begins, the first at 0, and the end.
    pub ring_offsets: *const u32,
    /// The number of rings.
    pub ring_count: usize,
    /// `polygon_count + 1` rings: where the rings of each polygon begin, the outer ring first, then the holes; and the end.
    pub polygon_offsets: *const u32,
    /// The number of polygons.
    pub polygon_count: usize,
    /// `polyline_vertex_count` x 2 coordinates: one polyline after the other.
    pub polyline_vertices: *const f64,
    /// The number of vertices of all polylines.
    pub polyline_vertex_count: usize,
    /// `polyline_count + 1` rows of `polyline_vertices`: where each polyline begins, and the end.
    pub polyline_offsets: *const u32,
    /// The number of polylines.
    pub polyline_count: usize,
    /// `point_count` x 2 coordinates.
    pub points: *const f64,
    /// The number of points.
    pub point_count: usize,
    /// `circle_count` x 3: the centre's coordinates and the radius.
    pub circles: *const f64,
    /// The number of circles.
    pub circle_count: usize,
    /// A #medax_crossings.
    pub crossings: u32,
    /// Must be 0.
    pub reserved: u32,
}

sized_struct!(medax_figure_parts, first_size: size_of::<medax_figure_parts>(), reserved: reserved, {
    ring_vertices: *const f64 = ptr::null(),
    ring_vertex_count: usize = 0,
    ring_offsets: *const u32 = ptr::null(),
    ring_count: usize = 0,
    polygon_offsets: *const u32 = ptr::null(),
    polygon_count: usize = 0,
    polyline_vertices: *const f64 = ptr::null(),
    polyline_vertex_count: usize = 0,
    polyline_offsets: *const u32 = ptr::null(),
    polyline_count: usize = 0,
    points: *const f64 = ptr::null(),
    point_count: usize = 0,
    circles: *const f64 = ptr::null(),
    circle_count: usize = 0,
    crossings: u32 = 0,
    reserved: u32 = 0,
});

impl medax_figure_parts {
    /// # Safety
    /// As the header has it for the arrays, which stay as they are during `'a`.
    unsafe fn translate<'a>(&self) -> Result<FigureParts<'a>> {
        Ok(FigureParts {
            ring_vertices: view::rows(self.ring_vertices, self.ring_vertex_count, "ring_vertices")?,
            ring_offsets: offsets(self.ring_offsets, self.ring_count, "ring_offsets")?,
            polygon_offsets: offsets(self.polygon_offsets, self.polygon_count, "polygon_offsets")?,
            polyline_vertices: view::rows(
                self.polyline_vertices,
                self.polyline_vertex_count,
                "polyline_vertices",
            )?,
            polyline_offsets: offsets(
                self.polyline_offsets,
                self.polyline_count,
                "polyline_offsets",
            )?,
            points: view::rows(self.points, self.point_count, "points")?,
            circles: view::rows(self.circles, self.circle_count, "circles")?,
        })
    }
}

/// Where `count` rows begin, and the end; nothing where there is no row.
unsafe fn offsets<'a>(data: *const u32, count: usize, name: &str) -> Result<&'a [u32]> {
    match count {
        0 => Ok(&[]),
        _ => view::slice(data, count.saturating_add(1), name),
    }
}

/// Sets figure parts to nothing.
///
/// \param parts The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *parts`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_parts_init(
    parts: *mut medax_figure_parts,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(parts, struct_size, "parts"))
}

/// Makes a figure of the caller's arrays, which are copied.
///
/// Vertices that repeat the one before are dropped, and so is the last one of a ring if it is the first again; rings are turned; -0
/// becomes 0. Collinear vertices stay. Edges, of rings and polylines alike, and circles may have no point in common but the vertex between two
/// edges of a chain and the ends that polylines share; holes must lie in their outer ring and in no other hole, and no polygon or disc in
/// another, though in its hole it may; unless `crossings` accepts all that. Points may lie anywhere.
///
/// \param parts The arrays.
/// \param job NULL for a default job.
/// \param out_figure Receives the figure, which the caller frees with #medax_figure_free.
/// \return `MEDAX_STATUS_OK`; with the ring, counted over all polygons, the polyline, the row of the point, or the circle: `NON_FINITE`,
///         `COORDINATE_RANGE`, `TOO_FEW_POINTS` for a ring of fewer than three distinct vertices or a polyline of fewer than
///         two, `DEGENERATE` for a ring on a line, `INVALID_ARGUMENT` for what crosses, touches or lies in the wrong place, and for a
///         radius that is not greater than 0; `TOO_FEW_POINTS` for a figure without anything; `MISMATCH` for offsets that
///         do not end with their count, `INVALID_ARGUMENT` for others that make no sense; `LIMIT_EXCEEDED` past 2^32 - 2
///         vertices and circles; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n + b) with b pairs of edges whose boxes meet. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_create(
    parts: *const medax_figure_parts,
    job: *const medax_job,
    out_figure: *mut *const medax_figure,
) -> medax_status {
    boundary::status(|| {
        if parts.is_null() {
            return Err(view::null("parts"));
        }
        let out = Out::new(out_figure, "out_figure")?;
        let parts = options::read(parts, "parts")?;
        let options = figure_options(parts.crossings)?;
        let mut own = None;
        let figure = Figure::new(parts.translate()?, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_figure { figure: Arc::new(figure) }));
        Ok(())
    })
}

/// Which features of a file make up a figure, and what becomes of crossings.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_figure_read_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// The features of which the `id`, or one of the properties `name`, `NAME`, `glyph` and `id`, is this text, or a number written so;
    /// UTF-8. NULL, the default: any name.
    pub feature_name: *const c_char,
    /// The number of a feature, from 0; `MEDAX_NONE`, the default, for any number. Not together with a name.
    pub feature_number: u32,
    /// A #medax_crossings.
    pub crossings: u32,
}

sized_struct!(medax_figure_read_options, first_size: size_of::<medax_figure_read_options>(),
    reserved: none, {
    feature_name: *const c_char = ptr::null(),
    feature_number: u32 = NONE,
    crossings: u32 = 0,
});

/// Sets the options for reading figures to their defaults: all features, crossings refused.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_read_options_init(
    options: *mut medax_figure_read_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// Reads a figure from a GeoJSON file: polygons, lines as open polylines, points, and points of a feature with a property `radius`
/// greater than 0 as circles.
///
/// \param path_utf8 The path.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_figure Receives the figure, which the caller frees with #medax_figure_free.
/// \return `MEDAX_STATUS_OK`; `FORMAT` with the line where the file is malformed; `INVALID_ARGUMENT` where no feature has the name or
///         number; `UNSUPPORTED` for another ending than `.geojson`; `IO`; and as #medax_figure_create, rings being
///         counted over the chosen features.
///
/// O(size of the file), and as #medax_figure_create. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_read(
    path_utf8: *const c_char,
    options: *const medax_figure_read_options,
    job: *const medax_job,
    out_figure: *mut *const medax_figure,
) -> medax_status {
    boundary::status(|| {
        let path = view::text(path_utf8, "path_utf8")?;
        let out = Out::new(out_figure, "out_figure")?;
        let options = options::read(options, "options")?;
        let name = match options.feature_name.is_null() {
            true => None,
            false => Some(view::text(options.feature_name, "feature_name")?),
        };
        let feature = match (name, options.feature_number) {
            (None, NONE) => FeatureChoice::All,
            (None, number) => FeatureChoice::Numbered(number as usize),
            (Some(name), NONE) => FeatureChoice::Named(name.to_string()),
            _ => {
                let message = "a feature is chosen by its name or its number, not by both";
                return Err(Error::new(Status::InvalidArgument, message));
            }
        };
        let options = ReadFigureOptions { feature, figure: figure_options(options.crossings)? };
        let mut own = None;
        let figure = io::read_figure(path, &options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_figure { figure: Arc::new(figure) }));
        Ok(())
    })
}

/// The vertices of a figure, chain by chain.
///
/// \param figure The figure, or NULL.
/// \return v x 2 coordinates, in input units. Borrowed from `figure`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_vertices(figure: *const medax_figure) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], 2), || {
        let vertices = handle::maybe(figure).map_or(&[][..], |f| f.figure.vertices());
        medax_view_f64::new(vertices.as_flattened(), 2)
    })
}

/// The chains of a figure.
///
/// \param figure The figure, or NULL.
/// \return One row a chain: its vertices, numbers in succession. Borrowed from `figure`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_chains(figure: *const medax_figure) -> medax_view_rows {
    boundary::value(medax_view_rows::EMPTY, || {
        handle::maybe(figure).map_or(medax_view_rows::EMPTY, |f| {
            let chains = f.figure.chains();
            medax_view_rows::new(chains.offsets(), chains.indices())
        })
    })
}

/// What each chain of a figure is.
///
/// \param figure The figure, or NULL.
/// \return One row a chain: a #medax_chain_kind. Borrowed from `figure`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_kinds(figure: *const medax_figure) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        let kinds = handle::maybe(figure).map_or(&[][..], |f| f.figure.kinds());
        medax_view_u32::new(view::numbers(kinds), 1)
    })
}

/// The part of each chain of a figure: a polygon, a polyline or a point.
///
/// \param figure The figure, or NULL.
/// \return One row a chain: a part, ascending. Borrowed from `figure`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_parts_of_chains(
    figure: *const medax_figure,
) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        let parts = handle::maybe(figure).map_or(&[][..], |f| f.figure.parts());
        medax_view_u32::new(parts, 1)
    })
}

/// The circles of a figure. Circle `i` of c is the part #medax_figure_part_count - c + i.
///
/// \param figure The figure, or NULL.
/// \return c x 3: the centre's coordinates and the radius. Borrowed from `figure`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_circles(figure: *const medax_figure) -> medax_view_f64 {
    boundary::value(medax_view_f64::new(&[], 3), || {
        let circles = handle::maybe(figure).map_or(&[][..], |f| f.figure.circles());
        medax_view_f64::new(circles.as_flattened(), 3)
    })
}

/// The number of parts of a figure: polygons, polylines, points and circles.
///
/// \param figure The figure; NULL has none.
/// \return The number of parts.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_part_count(figure: *const medax_figure) -> usize {
    boundary::value(0, || handle::maybe(figure).map_or(0, |f| f.figure.part_count()))
}

/// The smallest box round a figure, discs included; that of a disc is rounded outward.
///
/// \param figure The figure.
/// \param out_min Receives the two least coordinates.
/// \param out_max Receives the two greatest coordinates.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_bounds(
    figure: *const medax_figure,
    out_min: *mut f64,
    out_max: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let bounds = handle::get(figure, "figure")?.figure.bounds();
        let min = Out::new(out_min.cast::<[f64; 2]>(), "out_min")?;
        let max = Out::new(out_max.cast::<[f64; 2]>(), "out_max")?;
        let plane = |[x, y, _]: [f64; 3]| [x, y];
        min.put(plane(bounds.min));
        max.put(plane(bounds.max));
        Ok(())
    })
}

/// What was changed and accepted when a figure was made. The caller sets `struct_size`, the library the rest.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_normalised {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// Rings whose last vertex repeated the first one, and was dropped.
    pub closing_vertices: u64,
    /// Vertices at the place of the one before, which were dropped.
    pub repeated_vertices: u64,
    /// Rings that turned the wrong way, and were turned.
    pub turned_rings: u64,
    /// Pairs of edges or circles that cross or touch. 0 unless crossings were accepted.
    pub crossings: u64,
    /// Rings and circles in a place where `MEDAX_CROSSINGS_REFUSE` does not have them. 0 unless crossings were accepted, and 0
    /// where anything crosses.
    pub misplaced: u64,
}

sized_struct!(medax_normalised, first_size: size_of::<medax_normalised>(), reserved: none, {
    closing_vertices: u64 = 0,
    repeated_vertices: u64 = 0,
    turned_rings: u64 = 0,
    crossings: u64 = 0,
    misplaced: u64 = 0,
});

impl From<Normalised> for medax_normalised {
    fn from(found: Normalised) -> Self {
        let Normalised { closing_vertices, repeated_vertices, turned_rings, crossings, misplaced } =
            found;
        medax_normalised {
            closing_vertices,
            repeated_vertices,
            turned_rings,
            crossings,
            misplaced,
            ..<Self as options::SizedStruct>::DEFAULT
        }
    }
}

/// Tells what was changed and accepted when a figure was made.
///
/// \param figure The figure.
/// \param out_report Receives the counts; its `struct_size` must be set.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_normalised(
    figure: *const medax_figure,
    out_report: *mut medax_normalised,
) -> medax_status {
    boundary::status(|| {
        let figure = handle::get(figure, "figure")?;
        let report = Report::new(out_report, "out_report")?;
        report.fill(&(*figure.figure.normalised()).into());
        Ok(())
    })
}

/// Checks every invariant of a figure: its arrays, the turns of its rings, crossings, and where rings and circles lie.
///
/// \param figure The figure.
/// \param job NULL for a default job.
/// \param out_report Receives the findings; its `struct_size` must be set.
/// \return `MEDAX_STATUS_OK`, also where a problem was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// O(n log n + b + r n) with b pairs of edges side by side and r rings and circles. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_validate(
    figure: *const medax_figure,
    job: *const medax_job,
    out_report: *mut medax_validation,
) -> medax_status {
    validation::validate(job, out_report, |job| handle::get(figure, "figure")?.figure.validate(job))
}

/// One more reference to a figure.
///
/// \param figure The figure, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_clone(figure: *const medax_figure) -> *const medax_figure {
    boundary::value(ptr::null(), || handle::clone(figure))
}

/// Gives one reference to a figure back; the last one frees it.
///
/// \param figure The figure; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_figure_free(figure: *const medax_figure) {
    boundary::value((), || handle::free(figure));
}
