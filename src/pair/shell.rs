//! The surface of nodes round an inner structure, while that is collapsed.

use super::PairMesh;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::predicates::{Sign, orient3d};
use crate::vector::{Vec3, dot, sub};

/// What an element is, while elements come and go.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Gone,
    Pyramid,
    Between,
    Over,
}

/// A side of an element on the surface of nodes, from its node to that of the next side.
#[derive(Clone, Copy)]
pub(super) struct Side {
    pub node: u32,
    pub next: u32,
    pub previous: u32,
    /// The same side in the element beyond, the other way round.
    pub twin: u32,
    pub element: u32,
    /// Of a pyramid's side that of the pyramid over the other side of its face, over the same inner edge.
    pub partner: u32,
}

#[derive(Clone, Copy)]
struct Element {
    kind: Kind,
    first: u32,
    /// Of a pyramid the face of the pair-mesh that it is over.
    face: u32,
}

/// What was there before a change.
enum Before {
    Side(u32, Side),
    Element(u32, Element),
    Node(u32, [u32; 2]),
}

/// Why a change is taken back: the surface of nodes would touch itself, or there is no way.
pub(super) struct Refusal;

/// The nodes and elements of a pair-mesh as a closed surface that can be changed, and back.
///
/// Invariant, between changes: it is a closed oriented surface; every element has a positive volume, and so they are a partition of the solid.
pub(super) struct Shell<'a> {
    mesh: &'a PairMesh,
    nodes: Vec<[u32; 2]>,
    sides: Vec<Side>,
    elements: Vec<Element>,
    before: Vec<Before>,
    /// Vertices of the boundary that the pair-mesh does not have.
    added: Vec<Vec3>,
    lengths: [usize; 4],
}

impl<'a> Shell<'a> {
    /// The surface of a pair-mesh. Faces that are not to be whole are divided into triangles.
    pub fn new(
        mesh: &'a PairMesh,
        is_whole: &dyn Fn(u32) -> bool,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<Self> {
        let met = mesh.sides(room, run)?;
        let mut its = Shell {
            mesh,
            nodes: room.collect(mesh.nodes.iter().copied())?,
            sides: room.vec(met.len())?,
            elements: room.vec(mesh.element_count())?,
            before: Vec::new(),
            added: Vec::new(),
            lengths: [0; 4],
        };
        // The side that each side of the mesh has become.
        let mut become_of = room.vec(met.len())?;
        for element in run.watch(0..mesh.element_count() as u32) {
            let element = element?;
            let ring = mesh.ring(element);
            let count = ring.len() as u32;
            let kind = match element as usize {
                element if element < mesh.ends[0] => Kind::Pyramid,
                element if element < mesh.ends[1] => Kind::Between,
                _ => Kind::Over,
            };
            if kind != Kind::Pyramid || count == 3 || is_whole(element / 2) {
                room.grow(&mut its.sides, count as usize)?;
                let first = its.add(kind, ring);
                become_of.extend(first..first + count);
            } else {
                room.grow(&mut its.sides, 3 * (count as usize - 2))?;
                room.grow(&mut its.elements, count as usize - 3)?;
                let first = its.sides.len() as u32;
                for i in 1..count as usize - 1 {
                    let at = its.add(kind, &[ring[0], ring[i], ring[i + 1]]);
                    if i > 1 {
                        its.glue(at, at - 1);
                    }
                }
                become_of.push(first);
                become_of.extend((0..count - 2).map(|i| first + 3 * i + 1));
                become_of.push(its.sides.len() as u32 - 1);
            }
            if kind == Kind::Pyramid && element % 2 == 1 {
                its.pair_up(element / 2);
            }
        }
        let offsets = mesh.rings.offsets();
        for item in run.watch(met.iter().zip(&become_of)) {
            let (&[other, across], &side) = item?;
            its.sides[side as usize].twin = become_of[(offsets[other as usize] + across) as usize];
        }
        Ok(its)
    }

    /// Makes the sides of the last pyramids, over one side of a face and then over the other, partners.
    fn pair_up(&mut self, face: u32) {
        let new = self
            .elements
            .iter()
            .rev()
            .take_while(|element| element.kind == Kind::Pyramid && element.face == NONE);
        let (count, end) = (new.count(), self.elements.len());
        for element in &mut self.elements[end - count..] {
            element.face = face;
        }
        let [begin, middle] = [end - count, end - count / 2];
        for i in 0..count / 2 {
            // The rings of both begin at the same corner and turn opposite ways.
            let (one, two) = ((begin + i) as u32, (middle + count / 2 - 1 - i) as u32);
            let own: Vec<u32> = self.ring(one).collect();
            let others: Vec<u32> = self.ring(two).collect();
            for (&a, &b) in own.iter().zip(others.iter().rev()) {
                self.sides[a as usize].partner = b;
                self.sides[b as usize].partner = a;
            }
        }
    }

    pub fn side(&self, side: u32) -> Side {
        self.sides[side as usize]
    }

    pub fn kind(&self, element: u32) -> Kind {
        self.elements[element as usize].kind
    }

    pub fn first(&self, element: u32) -> u32 {
        self.elements[element as usize].first
    }

    /// The face of the pair-mesh that a pyramid is over, or over a part of.
    pub fn face(&self, element: u32) -> u32 {
        self.elements[element as usize].face
    }

    pub fn element_count(&self) -> u32 {
        self.elements.len() as u32
    }

    pub fn side_count(&self) -> usize {
        self.sides.len()
    }

    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// The boundary vertex and the inner vertex of a node.
    pub fn node(&self, node: u32) -> [u32; 2] {
        self.nodes[node as usize]
    }

    /// Those of the node where a side begins.
    pub fn ends(&self, side: u32) -> [u32; 2] {
        self.node(self.side(side).node)
    }

    /// The sides of an element.
    pub fn ring(&self, element: u32) -> impl Iterator<Item = u32> + '_ {
        self.ring_from(self.first(element))
    }

