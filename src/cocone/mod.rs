//! Cocone and Tight Cocone: surfaces through the samples, made of Delaunay triangles.
//!
//! Amenta, Choi, Dey, Leekha 2002, *A simple algorithm for homeomorphic surface reconstruction*; Dey, Giesen 2001, *Detecting
//! undersampling in surface reconstruction*; Dey, Goswami 2003, *Tight Cocone: a water-tight surface reconstructor*. See
//! `docs/algorithms/cocone.md`.

mod cone;
mod flat;
mod mark;
mod part;
mod peel;
mod prune;
mod sheet;
mod surface;
mod umbrella;
mod validate;
mod walk;

use crate::complex::{Complex, DisjointSets};
use crate::dual::Dual;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage, parts};
use crate::poles;
use crate::triangulation::Triangulation;
use cone::Cones;
use mark::Marks;
use sheet::Sheet;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, FRAC_PI_8};
use std::sync::Arc;
use umbrella::Umbrellas;
use walk::Side;

/// How a surface is taken from the Delaunay triangles. Angles are in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoconeOptions {
    /// The cocone's angle: how far from the tangent plane a Voronoi edge may pass, between 0 and pi / 2; pi / 8 by default.
    pub angle: f64,
    /// The ratio condition: how many times farther than the corners of its tangent polygon a well sampled point's poles are
    /// at least; not negative, 1.2 by default.
    pub ratio: f64,
    /// The normal condition: the largest angle between the pole vectors of cocone neighbours, between 0 and pi / 2; pi / 6 by
    /// default.
    pub normal_angle: f64,
}

impl Default for CoconeOptions {
    fn default() -> Self {
        CoconeOptions { angle: FRAC_PI_8, ratio: 1.2, normal_angle: FRAC_PI_6 }
    }
}

impl CoconeOptions {
    fn check(&self) -> Result<()> {
        let is_angle = |angle: f64| angle > 0.0 && angle < FRAC_PI_2;
        let problem = if !is_angle(self.angle) || !is_angle(self.normal_angle) {
            "the cocone's angle and the normal angle lie between 0 and pi / 2"
        } else if !(self.ratio >= 0.0 && self.ratio.is_finite()) {
            "the ratio of heights to widths is finite and not negative"
        } else {
            return Ok(());
        };
        Err(Error::new(Status::InvalidArgument, problem))
    }
}

/// The Cocone of a sample, and its Tight Cocone.
///
/// Invariants: every cell of the triangulation is inner or outer; `surface` is the boundary of the inner ones, oriented
/// outward, so that it is closed: every edge is in an even number of its triangles, and run equally often both ways. Cells of
/// which well sampled vertices say more often that they are inner than that they are outer are inner, and the other way round,
/// but for those that changed sides where the surface touched itself.
#[derive(Clone, Debug)]
pub struct Cocone {
    options: CoconeOptions,
    dual: Arc<Dual>,
    is_undersampled: Vec<bool>,
    is_well_sampled: Vec<bool>,
    is_inner: Vec<bool>,
    used: usize,
    marked: usize,
    /// The triangles of the umbrellas, as cells and facets, ascending; not only those of the open surface.
    layer: Vec<[u32; 2]>,
    /// The side of each sample's umbrella that is outside, 1 or 2; 0 where there is none.
    outer_side: Vec<u8>,
    /// The cells that changed sides where the surface touched itself, ascending.
    parted: Vec<u32>,
    open_surface: Arc<Complex>,
    surface: Arc<Complex>,
}

impl Cocone {
    /// The surfaces of a sample, given the Voronoi diagram of it alone, without far box.
    ///
    /// Errors: [`Status::InvalidArgument`] for a power diagram and for options out of range, [`Status::Mismatch`] for points with far box,
    /// [`Status::Degenerate`] where no cell is inner, and those of the job. Cost: O(m) for m cells, besides sorting the candidate triangles.
    pub fn new(dual: &Arc<Dual>, options: CoconeOptions, job: &Job) -> Result<Self> {
        let plan = [(Stage::Poles, 0.5), (Stage::Label, 0.4), (Stage::Extract, 0.1)];
        job.run(&plan, |run| Cocone::new_in(dual, options, run))
    }

