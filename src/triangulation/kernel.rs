//! The inner loops of construction, compiled for every processor and for those with AVX2, and chosen
//! at run time.
#![allow(unsafe_code)]

use super::cavity::{Cavity, Found};
use super::cells::{Cell, Patch, Slots};
use super::star::Star;
use super::walk;
use crate::job::Run;
use crate::predicates::around::Site;
use crate::predicates::lanes::Portable;
#[cfg(target_arch = "x86_64")]
use crate::predicates::processor::Avx2;
use crate::predicates::processor::Processor;

/// [`walk::locate`] as fast as the processor can.
#[inline]
pub(super) fn locate<S: Site, const SHARED: bool>(
    processor: Processor,
    patch: &Patch<'_>,
    sites: &[S],
    start: Cell,
    point: &S,
) -> Option<Cell> {
    match processor {
        Processor::Any => walk::locate::<Portable, S, SHARED>(patch, sites, start, point),
        #[cfg(target_arch = "x86_64")]
        Processor::Avx2 => {
            // SAFETY: this processor is named only where it was detected, and has all that the function is
            // compiled for; there is no other condition.
            unsafe { locate_avx2::<S, SHARED>(patch, sites, start, point) }
        }
    }
}

/// [`Cavity::search`] as fast as the processor can.
#[inline]
pub(super) fn search<S: Site, const SHARED: bool>(
    processor: Processor,
    cavity: &mut Cavity,
    patch: &mut Patch<'_>,
    sites: &[S],
    vertex: u32,
    start: Cell,
    run: &Run<'_>,
) -> crate::error::Result<Found> {
    match processor {
        Processor::Any => cavity.search::<Portable, S, SHARED>(patch, sites, vertex, start, run),
        #[cfg(target_arch = "x86_64")]
        Processor::Avx2 => {
            // SAFETY: as in `locate`.
            unsafe { search_avx2::<S, SHARED>(cavity, patch, sites, vertex, start, run) }
        }
    }
}

/// [`Star::fill`] as fast as the processor can.
#[inline]
pub(super) fn fill(
    processor: Processor,
    star: &mut Star,
    cavity: &Cavity,
    patch: &mut Patch<'_>,
    slots: &mut Slots,
    vertex: u32,
) -> Cell {
    match processor {
        Processor::Any => star.fill::<Portable>(cavity, patch, slots, vertex),
        #[cfg(target_arch = "x86_64")]
        Processor::Avx2 => {
            // SAFETY: as in `locate`.
            unsafe { fill_avx2(star, cavity, patch, slots, vertex) }
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,popcnt")]
fn fill_avx2(
    star: &mut Star,
    cavity: &Cavity,
    patch: &mut Patch<'_>,
    slots: &mut Slots,
    vertex: u32,
) -> Cell {
    star.fill::<Avx2>(cavity, patch, slots, vertex)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,popcnt")]
fn locate_avx2<S: Site, const SHARED: bool>(
    patch: &Patch<'_>,
    sites: &[S],
    start: Cell,
    point: &S,
) -> Option<Cell> {
    walk::locate::<Avx2, S, SHARED>(patch, sites, start, point)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,popcnt")]
fn search_avx2<S: Site, const SHARED: bool>(
    cavity: &mut Cavity,
    patch: &mut Patch<'_>,
    sites: &[S],
    vertex: u32,
    start: Cell,
    run: &Run<'_>,
) -> crate::error::Result<Found> {
    cavity.search::<Avx2, S, SHARED>(patch, sites, vertex, start, run)
}
