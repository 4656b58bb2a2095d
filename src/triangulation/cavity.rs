//! The cavity of a new point: the cells in conflict with it, and the facets round them (Bowyer 1981,
//! Watson 1981).

use super::cells::{Cell, FACET, Facet, Patch};
use crate::error::Result;
use crate::job::Run;
use crate::predicates::around::{Neighbors, Site, neighbors_in_conflict};
use crate::predicates::lanes::Lanes;
use crate::predicates::{Sign, in_conflict, orient3d, settle, stages};

/// Cells between two looks at the job.
const TICK: usize = 1024;

/// What a search has found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Found {
    /// The whole cavity.
    Cavity,
    /// That a cell in conflict is not the patch's own. No mark is left.
    Foreign,
}

/// The arrays of one search, kept from one to the next: nothing is allocated per point.
///
/// Both arrays are longer than what they hold, so that the search can write ahead.
#[derive(Default)]
pub(super) struct Cavity {
    cells: Vec<Cell>,
    cell_count: usize,
    boundary: Vec<Facet>,
    facet_count: usize,
}

impl Cavity {
    /// The cells in conflict.
    pub fn cells(&self) -> &[Cell] {
        &self.cells[..self.cell_count]
    }

    /// The facets round them, as the cells outside name them.
    pub fn boundary(&self) -> &[Facet] {
        &self.boundary[..self.facet_count]
    }

    /// Collects and marks the cells in conflict with a vertex, breadth first from one of them, and their
    /// boundary. `SHARED` if there are other patches.
    ///
    /// Two cells of the queue are tested at a time where there are as many: the processor then works on
    /// one while it waits for the other. Meanwhile memory fetches what the next two will need. Errors: [`crate::Status::Cancelled`].
    #[inline(always)]
    pub fn search<L: Lanes, S: Site, const SHARED: bool>(
        &mut self,
        patch: &mut Patch<'_>,
        sites: &[S],
        vertex: u32,
        start: Cell,
        run: &Run<'_>,
    ) -> Result<Found> {
        let mut patch = patch.reborrow();
        let patch = &mut patch;
        (self.cell_count, self.facet_count) = (0, 0);
        self.make_room(start);
        self.cells[0] = start;
        self.cell_count = 1;
        patch.set_mark(start, true);
        let point = &sites[vertex as usize];
        let mut next = 0;
        while next < self.cell_count {
            self.make_room(start);
            if next % TICK < 2 {
                run.poll()?;
            }
            for ahead in [2, 3] {
                patch.fetch_around(self.cells[(next + ahead).min(self.cell_count - 1)]);
            }
            let cell = self.cells[next];
            let of_cell = test::<L, S>(patch, sites, cell, point);
            let mut own = true;
            if next + 1 < self.cell_count {
                let second = self.cells[next + 1];
                let of_second = test::<L, S>(patch, sites, second, point);
                own &= self.sort_out::<L, S, SHARED>(patch, sites, vertex, cell, &of_cell);
                own &= self.sort_out::<L, S, SHARED>(patch, sites, vertex, second, &of_second);
                next += 2;
            } else {
                own &= self.sort_out::<L, S, SHARED>(patch, sites, vertex, cell, &of_cell);
                next += 1;
            }
            if SHARED && !own {
                self.forget(patch);
                return Ok(Found::Foreign);
            }
        }
        Ok(Found::Cavity)
    }

    /// Takes the marks back.
    pub fn forget(&mut self, patch: &mut Patch<'_>) {
        for &cell in self.cells() {
            patch.set_mark(cell, false);
        }
    }

    /// Makes room for what two cells can add.
    #[inline(always)]
    fn make_room(&mut self, any: Cell) {
        if self.cells.len() < self.cell_count + 8 || self.boundary.len() < self.facet_count + 8 {
            self.grow(any);
        }
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self, any: Cell) {
        let cells = 2 * self.cell_count + 64;
        self.cells.resize(self.cells.len().max(cells), any);
        let facets = 2 * self.facet_count + 64;
        self.boundary.resize(self.boundary.len().max(facets), Facet::default());
    }

