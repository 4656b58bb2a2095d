//! The full check of a triangulation, in exact arithmetic.

use super::Triangulation;
use super::conflict::{Conflict, Delaunay, Regular, Site, position};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Run, Stage};
use crate::predicates::{Sign, orient3d};
use crate::validation::Validation;

impl Triangulation {
    /// Checks every invariant: order, orientation, adjacency, the empty sphere (or power) of
    /// every facet with its perturbation, the convexity and closedness of the hull, Euler's
    /// formula, and that hidden vertices are hidden rightly.
    ///
    /// Locally empty spheres in a convex domain make the whole triangulation Delaunay
    /// (Delaunay 1934), so that this is a proof for the given cells. Errors: those of the job. Cost: O(m)
    /// exact predicates, and one walk per hidden vertex.
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            if self.check_indices(&mut report) {
                self.check_cells(&mut report, run)?;
                self.check_hull(&mut report, run)?;
                self.check_euler(&mut report, run)?;
                self.check_hidden(&mut report, run)?;
            }
            Ok(report)
        })
    }

    /// Whether all indices are in range; without that nothing else can be looked at.
    fn check_indices(&self, report: &mut Validation) -> bool {
        let (vertices, count) = (self.coords().len(), self.cells.len());
        report.check(
            count > 0 && self.neighbors.len() == count,
            ElementKind::Cell,
            count as u64,
            || "there must be cells, and as many rows of neighbours".into(),
        );
        for (cell, (corners, neighbors)) in self.cells.iter().zip(&self.neighbors).enumerate() {
            let sound = corners.iter().all(|&v| (v as usize) < vertices)
                && neighbors.iter().all(|&n| n == NONE || (n as usize) < count);
            report.check(sound, ElementKind::Cell, cell as u64, || {
                "names a vertex or a neighbour that does not exist".into()
            });
        }
        report.is_valid()
    }

    /// Order, orientation, adjacency and conflict, cell by cell.
    fn check_cells(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        for (cell, corners) in self.cells.iter().enumerate() {
            if cell % 256 == 0 {
                run.tick(cell, self.cells.len())?;
            }
            let id = cell as u64;
            let [a, b, c, d] = *corners;
            let first = a < b && b < c.min(d);
            report.check(first, ElementKind::Cell, id, || "its vertices are out of order".into());
            let after = cell == 0 || self.cells[cell - 1] < *corners;
            report.check(after, ElementKind::Cell, id, || "it is out of order".into());
            let sites = corners.map(|v| self.site(v));
            let [p, q, r, s] = sites.each_ref().map(position);
            report.check(orient3d(p, q, r, s) == Sign::Positive, ElementKind::Cell, id, || {
                "it is not positively oriented".into()
            });
            for slot in 0..4 {
                let neighbor = self.neighbors[cell][slot];
                if neighbor == NONE {
                    continue;
                }
                let Some(back) = self.facet_towards(neighbor, cell as u32, slot) else {
                    report.check(false, ElementKind::Cell, id, || {
                        format!("cell {neighbor} opposite its vertex {slot} does not share the facet")
                    });
                    continue;
                };
                let apex = self.site(self.cells[neighbor as usize][back]);
                report.check(!self.in_conflict(&sites, &apex), ElementKind::Cell, id, || {
                    format!("the vertex of cell {neighbor} beyond facet {slot} is in conflict with it")
                });
            }
        }
        Ok(())
    }

    /// The facet by which `neighbor` borders on `cell`'s facet `slot`, if it does: mutual, with
    /// the same three vertices.
    fn facet_towards(&self, neighbor: u32, cell: u32, slot: usize) -> Option<usize> {
        let corners = &self.cells[cell as usize];
        let others = &self.cells[neighbor as usize];
        (0..4).find(|&back| {
            self.neighbors[neighbor as usize][back] == cell
                && (0..4).all(|i| i == slot || others.contains(&corners[i]))
                && !corners.contains(&others[back])
        })
    }

    fn in_conflict(&self, cell: &[Site; 4], point: &Site) -> bool {
        let [a, b, c, d] = cell;
        if self.is_weighted() {
            Regular::in_conflict(a, b, c, d, point)
        } else {
            Delaunay::in_conflict(a, b, c, d, point)
        }
    }

    /// The hull is a closed surface, convex along every edge.
    fn check_hull(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut ring = Vec::new();
        for (cell, corners) in self.cells.iter().enumerate() {
            if cell % 1024 == 0 {
                run.poll()?;
            }
            for slot in (0..4).filter(|&slot| self.neighbors[cell][slot] == NONE) {
                // Outward: seen from the cell's fourth vertex the facet turns clockwise.
                let [x, y, z] = super::cells::FACET[slot].map(|i| corners[i]);
                for (a, b) in [(x, y), (y, z), (z, x)] {
                    let open = !self.bounded_ring(cell as u32, a, b, &mut ring);
                    let across = ring.first().zip(ring.last()).and_then(|(&first, &last)| {
                        let other = if last == cell as u32 { first } else { last };
                        self.hull_apex(other, a, b, corners[slot], cell as u32, slot)
                    });
                    let at = |v: u32| &self.coords()[v as usize];
                    let convex = across.is_some_and(|apex| {
                        orient3d(at(x), at(y), at(z), at(apex)) != Sign::Positive
                    });
                    report.check(open && convex, ElementKind::Cell, cell as u64, || {
                        format!("the hull is not closed and convex at its edge {a} {b}")
                    });
                }
            }
        }
        Ok(())
    }

    /// [`Triangulation::ring`], cut off where broken adjacency would keep it turning.
    fn bounded_ring(&self, cell: u32, a: u32, b: u32, ring: &mut Vec<u32>) -> bool {
        self.ring(cell, a, b, ring)
    }

    /// The third vertex of the hull facet of `cell` on the edge `a b`, other than the given facet.
    fn hull_apex(
        &self,
        cell: u32,
        a: u32,
        b: u32,
        _behind: u32,
        from: u32,
        from_slot: usize,
    ) -> Option<u32> {
        let corners = &self.cells[cell as usize];
        (0..4).find_map(|slot| {
            let on_edge = corners[slot] != a && corners[slot] != b;
            let hull = self.neighbors[cell as usize][slot] == NONE;
            if !on_edge || !hull || (cell == from && slot == from_slot) {
                return None;
            }
            corners.iter().enumerate().find_map(|(i, &v)| {
                (i != slot && v != a && v != b).then_some(v)
            })
        })
    }
}
