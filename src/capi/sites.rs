//! Sites
//!
//! What distances are measured to: a boundary, as pieces that belong to sites. A #medax_sites holds points, segments, rays, lines, in the
//! plane circles, in space triangles and spheres; it is made of a plane figure, of a mesh or polygon soup, or of the pieces themselves, and
//! knows what is inside.
//!
//! In the plane, dimension 2, every z is 0. Pieces are numbered from 0, sites by the caller.

use super::boundary;
use super::handle::{self, medax_complex, medax_figure, medax_job, medax_sites};
use super::options::flag;
use super::status::medax_status;
use super::view::{self, Buffer, Out, medax_view_u32};
use crate::complex::Complex;
use crate::distance::{Piece, Sites};
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Room, Run, Stage};
use std::ptr;
use std::sync::Arc;

/// What a piece is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_piece_kind {
    /// A point: 3 numbers.
    Point = 0,
    /// The points between two ends, one point if these are equal: 2 x 3 numbers.
    Segment = 1,
    /// An origin, and the way into which all else lies, of any length but 0: 2 x 3 numbers.
    Ray = 2,
    /// A point of it, and its direction, of any length but 0: 2 x 3 numbers.
    Line = 3,
    /// Three corners, in space only; one without area is its longest side: 3 x 3 numbers.
    Triangle = 4,
    /// The centre, and the radius, which is positive: 4 numbers. A circle in the plane. The surface alone, not the ball.
    Sphere = 5,
}

use medax_piece_kind as K;

/// A piece of a boundary, and the site to which it belongs.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct medax_piece {
    /// A #medax_piece_kind.
    pub kind: u32,
    /// The number of its site, anything but `MEDAX_NONE`.
    pub site: u32,
    /// Coordinates, in input units, as the kind has them. Those behind them are not looked at, and come out as 0.
    pub numbers: [f64; 9],
}

impl medax_piece {
    fn new(piece: &Piece, site: u32) -> Self {
        let (kind, given): (_, &[&[f64]]) = match piece {
            Piece::Point(p) => (K::Point, &[p]),
            Piece::Segment([p, q]) => (K::Segment, &[p, q]),
            Piece::Ray(p, along) => (K::Ray, &[p, along]),
            Piece::Line(p, along) => (K::Line, &[p, along]),
            Piece::Triangle([p, q, r]) => (K::Triangle, &[p, q, r]),
            Piece::Sphere(center, radius) => (K::Sphere, &[center, &[*radius]]),
        };
        let mut numbers = [0.0; 9];
        for (to, &from) in numbers.iter_mut().zip(given.iter().copied().flatten()) {
            *to = from;
        }
        medax_piece { kind: kind as u32, site, numbers }
    }

    fn translate(&self) -> Result<Piece> {
        let [a, b, c, d, e, f, g, h, i] = self.numbers;
        let (p, q, r) = ([a, b, c], [d, e, f], [g, h, i]);
        let kinds = [K::Point, K::Segment, K::Ray, K::Line, K::Triangle, K::Sphere];
        match kinds.into_iter().find(|&kind| kind as u32 == self.kind) {
            Some(K::Point) => Ok(Piece::Point(p)),
            Some(K::Segment) => Ok(Piece::Segment([p, q])),
            Some(K::Ray) => Ok(Piece::Ray(p, q)),
            Some(K::Line) => Ok(Piece::Line(p, q)),
            Some(K::Triangle) => Ok(Piece::Triangle([p, q, r])),
            Some(K::Sphere) => Ok(Piece::Sphere(p, d)),
            None => {
                let message = format!("{} is no medax_piece_kind", self.kind);
                Err(Error::new(Status::InvalidArgument, message))
            }
        }
    }
}

