//! Point location in the triangulation under construction.

use super::cavity::each;
use super::cells::{Cell, Patch};
use crate::predicates::around::{Site, beyond_facets};
use crate::predicates::lanes::Lanes;
use crate::predicates::{Sign, orient3d};

/// The cell that holds the point, or an infinite cell whose hull facet it lies strictly beyond.
/// `None` if the walk cannot but leave the patch, where `SHARED` says that there are others.
///
/// A visibility walk (Devillers, Pion, Teillaud 2002): cross any facet that separates the cell
/// from the point. It ends in Delaunay and regular triangulations, as their cells are acyclic
/// as seen from any point.
#[inline(always)]
pub(super) fn locate<L: Lanes, S: Site, const SHARED: bool>(
    patch: &Patch<'_>,
    sites: &[S],
    start: Cell,
    point: &S,
) -> Option<Cell> {
    let mut cell = start;
    if let Some(slot) = patch.infinite_slot(patch.vertices(cell)) {
        cell = patch.neighbors(cell)[slot].cell();
    }
    // The facet that the walk came through, as a bit.
    let mut entered = 0;
    loop {
        let vertices = patch.vertices(cell);
        if patch.infinite_slot(vertices).is_some() {
            return Some(cell);
        }
        // A finite cell: every vertex has a site.
        let corners = each(vertices, |v| sites.get(v as usize).unwrap_or(point));
        let (beyond, unsure) = beyond_facets::<L, S>(corners, point);
        let mut beyond = beyond & !entered;
        if beyond == 0 && unsure & !entered != 0 {
            beyond = surely_beyond(corners, point, unsure & !entered);
        }
        if beyond == 0 {
            return Some(cell);
        }
        let neighbors = patch.neighbors(cell);
        let mut across = neighbors[beyond.trailing_zeros() as usize & 3];
        // Any of the facets will do, so another one if this one leads out of the patch.
        while SHARED && !patch.owns(patch.vertices(across.cell())) {
            beyond &= beyond - 1;
            if beyond == 0 {
                return None;
            }
            across = neighbors[beyond.trailing_zeros() as usize & 3];
        }
        cell = across.cell();
        entered = 1 << across.slot();
    }
}

/// Of the facets that the filter was unsure of, one beyond which the point lies, as a bit; 0 if there
/// is none.
#[cold]
fn surely_beyond<S: Site>(corners: [&S; 4], point: &S, unsure: u32) -> u32 {
    let is_beyond = |slot: &usize| {
        let mut corners = corners.map(S::position);
        corners[*slot] = point.position();
        let [a, b, c, d] = corners;
        unsure >> slot & 1 == 1 && orient3d(a, b, c, d) == Sign::Negative
    };
    (0..4).find(is_beyond).map_or(0, |slot| 1 << slot)
}
