//! Decisions
//!
//! Does a circle or a sphere hold a point of the medial axis? The gradient of the distance points away from what is nearest. Where two
//! points of a circle or sphere that no part of the boundary enters have gradients that do not go together, the medial axis passes between
//! them; how much such tests may miss in the plane is known. (Stolpner, Whitesides 2009, Medial axis approximation with bounded error.)

use super::boundary;
use super::handle::{self, medax_job, medax_sites};
use super::options::{self, Report, SizedStruct, sized_struct};
use super::status::medax_status;
use super::view::{self, Buffer};
use crate::distance::{DecideOptions, DecideTest, Decision, largest_missed_angle};
use crate::index::NONE;
use crate::job::Stage;
use std::f64::consts::PI;

/// Which test has found a medial point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum medax_decide_test {
    /// None: no conclusion can be drawn.
    None = 0,
    /// The gradients at a point and at its opposite differ.
    Opposite = 1,
    /// Those at two neighbours point to different sides of the line through them. In the plane only.
    Sides = 2,
    /// Between the opposites of two neighbours there are other points. In the plane only.
    Between = 3,
}

const _: () = assert!(DecideTest::Opposite as u32 == medax_decide_test::Opposite as u32);
const _: () = assert!(DecideTest::Sides as u32 == medax_decide_test::Sides as u32);
const _: () = assert!(DecideTest::Between as u32 == medax_decide_test::Between as u32);

/// How near is near, for the search of medial points.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_decide_options {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// Two nearest points no farther apart than this are the same, in input units. 0, the default, asks for 1e-9 of #medax_sites_size.
    pub tolerance: f64,
    /// How far a point that is found may be from the medial axis, in input units. 0, the default, asks for 1e-6 of that size.
    pub epsilon: f64,
}

sized_struct!(medax_decide_options, first_size: size_of::<medax_decide_options>(), reserved: none,
    { tolerance: f64 = 0.0, epsilon: f64 = 0.0 });

/// Sets the options of decisions to their defaults.
///
/// \param options The caller's struct, of `struct_size` bytes.
/// \param struct_size `sizeof *options`.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_decide_options_init(
    options: *mut medax_decide_options,
    struct_size: usize,
) -> medax_status {
    boundary::status(|| options::init(options, struct_size, "options"))
}

/// What is known of a circle or a sphere. The caller sets `struct_size`, the library the rest.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct medax_decision {
    /// The size of this struct in the caller's program.
    pub struct_size: usize,
    /// A medial point in the circle or sphere, in input units; 0 unless a test has found one.
    pub center: [f64; 3],
    /// Its distance from the boundary; 0 unless a test has found one.
    pub radius: f64,
    /// The angle between the ways to its two nearest points, in radians; 0 unless a test has found one.
    pub object_angle: f64,
    /// The two nearest points; 0 unless a test has found one.
    pub feet: [f64; 6],
    /// In the plane the longest arc between two neighbours of Theta, in input units; 0 in space.
    pub gap: f64,
    /// The number of points of Theta.
    pub theta_count: u64,
    /// How often a test fired of which no point came: these do not count.
    pub unconfirmed: u64,
    /// The pieces that have the two nearest points; `MEDAX_NONE` unless a test has found one.
    pub pieces: [u32; 2],
    /// A #medax_decide_test.
    pub test: u32,
    /// 0.
    pub reserved: u32,
}

sized_struct!(medax_decision, first_size: size_of::<medax_decision>(), reserved: none, {
    center: [f64; 3] = [0.0; 3],
    radius: f64 = 0.0,
    object_angle: f64 = 0.0,
    feet: [f64; 6] = [0.0; 6],
    gap: f64 = 0.0,
    theta_count: u64 = 0,
    unconfirmed: u64 = 0,
    pieces: [u32; 2] = [NONE; 2],
    test: u32 = medax_decide_test::None as u32,
    reserved: u32 = 0,
});

impl From<&Decision> for medax_decision {
    fn from(decision: &Decision) -> Self {
        let undetermined = medax_decision {
            gap: decision.gap,
            theta_count: decision.theta.len() as u64,
            unconfirmed: decision.unconfirmed as u64,
            ..Self::DEFAULT
        };
        let (Some(test), Some(point)) = (decision.test, decision.point) else {
            return undetermined;
        };
        let [[a, b, c], [d, e, f]] = point.feet;
        medax_decision {
            center: point.center,
            radius: point.radius,
            object_angle: point.object_angle,
            feet: [a, b, c, d, e, f],
            pieces: point.pieces,
            test: test as u32,
            ..undetermined
        }
    }
}