/// Makes sites of the caller's pieces, which are copied.
///
/// \param dimension 2 in the plane, 3 in space.
/// \param pieces `piece_count` pieces.
/// \param piece_count The number of pieces, at least 1.
/// \param is_closed In the plane `flag_count` flags, one for each piece: 1 for one of a closed curve, 0 for any other; a point is inside
///        where a ray from it crosses these an odd number of times. NULL only if `flag_count` is 0. Copied.
/// \param flag_count The number of flags; 0 for none, so that all is outside.
/// \param job NULL for a default job.
/// \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
/// \return `MEDAX_STATUS_OK`; with the row of a piece: `NON_FINITE`, `COORDINATE_RANGE` beyond 2^200, and `INVALID_ARGUMENT` for a kind, a
///         site, a direction or a radius without meaning, for what does not lie in the plane, and for a flag that is neither 0 nor 1;
///         `INVALID_ARGUMENT` for another dimension, no pieces, and flags in space; `MISMATCH` unless each piece has a flag;
///         `LIMIT_EXCEEDED` past 2^31 - 1 pieces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_create(
    dimension: u32,
    pieces: *const medax_piece,
    piece_count: usize,
    is_closed: *const u8,
    flag_count: usize,
    job: *const medax_job,
    out_sites: *mut *const medax_sites,
) -> medax_status {
    boundary::status(|| {
        let given = view::slice(pieces, piece_count, "pieces")?;
        let flags = view::slice(is_closed, flag_count, "is_closed")?;
        let out = Out::new(out_sites, "out_sites")?;
        let mut own = None;
        let sites = handle::job(job, &mut own).run(&[(Stage::Order, 1.0)], |run| {
            let mut room = Room::new(run);
            let count = given.len();
            let (mut pieces, mut site_of_piece) = (room.vec(count)?, room.vec(count)?);
            for (row, piece) in (0..).zip(run.watch(given)) {
                let piece = piece?;
                pieces.push(piece.translate().map_err(|error| error.at(ElementKind::Row, row))?);
                site_of_piece.push(piece.site);
            }
            let sites = Sites::new_in(dimension, pieces, site_of_piece, run)?;
            closed(sites, flags, &mut room, run)
        })?;
        out.put(give(sites));
        Ok(())
    })
}

/// Marks the pieces of closed curves, if any flags are given.
fn closed(sites: Sites, flags: &[u8], room: &mut Room<'_>, run: &Run<'_>) -> Result<Sites> {
    if flags.is_empty() {
        return Ok(sites);
    }
    let mut is_closed = room.vec(flags.len())?;
    for (row, &number) in (0..).zip(flags) {
        run.poll()?;
        let is_piece = flag(u32::from(number), "is_closed");
        is_closed.push(is_piece.map_err(|error| error.at(ElementKind::Row, row))?);
    }
    sites.with_closed(is_closed)
}

fn give(sites: Sites) -> *const medax_sites {
    handle::new(medax_sites { sites: Arc::new(sites) })
}

/// The curves and points of a plane figure. Each part is a site; rings and circles are closed, so that the inside is that of the figure.
///
/// Pieces are the points and the edges, chain by chain, then the circles. Edges are segments.
///
/// \param figure The figure.
/// \param job NULL for a default job.
/// \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
/// \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^31 - 1 pieces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_of_figure(
    figure: *const medax_figure,
    job: *const medax_job,
    out_sites: *mut *const medax_sites,
) -> medax_status {
    boundary::status(|| {
        let figure = &handle::get(figure, "figure")?.figure;
        let out = Out::new(out_sites, "out_sites")?;
        let mut own = None;
        out.put(give(Sites::of_figure(figure, handle::job(job, &mut own))?));
        Ok(())
    })
}

/// A mesh, open or closed, or polygon soup: one site, number 0.
///
/// Pieces are the triangles of #medax_complex_triangles, then the loose edges as segments, then the vertices that neither uses as points.
/// With triangles the sites lie in space, and inside is where the faces wind round a point more than half a time; without, they have the
/// dimension of the complex.
///
/// \param complex The complex, which the sites keep alive.
/// \param is_closed In the plane `flag_count` flags, one for each piece, as for #medax_sites_create; NULL only if `flag_count` is 0.
///        Copied.
/// \param flag_count The number of flags; 0 for none.
/// \param job NULL for a default job.
/// \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a complex without vertices, for flags in space, and with its row for a flag that is
///         neither 0 nor 1; `MISMATCH` unless each piece has a flag; `COORDINATE_RANGE` with the row of a piece; `LIMIT_EXCEEDED` past 2^31
///         - 1 pieces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_of_complex(
    complex: *const medax_complex,
    is_closed: *const u8,
    flag_count: usize,
    job: *const medax_job,
    out_sites: *mut *const medax_sites,
) -> medax_status {
    of_mesh(complex, is_closed, flag_count, job, out_sites, Sites::of_complex_in)
}

/// The pieces of a mesh or polygon soup as #medax_sites_of_complex has them, each connected component a site: what faces and edges join by
/// common vertices, whose coordinates count for nothing. Both shells of a hollow solid are sites.
///
/// \param complex The complex, which the sites keep alive.
/// \param is_closed In the plane `flag_count` flags, one for each piece, as for #medax_sites_create; NULL only if `flag_count` is 0.
///        Copied.
/// \param flag_count The number of flags; 0 for none.
/// \param job NULL for a default job.
/// \param out_sites Receives the sites, numbered by their least vertices, which the caller frees with #medax_sites_free.
/// \return As #medax_sites_of_complex.
///
/// O(n log n). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_of_components(
    complex: *const medax_complex,
    is_closed: *const u8,
    flag_count: usize,
    job: *const medax_job,
    out_sites: *mut *const medax_sites,
) -> medax_status {
    of_mesh(complex, is_closed, flag_count, job, out_sites, Sites::of_components_in)
}

