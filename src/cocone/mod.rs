//! Cocone and Tight Cocone: surfaces through the samples, made of Delaunay triangles.
//!
//! Amenta, Choi, Dey, Leekha 2002, *A simple algorithm for homeomorphic surface reconstruction*; Dey, Giesen 2001, *Detecting
//! undersampling in surface reconstruction*; Dey, Goswami 2003, *Tight Cocone: a water-tight surface reconstructor*. See
//! `docs/algorithms/cocone.md`.

mod cone;
mod flat;
mod mark;
mod peel;
mod prune;
mod sheet;
mod surface;
mod umbrella;
mod walk;

use crate::complex::Complex;
use crate::dual::Dual;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage, parts};
use crate::poles::{self, Selection};
use crate::triangulation::{Incidence, Triangulation};
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
/// which well sampled vertices say more often that they are inner than that they are outer are inner, and the other way round.
#[derive(Clone, Debug)]
pub struct Cocone {
    options: CoconeOptions,
    dual: Arc<Dual>,
    is_undersampled: Vec<bool>,
    is_well_sampled: Vec<bool>,
    is_inner: Vec<bool>,
    used: usize,
    marked: usize,
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
        let Open { sheet, walls, front, is_flat } =
            open_surface(dual, &poles, &incidence, options, &mut room, run)?;
        drop(poles);
        let umbrellas = Umbrellas::new(t, &sheet, &walls, &incidence, &mut room, run)?;
        let Marks { of_cells: marks, .. } = mark::mark(dual, &sheet, &umbrellas, &mut room, run)?;
        let is_inner = peel::peel(t, &walls, &marks, &mut room, run)?;
        run.enter(Stage::Extract)?;
        let boundary = surface::boundary(t, &is_inner, &mut room, run)?;
        if boundary.is_empty() {
            return Err(Error::new(
                Status::Degenerate,
                "no part of space is inside: no sample is well sampled, or they enclose nothing; \
                 take more samples, or the power crust",
            ));
        }
        let surface = surface::complex(t, &boundary, &mut room, run)?;
        let facets = turned(t, &sheet, &front, &is_inner, &mut room, run)?;
        let open_surface = surface::complex(t, &facets, &mut room, run)?;
        Ok(Cocone {
            options,
            dual: dual.clone(),
            is_undersampled: room.collect(is_flat.iter().map(|flat| !flat))?,
            is_well_sampled: umbrellas.is_good,
            used: surface.vertices().len(),
            marked: marks.iter().filter(|&&mark| mark != mark::Mark::None).count(),
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
    /// A triangle between an inner and an outer cell is oriented outward, any other one as its neighbours are.
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

    /// For each sample whether the open surface is a disk round it.
    pub fn is_well_sampled(&self) -> &[bool] {
        &self.is_well_sampled
    }

    /// The number of samples that are vertices of the surface.
    pub fn used(&self) -> usize {
        self.used
    }

    /// The number of cells that well sampled vertices mark as inner or outer; the others are peeled off or left.
    pub fn marked(&self) -> usize {
        self.marked
    }
}

/// The surface of plain Cocone.
struct Open {
    sheet: Sheet,
    /// For each cell the bits of its facets that are in the sheet.
    walls: Vec<u8>,
    /// For each triangle whether the walk was in front of it.
    front: Vec<bool>,
    is_flat: Vec<bool>,
}

fn open_surface(
    dual: &Dual,
    poles: &Selection,
    incidence: &Incidence,
    options: CoconeOptions,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Open> {
    let t = &**dual.triangulation();
    let cones = Cones::new(dual, poles, libm::sin(options.angle), room, run)?;
    let conditions = [options.ratio, libm::cos(options.normal_angle)];
    let is_flat = flat::flat_samples(&cones, incidence, conditions, room, run)?;
    let candidates = candidates(&cones, &is_flat, room, run)?;
    drop(cones);
    let sheet = Sheet::new(t, candidates, room, run)?;
    let mut is_pruned = room.collect(is_flat.iter().copied())?;
    let kept = prune::prune(t, &sheet, &mut is_pruned, room, run)?;
    let sheet = Sheet::new(t, sheet.kept(&kept, room)?, room, run)?;
    let seen = walk::walk(t, &sheet, room, run)?;
    let mut kept: Vec<bool> = room.collect(seen.iter().map(|&side| side != Side::Unseen))?;
    prune::cut_flaps(&sheet, &mut kept, room, run)?;
    let sheet = Sheet::new(t, sheet.kept(&kept, room)?, room, run)?;
    let mut front = room.vec(sheet.len())?;
    front.extend(seen.iter().zip(&kept).filter(|(_, kept)| **kept).map(|(&s, _)| s == Side::Front));
    let walls = sheet.walls(t, room, run)?;
    Ok(Open { sheet, walls, front, is_flat })
}

/// The candidate triangles, ascending: those whose dual Voronoi edge meets the cocones of all their vertices that are flat, one at least
/// (Dey, Giesen 2001, section 5: the pole vectors of others say nothing).
fn candidates(
    cones: &Cones<'_>,
    is_flat: &[bool],
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
                let flat = |v: &u32| is_flat[*v as usize];
                let corners = t.facet(cell as u32, i);
                let mut tested = corners.into_iter().filter(flat).peekable();
                if tested.peek().is_some() && tested.all(|v| cones.meets(cell as u32, i, v)) {
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

/// The triangles of the open surface as cells and facets out of which they point.
fn turned(
    t: &Triangulation,
    sheet: &Sheet,
    front: &[bool],
    is_inner: &[bool],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<[u32; 2]>> {
    let mut facets = room.vec(sheet.len())?;
    for facet in run.watch(0..sheet.len() as u32) {
        let facet = facet?;
        let [cell, i] = sheet.facets[facet as usize];
        let other = umbrella::other_side(t, cell, i as usize);
        let is_in = |cell: u32| is_inner[cell as usize];
        let turn = match other {
            Some((next, _)) if is_in(cell) != is_in(next) => is_in(next),
            None if is_in(cell) => false,
            _ => !front[facet as usize],
        };
        // What lies beyond the hull is no cell.
        facets.push(match other {
            Some((next, j)) if turn => [next, j as u32],
            _ => [cell, i],
        });
    }
    Ok(facets)
}
