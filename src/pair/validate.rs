//! The checks of a pair-mesh.

use super::{PairElement, PairMesh};
use crate::error::{ElementKind, Result};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use crate::validation::Validation;
use crate::vector::{cross, dot, sub};

/// What a folded element's volume may be, as a share of the solid's: a fold by rounding.
const SLIVER: f64 = 1e-12;

impl PairMesh {
    /// Checks that the elements are a partition of the solid: their sides meet in pairs, the other way round; both pyramids of a face have it as their base; no element is folded whose volume is more than
    /// 1e-12 of the solid's; the volumes sum up to what the boundary encloses, to 1e-9 of it. Since no element is folded and the boundary is covered once, each point of the solid is in one element.
    ///
    /// Errors: those of the job. Cost: O(size).
    pub fn validate(&self, job: &Job) -> Result<Validation> {
        job.run(&[(Stage::Validate, 1.0)], |run| {
            run.enter(Stage::Validate)?;
            self.validate_in(run)
        })
    }

    pub(crate) fn validate_in(&self, run: &Run<'_>) -> Result<Validation> {
        let mut report = Validation::new();
        self.check_rings(&mut report, run)?;
        self.check_sides(&mut report, run)?;
        self.check_volumes(&mut report, run)?;
        Ok(report)
    }

    /// Whether rings are those of their kinds.
    fn check_rings(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        for element in run.watch(0..self.element_count() as u32) {
            let element = element?;
            let ring: Vec<[u32; 2]> =
                self.ring(element).iter().map(|&node| self.nodes[node as usize]).collect();
            let same = |i: usize, j: usize, end: usize| ring[i][end] == ring[j][end];
            let is_right = match self.kind(element) {
                PairElement::FaceVertex => {
                    let face = self.faces.row(element as usize / 2);
                    let mut base: Vec<u32> = ring.iter().map(|node| node[1]).collect();
                    if element.is_multiple_of(2) {
                        base[1..].reverse();
                    }
                    base == face && ring.iter().all(|node| node[0] == ring[0][0])
                }
                PairElement::EdgeEdge => {
                    ring.len() == 4
                        && (same(0, 3, 0) && same(1, 2, 0) && !same(0, 1, 0))
                        && (same(0, 1, 1) && same(2, 3, 1) && !same(0, 2, 1))
                }
                PairElement::VertexFace => {
                    ring.len() == 3
                        && (same(0, 1, 1) && same(0, 2, 1))
                        && !(same(0, 1, 0) || same(0, 2, 0) || same(1, 2, 0))
                }
            };
            report.check(is_right, ElementKind::Cell, u64::from(element), || {
                format!("its nodes {ring:?} are not those of such an element")
            });
        }
        Ok(())
    }

    /// Whether every side of a ring is a side of one other, the other way round.
    fn check_sides(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let mut room = Room::new(run);
        let sides = self.sides(&mut room, run)?;
        for element in run.watch(0..self.element_count() as u32) {
            let element = element?;
            let begin = self.rings.offsets()[element as usize];
            for side in 0..self.ring(element).len() as u32 {
                let [other, across] = sides[(begin + side) as usize];
                let is_met = other != NONE && other != element && {
                    let back = self.rings.offsets()[other as usize] + across;
                    sides[back as usize] == [element, side]
                };
                report.check(is_met, ElementKind::Cell, u64::from(element), || {
                    format!("side {side} of it is not met once by another element")
                });
            }
        }
        Ok(())
    }

    fn check_volumes(&self, report: &mut Validation, run: &Run<'_>) -> Result<()> {
        let enclosed = self.enclosed_volume();
        for element in self.folded_in(run)? {
            let volume = self.largest_piece(element);
            report.check(
                volume <= SLIVER * enclosed,
                ElementKind::Cell,
                u64::from(element),
                || format!("it is folded, and not by rounding: {volume} of {enclosed}"),
            );
        }
        let mut sum = 0.0;
        for element in run.watch(0..self.element_count() as u32) {
            sum += self.volume_and_moment(element?).0;
        }
        let is_whole = (sum - enclosed).abs() <= 1e-9 * enclosed;
        report.check(is_whole && enclosed > 0.0, ElementKind::Cell, 0, || {
            format!("the elements have a volume of {sum}, the boundary encloses {enclosed}")
        });
        Ok(())
    }

    /// The volume of the largest tetrahedron that is turned inside out.
    fn largest_piece(&self, element: u32) -> f64 {
        let volumes = (0..self.piece_count(element)).map(|piece| {
            let [a, b, c, d] = self.piece(element, piece).map(|v| self.place_of(v));
            -dot(cross(sub(b, a), sub(c, a)), sub(d, a)) / 6.0
        });
        volumes.fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::complex::Rows;
    use crate::dual::{Dual, DualOptions};
    use crate::labels::Labels;
    use crate::points::Points;
    use crate::triangulation::Triangulation;
    use std::sync::Arc;

    /// Points near a sphere, all cells inner.
    fn ball() -> PairMesh {
        let job = Job::default();
        let at = |i: usize| {
            let (z, turn) = (1.0 - (2.0 * i as f64 + 1.0) / 60.0, 2.4 * i as f64);
            let r = (1.0 - z * z).sqrt();
            [r * libm::cos(turn), 0.8 * r * libm::sin(turn), 0.6 * z]
        };
        let points = Points::by_row(60, at, Default::default(), &job).unwrap();
        let t = Arc::new(Triangulation::delaunay(&Arc::new(points), &job).unwrap());
        let dual = Arc::new(Dual::new(&t, DualOptions { facets: true }, &job).unwrap());
        let labels = Labels::new(&t, vec![true; t.cells().len()]).unwrap();
        PairMesh::voronoi(&dual, &labels, &job).unwrap()
    }

    #[test]
    fn whatever_is_changed_is_noticed() {
        let mesh = ball();
        let report = mesh.validate(&Job::default()).unwrap();
        assert!(report.is_valid() && report.checked > 500, "{report:?}");
        type Change = fn(&mut PairMesh);
        let changes: [(&str, Change); 6] = [
            ("an inner vertex outside", |mesh| mesh.inner[3] = [3.0, 0.0, 0.0]),
            ("a boundary vertex inside out", |mesh| {
                mesh.boundary[3] = mesh.boundary[3].map(|x| -x)
            }),
            ("a node of another vertex", |mesh| mesh.nodes[5][0] = (mesh.nodes[5][0] + 1) % 60),
            ("an element turned round", |mesh| {
                let rings: Vec<Vec<u32>> = mesh.rings.iter().map(<[u32]>::to_vec).collect();
                mesh.rings = Rows::default();
                for (i, mut ring) in rings.into_iter().enumerate() {
                    if i == mesh.ends[1] {
                        ring.reverse();
                    }
                    mesh.rings.push(&ring).unwrap();
                }
            }),
            ("an element less", |mesh| {
                let rings: Vec<Vec<u32>> = mesh.rings.iter().map(<[u32]>::to_vec).collect();
                mesh.rings = Rows::default();
                rings[..rings.len() - 1].iter().for_each(|ring| mesh.rings.push(ring).unwrap());
            }),
            ("a face less", |mesh| mesh.ends[0] -= 2),
        ];
        for (name, change) in changes {
            let mut mesh = mesh.clone();
            change(&mut mesh);
            assert!(!mesh.validate(&Job::default()).unwrap().is_valid(), "{name}");
        }
    }
}