unsafe fn of_mesh(
    complex: *const medax_complex,
    is_closed: *const u8,
    flag_count: usize,
    job: *const medax_job,
    out_sites: *mut *const medax_sites,
    made_of: fn(&Arc<Complex>, &Run<'_>) -> Result<Sites>,
) -> medax_status {
    boundary::status(|| {
        let complex = &handle::get(complex, "complex")?.complex;
        let flags = view::slice(is_closed, flag_count, "is_closed")?;
        let out = Out::new(out_sites, "out_sites")?;
        let mut own = None;
        let sites = handle::job(job, &mut own).run(&[(Stage::Order, 1.0)], |run| {
            closed(made_of(complex, run)?, flags, &mut Room::new(run), run)
        })?;
        out.put(give(sites));
        Ok(())
    })
}

/// The dimension of sites.
///
/// \param sites The sites; NULL has 0.
/// \return 2 in the plane, else 3.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_dimension(sites: *const medax_sites) -> u32 {
    boundary::value(0, || handle::maybe(sites).map_or(0, |s| s.sites.dimension()))
}

/// The number of pieces.
///
/// \param sites The sites; NULL has none.
/// \return The number of pieces.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_piece_count(sites: *const medax_sites) -> usize {
    boundary::value(0, || handle::maybe(sites).map_or(0, |s| s.sites.pieces().len()))
}

/// Some pieces, as they were given or found.
///
/// \param sites The sites.
/// \param first The first of them.
/// \param count How many.
/// \param out_pieces Receives `count` pieces; the caller's buffer, NULL only if `count` is 0.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` past the last piece; `NULL_ARGUMENT`.
///
/// O(count). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_pieces(
    sites: *const medax_sites,
    first: usize,
    count: usize,
    out_pieces: *mut medax_piece,
) -> medax_status {
    boundary::status(|| {
        let sites = &handle::get(sites, "sites")?.sites;
        let out = Buffer::new(out_pieces, count, "out_pieces")?;
        let range = view::range(first, count, sites.pieces().len(), "pieces")?;
        let chosen = sites.pieces()[range.clone()].iter().zip(&sites.site_of_piece()[range]);
        out.fill_with(chosen.map(|(piece, &site)| medax_piece::new(piece, site)));
        Ok(())
    })
}

/// The site of each piece.
///
/// \param sites The sites, or NULL.
/// \return One row a piece: a site. Borrowed from `sites`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_site_of_piece(sites: *const medax_sites) -> medax_view_u32 {
    boundary::value(medax_view_u32::new(&[], 1), || {
        let numbers = handle::maybe(sites).map_or(&[][..], |s| s.sites.site_of_piece());
        medax_view_u32::new(numbers, 1)
    })
}

/// The number of sites: one more than the largest number.
///
/// \param sites The sites; NULL has none.
/// \return The number of sites.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_site_count(sites: *const medax_sites) -> usize {
    boundary::value(0, || handle::maybe(sites).map_or(0, |s| s.sites.site_count() as usize))
}

/// The smallest box round the bounded pieces.
///
/// \param sites The sites.
/// \param out_min Receives the three least coordinates.
/// \param out_max Receives the three greatest coordinates.
/// \return `MEDAX_STATUS_OK`; `DEGENERATE` if all pieces are rays and lines; `NULL_ARGUMENT`.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_bounds(
    sites: *const medax_sites,
    out_min: *mut f64,
    out_max: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let sites = &handle::get(sites, "sites")?.sites;
        let min = Out::new(out_min.cast::<[f64; 3]>(), "out_min")?;
        let max = Out::new(out_max.cast::<[f64; 3]>(), "out_max")?;
        let bounds = sites.bounds().ok_or_else(|| {
            Error::new(Status::Degenerate, "rays and lines are unbounded, and have no box")
        })?;
        min.put(bounds.min);
        max.put(bounds.max);
        Ok(())
    })
}

/// The diagonal of that box, of which defaults of densities and tolerances are shares.
///
/// \param sites The sites; NULL has 0.
/// \return A length in input units, 1 where there is no box, or it is a point.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_size(sites: *const medax_sites) -> f64 {
    boundary::value(0.0, || handle::maybe(sites).map_or(0.0, |s| s.sites.size()))
}

/// One more reference to sites.
///
/// \param sites The sites, or NULL.
/// \return The same pointer; the caller frees it once more.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_clone(sites: *const medax_sites) -> *const medax_sites {
    boundary::value(ptr::null(), || handle::clone(sites))
}

/// Gives one reference to sites back; the last one frees them.
///
/// \param sites The sites; NULL does nothing.
///
/// Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_free(sites: *const medax_sites) {
    boundary::value((), || handle::free(sites));
}
