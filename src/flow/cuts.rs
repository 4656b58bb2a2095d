//! Cuts: where the orbits of Voronoi vertices cross Voronoi facets.

use super::outline::{Corner, Outline};
use super::share::Share;
use super::side::View;
use super::simplex::VoronoiSet;
use super::source::Source;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{PART, Room, Run};
use crate::vector::Vec3;

/// Where a cut begins: on the near sides of its facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Entry {
    /// The Voronoi vertex of a cell.
    Cell(u32),
    /// Where another cut has ended.
    Hit(u32),
}

/// A straight part of an orbit, across a facet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub from: Entry,
    /// The hit where it ends, or [`NONE`] at infinity.
    pub to: u32,
}

/// The end of a cut, inside a Voronoi edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub at: Vec3,
    /// The triangle whose Voronoi edge was hit.
    pub triangle: u32,
    /// Where on it, from the centre of the triangle's lesser cell on.
    pub share: Share,
    /// The facet that the cut crosses, and what puts its hits in their order where shares are equal.
    facet: u32,
    order: u32,
    /// Another hit of the same Voronoi edge, or [`NONE`].
    next: u32,
}

/// The cuts of a set of Voronoi faces.
///
/// Every Voronoi vertex of the set whose driver is the middle of an edge flows into that edge's facet, and every point where a facet's flow leaves through
/// the Voronoi edge of an obtuse triangle flows on into the facet of its longest edge: so the orbits of Voronoi vertices run through facets until they come to
/// a Voronoi edge that they follow, or to infinity. Since the longest edge of a triangle is longer than the others, facets can be
/// cut one after the other. Facets that stay whole are not cut: what enters them ends there.
///
/// Which side a cut from a Voronoi vertex hits is decided exactly. Farther cuts begin at rounded points, and their sides are found
/// in rounded arithmetic; but in each facet cuts leave in the order in which they enter, whatever is rounded: no two of them cross.
///
/// Invariants: the cuts of a facet are consecutive, clockwise seen from the second end of its edge; each hit ends one cut.
#[derive(Clone, Debug, Default)]
pub(super) struct Cuts {
    pub cuts: Vec<Cut>,
    pub hits: Vec<Hit>,
    /// For each facet where its cuts begin and end.
    pub of_facet: Vec<[u32; 2]>,
    /// For each triangle one of its hits.
    first_hit: Vec<u32>,
}

/// What the facets of a part of one level give, with hits numbered from 0.
struct Batch<'a> {
    facets: Vec<(u32, u32)>,
    cuts: Vec<Cut>,
    hits: Vec<Hit>,
    /// For each far side of an obtuse triangle the facet of its longest edge, which had to wait.
    released: Vec<u32>,
    _room: Room<'a>,
}

impl Cuts {
    pub fn new(
        source: &Source<'_>,
        set: &VoronoiSet,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let facets = source.facets.len();
        let mut cuts = Cuts {
            of_facet: room.filled(facets, [0; 2])?,
            first_hit: room.filled(source.triangles.len(), NONE)?,
            ..Cuts::default()
        };
        // For each facet how often it has to wait for another: once for each far side of that by which the flow comes in here.
        let mut awaited = room.filled(facets, 0u32)?;
        let mut members = Vec::new();
        let mut outline = Outline::default();
        for facet in run.watch(0..facets as u32) {
            let facet = facet?;
            if set.facets[facet as usize] {
                room.push(&mut members, facet)?;
                outline.trace(source, facet)?;
                for &side in outline.sides[outline.far()].iter().filter(|&&side| side != NONE) {
                    if let Some(count) =
                        awaited.get_mut(source.drivers.longest[side as usize] as usize)
                    {
                        *count += 1;
                    }
                }
            }
        }
        let mut level = room.vec(members.len())?;
        level.extend(members.iter().copied().filter(|&facet| awaited[facet as usize] == 0));
        let mut done = 0;
        while !level.is_empty() {
            let tracer = Tracer { source, set, cuts: &cuts };
            let parts = level.chunks(PART / 8).collect();
            let batches = run.in_parallel(parts, |part| tracer.trace(part, run))?;
            done += level.len();
            run.tick(done, 2 * members.len())?;
            level.clear();
            for batch in batches {
                run.poll()?;
                for &facet in &batch.released {
                    awaited[facet as usize] -= 1;
                    if awaited[facet as usize] == 0 && set.facets[facet as usize] {
                        level.push(facet);
                    }
                }
                cuts.append(batch, room)?;
            }
            level.sort_unstable();
        }
        if done < members.len() {
            return Err(Error::new(Status::Internal, "the flow turns in a circle"));
        }
        Ok(cuts)
    }

    fn append(&mut self, batch: Batch<'_>, room: &mut Room<'_>) -> Result<()> {
        let (first_cut, first_hit) = (self.cuts.len() as u32, self.hits.len() as u32);
        let mut begin = first_cut;
        for (facet, end) in batch.facets {
            self.of_facet[facet as usize] = [begin, first_cut + end];
            begin = first_cut + end;
        }
        room.grow(&mut self.cuts, batch.cuts.len())?;
        room.grow(&mut self.hits, batch.hits.len())?;
        self.cuts.extend(batch.cuts.into_iter().map(|cut| {
            let to = if cut.to == NONE { NONE } else { first_hit + cut.to };
            Cut { to, ..cut }
        }));
        for hit in batch.hits {
            let first = &mut self.first_hit[hit.triangle as usize];
            let next = std::mem::replace(first, self.hits.len() as u32);
            self.hits.push(Hit { next, ..hit });
        }
        Ok(())
    }

