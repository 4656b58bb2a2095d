//! The half-face structure (Shaham, Shamir, Cohen-Or, section 3.1).

use super::{PairElement, PairMesh};
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Job, Room, Run, Stage};
use std::ops::Range;

/// Every face of every element, seen from inside that element, with its edges.
///
/// An element's half-faces follow one another, a half-face's half-edges too. Those of a pyramid are its base, then its sides in the order of its ring; of an element
/// over a triangle the triangle, then its sides; of one between two edges its four sides. Half-edges turn counterclockwise seen from outside the element.
///
/// Invariants: `dual` is its own inverse and leads into another element, to the same corners the other way round, [`NONE`] on the boundary; `opposite` leads to the same edge, the other way round, in another
/// half-face of the same element; `partner` to the same edge, the other way round, in the dual half-face.
///
/// So `opposite` and `partner` by turns go round an edge from element to element, however many meet there, until the edge has been gone round or the boundary is met.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HalfFaces {
    /// Where the half-faces of each element begin; one more entry than elements.
    pub of_element: Vec<u32>,
    /// Where the half-edges of each half-face begin; one more entry than half-faces.
    pub offsets: Vec<u32>,
    /// The half-face on the other side, or [`NONE`].
    pub dual: Vec<u32>,
    /// The vertex at which each half-edge begins: those of the boundary, then the inner ones.
    pub origin: Vec<u32>,
    /// The half-edge on the other side of the edge within the element.
    pub opposite: Vec<u32>,
    /// That in the dual half-face, or [`NONE`].
    pub partner: Vec<u32>,
}

impl HalfFaces {
    /// The element of a half-face. Cost: O(log n).
    pub fn element(&self, half_face: u32) -> u32 {
        self.of_element.partition_point(|&begin| begin <= half_face) as u32 - 1
    }

    /// The half-face of a half-edge. Cost: O(log n).
    pub fn half_face(&self, half_edge: u32) -> u32 {
        self.offsets.partition_point(|&begin| begin <= half_edge) as u32 - 1
    }

    /// The next half-edge of the same half-face. Cost: O(log n).
    pub fn next(&self, half_edge: u32) -> u32 {
        let half_face = self.half_face(half_edge) as usize;
        let next = half_edge + 1;
        if next == self.offsets[half_face + 1] { self.offsets[half_face] } else { next }
    }
}

impl PairMesh {
    /// The half-face structure. Errors: [`Status::LimitExceeded`] past 2^32 - 2 half-edges; those of the job. Cost: O(size).
    pub fn half_faces(&self, job: &Job) -> Result<HalfFaces> {
        job.run(&[(Stage::Extract, 1.0)], |run| {
            run.enter(Stage::Extract)?;
            self.half_faces_in(run)
        })
    }

    pub(super) fn half_faces_in(&self, run: &Run<'_>) -> Result<HalfFaces> {
        let mut room = Room::new(run);
        let mut its = HalfFaces {
            of_element: room.vec(self.element_count() + 1)?,
            offsets: vec![0],
            dual: Vec::new(),
            origin: Vec::new(),
            opposite: Vec::new(),
            partner: Vec::new(),
        };
        for element in run.watch(0..self.element_count() as u32) {
            let element = element?;
            its.of_element.push(its.offsets.len() as u32 - 1);
            let begin = its.origin.len();
            let count = self.ring(element).len();
            if begin + 4 * count > NONE as usize - 1 {
                return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 2 half-edges"));
            }
            room.grow(&mut its.origin, 4 * count)?;
            room.grow(&mut its.offsets, count + 1)?;
            self.push_half_faces(element, &mut its);
            room.grow(&mut its.opposite, its.origin.len() - begin)?;
            for half_edge in begin..its.origin.len() {
                let ends = its.ends(half_edge as u32);
                let is_opposite = |&other: &u32| its.ends(other) == [ends[1], ends[0]];
                let opposite = (begin as u32..its.origin.len() as u32).find(is_opposite);
                its.opposite.push(opposite.unwrap_or(NONE));
            }
        }
        its.of_element.push(its.offsets.len() as u32 - 1);
        its.dual = room.filled(its.offsets.len() - 1, NONE)?;
        its.partner = room.filled(its.origin.len(), NONE)?;
        let sides = self.sides(&mut room, run)?;
        for element in run.watch(0..self.element_count() as u32) {
            let element = element?;
            if self.kind(element) == PairElement::FaceVertex {
                its.join(its.of_element[element as usize], its.of_element[(element ^ 1) as usize]);
            }
            let begin = self.rings.offsets()[element as usize];
            for side in 0..self.ring(element).len() as u32 {
                if let [other, across] = sides[(begin + side) as usize]
                    && other != NONE
                {
                    let (own, other) =
                        (self.side(&its, element, side), self.side(&its, other, across));
                    its.join(own, other);
                }
            }
        }
        Ok(its)
    }

    /// The half-face of a side of an element.
    fn side(&self, its: &HalfFaces, element: u32, side: u32) -> u32 {
        let own = u32::from(self.kind(element) != PairElement::EdgeEdge);
        its.of_element[element as usize] + own + side
    }

    /// The half-faces of an element. Seen from the boundary its ring turns counterclockwise.
    fn push_half_faces(&self, element: u32, its: &mut HalfFaces) {
        let ring = self.ring(element);
        let corners = || ring.iter().map(|&node| self.corners(node));
        match self.kind(element) {
            PairElement::FaceVertex => its.push(corners().rev().map(|[_, v]| v)),
            PairElement::VertexFace => its.push(corners().map(|[p, _]| p)),
            PairElement::EdgeEdge => {}
        }
        for ([p, v], [q, w]) in corners().zip(corners().cycle().skip(1)) {
            its.push(if p == q { [v, w, p] } else { [q, p, v] }.into_iter());
        }
    }
}

impl HalfFaces {
    fn push(&mut self, corners: impl Iterator<Item = u32>) {
        self.origin.extend(corners);
        self.offsets.push(self.origin.len() as u32);
    }

    /// The vertices at the ends of a half-edge.
    pub fn ends(&self, half_edge: u32) -> [u32; 2] {
        [half_edge, self.next(half_edge)].map(|half_edge| self.origin[half_edge as usize])
    }

    fn half_edges(&self, half_face: u32) -> Range<u32> {
        self.offsets[half_face as usize]..self.offsets[half_face as usize + 1]
    }

    /// Makes one half-face know that another one is its dual.
    fn join(&mut self, half_face: u32, dual: u32) {
        self.dual[half_face as usize] = dual;
        for half_edge in self.half_edges(half_face) {
            let [from, to] = self.ends(half_edge);
            let partner = self.half_edges(dual).find(|&other| self.ends(other) == [to, from]);
            self.partner[half_edge as usize] = partner.unwrap_or(NONE);
        }
    }
}
