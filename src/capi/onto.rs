//! Pair-mesh of a part
//!
//! A pair-mesh between the boundary of a solid and a part of its Voronoi diagram: a filtered medial axis, or a core. What is not
//! asked for is collapsed, as long as no element gets folded. (Shaham, Shamir, Cohen-Or 2004, section 4.)

use super::boundary;
use super::handle::{self, medax_complex, medax_job, medax_pair};
use super::options::{self, flag, sized_struct};
use super::status::medax_status;
use super::view::{Buffer, Out};
use crate::error::Result;
use crate::pair::{PairOntoOptions, PairReason};

/// Why a face or a loose edge of the inner structure is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_pair_reason {
    /// It was asked for.
    Asked = 0,
    /// None of its edges, or ends, is free: it closes a hole of what was asked for, joins parts of it, or lies behind what stays.
    Enclosed = 1,
    /// Something of it is free, but without it an element would be folded: some of the boundary would see nothing.
    Unseen = 2,
}

impl From<PairReason> for medax_pair_reason {
    fn from(reason: PairReason) -> Self {
        match reason {
            PairReason::Asked => medax_pair_reason::Asked,
            PairReason::Enclosed => medax_pair_reason::Enclosed,
            PairReason::Unseen => medax_pair_reason::Unseen,
        }
    }
}

/// How a pair-mesh is brought onto a part of its inner structure.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_pair_onto_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// 1 to divide triangles of the boundary round their centroids, at the middles of their edges, where no more goes without; 0, the default,
    /// not to. The boundary stays where it is, but has more vertices, of which the sample is `MEDAX_NONE`. Where it touches itself in an edge, the sheets there
    /// may be divided at different vertices.
    pub subdivide: u32,
    /// 1 to fail where anything stays that was not asked for, or what was is not there; 0, the default, not to.
    pub exact: u32,
}

sized_struct!(medax_pair_onto_options, first_size: size_of::<medax_pair_onto_options>(), reserved: none,
    { subdivide: u32 = 0, exact: u32 = 0 });

impl medax_pair_onto_options {
    fn translate(&self) -> Result<PairOntoOptions> {
        let subdivide = flag(self.subdivide, "subdivide")?;
        Ok(PairOntoOptions { subdivide, exact: flag(self.exact, "exact")? })
    }
}

/// Sets the options to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_onto_options_init(
    options: *mut medax_pair_onto_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// The pair-mesh of a part of the inner structure: of the Voronoi facets and edges in which a complex lies, such as the axis of a
/// #medax_medial, or a core, of the same samples. Of its faces and loose edges only the attribute `samples` counts; a complex without either
/// asks for nothing, and so for as little as can be.
///
/// What is not asked for is collapsed, bit by bit, as long as no element gets folded. So it always succeeds: where no more can go, the rest
/// stays, and #medax_pair_reasons tells what stood in the way. The search is local, so that another order might leave less. Faces that stay unasked are
/// triangles, and their corners may have moved into others. What was asked for and is not there counts in #medax_pair_missing.
///
/// \param pair A pair-mesh of #medax_pair_voronoi. It stays as it is.
/// \param part A complex of which the faces have an attribute `samples` of two indices, and the loose edges one of three.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param out_pair Receives the pair-mesh, which the caller frees with #medax_pair_free.
/// \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for faces or loose edges without `samples`, an option out of range, or a pair-mesh that is a part
///         already, or deformed; `DEGENERATE` where it was to be exact and something is missing, or stays unasked: then with the first such face; `LIMIT_EXCEEDED` past 2^32 - 2 sides; `NULL_ARGUMENT`, `CANCELLED`,
///         `BUSY`, `OUT_OF_MEMORY`.
///
/// O(size log size) where few changes are refused. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_onto(
    pair: *const medax_pair,
    part: *const medax_complex,
    options: *const medax_pair_onto_options,
    job: *const medax_job,
    out_pair: *mut *const medax_pair,
) -> medax_status {
    boundary::status(|| {
        let pair = &handle::get(pair, "pair")?.pair;
        let part = &handle::get(part, "part")?.complex;
        let options = options::read(options, "options")?.translate()?;
        let out = Out::new(out_pair, "out_pair")?;
        let mut own = None;
        let pair = pair.onto(part, options, handle::job(job, &mut own))?;
        out.put(handle::new(medax_pair { pair }));
        Ok(())
    })
}

/// The number of Voronoi facets and edges asked for that the inner structure does not have: they are of another diagram, outside, or of samples that
/// were removed.
///
/// \param pair The pair-mesh; NULL lacks none.
/// \return A count, 0 for a pair-mesh of #medax_pair_voronoi.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_missing(pair: *const medax_pair) -> usize {
    boundary::value(0, || handle::maybe(pair).map_or(0, |p| p.pair.missing()))
}

/// Why each face of the inner structure is there. The loose edges that were not asked for have theirs in the complex of #medax_pair_inner.
///
/// \param pair The pair-mesh.
/// \param out_reasons Receives a #medax_pair_reason for each row of #medax_pair_inner_faces.
/// \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
///
/// O(faces). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_pair_reasons(
    pair: *const medax_pair,
    out_reasons: *mut u32,
) -> medax_status {
    boundary::status(|| {
        let pair = &handle::get(pair, "pair")?.pair;
        let count = pair.inner_faces().len();
        let out = Buffer::new(out_reasons, count, "out_reasons")?;
        let given = pair.reasons().iter().copied();
        let reasons: Vec<u32> = given
            .chain(std::iter::repeat(PairReason::Asked))
            .take(count)
            .map(|reason| medax_pair_reason::from(reason) as u32)
            .collect();
        out.fill(&reasons);
        Ok(())
    })
}
