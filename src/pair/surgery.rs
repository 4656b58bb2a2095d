//! The changes by which an inner structure loses a face or an edge, and the elements round it close up.

use super::shell::{Kind, Refusal, Shell};

type Done = std::result::Result<(), Refusal>;

/// The strip of elements between edges over a free inner edge, from one pyramid of its only face to the other.
pub(super) struct Strip {
    /// Its elements' sides along the boundary, at the first end of the inner edge and at the second, these the other way round.
    pub at_first: Vec<u32>,
    pub at_second: Vec<u32>,
    /// The vertices of the boundary from apex to apex.
    pub path: Vec<u32>,
}

impl Shell<'_> {
    /// The strip over the inner edge of a pyramid's side, if nothing but that pyramid's face has that edge.
    pub fn strip(&self, side: u32) -> Option<Strip> {
        let (mut at_first, mut at_second) = (Vec::new(), Vec::new());
        let end = self.beyond(side, |twin| {
            at_first.push(self.side(twin).next);
            at_second.push(self.side(twin).previous);
        });
        if end != self.side(side).partner || at_first.is_empty() {
            return None;
        }
        let mut path: Vec<u32> = at_first.iter().map(|&side| self.ends(side)[0]).collect();
        path.push(self.ends(end)[0]);
        Some(Strip { at_first, at_second, path })
    }

    /// Takes away a face and its free edge: its two pyramids and the strip over that edge make room for a strip over each of its other edges, along the same path of the boundary.
    pub fn collapse_face(&mut self, side: u32, strip: &Strip) -> Done {
        let [face, other] = [side, self.side(side).partner].map(|side| self.side(side).element);
        let ring: Vec<u32> = std::iter::successors(Some(side), |&at| {
            Some(self.side(at).next).filter(|&next| next != side)
        })
        .collect();
        let count = ring.len();
        let steps = strip.at_first.len();
        // The nodes over each corner of the face, from apex to apex; the last corner is the first again.
        let mut nodes: Vec<Vec<u32>> = Vec::with_capacity(count + 1);
        let ends = |sides: &[u32]| -> Vec<u32> {
            let firsts = sides.iter().map(|&side| self.side(side).node);
            firsts.chain(sides.last().map(|&side| self.side(self.side(side).next).node)).collect()
        };
        let at_first = ends(&strip.at_first);
        let backward: Vec<u32> = strip.at_second.iter().rev().copied().collect();
        let mut at_second = ends(&backward);
        at_second.reverse();
        nodes.push(at_first.clone());
        nodes.push(at_second);
        for &at in &ring[2..] {
            let corner = self.ends(at)[1];
            let before = self.side(at).previous;
            let mut row = vec![self.side(at).node];
            for &v in &strip.path[1..steps] {
                row.push(self.add_node([v, corner]));
            }
            // The partner of the side before runs back from this corner.
            row.push(self.side(self.side(before).partner).node);
            nodes.push(row);
        }
        nodes.push(at_first);
        let beside: Vec<[u32; 2]> = ring
            .iter()
            .map(|&at| [self.side(at).twin, self.side(self.side(at).partner).twin])
            .collect();
        let round = |sides: &[u32]| -> Vec<u32> {
            sides.iter().map(|&side| self.side(side).twin).collect()
        };
        let (outside_first, outside_second) = (round(&strip.at_first), round(&strip.at_second));
        for &at in &strip.at_first {
            self.remove(self.side(at).element);
        }
        self.remove(face);
        self.remove(other);
        let mut above = outside_second;
        for j in 1..count {
            let mut behind = beside[j][0];
            let mut next_above = Vec::with_capacity(steps);
            for i in 0..steps {
                let its = [nodes[j][i], nodes[j + 1][i], nodes[j + 1][i + 1], nodes[j][i + 1]];
                let first = self.add(Kind::Between, &its);
                self.glue(first, behind);
                self.glue(first + 3, above[i]);
                behind = first + 2;
                next_above.push(first + 1);
            }
            self.glue(behind, beside[j][1]);
            above = next_above;
        }
        for (&a, &b) in above.iter().zip(&outside_first) {
            self.glue(a, b);
        }
        for [one, two] in &beside[1..] {
            self.zip_all(*one)?;
            self.zip_all(*two)?;
        }
        Ok(())
    }

    /// Zips as long as the strip runs back on itself at one of its sides.
    pub fn zip_all(&mut self, mut side: u32) -> Done {
        while let Some(next) = self.zip(side)? {
            side = next;
        }
        Ok(())
    }

    /// Closes up two elements that lie between the same edges, one back on the other, if a side is between two such. Returns the side between what is then beside each other.
    fn zip(&mut self, side: u32) -> std::result::Result<Option<u32>, Refusal> {
        let twin = self.side(side).twin;
        let [one, two] = [side, twin].map(|side| self.side(side).element);
        if self.kind(one) != Kind::Between || self.kind(two) != Kind::Between {
            return Ok(None);
        }
        let (far, back) = (self.opposite(side), self.opposite(twin));
        if self.ends(far)[0] != self.ends(back)[0] {
            return Ok(None);
        }
        let (before, behind) = (self.side(far).twin, self.side(back).twin);
        let is_closed = before == back;
        let at_first = [self.side(side).previous, self.side(twin).next];
        let at_second = [self.side(twin).previous, self.side(side).next];
        self.remove(one);
        self.remove(two);
        if !is_closed {
            self.glue(before, behind);
        }
        let mut empty = 0;
        for [a, b] in [at_first, at_second] {
            if self.side(a).twin == b {
                empty += 1;
                continue;
            }
            if !is_closed && self.side(a).node == self.side(self.side(b).next).node {
                return Err(Refusal);
            }
            self.glue(self.side(a).twin, self.side(b).twin);
        }
        if is_closed {
            // The strip goes round an end that sees nothing: that is gone, too.
            return if empty == 1 { Ok(None) } else { Err(Refusal) };
        }
        self.unite_round(before);
        self.unite_round(behind);
        Ok(Some(before))
    }
}
