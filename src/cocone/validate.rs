//! The check of a cocone, by other means than those that built it.

use super::Cocone;
use crate::complex::{Complex, DisjointSets, Element, Values};
use crate::dual::unit;
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::poles;
use crate::predicates::{Sign, orient3d};
use crate::sort::sort_by_key;
use crate::validation::Validation;
use crate::vector::{Vec3, dot, sub};

impl Cocone {
    /// Checks that the surface is just the facets between inner and outer cells, oriented outward, and runs every edge equally often both ways; that
    /// umbrellas divide the cells round their samples in two, and have the cells marked as most of them say; that
    /// cells without a mark are peeled off just where the outside reaches them; that no edge of the open surface has more than two triangles, and that its Voronoi
    /// edges come as near to the tangent planes as the cocones ask for. The Voronoi diagram has its own
    /// [`validate`](crate::Dual::validate). Errors: those of the job. Cost: O(size), besides sorting.
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            let cells = self.triangulation().cells().len();
            report.check(self.is_inner.len() == cells, ElementKind::Cell, cells as u64, || {
                "there must be one label per cell".into()
            });
            if report.is_valid() {
                self.check_boundary(&mut report, run)?;
                check_edges(&mut report, &self.surface, false, run)?;
                check_edges(&mut report, &self.open_surface, true, run)?;
                self.check_marks(&mut report, run)?;
                self.check_candidates(&mut report, run)?;
            }
            Ok(report)
        })
    }

    /// Every face of the surface lies between an inner cell and an outer one, and there are as many as such facets.
    fn check_boundary(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let t = self.triangulation();
        let (samples, cells) = (samples(&self.surface), cells_of_faces(&self.surface));
        let has = |cell: u32, corner: &u32| t.cells()[cell as usize].contains(corner);
        let mut last = None;
        for face in run.watch(self.surface.triangles().iter().zip(&cells).enumerate()) {
            let (face, (triangle, &[inner, outer])) = face?;
            let corners = triangle.map(|v| samples[v as usize]);
            let place = |v: u32| &t.coords()[v as usize];
            // Faces ascend by inner cell and facet: none comes twice.
            let slot = t.cells()[inner as usize].iter().position(|v| !corners.contains(v));
            let apex = slot.map(|slot| t.cells()[inner as usize][slot]);
            let [a, b, c] = corners.map(place);
            let holds = self.is_inner[inner as usize]
                && corners.iter().all(|corner| has(inner, corner))
                && (outer == NONE
                    || (!self.is_inner[outer as usize]
                        && corners.iter().all(|corner| has(outer, corner))))
                && apex.is_some_and(|v| orient3d(a, b, c, place(v)) == Sign::Negative)
                && last < slot.map(|slot| (inner, slot));
            last = slot.map(|slot| (inner, slot));
            report.check(holds, ElementKind::Face, face as u64, || {
                "the face does not divide an inner cell from an outer one, or points inward".into()
            });
        }
        let mut count = 0;
        for cell in run.watch(t.neighbors().iter().enumerate()) {
            let (cell, neighbors) = cell?;
            let is_outer = |&&next: &&u32| next == NONE || !self.is_inner[next as usize];
            count +=
                if self.is_inner[cell] { neighbors.iter().filter(is_outer).count() } else { 0 };
        }
        let faces = self.surface.faces().len();
        report.check(count == faces, ElementKind::Face, faces as u64, || {
            format!("{count} facets lie between inner and outer cells, but there are {faces} faces")
        });
        Ok(())
    }

    /// The umbrellas, the marks, and what is peeled off.
    fn check_marks(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let t = self.triangulation();
        let mut room = Room::new(run);
        let cells = t.cells().len();
        let is_wall = |cell: u32, i: usize| {
            let facet = match t.neighbors()[cell as usize][i] {
                next if next > cell => [cell, i as u32],
                next => [
                    next,
                    t.neighbors()[next as usize].iter().position(|&c| c == cell).unwrap_or(0)
                        as u32,
                ],
            };
            self.layer.binary_search(&facet).is_ok()
        };
        // For every vertex of every cell what its umbrella says: a set for each side, joined across facets that are not in it. The last ones are beyond the hull.
        room.keep(4 * (4 * cells + t.coords().len()))?;
        let beyond = |v: u32| (4 * cells) as u32 + v;
        let slot = |cell: u32, v: u32| {
            let slot = t.cells()[cell as usize].iter().position(|&corner| corner == v);
            4 * cell + slot.unwrap_or(0) as u32
        };
        let mut sides = DisjointSets::new(4 * cells + t.coords().len(), run)?;
        for cell in run.watch(0..cells as u32) {
            let cell = cell?;
            for (i, &next) in t.neighbors()[cell as usize].iter().enumerate() {
                if next > cell && !is_wall(cell, i) {
                    for v in t.facet(cell, i) {
                        let other = if next == NONE { beyond(v) } else { slot(next, v) };
                        sides.join(slot(cell, v), other);
                    }
                }
            }
        }
        // The root of the outer side of each umbrella, from its first triangle; every other one must divide the same two.
        let mut outer = room.filled(t.coords().len(), NONE)?;
        for facet in run.watch(&self.layer) {
            let &[cell, i] = facet?;
            let next = t.neighbors()[cell as usize][i as usize];
            for v in t.facet(cell, i as usize) {
                if !self.is_well_sampled[v as usize] {
                    continue;
                }
                let front = sides.root(if next == NONE { beyond(v) } else { slot(next, v) });
                let back = sides.root(slot(cell, v));
                let known = outer[v as usize];
                if known == NONE {
                    outer[v as usize] = if self.outer_side[v as usize] == 1 { front } else { back };
                }
                let holds = front != back && [front, back].contains(&outer[v as usize]);
                report.check(holds, ElementKind::Vertex, u64::from(v), || {
                    "the triangles round the sample do not divide the cells round it in two".into()
                });
            }
        }
        // Before cells changed sides.
        let was_inner =
            |cell: u32| self.is_inner[cell as usize] != self.parted.binary_search(&cell).is_ok();
        let mut votes = room.filled(cells, 0i32)?;
        let mut free = DisjointSets::new(cells, run)?;
        for cell in run.watch(0..cells as u32) {
            let cell = cell?;
            for v in t.cells()[cell as usize] {
                if self.is_well_sampled[v as usize] {
                    let is_outer = sides.root(slot(cell, v)) == outer[v as usize];
                    votes[cell as usize] += if is_outer { -1 } else { 1 };
                }
            }
            let vote = votes[cell as usize];
            report.check(
                vote == 0 || (vote > 0) == was_inner(cell),
                ElementKind::Cell,
                u64::from(cell),
                || "the cell is not what most of its well sampled vertices say".into(),
            );
        }
        // Cells without a mark that hang together share a label: outer if the outside gets there.
        let mut is_reached = room.filled(cells, false)?;
        for joins in [true, false] {
            for cell in run.watch((0..cells as u32).filter(|&cell| votes[cell as usize] == 0)) {
                let cell = cell?;
                for (i, &next) in t.neighbors()[cell as usize].iter().enumerate() {
                    if is_wall(cell, i) {
                        continue;
                    }
                    if next != NONE && votes[next as usize] == 0 {
                        free.join(cell, next);
                    } else if !joins && (next == NONE || votes[next as usize] < 0) {
                        is_reached[free.root(cell) as usize] = true;
                    }
                }
            }
        }
        for cell in run.watch((0..cells as u32).filter(|&cell| votes[cell as usize] == 0)) {
            let cell = cell?;
            let holds = is_reached[free.root(cell) as usize] != was_inner(cell);
            report.check(holds, ElementKind::Cell, u64::from(cell), || {
                "the cell without a mark is not what peeling makes of it".into()
            });
        }
        Ok(())
    }

    /// The least of (y . v)^2 - sin^2 |y|^2 over the dual edge of each triangle of the open surface is not positive, seen from its flat vertices.
    fn check_candidates(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let t = self.triangulation();
        let mut room = Room::new(run);
        let poles = poles::select_in(&self.dual, &mut room, run)?;
        let samples = samples(&self.open_surface);
        let cells = cells_of_faces(&self.open_surface);
        let sine = libm::sin(self.options.angle);
        let triangles = self.open_surface.triangles().iter().zip(&cells).enumerate();
        for face in run.watch(triangles) {
            let (face, (triangle, cells)) = face?;
            let corners = triangle.map(|v| samples[v as usize]);
            let mut flat =
                corners.iter().filter(|&&v| !self.is_undersampled[v as usize]).peekable();
            let is_some = flat.peek().is_some();
            let holds = is_some
                && flat.all(|&v| {
                    let ends = cells.map(|cell| self.end(cell, cells, corners, v));
                    reach(ends, poles.normals[v as usize], sine)
                });
            report.check(holds, ElementKind::Face, face as u64, || {
                "the triangle's Voronoi edge misses the cocone of a vertex, or none is flat".into()
            });
        }
        report.check(
            t.coords().len() == self.is_undersampled.len(),
            ElementKind::Vertex,
            0,
            || "there must be one flag per sample".into(),
        );
        Ok(())
    }

    /// An end of a Voronoi edge less a sample, of length 1 at infinity, and whether it is there.
    fn end(&self, cell: u32, cells: &[u32; 2], corners: [u32; 3], sample: u32) -> (Vec3, bool) {
        let t = self.triangulation();
        if cell != NONE {
            return (super::cone::offset(&self.dual, sample, cell), false);
        }
        let finite = cells[0].min(cells[1]);
        let slot = t.cells()[finite as usize].iter().position(|v| !corners.contains(v));
        let ray = self.dual.rays().of_facet(finite, slot.unwrap_or(0) as u32);
        (self.dual.rays().directions().get(ray as usize).copied().unwrap_or([0.0; 3]), true)
    }
}