/// Whether a circle of the plane, or a sphere in space, which no part of the boundary enters, holds a point of the medial axis: DECIDEMA2D
/// and DECIDEMA3D of the paper.
///
/// The gradient is looked at in some points of the circle or sphere, Phi, and with each of them at its opposite, the other one on the line
/// to its nearest point: together these are Theta. What is not found may be there nonetheless: in the plane #medax_largest_missed_angle
/// says how much, in space nothing is known.
///
/// \param sites The sites.
/// \param center_xyz The 3 coordinates of the centre; in the plane z is 0.
/// \param radius The radius in input units.
/// \param directions `direction_count` x 3 coordinates: the ways from the centre to the points of Phi, of any length but 0, in the plane
///        with z 0; such as those of #medax_sites_even_directions. NULL only if `direction_count` is 0.
/// \param direction_count The number of directions, at most 2^16.
/// \param options NULL for the defaults.
/// \param job NULL for a default job.
/// \param theta_capacity The number of points for which `out_theta` has room; twice `direction_count` is always enough.
/// \param out_theta Receives the first `theta_capacity` points of Theta, 3 coordinates each; in the plane they go round counterclockwise.
///        The caller's buffer, NULL only if `theta_capacity` is 0.
/// \param out_decision Filled, its `struct_size` being set.
/// \return `MEDAX_STATUS_OK` whether a medial point was found or not; `INVALID_ARGUMENT` for a radius that is not greater than 0, for a
///         circle or sphere that the boundary enters, for options that are no lengths, and with its row for a direction without length or
///         out of the plane; `NON_FINITE` for the centre; `LIMIT_EXCEEDED` for too many directions; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
///         `OUT_OF_MEMORY`.
///
/// One or two queries for each direction, and in the plane for each at most a look at all of Theta. Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_decide(
    sites: *const medax_sites,
    center_xyz: *const f64,
    radius: f64,
    directions: *const f64,
    direction_count: usize,
    options: *const medax_decide_options,
    job: *const medax_job,
    theta_capacity: usize,
    out_theta: *mut f64,
    out_decision: *mut medax_decision,
) -> medax_status {
    boundary::status(|| {
        let sites = &handle::get(sites, "sites")?.sites;
        let center = view::rows::<f64, 3>(center_xyz, 1, "center_xyz")?[0];
        let directions = view::rows(directions, direction_count, "directions")?;
        let medax_decide_options { tolerance, epsilon, .. } = options::read(options, "options")?;
        let theta = Buffer::new(out_theta.cast::<[f64; 3]>(), theta_capacity, "out_theta")?;
        let report = Report::new(out_decision, "out_decision")?;
        let mut own = None;
        let decision = handle::job(job, &mut own).run(&[(Stage::Query, 1.0)], |run| {
            let options = DecideOptions { tolerance, epsilon };
            sites.decide_in(center, radius, directions, options, run)
        })?;
        theta.fill(&decision.theta);
        report.fill(&(&decision).into());
        Ok(())
    })
}

/// Directions spread evenly, for decisions.
///
/// In the plane they go round counterclockwise from that of x; in space they lie on a spiral from pole to pole, each the golden angle
/// further.
///
/// \param sites The sites, whose dimension counts.
/// \param count The number of directions.
/// \param out_directions Receives `count` x 3 coordinates: vectors of length 1; the caller's buffer, NULL only if `count` is 0.
/// \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a count that no memory holds.
///
/// O(count). Since 0.1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn medax_sites_even_directions(
    sites: *const medax_sites,
    count: usize,
    out_directions: *mut f64,
) -> medax_status {
    boundary::status(|| {
        let sites = &handle::get(sites, "sites")?.sites;
        let out = Buffer::new(out_directions.cast::<[f64; 3]>(), count, "out_directions")?;
        out.fill_with(sites.even_directions(count));
        Ok(())
    })
}

/// The largest object angle of a medial point that a circle of the plane can hold unnoticed: arcsin(L / 2R) + arcsin(L / d), theorem 10 of
/// the paper.
///
/// It holds for a circle that the boundary does not enter and in which no test found anything, and for points in the convex hull of Theta
/// of which both ways to the nearest points leave the hull at L or more from the point, and at L or more from the nearest points.
///
/// \param gap L, the longest arc between neighbours of Theta (#medax_decision).
/// \param radius R, that of the circle.
/// \param distance d, that of the point from the boundary; the least there is, if there are many.
/// \return An angle in radians; pi where there is no claim: where L >= 2R, d < 2L, or a number makes no sense.
///
/// Constant time. Since 0.1.
#[unsafe(no_mangle)]
pub extern "C" fn medax_largest_missed_angle(gap: f64, radius: f64, distance: f64) -> f64 {
    boundary::value(PI, || largest_missed_angle(gap, radius, distance).unwrap_or(PI))
}
