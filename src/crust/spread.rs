//! Labels spread from the far box, the most certain first (Amenta, Choi, Kolluri 2001, section 5.2 and Figure 8).

use super::label::Label;
use super::links::{Link, Links};
use super::queue::Queue;
use crate::error::Result;
use crate::job::{Room, Run};

/// What the labels given so far say of a pole: a belief in [0, 1] for either label, by its number.
type Belief = [f64; 2];

/// Figure 8, Update_Priority: a confused pole waits.
fn priority([outer, inner]: Belief) -> f64 {
    if inner > 0.0 && outer > 0.0 { (inner - outer).abs() - 1.0 } else { inner.max(outer) }
}

/// The label of every pole that labels reach, given those that are outside.
///
/// A pole enters the queue when a label first reaches it, as in the authors' program: Figure 8
/// read literally would label unreached poles, with priority 0, before the confused ones that might
/// still reach them. Cost: O((p + links) log p).
pub(super) fn spread(
    links: &Links,
    outside: &[bool],
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<Option<Label>>> {
    let count = outside.len();
    let mut beliefs = room.filled(count, Belief::default())?;
    let mut labels: Vec<Option<Label>> = room.filled(count, None)?;
    let mut queue = Queue::new(count, room)?;
    for pole in run.watch(0..count as u32) {
        let pole = pole?;
        if outside[pole as usize] {
            beliefs[pole as usize][Label::Outer as usize] = 1.0;
            queue.put(pole, 1.0);
        }
    }
    let mut done = 0;
    while let Some(pole) = queue.pop() {
        let p = pole as usize;
        let [outer, inner] = beliefs[p];
        if done % 1024 == 0 {
            run.tick(count + done, 2 * count)?;
        }
        done += 1;
        let label = if inner > outer { Label::Inner } else { Label::Outer };
        let strength = inner.max(outer);
        labels[p] = Some(label);
        // Nothing raises that any more.
        beliefs[p] = [f64::INFINITY; 2];
        pass_on(links.of(pole), label, strength, &mut beliefs, &mut queue);
    }
    Ok(labels)
}

/// Passes a label on to the poles that are linked to its own.
fn pass_on(links: &[Link], label: Label, strength: f64, beliefs: &mut [Belief], queue: &mut Queue) {
    let raised = |link: &Link| {
        let to = if link.weight < 0.0 { label.opposite() } else { label };
        (to as usize, strength * link.weight.abs())
    };
    for link in links {
        let (to, raised) = raised(link);
        let belief = &mut beliefs[link.other as usize];
        if raised <= belief[to] {
            continue;
        }
        let before = priority(*belief);
        belief[to] = raised;
        let priority = priority(*belief);
        if priority != before {
            queue.put(link.other, priority);
        }
    }
}