/// Whether a segment or ray comes into the cocone, up to rounding.
fn reach(ends: [(Vec3, bool); 2], normal: Vec3, sine: f64) -> bool {
    let [(a, _), (b, _)] = if ends[0].1 { [ends[1], ends[0]] } else { ends };
    let is_ray = ends[0].1 || ends[1].1;
    if a == [0.0; 3] {
        return true;
    }
    // Lengths relative to that of the nearer end.
    let largest = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let a = a.map(|x| x / largest);
    let b = if is_ray { b } else { b.map(|x| x / largest) };
    let along = if is_ray { b } else { sub(b, a) };
    let form = |x: Vec3, y: Vec3| dot(x, normal) * dot(y, normal) - sine * sine * dot(x, y);
    // A quadratic function of the place along the edge.
    let (square, linear) = (form(along, along), form(a, along));
    let at = |step: f64| {
        let y = [0, 1, 2].map(|k| a[k] + step * along[k]);
        y == [0.0; 3] || form(unit(y), unit(y)) <= 1e-6
    };
    let lowest = if square > 0.0 { -linear / square } else { 0.0 };
    let is_on = lowest > 0.0 && (is_ray || lowest < 1.0);
    at(0.0) || (is_on && at(lowest)) || if is_ray { form(b, b) <= 1e-6 } else { at(1.0) }
}

