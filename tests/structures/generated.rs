//! Generated sets: the properties that every structure has on every input, with the smallest set that
//! breaks one where one is broken.

use crate::triangulation::brute_force;
use medax::dual::DualOptions;
use medax::{Dual, Job, Points, Poles, PowerCrust, Status, Triangulation, Validation};
use proptest::prelude::*;
use std::sync::Arc;

/// A set of points, and a weight for each.
type Weighted = (Vec<[f64; 3]>, Vec<f64>);

/// A number moved by so many units in the last place; zero stays, since what is next to it is too small
/// for a coordinate.
fn moved(x: f64, ulps: i8) -> f64 {
    let ulps = if x == 0.0 { 0 } else { ulps };
    (0..ulps.abs()).fold(x, |x, _| if ulps < 0 { x.next_down() } else { x.next_up() })
}

/// Small integers: nearly every predicate is a tie.
fn lattice() -> impl Strategy<Value = Weighted> {
    let row = (prop::array::uniform3(0i8..4), 0i8..3)
        .prop_map(|(p, w)| (p.map(f64::from), f64::from(w) / 2.0));
    prop::collection::vec(row, 5..20).prop_map(|rows| rows.into_iter().unzip())
}

/// The same scaled, shifted and moved by ulps: nothing is a tie, and everything nearly so.
fn shaken_lattice() -> impl Strategy<Value = Weighted> {
    let ulps = || -2i8..3;
    let row = (prop::array::uniform3((0i8..4, ulps())), (0i8..3, ulps()));
    let rows = prop::collection::vec(row, 5..20);
    let shift = prop::array::uniform3(prop_oneof![Just(0.0), Just(1.0), Just(1e9), -10.0..10.0]);
    (rows, -40i32..40, prop_oneof![Just(1.0), Just(0.1), Just(1.0 / 3.0)], shift).prop_map(
        |(rows, exponent, factor, shift)| {
            let step = factor * 2f64.powi(exponent);
            let place = |(p, (w, ulps)): ([(i8, i8); 3], (i8, i8))| {
                let at = |k: usize| moved((f64::from(p[k].0) + shift[k]) * step, p[k].1);
                let weight = moved(f64::from(w) / 2.0 * step * step, ulps);
                (std::array::from_fn(at), weight)
            };
            rows.into_iter().map(place).unzip()
        },
    )
}

/// Coordinates and weights over many orders of magnitude, of either sign.
fn floats() -> impl Strategy<Value = Weighted> {
    let number = || {
        (any::<bool>(), -30i32..30, 0u32..1 << 20, any::<bool>()).prop_map(|(minus, e, m, full)| {
            let mantissa = 1.0 + f64::from(m) / f64::from(1 << 20) / if full { 3.0 } else { 1.0 };
            2f64.powi(e) * mantissa * if minus { -1.0 } else { 1.0 }
        })
    };
    let row = (
        prop::array::uniform3(prop_oneof![4 => number().boxed(), 1 => Just(0.0).boxed()]),
        number(),
    );
    prop::collection::vec(row, 5..20).prop_map(|rows| rows.into_iter().unzip())
}

/// On a sphere, up to rounding.
fn spheres() -> impl Strategy<Value = Weighted> {
    let row = prop::array::uniform3(-1.0..1.0f64).prop_filter_map("the origin", |p| {
        let r = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        (r > 0.1).then(|| (p.map(|x| x / r), 0.25))
    });
    prop::collection::vec(row, 5..20).prop_map(|rows| rows.into_iter().unzip())
}

fn any_set() -> impl Strategy<Value = Weighted> {
    prop_oneof![lattice(), shaken_lattice(), floats(), spheres()]
}

fn sound(found: medax::Result<Validation>, what: &str) -> Result<(), TestCaseError> {
    let report = found.unwrap();
    prop_assert!(report.is_valid() && report.checked > 0, "{}: {:?}", what, report);
    Ok(())
}

/// Whether the set is one that has no triangulation.
fn is_degenerate<T>(built: &medax::Result<T>) -> bool {
    let status = built.as_ref().err().map(|error| error.status());
    matches!(status, Some(Status::Degenerate | Status::TooFewPoints))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..Default::default() })]

    #[test]
    fn triangulations_equal_brute_force((rows, weights) in any_set()) {
        let job = Job::default();
        let points = Arc::new(Points::new(&rows, Default::default(), &job).unwrap());
        let delaunay = Triangulation::delaunay(&points, &job);
        let regular = Triangulation::regular(&points, &weights, &job);
        if is_degenerate(&delaunay) {
            prop_assert!(is_degenerate(&regular));
            return Ok(());
        }
        for (t, weighted) in [(delaunay.unwrap(), false), (regular.unwrap(), true)] {
            prop_assert_eq!(t.cells(), brute_force(&t, weighted));
            sound(t.validate(&job), "triangulation")?;
        }
    }

    #[test]
    fn what_follows_from_a_triangulation_is_sound((rows, weights) in any_set()) {
        let job = Job::default();
        let points = Arc::new(Points::new(&rows, Default::default(), &job).unwrap());
        let options = DualOptions { facets: true };
        let Ok(delaunay) = Triangulation::delaunay(&points, &job) else { return Ok(()) };
        let dual = Arc::new(Dual::new(&Arc::new(delaunay), options, &job).unwrap());
        sound(dual.validate(&job), "Voronoi diagram")?;
        sound(Poles::new(&dual, Default::default(), &job).unwrap().validate(&job), "poles")?;
        let regular = Triangulation::regular(&points, &weights, &job).unwrap();
        let power = Dual::new(&Arc::new(regular), options, &job).unwrap();
        sound(power.validate(&job), "power diagram")?;
        let crust = PowerCrust::build(&points, Default::default(), &job);
        // Five points on a sphere, say, have poles in a plane.
        if is_degenerate(&crust) {
            return Ok(());
        }
        let crust = crust.unwrap();
        sound(crust.poles().validate(&job), "poles with the far box")?;
        sound(crust.validate(&job), "power crust")?;
        let topology = crust.surface().topology(&job).unwrap();
        // Where every pole is outer the surface is empty.
        let is_solid = topology.closed && topology.oriented && topology.nonmanifold_edges == 0;
        prop_assert!(is_solid || crust.surface().faces().is_empty(), "{:?}", topology);
    }
}
