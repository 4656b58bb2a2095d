//! The combinatorial check of a power crust.

use super::balls::{Grid, own_samples};
use super::division::Division;
use super::label::{label_poles, unbounded_poles};
use super::shards::samples_of_cells;
use super::surface::{self, Shards};
use super::{Balls, Label, PowerCrust};
use crate::complex::{Complex, Element, Topology, Values};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::sort::sort_by_key;
use crate::triangulation::Edges;
use crate::validation::Validation;
use crate::vector::{cross, dot, length, sub, unit};

impl PowerCrust {
    /// Checks that the triangulation is that of the poles' balls, that the labels are those of the algorithm unless they were given, that the surface is closed, that its faces are the power facets between
    /// inner and outer poles, that merging shards changed no topology, moved vertices to their samples and turned no triangle over, that no inner pole has an unbounded cell, and that the power
    /// shapes are those of the labels. The cells are not looked at: the triangulation has
    /// its own [`validate`](crate::Triangulation::validate). Errors: those of the job. Cost: O(size).
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            let mut report = Validation::new();
            report.check(
                self.labels.len() == self.poles.len()
                    && self.regular.points().row_count() == self.poles.len(),
                ElementKind::Vertex,
                self.labels.len() as u64,
                || "there must be one label, and one row of the triangulation, per pole".into(),
            );
            if report.is_valid() {
                let incidence = self.regular.incidence_in(run)?;
                let edges = self.regular.edges_in(&incidence, run)?;
                let mut room = Room::new(run);
                room.keep(edges.bytes())?;
                self.check_balls(&mut report, run)?;
                self.check_labels(&mut report, run)?;
                self.check_closed(&mut report, run)?;
                self.check_faces(&mut report, &edges, run)?;
                self.check_unbounded(&mut report, run)?;
                // Of wrong labels there may be no surface.
                if report.is_valid() {
                    self.check_shards(&mut report, run)?;
                }
                self.check_shape(&mut report, &self.inner_shape, Label::Inner, run)?;
                self.check_shape(&mut report, &self.outer_shape, Label::Outer, run)?;
            }
            Ok(report)
        })
    }

    /// Each pole is a row of the triangulation with its own ball, or with one that lies on the grid, half a step
    /// away at most, and holds the pole's own sample on its sphere.
    fn check_balls(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let t = &*self.regular;
        let is_rounded = self.options.round_poles && matches!(self.balls, Balls::Poles);
        let step = is_rounded.then(|| Grid::of(&self.poles).step);
        let own = own_samples(&self.poles, &mut Room::new(run), run)?;
        for (pole, &vertex) in t.points().vertex_of_row().iter().enumerate() {
            if pole % 1024 == 0 {
                run.poll()?;
            }
            let weight = self.weight(pole);
            report.check(
                weight.is_some() == (vertex != NONE),
                ElementKind::Vertex,
                pole as u64,
                || "it was left out, and is there, or the other way round".into(),
            );
            let (Some(own_weight), true) = (weight, vertex != NONE) else { continue };
            let [x, y, z, _] = self.poles.balls()[pole];
            let (center, weight) = (t.coords()[vertex as usize], t.weights()[vertex as usize]);
            let pairs = || center.into_iter().zip([x, y, z]);
            let (is_moved_right, expected, slack) = match step {
                None => (center == [x, y, z], own_weight, 0.0),
                Some(step) => {
                    let on_grid = |x: f64| (x / step).fract() == 0.0;
                    let moved = pairs().all(|(to, from)| (to - from).abs() <= step / 2.0);
                    let sample = self.poles.triangulation().coords()[own[pole] as usize];
                    let square = center.iter().zip(sample).map(|(c, s)| (c - s) * (c - s)).sum();
                    let on_grid = center.into_iter().all(on_grid) && on_grid(weight / step);
                    (on_grid && moved, square, step * step + 8.0 * f64::EPSILON * square)
                }
            };
            // Where several poles lie, the heaviest counts.
            let counts = t.row_of_vertex()[vertex as usize] == pole as u32;
            let excess = weight - expected;
            let right = is_moved_right && excess >= -slack && (!counts || excess <= slack);
            report.check(right, ElementKind::Vertex, pole as u64, || {
                "its ball in the regular triangulation is another".into()
            });
        }
        Ok(())
    }

    /// Labelling once more gives the same labels, those of hidden poles included. Where balls were changed there is nothing to
    /// compare with, since labels were kept, nor where they were given.
    fn check_labels(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        if self.account.given || matches!(self.balls, Balls::Changed(_)) {
            return Ok(());
        }
        let again = label_poles(&self.poles, &self.regular, &self.options, run)?;
        let pairs = self.labels.iter().zip(&again.labels);
        for (pole, (label, expected)) in pairs.enumerate() {
            report.check(label == expected, ElementKind::Vertex, pole as u64, || {
                format!("it is labelled {label:?}, but the algorithm says {expected:?}")
            });
        }
        Ok(())
    }

    /// Each directed side of a face occurs once, and so does its reverse.
    fn check_closed(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut room = Room::new(run);
        let faces = self.surface.faces();
        // Each side from its tail to its head, and its face.
        let mut sides: Vec<(u64, u32)> = room.vec(faces.indices().len())?;
        let directed = |from: u32, to: u32| u64::from(from) << 32 | u64::from(to);
        for (face, ring) in faces.iter().enumerate() {
            if face % 4096 == 0 {
                run.tick(face, 4 * faces.len())?;
            }
            for (i, &from) in ring.iter().enumerate() {
                sides.push((directed(from, ring[(i + 1) % ring.len()]), face as u32));
            }
        }
        sort_by_key(&mut sides, |side| side.0, run)?;
        for (i, &(side, face)) in sides.iter().enumerate() {
            if i % 4096 == 0 {
                run.tick(sides.len() + i, 4 * sides.len())?;
            }
            let [from, to] = [(side >> 32) as u32, side as u32];
            let reverse = directed(to, from);
            let begin = sides.partition_point(|side| side.0 < reverse);
            let reversed = sides[begin..].iter().take_while(|side| side.0 == reverse).count();
            report.check(reversed == 1, ElementKind::Face, u64::from(face), || {
                format!("{reversed} faces meet it along its side from vertex {from} to {to}")
            });
        }
        Ok(())
    }

    /// The faces are those between an inner and an outer pole, in the order of the edges of the regular triangulation, and turn round
    /// these. Where shards were merged a face has one vertex for all cells of its ring that are the same sample; it may be missing if
    /// that leaves two.
    fn check_faces(&self, report: &mut Validation, edges: &Edges, run: &Run<'_>) -> Result<()> {
        let indices = |element, name| match self.surface.attribute(element, name)?.values() {
            Values::U32(values) => Some(values),
            Values::F64(_) => None,
        };
        let (Some(inner), Some(outer), Some(cells), Some(samples)) = (
            indices(Element::Face, "inner_pole"),
            indices(Element::Face, "outer_pole"),
            indices(Element::Vertex, "cell"),
            indices(Element::Vertex, "sample"),
        ) else {
            report.check(false, ElementKind::Face, 0, || "its attributes are missing".into());
            return Ok(());
        };
        let vertex_of_pole = self.regular.points().vertex_of_row();
        let mut room = Room::new(run);
        let all = room.collect(0..self.regular.cells().len() as u32)?;
        let mut of_cells =
            samples_of_cells(&self.poles, &self.regular, &all, [0.0; 2], &mut room, run)?;
        // What stayed apart is no sample.
        for (&cell, _) in cells.iter().zip(samples).filter(|&(_, &sample)| sample == NONE) {
            of_cells[cell as usize] = NONE;
        }
        let keep = self.shards != Shards::Merge;
        // A sample, or a cell.
        let key = |sample: u32, cell: u32| match sample {
            NONE => (NONE, cell),
            _ if keep => (NONE, cell),
            sample => (sample, NONE),
        };
        let contracted = |ring: &mut Vec<(u32, u32)>| {
            ring.dedup();
            while ring.len() > 1 && ring.first() == ring.last() {
                ring.pop();
            }
        };
        let faces = self.surface.faces();
        let (mut face, mut ring, mut keys, mut found) = (0, Vec::new(), Vec::new(), Vec::new());
        for (i, (ends, &cell)) in edges.ends.iter().zip(&edges.cells).enumerate() {
            if i % 1024 == 0 {
                run.tick(i + edges.ends.len(), 2 * edges.ends.len())?;
            }
            let [p, q] = ends.map(|v| self.regular.row_of_vertex()[v as usize]);
            let [p, q] = match (self.labels[p as usize], self.labels[q as usize]) {
                (Label::Inner, Label::Outer) => [p, q],
                (Label::Outer, Label::Inner) => [q, p],
                _ => continue,
            };
            let [a, b] = [p, q].map(|pole| vertex_of_pole[pole as usize]);
            let closed = self.regular.ring(cell, a, b, &mut ring);
            keys.clear();
            keys.extend(ring.iter().map(|&c| key(of_cells[c as usize], c)));
            contracted(&mut keys);
            let is_there = face < faces.len() && (inner[face], outer[face]) == (p, q);
            if is_there {
                found.clear();
                found.extend(faces.row(face).iter().map(|&v| {
                    let v = v as usize;
                    key(samples[v], cells[v])
                }));
                contracted(&mut found);
            }
            let right = closed && if is_there { found == keys } else { keys.len() < 3 };
            report.check(right, ElementKind::Face, face as u64, || {
                format!("it is not the power facet between inner pole {p} and outer pole {q}")
            });
            face += usize::from(is_there);
        }
        report.check(face == faces.len(), ElementKind::Face, face as u64, || {
            "it lies between no inner and outer pole, or out of order".into()
        });
        Ok(())
    }

    /// With or without its shards the surface has as many pieces, the same Euler characteristic, and no boundary; its vertices are where
    /// their samples are, and these on the balls on either side.
    fn check_shards(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        if self.shards != Shards::Merge {
            return Ok(());
        }
        let division = Division::new(&self.regular, &self.labels, &mut Room::new(run), run)?;
        let whole = surface::extract(&self.poles, &self.regular, &division, Shards::Keep, run)?;
        let [merged, whole] = [&*self.surface, &whole].map(|surface| surface.topology_in(run));
        let (merged, whole) = (merged?, whole?);
        let form = |t: &Topology| (t.components, t.euler_characteristic, t.boundary_loops);
        report.check(form(&merged) == form(&whole), ElementKind::Face, 0, || {
            format!("merging shards made {:?} of {:?}", form(&merged), form(&whole))
        });
        let samples = match self.surface.attribute(Element::Vertex, "sample").map(|a| a.values()) {
            Some(Values::U32(samples)) => &samples[..],
            _ => &[],
        };
        for (vertex, &sample) in samples.iter().enumerate().filter(|&(_, &s)| s != NONE) {
            let at = self.poles.triangulation().coords()[sample as usize];
            let there = self.surface.vertices()[vertex] == at;
            report.check(there, ElementKind::Vertex, vertex as u64, || {
                format!("it is not where sample {sample} is")
            });
        }
        self.check_turns(report, samples, run)
    }

    /// No triangle that has a sample as its corner turns clockwise as seen from its outer pole, but for needles.
    fn check_turns(&self, report: &mut Validation, samples: &[u32], run: &Run<'_>) -> Result<()> {
        let poles = ["inner_pole", "outer_pole"].map(|name| {
            match self.surface.attribute(Element::Face, name).map(|a| a.values()) {
                Some(Values::U32(poles)) => &poles[..],
                _ => &[],
            }
        });
        let center = |pole: u32| [0, 1, 2].map(|axis| self.poles.balls()[pole as usize][axis]);
        let triangles = self.surface.triangles().iter().zip(self.surface.face_of_triangle());
        for triangle in run.watch(triangles) {
            let (corners, &face) = triangle?;
            let [Some(&inner), Some(&outer)] = poles.map(|poles| poles.get(face as usize)) else {
                continue;
            };
            let [a, b, c] = corners.map(|v| self.surface.vertices()[v as usize]);
            let longest =
                [sub(b, a), sub(c, b), sub(a, c)].map(length).into_iter().fold(0.0, f64::max);
            let outward = unit(sub(center(outer), center(inner)));
            let height = dot(cross(sub(c, b), sub(a, b)), outward) / longest;
            let is_apart = corners.iter().all(|&v| samples.get(v as usize) == Some(&NONE));
            // Twice what was allowed: rounding differs here.
            let turns_right = is_apart || height >= -2e-9 * longest || longest == 0.0;
            report.check(turns_right, ElementKind::Face, face.into(), || {
                "merging shards turned a triangle of it over".into()
            });
        }
        Ok(())
    }

    fn check_unbounded(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        for pole in unbounded_poles(&self.regular, &mut Room::new(run), run)? {
            let outer = self.labels[pole as usize] == Label::Outer;
            report.check(outer, ElementKind::Vertex, u64::from(pole), || {
                "an inner pole has an unbounded power cell".into()
            });
        }
        Ok(())
    }

    /// The shape's vertices are the visible poles of its side, with their attributes.
    fn check_shape(
        &self,
        report: &mut Validation,
        shape: &Complex,
        side: Label,
        run: &Run<'_>,
    ) -> Result<()> {
        run.poll()?;
        let mut hidden = Room::new(run).filled(self.regular.coords().len(), false)?;
        for &vertex in self.regular.hidden() {
            hidden[vertex as usize] = true;
        }
        let rows = self.regular.row_of_vertex().iter().zip(&hidden);
        let visible =
            rows.filter(|&(&pole, &hidden)| !hidden && self.labels[pole as usize] == side);
        let expected = visible.map(|(&pole, _)| pole);
        let found = match shape.attribute(Element::Vertex, "pole").map(|a| a.values()) {
            Some(Values::U32(poles)) => poles.iter().copied(),
            _ => [].iter().copied(),
        };
        report.check(expected.eq(found), ElementKind::Vertex, 0, || {
            format!("the {side:?} power shape is not that of the visible poles")
        });
        let values = |element, name| shape.attribute(element, name).map(|a| a.values());
        let angles = values(Element::Vertex, "object_angle");
        let (Some(Values::U32(poles)), Some(Values::U32(labels)), Some(Values::F64(angles))) =
            (values(Element::Vertex, "pole"), values(Element::Vertex, "label"), angles)
        else {
            report.check(false, ElementKind::Vertex, 0, || "attributes are missing".into());
            return Ok(());
        };
        for (vertex, &pole) in poles.iter().enumerate() {
            let right = labels[vertex] == side as u32
                && self.poles.object_angles().get(pole as usize) == Some(&angles[vertex]);
            report.check(right, ElementKind::Vertex, vertex as u64, || {
                format!("its label or its object angle in the {side:?} shape is another")
            });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crust::PowerCrustOptions;
    use crate::{Points, Triangulation};
    use std::sync::Arc;

    /// A cube's surface, sampled on a lattice: ties everywhere, sharp edges.
    fn crust() -> PowerCrust {
        let rows = (0..343u32).map(|i| [i % 7, i / 7 % 7, i / 49]);
        let rows: Vec<[f64; 3]> = rows
            .filter(|row| row.iter().any(|&x| x == 0 || x == 6))
            .map(|row| row.map(f64::from))
            .collect();
        let points = Points::new(&rows, Default::default(), &Job::default()).unwrap();
        PowerCrust::build(&Arc::new(points), PowerCrustOptions::default(), &Job::default()).unwrap()
    }

    fn is_valid(crust: &PowerCrust) -> bool {
        crust.validate(&Job::default()).unwrap().is_valid()
    }

    #[test]
    fn one_wrong_label_is_noticed() {
        let crust = crust();
        assert!(is_valid(&crust));
        assert!(crust.labels.contains(&Label::Inner) && crust.labels.contains(&Label::Outer));
        for pole in 0..crust.labels.len() {
            let mut crust = crust.clone();
            crust.labels[pole] = match crust.labels[pole] {
                Label::Inner => Label::Outer,
                Label::Outer => Label::Inner,
            };
            assert!(!is_valid(&crust), "pole {pole}");
        }
    }

    #[test]
    fn another_ball_is_noticed() {
        let mut crust = crust();
        crust.options.round_poles = true;
        crust = PowerCrust::from_poles(&crust.poles, crust.options, &Job::default()).unwrap();
        let has_its_balls = |crust: &PowerCrust| {
            let mut report = Validation::new();
            let check = |run: &Run<'_>| crust.check_balls(&mut report, run);
            Job::default().run(&[], check).unwrap();
            report.is_valid()
        };
        assert!(has_its_balls(&crust));
        let step = Grid::of(&crust.poles).step;
        let exact = PowerCrustOptions { round_poles: false, ..crust.options };
        for options in [crust.options, exact] {
            crust = PowerCrust::from_poles(&crust.poles, options, &Job::default()).unwrap();
            // Off the grid, on it but too far, weights too small and too large.
            for (by, of_weight) in [(0.1, 0.0), (1.0, 0.0), (0.0, -4.0), (0.0, 4.0)] {
                let row = crust.poles.len() as u32 / 2;
                let t = &crust.regular;
                let vertex_of_row = t.points().vertex_of_row().iter();
                let mut rows: Vec<_> = vertex_of_row.map(|&v| t.site(v)).collect();
                rows[row as usize][1] += by * step;
                // Some poles have the place of others: their weights are those of the heaviest.
                rows[row as usize][3] += of_weight * step;
                let points = |i: usize| [0, 1, 2].map(|k| rows[i][k]);
                let points =
                    Points::by_row(rows.len(), points, Default::default(), &Job::default())
                        .unwrap();
                let weights: Vec<f64> = rows.iter().map(|row| row[3]).collect();
                let other = Triangulation::regular(&Arc::new(points), &weights, &Job::default());
                let other = PowerCrust { regular: Arc::new(other.unwrap()), ..crust.clone() };
                assert!(!has_its_balls(&other), "{by} {of_weight} {options:?}");
            }
        }
    }

    #[test]
    fn another_surface_or_shape_is_noticed() {
        let crust = crust();
        let mut swapped = crust.clone();
        std::mem::swap(&mut swapped.inner_shape, &mut swapped.outer_shape);
        assert!(!is_valid(&swapped));
        let mut empty = crust.clone();
        empty.surface = Arc::default();
        assert!(!is_valid(&empty));
        let faces = crust.surface.faces();
        for face in 0..faces.len() {
            let mut torn = crate::complex::Rows::default();
            for (i, ring) in faces.iter().enumerate() {
                let mut ring = ring.to_vec();
                if i == face {
                    ring.reverse();
                }
                torn.push(&ring).unwrap();
            }
            let mut crust = crust.clone();
            let parts = crate::complex::ComplexParts {
                vertices: crust.surface.vertices().to_vec(),
                faces: torn,
                attributes: crust.surface.attributes().to_vec(),
                ..Default::default()
            };
            crust.surface = Arc::new(Complex::new(parts).unwrap());
            assert!(!is_valid(&crust), "face {face} turned over");
        }
    }
}
