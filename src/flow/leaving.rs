//! Which Voronoi facets cannot extend a core: those whose flow leaves the medial axis of its side.

use super::Flow;
use super::closure::Subset;
use super::critical::CriticalClass;
use super::simplex::{Simplex, VoronoiSet};
use super::source::Source;
use super::subdivision::Subdivision;
use super::upstream::Upstream;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::medial::Side;
use crate::sort::sort_by_key;

impl Flow {
    /// Takes off a list the facets whose flow comes to a critical point that does not belong to the axis of a side.
    ///
    /// Whole Voronoi faces are looked at first, of which nothing need be cut: only the faces by which these lead to such a point are cut.
    pub(super) fn retain_staying(
        &self,
        source: &Source<'_>,
        side: Side,
        facets: &mut Vec<u32>,
        run: &Run<'_>,
    ) -> Result<()> {
        // Nothing of it is kept.
        let mut room = Room::new(run);
        let room = &mut room;
        let others = || {
            let critical = self.critical.simplices().iter().zip(self.critical.classes());
            critical.filter(|(_, class)| !class.is_on(side)).map(|(&simplex, _)| simplex)
        };
        let Some(Leads { suspects, by }) = Leads::new(source, facets, others(), room, run)? else {
            return Ok(());
        };
        let seeds = suspects.iter().map(|&facet| Simplex::Edge(facet));
        let mut set = VoronoiSet::touched(source, seeds, Some(&by), room, run)?;
        set.whole.fill(false);
        let its = Subdivision::new(source, &set, room, run)?;
        let upstream = Upstream::new(&its, room, run)?;
        let mut leaving = Subset::new(&its, room)?;
        let ends = others().flat_map(|simplex| its.elements_at(simplex));
        upstream.add_to(&mut leaving, ends, room, run)?;
        facets.retain(|&facet| {
            suspects.binary_search(&facet).is_err()
                || !its.faces_of(facet).any(|face| leaving.has_face[face as usize])
        });
        Ok(())
    }
}

impl CriticalClass {
    /// Whether a point belongs to the medial axis of a side.
    pub(super) fn is_on(self, side: Side) -> bool {
        match self {
            CriticalClass::Surface => false,
            CriticalClass::Inner => side != Side::Outer,
            CriticalClass::Outer => side != Side::Inner,
        }
    }
}

/// How facets may lead to critical points, as far as whole faces tell.
struct Leads {
    /// The facets that may, ascending.
    suspects: Vec<u32>,
    /// All faces on the way.
    by: VoronoiSet,
}

impl Leads {
    /// Given an ascending list of facets; `None` if none of them may.
    fn new(
        source: &Source<'_>,
        facets: &[u32],
        critical: impl Iterator<Item = Simplex>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Option<Self>> {
        let mut spare = Room::new(run);
        let seeds = facets.iter().map(|&facet| Simplex::Edge(facet));
        let (touched, mut steps) = VoronoiSet::touched_by_steps(source, seeds, &mut spare, run)?;
        let mut waiting = Vec::new();
        for simplex in critical.filter(|&simplex| touched.has(simplex)) {
            spare.push(&mut waiting, simplex)?;
        }
        if waiting.is_empty() {
            return Ok(None);
        }
        let place = |face: Simplex| (face.dimension() as u64) << 32 | u64::from(face.number());
        sort_by_key(&mut steps, |&(_, to)| place(to), run)?;
        let mut by = VoronoiSet::filled(source, false, room)?;
        let mut seen = 0;
        while let Some(face) = waiting.pop() {
            seen += 1;
            if seen % 1024 == 0 {
                run.poll()?;
            }
            if !by.insert(face) {
                continue;
            }
            let begin = steps.partition_point(|&(_, to)| place(to) < place(face));
            let before = steps[begin..].iter().take_while(|&&(_, to)| to == face);
            spare.grow(&mut waiting, before.clone().count())?;
            waiting.extend(before.map(|&(from, _)| from));
        }
        let mut suspects = room.vec(facets.len())?;
        suspects.extend(facets.iter().copied().filter(|&facet| by.facets[facet as usize]));
        // The facets that are crossed.
        for triangle in run.watch(0..source.triangles.len()) {
            let triangle = triangle?;
            let facet = source.drivers.longest[triangle];
            if by.edges[triangle] && facet != NONE {
                by.facets[facet as usize] = true;
            }
        }
        for cell in run.watch(0..by.vertices.len()) {
            let cell = cell?;
            if by.vertices[cell] {
                by.insert(source.drivers.of_cell(source.triangles, cell as u32));
            }
        }
        Ok(Some(Leads { suspects, by }))
    }
}