    /// The cuts of a facet.
    pub fn of(&self, facet: u32) -> &[Cut] {
        let [begin, end] = self.of_facet[facet as usize];
        &self.cuts[begin as usize..end as usize]
    }

    /// Replaces a list by the hits on a triangle's Voronoi edge, from its lesser cell on.
    pub fn hits_on(&self, triangle: u32, list: &mut Vec<u32>) {
        list.clear();
        let mut hit = self.first_hit[triangle as usize];
        while hit != NONE {
            list.push(hit);
            hit = self.hits[hit as usize].next;
        }
        list.sort_unstable_by(|&a, &b| {
            let [a, b] = [a, b].map(|hit| &self.hits[hit as usize]);
            a.share.order(&b.share).then((a.facet, a.order).cmp(&(b.facet, b.order)))
        });
    }
}

/// What cuts facets.
struct Tracer<'a> {
    source: &'a Source<'a>,
    set: &'a VoronoiSet,
    cuts: &'a Cuts,
}

impl Tracer<'_> {
    fn trace<'r>(&self, part: &[u32], run: &'r Run<'r>) -> Result<Batch<'r>> {
        let mut room = Room::new(run);
        let (mut cuts, mut hits, mut released) = (Vec::new(), Vec::new(), Vec::new());
        let mut facets = room.vec(part.len())?;
        let (mut outline, mut list, mut entries) = (Outline::default(), Vec::new(), Vec::new());
        let mut seen = 0;
        for &facet in part {
            outline.trace(self.source, facet)?;
            seen += outline.sides.len();
            if seen > 4096 {
                seen = 0;
                run.poll()?;
            }
            for &side in &outline.sides[outline.far()] {
                if side != NONE && self.source.drivers.longest[side as usize] != NONE {
                    room.push(&mut released, self.source.drivers.longest[side as usize])?;
                }
            }
            if self.set.whole[facet as usize] {
                continue;
            }
            self.entries(&outline, &mut list, &mut entries);
            if !entries.is_empty() {
                room.grow(&mut cuts, entries.len())?;
                room.grow(&mut hits, entries.len())?;
                self.cut(facet, &outline, &entries, &mut cuts, &mut hits);
                facets.push((facet, cuts.len() as u32));
            }
        }
        Ok(Batch { facets, cuts, hits, released, _room: room })
    }

    /// Where orbits enter a facet, clockwise.
    fn entries(&self, outline: &Outline, list: &mut Vec<u32>, entries: &mut Vec<Entry>) {
        entries.clear();
        for side in 0..outline.near {
            if let (1.., Corner::Cell(cell)) = (side, outline.corners[side])
                && self.set.vertices[cell as usize]
            {
                entries.push(Entry::Cell(cell));
            }
            let triangle = outline.sides[side];
            self.cuts.hits_on(triangle, list);
            if !self.runs_on(outline, side) {
                list.reverse();
            }
            entries.extend(list.iter().map(|&hit| Entry::Hit(hit)));
        }
    }

    /// Whether a side begins at the lesser cell of its triangle.
    fn runs_on(&self, outline: &Outline, side: usize) -> bool {
        let [lesser, _] = self.source.triangles.sides[outline.sides[side] as usize];
        outline.corners[side] == Corner::Cell(lesser)
    }

    /// Follows every entry across a facet.
    fn cut(
        &self,
        facet: u32,
        outline: &Outline,
        entries: &[Entry],
        cuts: &mut Vec<Cut>,
        hits: &mut Vec<Hit>,
    ) {
        let view = View::new(self.source.dual, self.source.facets.edges()[facet as usize]);
        let vector = |entry: Entry| match entry {
            Entry::Cell(cell) => view.vector(Corner::Cell(cell)),
            Entry::Hit(hit) => view.to(self.cuts.hits[hit as usize].at),
        };
        // Rays leave through the far sides one after the other, the last one first. The least that those from Voronoi vertices may come
        // to; `far` is one more than the side.
        let mut far = outline.sides.len();
        let mut exact = Vec::with_capacity(entries.len());
        for &entry in entries {
            if let Entry::Cell(cell) = entry {
                far = view.exit(outline, cell, far);
            }
            exact.push(far);
        }
        let mut least = outline.near + 1;
        for (i, &entry) in entries.iter().enumerate().rev() {
            match entry {
                Entry::Cell(_) => least = exact[i],
                Entry::Hit(_) => exact[i] = least,
            }
        }
        let mut far = outline.sides.len();
        let mut last: Option<Share> = None;
        for (&entry, &least) in entries.iter().zip(&exact) {
            let x = vector(entry);
            let mut next = far;
            while next > least {
                let is_beyond = match entry {
                    Entry::Cell(_) => true,
                    Entry::Hit(_) => view.turn(x, view.vector(outline.corners[next - 1])) > 0.0,
                };
                if !is_beyond {
                    break;
                }
                next -= 1;
            }
            if next != far {
                (far, last) = (next, None);
            }
            let side = far - 1;
            let triangle = outline.sides[side];
            if triangle == NONE {
                cuts.push(Cut { from: entry, to: NONE });
                continue;
            }
            let share = view.share(outline, side, x, last);
            last = Some(share);
            let runs_on = self.runs_on(outline, side);
            let is_ray = !matches!(
                (outline.corners[side], outline.end(side)),
                (Corner::Cell(_), Corner::Cell(_))
            );
            let order = hits.len() as u32;
            cuts.push(Cut { from: entry, to: order });
            let at = view.place(outline, side, share);
            // Hits come against the side's direction.
            let order = if runs_on { u32::MAX - order } else { order };
            let share = if runs_on || is_ray { share } else { share.reversed() };
            hits.push(Hit { at, triangle, share, facet, order, next: NONE });
        }
    }
}
