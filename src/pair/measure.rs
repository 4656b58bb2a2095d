//! The tetrahedra that elements consist of, their volumes, and which are folded.

use super::{PairElement, PairMesh};
use crate::error::Result;
use crate::job::{Job, PART, Room, Run, Stage, parts};
use crate::predicates::orient3d;
use crate::vector::{Vec3, add, cross, dot, scale, sub};

impl PairMesh {
    /// The number of tetrahedra of an element: of a pyramid over k corners k - 2, else 1.
    pub fn piece_count(&self, element: u32) -> u32 {
        match self.kind(element) {
            PairElement::FaceVertex => self.ring(element).len() as u32 - 2,
            _ => 1,
        }
    }

    /// The corners of a tetrahedron of an element, positively oriented, as vertices: those of the boundary, then the inner ones. It must be one of [`PairMesh::piece_count`].
    ///
    /// Those of a pyramid are its apex and a fan from the first corner of its base, the same from both sides of a face; of an element between two edges the ends of the boundary's and those of the inner
    /// one; of one over a triangle the inner vertex and the triangle.
    pub fn piece(&self, element: u32, piece: u32) -> [u32; 4] {
        let ring = self.ring(element);
        let boundary = |i: usize| self.nodes[ring[i] as usize][0];
        let inner = |i: usize| self.boundary.len() as u32 + self.nodes[ring[i] as usize][1];
        match self.kind(element) {
            PairElement::FaceVertex => {
                let i = piece as usize + 1;
                [boundary(0), inner(0), inner(i + 1), inner(i)]
            }
            PairElement::EdgeEdge => [boundary(0), boundary(1), inner(0), inner(2)],
            PairElement::VertexFace => [inner(0), boundary(0), boundary(1), boundary(2)],
        }
    }

    /// Where a vertex is, of the boundary or, counted after these, an inner one.
    pub fn place_of(&self, vertex: u32) -> Vec3 {
        match (vertex as usize).checked_sub(self.boundary.len()) {
            None => self.boundary[vertex as usize],
            Some(inner) => self.inner[inner],
        }
    }

    /// The volume of each element, in cubed units; less than 0 where one is folded, or by rounding where it has next to none ([`PairMesh::folded`] decides exactly). Errors: those of the job. Cost: O(size).
    pub fn volumes(&self, job: &Job) -> Result<Vec<f64>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.of_elements(run, |element| self.volume_and_moment(element).0)
        })
    }

    /// The centroid of each element; of one without volume the mean of its corners. Errors and cost as [`PairMesh::volumes`].
    pub fn centroids(&self, job: &Job) -> Result<Vec<Vec3>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.of_elements(run, |element| {
                let (volume, moment) = self.volume_and_moment(element);
                let origin = self.place_of(self.piece(element, 0)[0]);
                let centroid = add(origin, scale(moment, 1.0 / volume));
                if volume > 0.0 && centroid.iter().all(|x| x.is_finite()) {
                    return centroid;
                }
                let corners = self.piece(element, 0).map(|v| sub(self.place_of(v), origin));
                add(origin, scale(corners.into_iter().fold([0.0; 3], add), 0.25))
            })
        })
    }

    /// The elements that are turned inside out, in part or as a whole, ascending: some tetrahedron has a volume that is exactly less than 0. Errors and cost as [`PairMesh::volumes`].
    pub fn folded(&self, job: &Job) -> Result<Vec<u32>> {
        job.run(&[(Stage::Query, 1.0)], |run| {
            run.enter(Stage::Query)?;
            self.folded_in(run)
        })
    }

    pub(super) fn folded_in(&self, run: &Run<'_>) -> Result<Vec<u32>> {
        let folded = run.in_parallel(parts(self.element_count()), |range| {
            run.poll()?;
            let elements = range.map(|element| element as u32);
            Ok(elements.filter(|&element| self.is_folded(element)).collect::<Vec<_>>())
        })?;
        Ok(folded.concat())
    }

    fn is_folded(&self, element: u32) -> bool {
        (0..self.piece_count(element)).any(|piece| {
            let [a, b, c, d] = self.piece(element, piece).map(|v| self.place_of(v));
            orient3d(&a, &b, &c, &d).is_negative()
        })
    }

    /// The volume that the boundary encloses. Cost: O(triangles).
    pub fn enclosed_volume(&self) -> f64 {
        let origin = self.boundary.first().copied().unwrap_or_default();
        let triangles = (self.ends[1]..self.element_count()).map(|element| {
            let [_, p, q, r] = self.piece(element as u32, 0).map(|v| sub(self.place_of(v), origin));
            dot(p, cross(q, r))
        });
        triangles.sum::<f64>() / 6.0
    }

    /// The volume of an element, and its first moment about the first corner of its first tetrahedron.
    pub(super) fn volume_and_moment(&self, element: u32) -> (f64, Vec3) {
        let origin = self.place_of(self.piece(element, 0)[0]);
        let mut sum = (0.0, [0.0; 3]);
        for piece in 0..self.piece_count(element) {
            let [a, b, c, d] = self.piece(element, piece).map(|v| sub(self.place_of(v), origin));
            let volume = dot(cross(sub(b, a), sub(c, a)), sub(d, a)) / 6.0;
            let mean = scale(add(add(a, b), add(c, d)), 0.25);
            sum = (sum.0 + volume, add(sum.1, scale(mean, volume)));
        }
        sum
    }

    fn of_elements<T: Copy + Default + Send>(
        &self,
        run: &Run<'_>,
        of: impl Fn(u32) -> T + Sync,
    ) -> Result<Vec<T>> {
        let mut values = Room::new(run).filled(self.element_count(), T::default())?;
        run.in_parallel(values.chunks_mut(PART).enumerate().collect(), |(part, values)| {
            run.poll()?;
            values.iter_mut().zip(part * PART..).for_each(|(value, i)| *value = of(i as u32));
            Ok(())
        })?;
        Ok(values)
    }
}