    /// [`Cocone::new`] as a stage of a larger build.
    pub(crate) fn new_in(dual: &Arc<Dual>, options: CoconeOptions, run: &Run<'_>) -> Result<Self> {
        options.check()?;
        let t = &**dual.triangulation();
        if t.points().row_of_vertex().contains(&NONE) {
            return Err(Error::new(
                Status::Mismatch,
                "a cocone needs the Voronoi diagram of the samples alone, without the far box",
            ));
        }
        run.enter(Stage::Poles)?;
        let mut room = Room::new(run);
        let poles = poles::select_in(dual, &mut room, run)?;
        let incidence = t.incidence_in(run)?;
        room.keep(4 * (t.coords().len() + 4 * t.cells().len()))?;
        run.enter(Stage::Label)?;
        let cones = Cones::new(dual, &poles, libm::sin(options.angle), &mut room, run)?;
        let conditions = [options.ratio, libm::cos(options.normal_angle)];
        let is_flat = flat::flat_samples(&cones, &incidence, conditions, &mut room, run)?;
        let open = Layer::new(&cones, &is_flat, false, &mut room, run)?;
        let Layer { sheet, .. } = Layer::new(&cones, &is_flat, true, &mut room, run)?;
        drop(cones);
        let walls = sheet.walls(t, &mut room, run)?;
        let umbrellas = Umbrellas::new(t, &sheet, &walls, &incidence, &mut room, run)?;
        let Marks { outer_side, votes } = mark::mark(dual, &sheet, &umbrellas, &mut room, run)?;
        let mut is_inner = peel::peel(t, &walls, &votes, &mut room, run)?;
        let parted = part::part(t, &incidence, &votes, &mut is_inner, &mut room, run)?;
        run.enter(Stage::Extract)?;
        let boundary = t.boundary_of(&is_inner, &mut room, run)?;
        if boundary.is_empty() {
            return Err(Error::new(
                Status::Degenerate,
                "no part of space is inside: no sample is well sampled, or they enclose nothing; \
                 take more samples, or the power crust",
            ));
        }
        let never = room.filled(boundary.len(), false)?;
        let surface = surface::complex(t, &boundary, &never, &mut room, run)?;
        let turned = turned(t, &open, &is_inner, &mut room, run)?;
        let open_surface = surface::complex(t, &open.sheet.facets, &turned, &mut room, run)?;
        Ok(Cocone {
            options,
            dual: dual.clone(),
            is_undersampled: room.collect(is_flat.iter().map(|flat| !flat))?,
            is_well_sampled: umbrellas.is_good,
            used: surface.vertices().len(),
            marked: votes.iter().filter(|&&vote| vote != 0).count(),
            layer: sheet.facets,
            outer_side,
            parted,
            is_inner,
            open_surface: Arc::new(open_surface),
            surface: Arc::new(surface),
        })
    }

    /// What was asked for.
    pub fn options(&self) -> &CoconeOptions {
        &self.options
    }

    /// The Voronoi diagram of the samples.
    pub fn dual(&self) -> &Arc<Dual> {
        &self.dual
    }

    /// The Delaunay triangulation of the samples.
    pub fn triangulation(&self) -> &Arc<Triangulation> {
        self.dual.triangulation()
    }

    /// The Tight Cocone: the boundary of the inner cells, as triangles that are oriented outward.
    ///
    /// Vertices are the samples that it uses, ascending, with `sample`; faces carry `inner_cell` and `outer_cell`, which is [`NONE`] on the hull.
    pub fn surface(&self) -> &Arc<Complex> {
        &self.surface
    }

    /// The Cocone: a layer of candidate triangles, open where the sample is not dense enough. Attributes are those of [`Cocone::surface`].
    ///
    /// It is oriented, and no edge has more than two triangles. Components point out where more of their triangles
    /// do that lie between inner and outer cells; `inner_cell` is what lies behind a triangle, also where that is not inner, and [`NONE`] beyond the hull.
    pub fn open_surface(&self) -> &Arc<Complex> {
        &self.open_surface
    }

    /// For each cell of the triangulation whether it is inside.
    pub fn is_inner(&self) -> &[bool] {
        &self.is_inner
    }

    /// For each sample whether it is undersampled: it does not fulfil the ratio and the normal condition.
    pub fn is_undersampled(&self) -> &[bool] {
        &self.is_undersampled
    }

    /// For each sample whether the triangles round it are a disk that divides inside from outside. Triangles of undersampled points count here,
    /// which are not in the open surface.
    pub fn is_well_sampled(&self) -> &[bool] {
        &self.is_well_sampled
    }

    /// The number of samples that are vertices of the surface.
    pub fn used(&self) -> usize {
        self.used
    }

    /// The share of the samples that are vertices of the surface, in [0, 1].
    pub fn used_share(&self) -> f64 {
        self.used as f64 / self.is_undersampled.len() as f64
    }

    /// The number of cells that well sampled vertices mark as inner or outer; the others are peeled off or left.
    pub fn marked(&self) -> usize {
        self.marked
    }
}

/// One layer of the candidate triangles.
struct Layer<'a> {
    sheet: Sheet<'a>,
    /// For each triangle whether the walk was in front of it.
    front: Vec<bool>,
}

