//! The full check of a triangulation, in exact arithmetic.

use super::Triangulation;
use super::cells::FACET;
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::predicates::{Sign, delaunay_conflict, orient3d, position, regular_conflict};
use crate::sort::sort_by_key;
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
            if self.check_indices(&mut report, run)? {
                self.check_cells(&mut report, run)?;
                self.check_hull(&mut report, run)?;
                self.check_euler(&mut report, run)?;
                self.check_hidden(&mut report, run)?;
            }
            Ok(report)
        })
    }

    /// Whether all indices are in range; without that nothing else can be looked at.
    fn check_indices(&self, report: &mut Validation, run: &Run<'_>) -> Result<bool> {
        let (vertices, count) = (self.coords().len(), self.cells.len());
        report.check(
            count > 0 && self.neighbors.len() == count,
            ElementKind::Cell,
            count as u64,
            || "there must be cells, and as many rows of neighbours".into(),
        );
        for row in run.watch(self.cells.iter().zip(&self.neighbors).enumerate()) {
            let (cell, (corners, neighbors)) = row?;
            let sound = corners.iter().all(|&v| (v as usize) < vertices)
                && neighbors.iter().all(|&n| n == NONE || (n as usize) < count);
            report.check(sound, ElementKind::Cell, cell as u64, || {
                "names a vertex or a neighbour that does not exist".into()
            });
        }
        Ok(report.is_valid())
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
                        format!(
                            "cell {neighbor} opposite its vertex {slot} does not share the facet"
                        )
                    });
                    continue;
                };
                let apex = self.site(self.cells[neighbor as usize][back]);
                report.check(!self.in_conflict(&sites, &apex), ElementKind::Cell, id, || {
                    format!(
                        "the vertex of cell {neighbor} beyond facet {slot} is in conflict with it"
                    )
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

    fn in_conflict(&self, cell: &[[f64; 4]; 4], point: &[f64; 4]) -> bool {
        let [a, b, c, d] = cell;
        if self.is_weighted() {
            regular_conflict(a, b, c, d, point)
        } else {
            delaunay_conflict(a, b, c, d, point)
        }
    }

    /// The hull is one closed surface, convex along every edge.
    ///
    /// A closed connected surface that is locally convex bounds a convex solid, and a cell complex of
    /// positively oriented cells with that boundary covers it once.
    fn check_hull(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut room = Room::new(run);
        let mut sides: Vec<Side> = Vec::new();
        let mut facets: Vec<[u32; 3]> = Vec::new();
        for cell in run.watch(self.cells.iter().enumerate()) {
            let (cell, corners) = cell?;
            for slot in (0..4).filter(|&slot| self.neighbors[cell][slot] == NONE) {
                // Seen from within the facet turns counterclockwise, and beyond it is positive.
                let [x, y, z] = FACET[slot].map(|i| corners[i]);
                for (from, to) in [(x, y), (y, z), (z, x)] {
                    let edge = [from.min(to), from.max(to)];
                    let facet = facets.len() as u32;
                    room.push(&mut sides, Side { edge, forward: from < to, facet })?;
                }
                room.push(&mut facets, [x, y, z])?;
            }
        }
        let edge = |side: &Side| u64::from(side.edge[0]) << 32 | u64::from(side.edge[1]);
        sort_by_key(&mut sides, edge, run)?;
        let mut pieces =
            Pieces { parent: room.collect(0..facets.len() as u32)?, count: facets.len() };
        let at = |v: u32| &self.coords()[v as usize];
        for (i, group) in sides.chunk_by(|s, t| s.edge == t.edge).enumerate() {
            if i % 4096 == 0 {
                run.poll()?;
            }
            let paired = matches!(group, [s, t] if s.forward != t.forward);
            report.check(paired, ElementKind::Vertex, u64::from(group[0].edge[0]), || {
                format!("the hull is not closed at its edge to vertex {}", group[0].edge[1])
            });
            let [s, t] = group else { continue };
            pieces.join(s.facet, t.facet);
            let [x, y, z] = facets[s.facet as usize].map(at);
            let apex = facets[t.facet as usize].into_iter().find(|v| !s.edge.contains(v));
            let convex = apex.is_some_and(|v| orient3d(x, y, z, at(v)) != Sign::Positive);
            report.check(convex, ElementKind::Vertex, u64::from(s.edge[0]), || {
                format!("the hull is not convex at its edge to vertex {}", s.edge[1])
            });
        }
        report.check(pieces.count == 1, ElementKind::Cell, 0, || {
            format!("the hull has {} pieces", pieces.count)
        });
        Ok(())
    }

    /// Vertices - edges + facets - cells = 1, as for every solid without holes.
    fn check_euler(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let incidence = self.incidence_in(run)?;
        let edges = self.edges_in(&incidence, run)?.ends.len() as i64;
        let used = incidence.offsets().windows(2).filter(|pair| pair[0] < pair[1]).count() as i64;
        let hull = self.neighbors.as_flattened().iter().filter(|&&n| n == NONE).count() as i64;
        let cells = self.cells.len() as i64;
        let characteristic = used - edges + (4 * cells + hull) / 2 - cells;
        report.check(characteristic == 1, ElementKind::Cell, 0, || {
            format!("the Euler characteristic is {characteristic}, not 1")
        });
        let unused = (0..self.coords().len() as u32).filter(|&v| incidence.cells_of(v).is_empty());
        report.check(unused.eq(self.hidden.iter().copied()), ElementKind::Vertex, 0, || {
            "the hidden vertices are not those that no cell uses".into()
        });
        Ok(())
    }

    /// A hidden vertex is not in conflict with the cell that holds it.
    fn check_hidden(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        if !report.is_valid() {
            // A walk through broken cells need not end.
            return Ok(());
        }
        let mut cell = 0;
        for &vertex in &self.hidden {
            run.poll()?;
            let site = self.site(vertex);
            let found = self.locate(*position(&site), cell)?;
            let rightly = found.is_some_and(|found| {
                cell = found;
                !self.in_conflict(&self.cells[found as usize].map(|v| self.site(v)), &site)
            });
            report.check(rightly, ElementKind::Vertex, u64::from(vertex), || {
                "it is hidden, but in conflict with the cell that holds it".into()
            });
        }
        Ok(())
    }
}

/// One side of a hull facet.
#[derive(Clone, Copy)]
struct Side {
    edge: [u32; 2],
    forward: bool,
    facet: u32,
}

/// Disjoint sets of facets.
struct Pieces {
    parent: Vec<u32>,
    count: usize,
}

impl Pieces {
    fn root(&mut self, mut facet: u32) -> u32 {
        while self.parent[facet as usize] != facet {
            let above = self.parent[self.parent[facet as usize] as usize];
            self.parent[facet as usize] = above;
            facet = above;
        }
        facet
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        if a != b {
            self.parent[a.max(b) as usize] = a.min(b);
            self.count -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::points::Points;
    use std::sync::Arc;

    /// Lattice points with weights of which some hide: ties, flat hull facets, hidden vertices.
    fn triangulation() -> Triangulation {
        let row = |i: usize| [i % 4, i / 4 % 4, i / 16].map(|x| x as f64);
        let points = Points::by_row(64, row, Default::default(), &Job::default()).unwrap();
        let weights: Vec<f64> = (0..64u32).map(|i| f64::from(i * 7 % 5)).collect();
        Triangulation::regular(&Arc::new(points), &weights, &Job::default()).unwrap()
    }

    fn is_valid(t: &Triangulation) -> bool {
        t.validate(&Job::default()).unwrap().is_valid()
    }

    #[test]
    fn one_wrong_neighbor_is_noticed() {
        let t = triangulation();
        assert!(is_valid(&t) && !t.hidden.is_empty());
        let count = t.cells.len() as u32;
        for cell in 0..t.cells.len() {
            for slot in 0..4 {
                for wrong in [NONE, 0, (cell as u32 + 1) % count, count] {
                    let mut t = t.clone();
                    if std::mem::replace(&mut t.neighbors[cell][slot], wrong) != wrong {
                        assert!(!is_valid(&t), "cell {cell}, slot {slot}, {wrong}");
                    }
                }
            }
        }
    }

    #[test]
    fn one_wrong_cell_is_noticed() {
        let t = triangulation();
        for cell in 0..t.cells.len() {
            let mut turned = t.clone();
            turned.cells[cell].swap(2, 3);
            assert!(!is_valid(&turned), "cell {cell} turned over");
            let mut rotated = t.clone();
            rotated.cells[cell].rotate_left(1);
            assert!(!is_valid(&rotated), "cell {cell} rotated");
            for slot in 0..4 {
                let mut t = t.clone();
                t.cells[cell][slot] = (t.cells[cell][slot] + 1) % 64;
                assert!(!is_valid(&t), "cell {cell}, vertex {slot}");
            }
        }
    }

    #[test]
    fn a_missing_or_added_cell_is_noticed() {
        let mut t = triangulation();
        t.cells.pop();
        assert!(!is_valid(&t));
        t.neighbors.pop();
        assert!(!is_valid(&t));
        let mut t = triangulation();
        t.cells.push(t.cells[0]);
        t.neighbors.push(t.neighbors[0]);
        assert!(!is_valid(&t));
    }

    #[test]
    fn wrong_weights_and_hidden_vertices_are_noticed() {
        let t = triangulation();
        for vertex in 0..64 {
            let mut t = t.clone();
            t.weights[vertex] += 20.0;
            assert!(!is_valid(&t), "vertex {vertex} too heavy");
        }
        let mut t = t.clone();
        let hidden = t.hidden.pop();
        assert!(hidden.is_some() && !is_valid(&t));
        let mut flat = triangulation();
        let used = (0..64).find(|v| !flat.hidden.contains(v)).unwrap();
        flat.hidden.insert(0, used);
        assert!(!is_valid(&flat));
    }
}
