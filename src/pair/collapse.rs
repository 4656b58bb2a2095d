//! The order in which an inner structure is collapsed onto what of it is asked for.

use super::shell::{Kind, Refusal, Shell};
use super::surgery::Strip;
use super::target::Target;
use crate::error::{Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The sides that a vertex which moves may have at its nodes: what is looked at is bounded.
const MOST_SIDES: usize = 4000;
/// The rounds in which faces that could not be collapsed are tried again.
const FACE_ROUNDS: usize = 4;
/// The triangles on either side of a strip among which it may have another path, and those that are divided for it.
const REACH: [usize; 2] = [48, 8];

/// What may be done next, the least distance first: a face be collapsed from the free edge at a side of its pyramid (false), or the inner vertex where a side begins move into another (true).
type Candidate = Reverse<(u64, u32, bool)>;

/// Vertices that are not asked for move into others next to them, faces collapse from their free edges, as long as no element gets folded. Each change is local, and taken back where it
/// would fold one: so at all times there is a valid pair-mesh.
pub(super) struct Collapse<'a, 'r> {
    pub shell: Shell<'a>,
    target: &'a Target,
    /// Whether triangles may be divided yet, and whether they are.
    may_divide: bool,
    divides: bool,
    waiting: BinaryHeap<Candidate>,
    /// The vertices that are listed for the next round, and for each vertex a side that begins there, or [`NONE`] if it is not listed.
    listed: Vec<u32>,
    side_of: Vec<u32>,
    /// The free edges from which faces could not be collapsed in this round, and how many rounds there were.
    refused: Vec<u32>,
    rounds: usize,
    room: Room<'r>,
    run: &'r Run<'r>,
}

impl<'a, 'r> Collapse<'a, 'r> {
    /// Errors: those of the job; [`Status::LimitExceeded`] past 2^32 - 2 sides.
    pub fn run(
        shell: Shell<'a>,
        target: &'a Target,
        subdivide: bool,
        run: &'r Run<'r>,
    ) -> Result<Shell<'a>> {
        let mut room = Room::new(run);
        let count = target.is_fixed.len();
        let mut its = Collapse {
            shell,
            target,
            may_divide: subdivide,
            divides: false,
            waiting: BinaryHeap::new(),
            listed: room.vec(count)?,
            side_of: room.filled(count, NONE)?,
            refused: Vec::new(),
            rounds: 0,
            room,
            run,
        };
        for element in 0..its.shell.element_count() {
            run.poll()?;
            if its.shell.kind(element) == Kind::Pyramid {
                its.offer_face(element);
            }
            for side in its.shell.sides_of(element) {
                its.offer_vertex(side);
            }
        }
        let mut charged = 0;
        while let Some(Reverse((_, side, is_vertex))) = its.next()? {
            run.poll()?;
            match (its.shell.kind(its.shell.side(side).element), is_vertex) {
                (Kind::Gone, _) => {}
                (_, false) => its.try_face(side),
                (_, true) => its.try_vertex(side),
            }
            if its.shell.side_count() >= NONE as usize {
                return Err(Error::new(Status::LimitExceeded, "more than 2^32 - 2 sides"));
            }
            let bytes = its.shell.bytes() + its.waiting.len() * size_of::<Candidate>();
            its.room.keep(bytes.saturating_sub(charged))?;
            charged = charged.max(bytes);
        }
        Ok(its.shell)
    }

    /// Lists a face with each free edge that it has, if it need not stay.
    fn offer_face(&mut self, element: u32) {
        let is_gone = self.shell.kind(element) == Kind::Gone;
        if is_gone || self.target.is_asked(self.shell.face(element)) {
            return;
        }
        for side in self.shell.sides_of(element) {
            let partner = self.shell.side(side).partner;
            if self.shell.beyond(side, |_| {}) == partner {
                let [a, b] = [side, partner].map(|side| self.shell.ends(side)[0]);
                let squared = Shell::squared(self.shell.boundary(a), self.shell.boundary(b));
                self.waiting.push(Reverse((squared.to_bits(), side, false)));
            }
        }
    }

    /// Lists the inner vertex where a side begins for the next round, if it may move.
    fn offer_vertex(&mut self, side: u32) {
        let v = self.shell.ends(side)[1];
        if self.target.is_fixed[v as usize] {
            return;
        }
        if std::mem::replace(&mut self.side_of[v as usize], side) == NONE {
            self.listed.push(v);
        }
    }

    /// What is to be done next. Where nothing waits a new round begins, with the vertices of which the surroundings have changed; and where there are none, triangles are divided, if they may be.
    fn next(&mut self) -> Result<Option<Candidate>> {
        if self.waiting.is_empty() {
            self.rounds += 1;
            let refused = std::mem::take(&mut self.refused);
            let again = if self.rounds <= FACE_ROUNDS { refused } else { Vec::new() };
            for side in self.run.watch(again) {
                self.offer_face(self.shell.side(side?).element);
            }
            for v in self.run.watch(std::mem::take(&mut self.listed)) {
                let v = v?;
                let side = std::mem::replace(&mut self.side_of[v as usize], NONE);
                let b = self.shell.ends(side)[0];
                let squared = Shell::squared(self.shell.boundary(b), self.shell.inner(v));
                self.waiting.push(Reverse((squared.to_bits(), side, true)));
            }
            if self.waiting.is_empty() && std::mem::take(&mut self.may_divide) {
                (self.divides, self.rounds) = (true, 0);
                for element in 0..self.shell.element_count() {
                    self.run.poll()?;
                    if self.shell.kind(element) == Kind::Pyramid {
                        self.offer_face(element);
                    }
                }
            }
        }
        Ok(self.waiting.pop())
    }

    /// Lists what may be done now round the inner edge that a side runs along: its ends, and the next face.
    fn offer_round(&mut self, side: u32) {
        if self.shell.kind(self.shell.side(side).element) == Kind::Gone {
            return;
        }
        self.offer_vertex(side);
        self.offer_vertex(self.shell.side(side).next);
        let mut at = side;
        loop {
            match self.shell.kind(self.shell.side(at).element) {
                Kind::Pyramid => return self.offer_face(self.shell.side(at).element),
                Kind::Between if self.shell.is_along_inner(at) => {
                    at = self.shell.side(self.shell.opposite(at)).twin;
                    if at == side {
                        return;
                    }
                }
                _ => return,
            }
        }
    }

    fn change(
        &mut self,
        change: impl FnOnce(&mut Shell<'a>) -> std::result::Result<(), Refusal>,
    ) -> bool {
        self.shell.begin();
        if change(&mut self.shell).is_ok() && self.shell.is_right() {
            return true;
        }
        self.shell.take_back();
        false
    }

    fn try_face(&mut self, side: u32) {
        let ends = [side, self.shell.side(side).next].map(|at| self.shell.ends(at)[1]);
        if self.target.is_edge_asked(ends) {
            return;
        }
        let Some(strip) = self.shell.strip(side) else { return };
        let element = self.shell.side(side).element;
        let beside: Vec<u32> =
            self.shell.sides_of(element).iter().map(|&at| self.shell.side(at).twin).collect();
        let done = self.change(|shell| shell.collapse_face(side, &strip))
            || self.change(|shell| collapse_elsewhere(shell, side, &strip))
            || self.divides
                && self.change(|shell| {
                    let region = shell.region(&strip, REACH[1]);
                    shell.subdivide(&strip, &region);
                    let strip = shell.strip(side).ok_or(Refusal)?;
                    collapse_elsewhere(shell, side, &strip)
                });
        if !done {
            self.refused.push(side);
        } else {
            beside.into_iter().for_each(|at| self.offer_round(at));
        }
    }

    fn try_vertex(&mut self, side: u32) {
        // What was listed may have moved into a vertex that stays.
        let v = self.shell.ends(side)[1];
        if self.target.is_fixed[v as usize] {
            return;
        }
        let Some(star) = self.shell.star(side, MOST_SIDES) else { return };
        let shell = &self.shell;
        let away = |w: u32| Shell::squared(shell.inner(v), shell.inner(w)).to_bits();
        let mut ends: Vec<(u64, u32)> = star.ends.iter().map(|&w| (away(w), w)).collect();
        ends.sort_unstable();
        for (_, w) in ends {
            let mut meeting = Vec::new();
            let done = self.change(|shell| {
                meeting = shell.contract(&star, w)?;
                Ok(())
            });
            if !done {
                continue;
            }
            meeting.into_iter().for_each(|at| self.offer_round(at));
            for &element in &star.elements {
                match self.shell.kind(element) {
                    Kind::Gone => continue,
                    Kind::Pyramid => self.offer_face(element),
                    _ => {}
                }
                for side in self.shell.sides_of(element) {
                    self.offer_vertex(side);
                }
            }
            return;
        }
    }
}

/// Collapses a face along another path of the boundary.
fn collapse_elsewhere(
    shell: &mut Shell<'_>,
    side: u32,
    strip: &Strip,
) -> std::result::Result<(), Refusal> {
    shell.reroute(side, strip, REACH[0]).ok_or(Refusal)?;
    let strip = shell.strip(side).ok_or(Refusal)?;
    shell.collapse_face(side, &strip)
}
