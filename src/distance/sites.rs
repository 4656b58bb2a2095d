//! Sites: what distances are measured to.

use super::piece::{Foot, Piece};
use super::side::Solid;
use super::tree::Tree;
use crate::complex::{Complex, DisjointSets};
use crate::error::{ElementKind, Error, Result, Status};
use crate::figure::{ChainKind, Figure};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::points::Bounds;
use crate::vector::{Vec3, length, scale, sub};
use std::sync::Arc;

/// A boundary, as pieces that belong to sites: a polygon, a mesh, a line. Whatever can be nearest.
///
/// Invariants: there is a piece; every number is finite, at most 2^200 in absolute value, and not -0; `site_of_piece` has a site for each piece. In the plane, `dimension` 2, every z is 0 and
/// no piece is a triangle.
#[derive(Clone, Debug)]
pub struct Sites {
    dimension: u32,
    pieces: Vec<Piece>,
    site_of_piece: Vec<u32>,
    site_count: u32,
    bounds: Option<Bounds>,
    tree: Tree,
    pub(super) solid: Solid,
}

/// What is nearest to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nearest {
    /// The nearest point of the boundary.
    pub point: [f64; 3],
    /// How far away it is, in input units.
    pub distance: f64,
    /// The way there, of length 1; 0 from a point of the boundary. The gradient of the negative distance, where it has one.
    pub direction: [f64; 3],
    /// The piece whose point it is, of several the least.
    pub piece: u32,
}

impl Sites {
    /// Sites in the plane (2) or in space (3), one for each number that `site_of_piece` names. -0 becomes 0.
    ///
    /// Errors: [`Status::InvalidArgument`] for another dimension, no pieces, and with the row of the piece a direction or a radius without meaning, a piece out of the plane, or
    /// u32::MAX for its site; [`Status::NonFinite`] and [`Status::CoordinateRange`] with its row; [`Status::Mismatch`] unless each piece has a site; those of the job. Cost: O(n log n).
    pub fn new(
        dimension: u32,
        pieces: Vec<Piece>,
        site_of_piece: Vec<u32>,
        job: &Job,
    ) -> Result<Self> {
        job.run(&[(Stage::Order, 1.0)], |run| Sites::new_in(dimension, pieces, site_of_piece, run))
    }

    /// [`Sites::new`] as a stage of a larger build.
    pub(crate) fn new_in(
        dimension: u32,
        mut pieces: Vec<Piece>,
        site_of_piece: Vec<u32>,
        run: &Run<'_>,
    ) -> Result<Self> {
        run.enter(Stage::Order)?;
        let wrong = |message: &str| Error::new(Status::InvalidArgument, message);
        if !(2..=3).contains(&dimension) {
            return Err(wrong("sites lie in 2 or in 3 dimensions"));
        }
        if pieces.is_empty() {
            return Err(wrong("there is nothing to measure distances to"));
        }
        if pieces.len() >= 1 << 31 {
            return Err(Error::new(Status::LimitExceeded, "more than 2^31 - 1 pieces"));
        }
        if site_of_piece.len() != pieces.len() {
            let message = format!("{} sites for {} pieces", site_of_piece.len(), pieces.len());
            return Err(Error::new(Status::Mismatch, message));
        }
        for (row, piece) in (0..).zip(run.watch(&mut pieces)) {
            let piece = piece?;
            piece.check(dimension).map_err(|error| error.at(ElementKind::Row, row))?;
            *piece = piece.normalized();
        }
        if let Some(row) = site_of_piece.iter().position(|&site| site == NONE) {
            return Err(wrong("a site has no number").at(ElementKind::Row, row as u64));
        }
        let mut room = Room::new(run);
        let tree = Tree::new(&pieces, &mut room, run)?;
        let corners = pieces.iter().filter_map(Piece::bounds).flat_map(|b| [b.min, b.max]);
        let bounds = Bounds::of(corners);
        let site_count = site_of_piece.iter().max().map_or(0, |&site| site + 1);
        Ok(Sites { dimension, pieces, site_of_piece, site_count, bounds, tree, solid: Solid::None })
    }

