//! Inner or outer: the labels of poles.

use super::PowerCrustOptions;
use super::conflict;
use super::links::Links;
use super::spread::spread;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{Room, Run};
use crate::poles::Poles;
use crate::triangulation::Triangulation;

/// The side of the surface on which a pole lies. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Label {
    /// Outside the solid.
    Outer = 0,
    /// Inside the solid.
    Inner = 1,
}

impl Label {
    pub(super) fn opposite(self) -> Self {
        match self {
            Label::Outer => Label::Inner,
            Label::Inner => Label::Outer,
        }
    }
}

/// How poles are labelled. The numbers are the C ABI's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum LabelRule {
    /// As [`LabelRule::Spread`]; as [`LabelRule::LeastConflict`] if that leaves more conflict than [`CONFLICT_LIMIT`].
    #[default]
    Auto = 0,
    /// Labels spread from the far box, the most certain first, and are never taken back (Amenta, Choi, Kolluri 2001, Figure 8).
    Spread = 1,
    /// Then labels are changed until they contradict each other as little as can be found: what is wrong in one place does not
    /// spread.
    LeastConflict = 2,
}

/// How much conflict a pole [`LabelRule::Auto`] bears with. Clean samples have a tenth of that, noisy and one-sided ones
/// four times as much or more.
pub const CONFLICT_LIMIT: f64 = 0.005;

/// The labels, and how they came about.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Labelling {
    /// One label per pole.
    pub labels: Vec<Label>,
    /// How they came about.
    pub account: LabelAccount,
}

/// How the labels of a power crust came about.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LabelAccount {
    /// Whether a host or a mesh gave them: then no rule tells them.
    pub given: bool,
    /// The number of poles that no label reached, and that are outer for that reason.
    pub unreached: usize,
    /// The number of poles made outer because their power cells are unbounded.
    pub forced: usize,
    /// [`super::PowerCrust::conflict`].
    pub conflict: f64,
    /// [`super::PowerCrust::is_settled`].
    pub settled: bool,
}

/// Labels every pole. Cost: O((p + links) log p), and where labels are changed some minimum cuts.
pub(super) fn label_poles(
    poles: &Poles,
    regular: &Triangulation,
    options: &PowerCrustOptions,
    run: &Run<'_>,
) -> Result<Labelling> {
    let mut room = Room::new(run);
    let links = Links::of_poles(poles, regular, options, run)?;
    room.keep(links.bytes())?;
    run.tick(1, 2)?;
    let unbounded = unbounded_poles(regular, &mut room, run)?;
    let mut outside = room.filled(links.count(), false)?;
    match options.viewpoint {
        None => outside.copy_from_slice(poles.touches_far_box()),
        Some(_) => outside[poles.len()] = true,
    }
    // The paper's labels spread from the far box alone; all that is outside stays so when labels are changed.
    let mut sources = room.collect(outside.iter().copied())?;
    for &pole in &unbounded {
        outside[pole as usize] = true;
    }
    if options.viewpoint.is_some() {
        sources.copy_from_slice(&outside);
    }
    let spread = spread(&links, &sources, &mut room, run)?;
    let mut account = LabelAccount {
        unreached: spread.iter().filter(|label| label.is_none()).count(),
        ..LabelAccount::default()
    };
    let labelled = spread.iter().map(|label| label.unwrap_or(Label::Outer));
    let mut labels: Vec<Label> = room.collect(labelled)?;
    let limit = match options.label_rule {
        LabelRule::Auto => CONFLICT_LIMIT,
        LabelRule::Spread => f64::INFINITY,
        LabelRule::LeastConflict => 0.0,
    };
    account.conflict = conflict::of(&links, &labels, run)?;
    if account.conflict > limit {
        conflict::settle(&links, &outside, &mut labels, run)?;
        account.conflict = conflict::of(&links, &labels, run)?;
        account.settled = true;
    }
    labels.truncate(poles.len());
    account.forced = force(&unbounded, &mut labels);
    Ok(Labelling { labels, account })
}

/// Makes the poles with unbounded power cells outer, and returns how many were inner.
pub(super) fn force_outer(
    regular: &Triangulation,
    labels: &mut [Label],
    run: &Run<'_>,
) -> Result<usize> {
    let unbounded = unbounded_poles(regular, &mut Room::new(run), run)?;
    Ok(force(&unbounded, labels))
}

fn force(unbounded: &[u32], labels: &mut [Label]) -> usize {
    let mut forced = 0;
    for &pole in unbounded {
        let label = &mut labels[pole as usize];
        forced += usize::from(*label == Label::Inner);
        *label = Label::Outer;
    }
    forced
}

/// The poles whose power cells are unbounded: those on the hull of the regular triangulation,
/// each once, ascending by vertex.
pub(super) fn unbounded_poles(
    regular: &Triangulation,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<u32>> {
    let mut on_hull = room.filled(regular.coords().len(), false)?;
    for cell in run.watch(regular.cells().iter().zip(regular.neighbors())) {
        let (cell, neighbors) = cell?;
        for slot in (0..4).filter(|&slot| neighbors[slot] == NONE) {
            for other in (0..4).filter(|&other| other != slot) {
                on_hull[cell[other] as usize] = true;
            }
        }
    }
    let mut poles = Vec::new();
    for vertex in (0..on_hull.len()).filter(|&v| on_hull[v]) {
        room.push(&mut poles, regular.row_of_vertex()[vertex])?;
    }
    Ok(poles)
}