    /// Divides a cell's neighbours into the cavity and what lies round it. Without branches on what
    /// the tests found: nothing foretells it. Returns `false` if one in conflict is not the patch's own.
    #[inline(always)]
    fn sort_out<L: Lanes, S: Site, const SHARED: bool>(
        &mut self,
        patch: &mut Patch<'_>,
        sites: &[S],
        vertex: u32,
        cell: Cell,
        tests: &Neighbors,
    ) -> bool {
        let facets = patch.neighbors(cell);
        let known = bits(|i| patch.is_marked(facets[i].cell()));
        let mut conflict = tests.conflict;
        let unsure = tests.unsure & !known;
        stages::count_settled(!tests.unsure & !known);
        if unsure != 0 {
            conflict |= settle_unsure(patch.reborrow(), sites, vertex, facets, unsure, tests);
        }
        let inside = conflict | known;
        if SHARED {
            let vertices = patch.vertices(cell);
            // A neighbour has the vertices of the facet, and the one opposite.
            let own = bits(|i| patch.owns_vertex(vertices[i]));
            let of_facet = |i: usize| (own & !(1 << i)).count_ones();
            let opposite = |i: usize| u32::from(patch.owns_vertex(patch.opposite(facets[i])));
            if inside & !known & !bits(|i| of_facet(i) + opposite(i) >= 3) != 0 {
                return false;
            }
        }
        for (i, facet) in facets.into_iter().enumerate() {
            patch.set_mark(facet.cell(), inside >> i & 1 == 1);
        }
        let (added, outer) = (inside & !known, !inside & 15);
        *window(&mut self.cells, self.cell_count) = L::packed(each(facets, Facet::cell), added);
        *window(&mut self.boundary, self.facet_count) = L::packed(facets, outer);
        self.cell_count += added.count_ones() as usize;
        self.facet_count += outer.count_ones() as usize;
        true
    }
}

/// Four elements from a place on.
#[inline(always)]
fn window<T>(items: &mut [T], from: usize) -> &mut [T; 4] {
    items[from..].first_chunk_mut().expect("room was made")
}

/// Four truth values as bits.
#[inline(always)]
fn bits(of: impl Fn(usize) -> bool) -> u32 {
    u32::from(of(0)) | u32::from(of(1)) << 1 | u32::from(of(2)) << 2 | u32::from(of(3)) << 3
}

/// As `map`, which would not be compiled for AVX2.
#[inline(always)]
pub(super) fn each<T, U>([a, b, c, d]: [T; 4], of: impl Fn(T) -> U) -> [U; 4] {
    [of(a), of(b), of(c), of(d)]
}

/// The filter's tests of a cell's neighbours.
#[inline(always)]
fn test<L: Lanes, S: Site>(patch: &Patch<'_>, sites: &[S], cell: Cell, point: &S) -> Neighbors {
    let vertices = patch.vertices(cell);
    let facets = patch.neighbors(cell);
    let opposite = each(facets, |facet| patch.opposite(facet));
    // Those in conflict will be asked for their neighbours, the others given new ones.
    each(facets, |facet| patch.fetch_neighbors(facet.cell()));
    // The point itself stands in for the vertex at infinity, which has no site.
    let site = |v: u32| sites.get(v as usize).unwrap_or(point);
    let infinite = [L::equal(vertices, patch.infinite()), L::equal(opposite, patch.infinite())];
    neighbors_in_conflict::<L, S>(each(vertices, site), each(opposite, site), infinite, point)
}

/// Tests exactly, among a cell's neighbours, those of which the filter was unsure.
#[cold]
#[inline(never)]
fn settle_unsure<S: Site>(
    patch: Patch<'_>,
    sites: &[S],
    vertex: u32,
    neighbors: [Facet; 4],
    unsure: u32,
    tests: &Neighbors,
) -> u32 {
    let point = &sites[vertex as usize];
    let settled = |i: usize| {
        let cell = neighbors[i].cell();
        let vertices = patch.vertices(cell);
        if unsure >> i & 1 == 0 {
            false
        } else if patch.infinite_slot(vertices).is_some() {
            cell_in_conflict(&patch, sites, cell, point)
        } else {
            let vertices = vertices.map(|v| &sites[v as usize]);
            // The filter's cells have the wrong orientation, and so its determinants the other sign.
            settle(vertices, point, -tests.determinants[i])
        }
    };
    bits(settled)
}

/// Whether a cell, finite or infinite, is in conflict with a point.
pub(super) fn cell_in_conflict<S: Site>(
    patch: &Patch<'_>,
    sites: &[S],
    cell: Cell,
    point: &S,
) -> bool {
    let finite = |cell| in_conflict(patch.vertices(cell).map(|v| &sites[v as usize]), point);
    let vertices = patch.vertices(cell);
    let Some(slot) = patch.infinite_slot(vertices) else { return finite(cell) };
    let [a, b, c] = FACET[slot].map(|i| sites[vertices[i] as usize].position());
    match orient3d(point.position(), a, b, c) {
        Sign::Positive => true,
        Sign::Negative => false,
        // In the plane of the hull facet the circle decides, and it is where the plane
        // cuts the sphere of the finite cell behind the facet. The perturbation agrees: lifting
        // that cell's fourth vertex moves nothing in the plane.
        Sign::Zero => finite(patch.neighbor(cell.facet(slot as u32)).cell()),
    }
}