impl<'a> Layer<'a> {
    /// The pruned candidates that a walk meets; see [`candidates`] and [`walk::walk`].
    fn new(
        cones: &Cones<'_>,
        is_flat: &[bool],
        everywhere: bool,
        room: &mut Room<'_>,
        run: &'a Run<'a>,
    ) -> Result<Self> {
        let t = &**cones.dual.triangulation();
        let mut passing = Room::new(run);
        let facets = candidates(cones, is_flat, everywhere, &mut Room::new(run), run)?;
        let mut sheet = Sheet::new(t, facets, run)?;
        let mut is_pruned = passing.collect(is_flat.iter().copied())?;
        let kept = prune::prune(t, &sheet, &mut is_pruned, &mut Room::new(run), run)?;
        sheet = Sheet::new(t, sheet.kept(&kept, &mut Room::new(run))?, run)?;
        // What a first walk finds to be flaps is in the way of the second.
        let seen = walk::walk(t, &sheet, is_flat, false, &mut Room::new(run), run)?;
        let is_seen = |side: &Side| *side != Side::Unseen;
        let mut kept = passing.collect(seen.iter().map(is_seen))?;
        prune::cut_flaps(&sheet, &mut kept, &mut Room::new(run), run)?;
        let kept: Vec<bool> =
            passing.collect(seen.iter().zip(&kept).map(|(side, kept)| !is_seen(side) || *kept))?;
        sheet = Sheet::new(t, sheet.kept(&kept, &mut Room::new(run))?, run)?;
        let seen = walk::walk(t, &sheet, is_flat, !everywhere, &mut Room::new(run), run)?;
        let mut kept = passing.collect(seen.iter().map(is_seen))?;
        prune::cut_flaps(&sheet, &mut kept, &mut Room::new(run), run)?;
        let mut front = room.vec(sheet.len())?;
        let sides = seen.iter().zip(&kept).filter(|(_, kept)| **kept);
        front.extend(sides.map(|(&side, _)| side == Side::Front));
        sheet = Sheet::new(t, sheet.kept(&kept, &mut Room::new(run))?, run)?;
        Ok(Layer { sheet, front })
    }
}

/// The candidate triangles, ascending: those whose dual Voronoi edge meets the cocones of all their vertices that are flat, one at least
/// (Dey, Giesen 2001, section 5: the pole vectors of others say nothing). `everywhere` triangles without a flat vertex are
/// candidates, too, if the edge meets the cocones of all three (Amenta, Choi, Dey, Leekha 2002).
fn candidates(
    cones: &Cones<'_>,
    is_flat: &[bool],
    everywhere: bool,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<[u32; 2]>> {
    let t = cones.dual.triangulation();
    let pieces = run.in_parallel(parts(t.cells().len()), |range| {
        let mut room = Room::new(run);
        let mut facets: Vec<[u32; 2]> = Vec::new();
        for cell in range {
            if cell % 1024 == 0 {
                run.poll()?;
            }
            for (i, &next) in t.neighbors()[cell].iter().enumerate() {
                if (next as usize) < cell {
                    continue;
                }
                let corners = t.facet(cell as u32, i);
                let flat = |v: u32| is_flat[v as usize];
                let some_flat = corners.into_iter().any(flat);
                let meets = |v: u32| (some_flat && !flat(v)) || cones.meets(cell as u32, i, v);
                if (some_flat || everywhere) && corners.into_iter().all(meets) {
                    room.push(&mut facets, [cell as u32, i as u32])?;
                }
            }
        }
        Ok((facets, room))
    })?;
    let mut facets = room.vec(pieces.iter().map(|(piece, _)| piece.len()).sum())?;
    for (piece, _) in pieces {
        run.poll()?;
        facets.extend(piece);
    }
    Ok(facets)
}

/// For each triangle of a layer whether it must be turned to point out: as the walk saw it, but for components of which more triangles
/// between inner and outer cells then point in than out.
fn turned(
    t: &Triangulation,
    layer: &Layer<'_>,
    is_inner: &[bool],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<bool>> {
    let sheet = &layer.sheet;
    room.keep(4 * sheet.len())?;
    let mut components = DisjointSets::new(sheet.len(), run)?;
    for edge in run.watch(0..sheet.edge_count() as u32) {
        for pair in sheet.sides_of_edge(edge?).windows(2) {
            components.join(pair[0] / 4, pair[1] / 4);
        }
    }
    let mut agree = room.filled(sheet.len(), 0i64)?;
    for facet in run.watch(0..sheet.len() as u32) {
        let facet = facet?;
        let is_in = |cell: u32| cell != NONE && is_inner[cell as usize];
        let [behind, before] = sheet.cells(t, facet).map(is_in);
        if behind != before {
            let points_out = behind == layer.front[facet as usize];
            agree[components.root(facet) as usize] += if points_out { 1 } else { -1 };
        }
    }
    let mut turned = room.vec(sheet.len())?;
    for facet in run.watch(0..sheet.len() as u32) {
        let facet = facet?;
        let flips = agree[components.root(facet) as usize] < 0;
        turned.push(layer.front[facet as usize] == flips);
    }
    Ok(turned)
}