/// Edges are run equally often both ways; in an open surface at most once each way.
fn check_edges(
    report: &mut Validation,
    surface: &Complex,
    is_open: bool,
    run: &Run<'_>,
) -> Result<()> {
    let mut room = Room::new(run);
    let mut edges: Vec<(u64, bool)> = room.vec(3 * surface.triangles().len())?;
    for triangle in run.watch(surface.triangles()) {
        let [a, b, c] = *triangle?;
        for [p, q] in [[a, b], [b, c], [c, a]] {
            edges.push((u64::from(p.min(q)) << 32 | u64::from(p.max(q)), p < q));
        }
    }
    sort_by_key(&mut edges, |&(edge, _)| edge, run)?;
    for edge in run.watch(edges.chunk_by(|a, b| a.0 == b.0)) {
        let edge = edge?;
        let up = edge.iter().filter(|(_, up)| *up).count();
        let holds = if is_open { up < 2 && edge.len() - up < 2 } else { 2 * up == edge.len() };
        report.check(holds, ElementKind::Vertex, edge[0].0 >> 32, || {
            "an edge at the vertex is not run equally often both ways".into()
        });
    }
    Ok(())
}

/// The sample of each vertex.
fn samples(surface: &Complex) -> &[u32] {
    indices(surface, Element::Vertex, "sample")
}

/// The inner and the outer cell of each face.
fn cells_of_faces(surface: &Complex) -> Vec<[u32; 2]> {
    let inner = indices(surface, Element::Face, "inner_cell");
    let outer = indices(surface, Element::Face, "outer_cell");
    inner.iter().zip(outer).map(|(&inner, &outer)| [inner, outer]).collect()
}

fn indices<'a>(surface: &'a Complex, element: Element, name: &str) -> &'a [u32] {
    match surface.attribute(element, name).map(|attribute| attribute.values()) {
        Some(Values::U32(values)) => values,
        _ => &[],
    }
}