    /// The curves and points of a figure: each of its parts is a site, its rings and circles are closed.
    ///
    /// Errors: those of the job.
    pub fn of_figure(figure: &Figure, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Order, 1.0)], |run| Sites::of_figure_in(figure, run))
    }

    /// [`Sites::of_figure`] as a stage of a larger build.
    pub(crate) fn of_figure_in(figure: &Figure, run: &Run<'_>) -> Result<Self> {
        let mut room = Room::new(run);
        let at = |v: u32| {
            let [x, y] = figure.vertices()[v as usize];
            [x, y, 0.0]
        };
        let count = figure.vertices().len() + figure.circles().len();
        let (mut pieces, mut site_of_piece) = (room.vec(count)?, room.vec(count)?);
        let mut is_closed = room.vec(count)?;
        let mut push = |piece, site, closed| {
            pieces.push(piece);
            site_of_piece.push(site);
            is_closed.push(closed);
        };
        for chain in run.watch(0..figure.kinds().len()) {
            let chain = chain?;
            let (kind, part) = (figure.kinds()[chain], figure.parts()[chain]);
            if kind == ChainKind::Point {
                figure
                    .chains()
                    .row(chain)
                    .iter()
                    .for_each(|&v| push(Piece::Point(at(v)), part, false));
            }
            for ends in figure.edges(chain) {
                push(Piece::Segment(ends.map(at)), part, kind.is_ring());
            }
        }
        for (i, &[x, y, radius]) in figure.circles().iter().enumerate() {
            push(Piece::Sphere([x, y, 0.0], radius), figure.part_of_circle(i), true);
        }
        let solid = Solid::Curves(is_closed);
        Ok(Sites { solid, ..Sites::new_in(2, pieces, site_of_piece, run)? })
    }

    /// The faces of a complex as triangles, its loose edges as segments, and its vertices that neither uses as points: one site. Polygon soup is welcome; inside is where the faces wind round a point.
    ///
    /// Errors: [`Status::InvalidArgument`] for a complex without vertices; [`Status::CoordinateRange`] with the row of the piece; those of the job.
    pub fn of_complex(complex: &Arc<Complex>, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Order, 1.0)], |run| Sites::of_complex_in(complex, run))
    }

    /// [`Sites::of_complex`] as a stage of a larger build.
    pub(crate) fn of_complex_in(complex: &Arc<Complex>, run: &Run<'_>) -> Result<Self> {
        Sites::of_parts(complex, |_| 0, run)
    }

    /// The same pieces, each connected component of the complex a site: what its faces and edges join by common vertices, whose coordinates count for nothing. They are numbered by their least
    /// vertices. So what lies between two solids of a mesh is told from what lies within one; both shells of a hollow solid are sites, too.
    ///
    /// Errors: as [`Sites::of_complex`].
    pub fn of_components(complex: &Arc<Complex>, job: &Job) -> Result<Self> {
        job.run(&[(Stage::Order, 1.0)], |run| Sites::of_components_in(complex, run))
    }

    /// [`Sites::of_components`] as a stage of a larger build.
    pub(crate) fn of_components_in(complex: &Arc<Complex>, run: &Run<'_>) -> Result<Self> {
        let mut room = Room::new(run);
        let count = complex.vertices().len();
        let mut components = DisjointSets::new(count, run)?;
        for face in run.watch(complex.faces().iter()) {
            face?.windows(2).for_each(|ends| {
                components.join(ends[0], ends[1]);
            });
        }
        for edge in run.watch(complex.edges()) {
            let &[a, b] = edge?;
            components.join(a, b);
        }
        // The root is the least vertex, so that it has its number before the others.
        let (mut sites, mut site_of_vertex) = (0, room.vec(count)?);
        for v in run.watch(0..count as u32) {
            let v = v?;
            let root = components.root(v);
            site_of_vertex.push(if root == v { sites } else { site_of_vertex[root as usize] });
            sites += u32::from(root == v);
        }
        Sites::of_parts(complex, |v| site_of_vertex[v as usize], run)
    }

    /// The pieces of a complex, with the site of one of its vertices each.
    fn of_parts(
        complex: &Arc<Complex>,
        site_of_vertex: impl Fn(u32) -> u32,
        run: &Run<'_>,
    ) -> Result<Self> {
        let mut room = Room::new(run);
        let at = |v: u32| complex.vertices()[v as usize];
        let mut is_used = room.filled(complex.vertices().len(), false)?;
        let used = complex.faces().indices().iter().chain(complex.edges().as_flattened());
        used.for_each(|&v| is_used[v as usize] = true);
        let unused = is_used.iter().filter(|is_used| !**is_used).count();
        let count = complex.triangles().len() + complex.edges().len() + unused;
        let (mut pieces, mut site_of_piece) = (room.vec(count)?, room.vec(count)?);
        let mut push = |piece, vertex| {
            pieces.push(piece);
            site_of_piece.push(site_of_vertex(vertex));
        };
        complex.triangles().iter().for_each(|t| push(Piece::Triangle(t.map(at)), t[0]));
        complex.edges().iter().for_each(|e| push(Piece::Segment(e.map(at)), e[0]));
        let unused = (0..).zip(is_used).filter(|(_, is_used)| !is_used);
        unused.for_each(|(v, _)| push(Piece::Point(at(v)), v));
        let dimension = if complex.triangles().is_empty() { complex.dimension() } else { 3 };
        let solid = match complex.triangles().is_empty() {
            true => Solid::None,
            false => Solid::Mesh(complex.clone()),
        };
        Ok(Sites { solid, ..Sites::new_in(dimension, pieces, site_of_piece, run)? })
    }

    /// The same, of which in the plane some pieces are parts of closed curves: a point is inside where a ray from it crosses these an odd number of times.
    ///
    /// Errors: [`Status::Mismatch`] unless there is a flag for each piece; [`Status::InvalidArgument`] in space.
    pub fn with_closed(mut self, is_closed: Vec<bool>) -> Result<Self> {
        if self.dimension != 2 {
            let message = "in space a mesh tells the inside, and not curves";
            return Err(Error::new(Status::InvalidArgument, message));
        }
        if is_closed.len() != self.pieces.len() {
            let message = format!("{} flags for {} pieces", is_closed.len(), self.pieces.len());
            return Err(Error::new(Status::Mismatch, message));
        }
        self.solid = Solid::Curves(is_closed);
        Ok(self)
    }

    /// 2 in the plane, else 3.
    pub fn dimension(&self) -> u32 {
        self.dimension
    }

    pub(super) fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The pieces.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The site of each piece.
    pub fn site_of_piece(&self) -> &[u32] {
        &self.site_of_piece
    }

    /// One more than the largest number of a site.
    pub fn site_count(&self) -> u32 {
        self.site_count
    }

    /// The smallest box round the bounded pieces; `None` if there are none.
    pub fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    /// The diagonal of that box, 1 where there is none.
    pub fn size(&self) -> f64 {
        self.bounds.map(|bounds| bounds.diagonal()).filter(|&size| size > 0.0).unwrap_or(1.0)
    }

    /// What is nearest to one point, whose coordinates must be finite and in range.
    #[inline]
    pub(crate) fn foot(&self, p: Vec3) -> Foot {
        let nothing = Foot { point: p, distance_squared: f64::INFINITY, piece: 0 };
        self.tree.nearest(p, f64::INFINITY).unwrap_or(nothing)
    }

    /// What is nearest to one point, if it is no farther than a distance.
    pub(crate) fn foot_within(&self, p: Vec3, distance: f64) -> Option<Foot> {
        self.tree.nearest(p, distance * distance)
    }

    /// The nearest points of all pieces that are no farther than a distance, by pieces.
    pub(crate) fn feet_within(&self, p: Vec3, distance: f64, feet: &mut Vec<Foot>) {
        feet.clear();
        self.tree.within(p, distance * distance, |foot| feet.push(foot));
        feet.sort_unstable_by_key(|foot| foot.piece);
    }
}

impl Foot {
    /// What it says of a point.
    pub(super) fn seen_from(&self, p: Vec3) -> Nearest {
        let way = sub(self.point, p);
        let distance = length(way);
        let direction = if distance > 0.0 { scale(way, 1.0 / distance) } else { [0.0; 3] };
        Nearest { point: self.point, distance, direction, piece: self.piece }
    }
}
