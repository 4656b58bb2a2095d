//! Smaller triangles of the boundary beside a strip, so that there are more paths for it (Shaham, Shamir, Cohen-Or, section 4).

use super::reroute::Region;
use super::shell::{Kind, Shell};
use super::surgery::Strip;
use crate::vector::{add, scale};
use std::collections::HashMap;

impl Shell<'_> {
    /// Divides the triangles on both sides of a strip round their centroids, at the middles of the edges between them.
    pub fn subdivide(&mut self, strip: &Strip, region: &Region) {
        // The middle of each edge: its node, or those at both ends of the strip's inner edge. Sides without one stay whole.
        let mut middle: HashMap<u32, u32> = HashMap::new();
        let mut outside: Vec<[u32; 2]> = Vec::new();
        for (&first, &second) in strip.at_first.iter().zip(&strip.at_second) {
            let twins = [first, second].map(|at| self.side(at).twin);
            if twins.iter().all(|&at| region.of.contains_key(&self.side(at).element)) {
                let vertex = self.add_middle(first);
                for (at, own) in twins.into_iter().zip([first, second]) {
                    let inner = self.ends(own)[1];
                    let node = self.add_node([vertex, inner]);
                    middle.insert(at, node);
                    middle.insert(own, node);
                }
            }
        }
        for &element in region.of.keys() {
            for at in self.ring(element).collect::<Vec<_>>() {
                let twin = self.side(at).twin;
                if middle.contains_key(&at) {
                    continue;
                }
                if region.of.contains_key(&self.side(twin).element) {
                    let vertex = self.add_middle(at);
                    let node = self.add_node([vertex, self.ends(at)[1]]);
                    middle.insert(at, node);
                    middle.insert(twin, node);
                } else {
                    outside.push([at, twin]);
                }
            }
        }
        // The sides of what is new, by their nodes.
        let mut new: HashMap<[u32; 2], u32> = HashMap::new();
        for &element in region.of.keys() {
            let sides: Vec<u32> = self.ring(element).collect();
            let corners = [0, 1, 2].map(|i| *self.boundary(self.ends(sides[i])[0]));
            let sum = corners.into_iter().fold([0.0; 3], add);
            let vertex = self.add_boundary(scale(sum, 1.0 / 3.0));
            let center = self.add_node([vertex, self.ends(sides[0])[1]]);
            let mut rim: Vec<u32> = Vec::new();
            for &at in &sides {
                rim.push(self.side(at).node);
                rim.extend(middle.get(&at));
            }
            let mut firsts: Vec<u32> = Vec::new();
            for (&from, &to) in rim.iter().zip(rim.iter().cycle().skip(1)) {
                let first = self.add(Kind::Over, &[center, from, to]);
                new.insert([from, to], first + 1);
                firsts.push(first);
            }
            for (&one, &two) in firsts.iter().zip(firsts.iter().cycle().skip(1)) {
                self.glue(one + 2, two);
            }
        }
        for (&first, &second) in strip.at_first.iter().zip(&strip.at_second) {
            let Some(&middle_first) = middle.get(&first) else { continue };
            let middle_second = middle[&second];
            let [x, y, back_y, back_x] = {
                let mut nodes = [0; 4];
                let mut at = first;
                for node in &mut nodes {
                    *node = self.side(at).node;
                    at = self.side(at).next;
                }
                nodes
            };
            let element = self.side(first).element;
            let [at_y, at_x] =
                [self.side(first).next, self.side(first).previous].map(|side| self.side(side).twin);
            self.remove(element);
            let one = self.add(Kind::Between, &[x, middle_first, middle_second, back_x]);
            let two = self.add(Kind::Between, &[middle_first, y, back_y, middle_second]);
            self.glue(one + 1, two + 3);
            self.glue(one + 3, at_x);
            self.glue(two + 1, at_y);
            for at in [one, one + 2, two, two + 2] {
                let ends = [self.side(at).node, self.side(self.side(at).next).node];
                new.insert(ends, at);
            }
        }
        for &element in region.of.keys() {
            self.remove(element);
        }
        for [at, twin] in outside {
            let ends = [self.side(at).node, self.side(self.side(at).next).node];
            self.glue(new[&ends], twin);
        }
        let mut pairs: Vec<[u32; 2]> = new
            .iter()
            .filter_map(|(&[from, to], &at)| new.get(&[to, from]).map(|&twin| [at, twin]))
            .filter(|[at, twin]| at < twin)
            .collect();
        pairs.sort_unstable();
        for [at, twin] in pairs {
            self.glue(at, twin);
        }
    }

    /// A vertex of the boundary in the middle of a side.
    fn add_middle(&mut self, side: u32) -> u32 {
        let ends = [side, self.side(side).next].map(|at| *self.boundary(self.ends(at)[0]));
        self.add_boundary(scale(add(ends[0], ends[1]), 0.5))
    }
}
