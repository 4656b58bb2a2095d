//! The core: the flow closure of the critical points of the medial axis, alone or with that of Voronoi facets.

use super::closure::Subset;
use super::simplex::{Simplex, VoronoiSet};
use super::source::Source;
use super::subdivision::Subdivision;
use super::{Flow, inner};
use crate::complex::Complex;
use crate::error::{ElementKind, Error, Result, Status};
use crate::job::{Job, Room, Run, Stage};
use crate::medial::Side;

/// Which core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoreOptions {
    /// On which side of the surface; the inner core by default.
    pub side: Side,
    /// Add as much of the flow of other critical points as it takes for the core to have the homotopy type of the labelled solid, however sparse the sample is; on by
    /// default. It does nothing to the outer core.
    pub repair: bool,
}

impl Default for CoreOptions {
    fn default() -> Self {
        CoreOptions { side: Side::Inner, repair: true }
    }
}

/// A core, and what became of the facets by which it was to be extended.
#[derive(Clone, Debug)]
pub struct Core {
    pub(super) complex: Complex,
    pub(super) unbounded: usize,
    pub(super) taken: usize,
    pub(super) excluded: Excluded,
}

/// The facets that cannot extend a core (Giesen, Ramos, Sadri, theorem 3.17), each counted once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Excluded {
    /// Those that cross the surface: the dual edge is one of its edges.
    pub of_surface: usize,
    /// Those on the other side of the surface.
    pub elsewhere: usize,
    /// Those whose flow comes to a critical point of the surface, or of the other side; and those that stay open for a sample within the solid, when the core is repaired.
    pub leaving: usize,
}

impl Core {
    /// The core as faces and loose edges. Vertices carry `radius` (their distance from the samples, in input units), `cell` (of which they are the Voronoi vertex, or
    /// [`NONE`](crate::NONE)), and `critical` (the row of the critical point that they are, or `NONE`); faces carry `facet` (the part of which they are),
    /// `samples` (the two ends of the facet's dual edge) and `lambda` (half its length); edges, those of no face, carry `samples` (the corners of the triangle whose Voronoi edge they
    /// are a part of; or the two samples of the facet in which they follow an orbit, then `NONE`).
    pub fn complex(&self) -> &Complex {
        &self.complex
    }

    /// The core alone.
    pub fn into_complex(self) -> Complex {
        self.complex
    }

    /// The number of faces and loose edges that are left out, since they are unbounded.
    pub fn unbounded(&self) -> usize {
        self.unbounded
    }

    /// The number of facets by which the core was extended.
    pub fn taken(&self) -> usize {
        self.taken
    }

    /// The facets that were left out, by their kinds.
    pub fn excluded(&self) -> Excluded {
        self.excluded
    }
}

impl Flow {
    /// The core of one side: the union of the unstable manifolds of the critical points of its medial axis, which has the homotopy type of the solid if
    /// the sample is dense enough (Giesen, Ramos, Sadri, theorem 3.16); extended by the flow closures of Voronoi facets, but for those that cannot extend it (theorem 3.17).
    ///
    /// Errors: [`Status::InvalidArgument`] for a facet that the dual does not have; those of the job. Cost: O(n), and O(size) of the part of the flow complex that is reached.
    pub fn core(&self, options: CoreOptions, facets: &[u32], job: &Job) -> Result<Core> {
        job.run(&[(Stage::Flow, 0.8), (Stage::Extract, 0.2)], |run| {
            run.enter(Stage::Flow)?;
            self.core_in(options, facets, run)
        })
    }

    /// [`Flow::core`] as a stage of a larger build.
    pub(crate) fn core_in(
        &self,
        options: CoreOptions,
        facets: &[u32],
        run: &Run<'_>,
    ) -> Result<Core> {
        let source = self.source()?;
        let mut room = Room::new(run);
        let (mut candidates, mut excluded) =
            self.candidates(&source, options.side, facets, &mut room, run)?;
        let inner = match options.repair && options.side == Side::Inner {
            true => Some(inner::inner(self, &source, &mut room, run)?),
            false => None,
        };
        // The facets that open the cells of samples within the solid stay open.
        let is_open = |face: Simplex| inner.as_ref().is_some_and(|inner| !inner.has(face));
        let of_core = || self.simplices_of(options.side).filter(|&face| !is_open(face));
        let before = candidates.len();
        candidates.retain(|&facet| !is_open(Simplex::Edge(facet)));
        self.retain_staying(&source, options.side, &mut candidates, run)?;
        excluded.leaving = before - candidates.len();
        let flowing = || of_core().chain(candidates.iter().map(|&facet| Simplex::Edge(facet)));
        let rest = match &inner {
            Some(inner) => Some(inner::rest(self, &source, inner, flowing(), &mut room, run)?),
            None => None,
        };
        let from = rest.iter().flat_map(|rest| rest.seeds.iter().copied());
        let from = flowing().chain(from);
        let mut set = VoronoiSet::touched(&source, from, inner.as_ref(), &mut room, run)?;
        if let Some(rest) = &rest {
            set.unite(&rest.faces);
        }
        let its = Subdivision::new(&source, &set, &mut room, run)?;
        drop(set);
        run.enter(Stage::Extract)?;
        let mut core = Subset::new(&its, &mut room)?;
        let within = match &inner {
            Some(inner) => Some(inner::elements(&its, &source, inner, &mut room, run)?),
            None => None,
        };
        let seeds = flowing().flat_map(|face| its.elements_of(face));
        core.add(&its, seeds, within.as_ref(), &mut room, run)?;
        if let (Some(rest), Some(within)) = (&rest, &within) {
            let mut all = core.clone();
            let seeds = rest.seeds.iter().flat_map(|&face| its.elements_of(face));
            all.add(&its, seeds, Some(within), &mut room, run)?;
            for face in run.watch(rest.faces.faces()) {
                its.elements_of(face?).for_each(|element| _ = all.insert(element));
            }
            all.close(&its);
            all.collapse(&its, &core, &mut room, run)?;
            core = all;
        }
        let (complex, unbounded) = self.complex_of(&its, &core, run)?;
        Ok(Core { complex, unbounded, taken: candidates.len(), excluded })
    }

    /// The critical points of the medial axis on one side.
    fn simplices_of(&self, side: Side) -> impl Iterator<Item = Simplex> + Clone + '_ {
        let critical = self.critical.simplices().iter().zip(self.critical.classes());
        critical.filter(move |(_, its)| its.is_on(side)).map(|(&simplex, _)| simplex)
    }

    /// The facets of a list that lie on one side, without repetition.
    fn candidates(
        &self,
        source: &Source<'_>,
        side: Side,
        facets: &[u32],
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<(Vec<u32>, Excluded)> {
        let (mut candidates, mut excluded) = (room.vec(facets.len())?, Excluded::default());
        for facet in run.watch(facets) {
            let &facet = facet?;
            if facet as usize >= source.facets.len() {
                let message = format!("there are only {} Voronoi facets", source.facets.len());
                return Err(Error::new(Status::InvalidArgument, message)
                    .at(ElementKind::Face, u64::from(facet)));
            }
            candidates.push(facet);
        }
        candidates.sort_unstable();
        candidates.dedup();
        candidates.retain(|&facet| match source.side_of(&self.labels, Simplex::Edge(facet)) {
            Side::Both => {
                excluded.of_surface += 1;
                false
            }
            its if side != Side::Both && its != side => {
                excluded.elsewhere += 1;
                false
            }
            _ => true,
        });
        Ok((candidates, excluded))
    }
}