    /// The same, as a list.
    pub fn sides_of(&self, element: u32) -> Vec<u32> {
        self.ring(element).collect()
    }

    /// The sides of an element from one of them on.
    pub fn ring_from(&self, first: u32) -> impl Iterator<Item = u32> + '_ {
        let next = move |&side: &u32| Some(self.side(side).next).filter(|&next| next != first);
        std::iter::successors(Some(first), next)
    }

    /// The ends of the inner edge of an element between edges, if no face has that edge.
    pub fn loose_edge(&self, element: u32) -> Option<[u32; 2]> {
        let first = self.first(element);
        let begin = if self.is_along_inner(first) { first } else { self.side(first).next };
        let mut at = begin;
        loop {
            at = self.side(self.opposite(at)).twin;
            if at == begin {
                return Some([self.ends(at)[1], self.ends(self.side(at).next)[1]]);
            }
            if self.kind(self.side(at).element) != Kind::Between {
                return None;
            }
        }
    }

    /// Whether the inner vertex where a side begins has one inner edge only.
    pub fn is_end(&self, side: u32) -> bool {
        self.star(side, usize::MAX).is_some_and(|star| star.ends.len() == 1)
    }

    /// The side opposite, in an element between two edges.
    pub fn opposite(&self, side: u32) -> u32 {
        self.side(self.side(side).next).next
    }

    /// Whether a side runs along an inner edge, its boundary vertex staying where it is.
    pub fn is_along_inner(&self, side: u32) -> bool {
        self.ends(side)[0] == self.ends(self.side(side).next)[0]
    }

    /// The side beyond the elements between edges over the inner edge that a pyramid's side runs along: that of the next pyramid round that edge. The elements are visited.
    pub fn beyond(&self, side: u32, mut visit: impl FnMut(u32)) -> u32 {
        let mut twin = self.side(side).twin;
        while self.kind(self.side(twin).element) == Kind::Between {
            visit(twin);
            twin = self.side(self.opposite(twin)).twin;
        }
        twin
    }

    /// Begins a change, which may be taken back until the next one begins.
    pub fn begin(&mut self) {
        self.before.clear();
        self.lengths = [self.nodes.len(), self.sides.len(), self.elements.len(), self.added.len()];
    }

    /// Whether every element that a change made or touched has a positive volume.
    pub fn is_right(&self) -> bool {
        let old = self.before.iter().filter_map(|before| match before {
            Before::Element(element, _) => Some(*element),
            _ => None,
        });
        let new = self.lengths[2] as u32..self.elements.len() as u32;
        old.chain(new).all(|element| self.is_positive(element))
    }

    /// Undoes what was changed.
    pub fn take_back(&mut self) {
        while let Some(before) = self.before.pop() {
            match before {
                Before::Side(i, side) => self.sides[i as usize] = side,
                Before::Element(i, element) => self.elements[i as usize] = element,
                Before::Node(i, node) => self.nodes[i as usize] = node,
            }
        }
        let [nodes, sides, elements, added] = self.lengths;
        self.nodes.truncate(nodes);
        self.sides.truncate(sides);
        self.elements.truncate(elements);
        self.added.truncate(added);
    }

    /// Whether an element's volume is positive; that of a pyramid over more than a triangle stays so.
    fn is_positive(&self, element: u32) -> bool {
        let first = self.first(element);
        match self.kind(element) {
            Kind::Gone => true,
            Kind::Pyramid => {
                let base: Vec<u32> = self.ring(element).map(|side| self.ends(side)[1]).collect();
                let apex = self.boundary(self.ends(first)[0]);
                let [p, q, r] = [0, 1, 2].map(|i| self.inner(base[i]));
                base.len() > 3 || orient3d(apex, p, r, q) == Sign::Positive
            }
            Kind::Over => {
                let corners: Vec<u32> = self.ring(element).map(|side| self.ends(side)[0]).collect();
                self.is_over(self.ends(first)[1], [corners[0], corners[1], corners[2]])
            }
            Kind::Between => {
                let along = match self.is_along_inner(first) {
                    true => self.side(first).next,
                    false => first,
                };
                let [a, c] = self.ends(along);
                let [b, d] = self.ends(self.opposite(along));
                self.is_between([a, b], [c, d])
            }
        }
    }

    /// Where a vertex of the boundary is, one that was added as well.
    pub fn boundary(&self, v: u32) -> &Vec3 {
        let count = self.mesh.boundary.len();
        self.mesh.boundary.get(v as usize).unwrap_or_else(|| &self.added[v as usize - count])
    }

    /// The vertices of the boundary that were added.
    pub fn added(&self) -> &[Vec3] {
        &self.added
    }

    /// A new vertex of the boundary.
    pub fn add_boundary(&mut self, place: Vec3) -> u32 {
        self.added.push(place);
        (self.mesh.boundary.len() + self.added.len()) as u32 - 1
    }

    /// Where an inner vertex is.
    pub fn inner(&self, v: u32) -> &Vec3 {
        &self.mesh.inner[v as usize]
    }

    /// Whether a triangle of the boundary is seen from its inner side by an inner vertex.
    pub fn is_over(&self, v: u32, triangle: [u32; 3]) -> bool {
        let [p, q, r] = triangle.map(|corner| self.boundary(corner));
        orient3d(self.inner(v), p, q, r) == Sign::Positive
    }

    /// Whether the element between an edge of the boundary and an inner edge has a positive volume, when its ring goes along the one and then along the other.
    pub fn is_between(&self, [a, b]: [u32; 2], [c, d]: [u32; 2]) -> bool {
        orient3d(self.boundary(a), self.boundary(b), self.inner(c), self.inner(d)) == Sign::Positive
    }

    /// What one vertex is away from another, squared.
    pub fn squared(a: &Vec3, b: &Vec3) -> f64 {
        let away = sub(*a, *b);
        dot(away, away)
    }

    /// What the shell takes, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..])
            + size_of_val(&self.sides[..])
            + size_of_val(&self.elements[..])
            + size_of_val(&self.added[..])
    }

    pub fn set(&mut self, at: u32, change: impl FnOnce(&mut Side)) {
        if (at as usize) < self.lengths[1] {
            self.before.push(Before::Side(at, self.sides[at as usize]));
        }
        change(&mut self.sides[at as usize]);
    }

    pub fn set_inner(&mut self, node: u32, inner: u32) {
        if (node as usize) < self.lengths[0] {
            self.before.push(Before::Node(node, self.nodes[node as usize]));
        }
        self.nodes[node as usize][1] = inner;
    }

    /// Marks an element as changed, so that its volume is looked at.
    pub fn touch(&mut self, element: u32) {
        if (element as usize) < self.lengths[2] {
            self.before.push(Before::Element(element, self.elements[element as usize]));
        }
    }

    pub fn remove(&mut self, element: u32) {
        self.touch(element);
        self.elements[element as usize].kind = Kind::Gone;
    }

    pub fn add_node(&mut self, ends: [u32; 2]) -> u32 {
        self.nodes.push(ends);
        self.nodes.len() as u32 - 1
    }

    /// A new element, of which the sides have no twins. Returns the first.
    pub fn add(&mut self, kind: Kind, ring: &[u32]) -> u32 {
        let (first, count) = (self.sides.len() as u32, ring.len() as u32);
        let element = self.elements.len() as u32;
        self.elements.push(Element { kind, first, face: NONE });
        for (i, &node) in (0..).zip(ring) {
            let (next, previous) = (first + (i + 1) % count, first + (i + count - 1) % count);
            self.sides.push(Side { node, next, previous, twin: NONE, element, partner: NONE });
        }
        first
    }

    pub fn glue(&mut self, a: u32, b: u32) {
        self.set(a, |side| side.twin = b);
        self.set(b, |side| side.twin = a);
    }

    /// Gives all sides that begin where one does its node.
    pub fn unite_round(&mut self, side: u32) {
        let node = self.side(side).node;
        let mut at = side;
        loop {
            at = self.side(self.side(at).previous).twin;
            if at == side {
                break;
            }
            if self.side(at).node != node {
                self.set(at, |side| side.node = node);
            }
        }
    }
}
