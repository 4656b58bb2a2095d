//! Local feature size and thickness: against all poles and samples, and on shapes whose walls are known.

use crate::sets::Random;
use crate::variants::{brick, crust, ellipsoid, points, torus};
use medax::complex::{Attribute, ComplexParts, Element, Values};
use medax::crust::{Label, SimplifyOptions, Sizes};
use medax::poles::{Omit, PolesOptions};
use medax::{Complex, Job, JobOptions, NONE, PowerCrust, Status};

fn whole(rows: &[[f64; 3]]) -> PowerCrust {
    crust(rows, PolesOptions::default())
}

fn samples(crust: &PowerCrust) -> &[[f64; 3]] {
    &crust.poles().triangulation().coords()[..crust.poles().sample_count()]
}

fn sizes(crust: &PowerCrust, queries: &[[f64; 3]]) -> Sizes {
    crust.sizes_at(queries, &Job::default()).unwrap()
}

fn square(a: [f64; 3], b: [f64; 3]) -> f64 {
    [0, 1, 2].map(|k| (a[k] - b[k]) * (a[k] - b[k])).iter().sum()
}

/// The diameter of each sample's inner ball, given the radius that each pole's ball has now.
fn diameters(crust: &PowerCrust, radius: &impl Fn(usize) -> Option<f64>) -> Vec<Option<f64>> {
    let diameter = |&pole: &u32| match pole {
        NONE => None,
        pole if crust.labels()[pole as usize] == Label::Outer => None,
        pole => Some(2.0 * radius(pole as usize)?),
    };
    let largest = |pair: &[u32; 2]| pair.iter().filter_map(diameter).reduce(f64::max);
    crust.poles().pole_of_sample().iter().map(largest).collect()
}

/// Compares the sizes at all samples and at points round them with those that looking at everything gives.
fn assert_sizes(crust: &PowerCrust, radius: impl Fn(usize) -> Option<f64>, name: &str) {
    let diameters = diameters(crust, &radius);
    let mut random = Random(5);
    let mut queries = samples(crust).to_vec();
    queries.extend((0..300).map(|_| random.cube().map(|x| 4.0 * x - 2.0)));
    let found = sizes(crust, &queries);
    for (i, &query) in queries.iter().enumerate() {
        let there = crust.poles().balls().iter().enumerate();
        let there = there.filter(|&(pole, _)| radius(pole).is_some());
        let feature = there.map(|(_, &[x, y, z, _])| square([x, y, z], query));
        let feature = feature.fold(f64::INFINITY, f64::min).sqrt();
        assert_eq!(found.feature_size[i], feature, "{name}, {query:?}");
        let having = samples(crust).iter().zip(&diameters).enumerate();
        let having = having.filter_map(|(s, (&at, &d))| Some((square(at, query), s, d?)));
        let nearest = having.min_by(|a, b| (a.0, a.1).partial_cmp(&(b.0, b.1)).unwrap());
        let thickness = nearest.map_or(0.0, |(_, _, diameter)| diameter);
        assert_eq!(found.thickness[i], thickness, "{name}, {query:?}");
    }
}

#[test]
fn sizes_are_those_that_looking_at_everything_gives() {
    let noisy = ellipsoid(1200, 0.02);
    let plain = whole(&noisy);
    let radius = |pole: usize| Some(plain.poles().balls()[pole][3]);
    assert_sizes(&plain, radius, "noise");
    // Among these are samples without a pole, and with an outer one only.
    for omit in [Omit::Side, Omit::Both] {
        let fewer = crust(&noisy, PolesOptions { omit, lambda: 0.4 });
        let radius = |pole: usize| Some(fewer.poles().balls()[pole][3]);
        let without = diameters(&fewer, &radius).iter().filter(|d| d.is_none()).count();
        assert!(without > 100, "{omit:?}: {without}");
        assert_sizes(&fewer, radius, "poles left out");
    }
    let options = SimplifyOptions { epsilon: Some(0.1), delta: Some(0.02) };
    let simple = plain.simplify(options, &Job::default()).unwrap();
    let gone = |pole: usize| {
        let pole = pole as u32;
        simple.unstable.binary_search(&pole).is_ok()
            || simple.redundant.binary_search_by_key(&pole, |pair| pair[0]).is_ok()
    };
    let radius = |pole: usize| (!gone(pole)).then(|| plain.poles().balls()[pole][3]);
    assert_sizes(&simple.crust, radius, "simplified");
    for distance in [-0.2, 0.1] {
        let offset = plain.offset(distance, &Job::default()).unwrap();
        let radius = |pole: usize| {
            let radius = match plain.labels()[pole] {
                Label::Inner => plain.poles().balls()[pole][3] + distance,
                Label::Outer => plain.poles().balls()[pole][3] - distance,
            };
            (radius > 0.0).then(|| (radius * radius).sqrt())
        };
        assert!((0..plain.poles().len()).any(|pole| radius(pole).is_none()), "{distance}");
        assert_sizes(&offset, radius, "offset");
    }
}

#[test]
fn of_samples_as_near_the_least_counts() {
    // A wedge, thicker from row to row, with samples on a grid: many points are as near to one row as to the next.
    let mut rows = Vec::new();
    for i in 0..16 {
        let x = f64::from(i) + 0.5;
        for y in (0..12).map(|j| f64::from(j) + 0.5) {
            rows.extend([[x, y, 0.0], [x, y, 2.0 + 0.25 * x]]);
        }
        rows.extend([0.0, 12.0].into_iter().flat_map(|y| [[x, y, 0.5], [x, y, 1.5]]));
    }
    for y in (0..12).map(|j| f64::from(j) + 0.5) {
        rows.extend([0.0, 16.0].into_iter().flat_map(|x| [[x, y, 0.5], [x, y, 1.5]]));
    }
    let crust = whole(&rows);
    let diameters = diameters(&crust, &|pole| Some(crust.poles().balls()[pole][3]));
    let mut queries = Vec::new();
    for i in 0..=32 {
        for j in 0..=24 {
            queries.extend([-1.0, 0.0].map(|z| [0.5 * f64::from(i), 0.5 * f64::from(j), z]));
        }
    }
    let found = sizes(&crust, &queries);
    let mut choices = 0;
    for (query, thickness) in queries.iter().zip(found.thickness) {
        let all = samples(&crust).iter().zip(&diameters);
        let all = all.filter_map(|(&at, &d)| Some((square(at, *query), d?)));
        let all: Vec<(f64, f64)> = all.collect();
        let least = all.iter().map(|(d, _)| *d).fold(f64::INFINITY, f64::min);
        let tied: Vec<f64> = all.iter().filter(|(d, _)| *d == least).map(|(_, d)| *d).collect();
        assert_eq!(thickness, tied[0], "{query:?}");
        choices += usize::from(tied.iter().any(|d| *d != tied[0]));
    }
    assert!(choices > 50, "{choices} choices between different thicknesses");
}

#[test]
fn a_torus_is_as_thick_as_its_tube() {
    let crust = whole(&torus());
    let found = sizes(&crust, samples(&crust));
    // Measured: 0.7000 to 0.7001, and 1.4000 to 1.4022.
    assert!(found.feature_size.iter().all(|size| (size - 0.7).abs() < 0.001));
    assert!(found.thickness.iter().all(|thickness| (thickness - 1.4).abs() < 0.01));
    // On the core circle there are poles, and outside the surface thickness is that of the nearest sample.
    let circle: Vec<[f64; 3]> = (0..100)
        .map(|i| 0.0628 * f64::from(i))
        .map(|u| [2.0 * u.cos(), 2.0 * u.sin(), 0.0])
        .collect();
    assert!(sizes(&crust, &circle).feature_size.iter().all(|size| *size < 0.05));
    let away = sizes(&crust, &[[5.0, 0.0, 1.0]]);
    assert!((away.thickness[0] - 1.4).abs() < 0.01 && away.feature_size[0] > 2.5);
}

#[test]
fn an_offset_is_thicker_by_twice_the_distance() {
    let crust = whole(&torus());
    let before = sizes(&crust, samples(&crust));
    for distance in [-0.3, 0.2] {
        let offset = crust.offset(distance, &Job::default()).unwrap();
        let after = sizes(&offset, samples(&crust));
        for (before, after) in before.thickness.iter().zip(&after.thickness) {
            assert!((after - before - 2.0 * distance).abs() < 1e-12);
        }
    }
    // Nothing inside is left; the outer poles still are.
    let gone = sizes(&crust.offset(-0.75, &Job::default()).unwrap(), samples(&crust));
    assert!(gone.thickness.iter().all(|thickness| *thickness == 0.0));
    assert!(gone.feature_size.iter().all(|size| size.is_finite() && *size > 0.9));
}

#[test]
fn a_plate_has_its_thickness_away_from_its_edges() {
    let half = [1.0, 0.5, 0.1];
    let crust = whole(&brick(half, 0.04));
    let found = sizes(&crust, samples(&crust));
    let (mut inside, mut rim) = (0, 0);
    for (&[x, y, z], &thickness) in samples(&crust).iter().zip(&found.thickness) {
        let from_edge = (half[0] - x.abs()).min(half[1] - y.abs());
        if z.abs() == half[2] && from_edge > 0.15 {
            // Measured: 0.2056 to 0.2096: the ball reaches in between the samples.
            assert!((0.2..0.212).contains(&thickness), "{thickness} at {x} {y} {z}");
            inside += 1;
        } else if z.abs() == half[2] && from_edge < 0.05 {
            // The ball there touches both faces that meet. Measured: 0.077 to 0.110.
            assert!(thickness < 0.12, "{thickness} at {x} {y} {z}");
            rim += 1;
        }
    }
    assert!(inside > 1000 && rim > 100, "{inside} and {rim}");
}

#[test]
fn the_wall_between_two_spheres_is_as_thick_as_the_gap() {
    let mut random = Random(12);
    let mut rows: Vec<_> = (0..6000).map(|_| random.sphere()).collect();
    rows.extend((0..3000).map(|_| random.sphere().map(|x| 0.6 * x)));
    let crust = whole(&rows);
    assert_eq!(crust.surface().topology(&Job::default()).unwrap().components, 2);
    let mut thickness = sizes(&crust, &rows).thickness;
    thickness.sort_by(f64::total_cmp);
    // Measured: 0.4004 to 0.4190, and 0.4063 in the middle: random samples are up to 0.1 apart.
    assert!(thickness[0] > 0.399 && thickness[thickness.len() - 1] < 0.43, "{thickness:?}");
    assert!((thickness[thickness.len() / 2] - 0.4).abs() < 0.01);
    // In the void is no wall: what is nearest counts.
    let middle = sizes(&crust, &[[0.0; 3]]);
    assert!((0.39..0.43).contains(&middle.thickness[0]) && middle.feature_size[0] < 0.01);
}

fn values<'a>(complex: &'a Complex, name: &str) -> &'a Values {
    complex.attribute(Element::Vertex, name).unwrap().values()
}

#[test]
fn samples_and_surfaces_carry_their_sizes() {
    let mut rows = ellipsoid(500, 0.0);
    rows.extend_from_within(100..200);
    rows.reverse();
    let crust = whole(&rows);
    let complex = crust.samples_to_complex(&Job::default()).unwrap();
    let found = sizes(&crust, samples(&crust));
    assert_eq!(complex.vertices(), samples(&crust));
    assert_eq!(*values(&complex, "feature_size"), Values::F64(found.feature_size));
    assert_eq!(*values(&complex, "thickness"), Values::F64(found.thickness));
    let Values::U32(row) = values(&complex, "row") else { panic!("rows are numbers") };
    assert_eq!(row, points(&rows).row_of_vertex());
    assert!((row.iter().zip(samples(&crust))).all(|(&row, at)| rows[row as usize] == *at));

    let surface = crust.surface();
    let sized = crust.with_sizes(surface, &Job::default()).unwrap();
    assert_eq!((sized.vertices(), sized.faces()), (surface.vertices(), surface.faces()));
    assert_eq!(sized.attributes().len(), surface.attributes().len() + 2);
    assert_eq!(values(&sized, "sample"), values(surface, "sample"));
    let found = sizes(&crust, surface.vertices());
    assert_eq!(*values(&sized, "thickness"), Values::F64(found.thickness));
    // Once more, and with attributes of these names elsewhere: those of the vertices are replaced.
    assert_eq!(crust.with_sizes(&sized, &Job::default()).unwrap(), sized);
    let offset = crust.offset(0.1, &Job::default()).unwrap();
    let other = offset.with_sizes(&sized, &Job::default()).unwrap();
    assert_eq!(other.attributes().len(), sized.attributes().len());
    let found = sizes(&offset, surface.vertices());
    assert_eq!(*values(&other, "feature_size"), Values::F64(found.feature_size));
    let edge = Attribute::new("thickness", Element::Edge, 2, Values::U32(vec![1, 2])).unwrap();
    let parts = ComplexParts {
        vertices: vec![[0.0; 3], [1.0, 0.0, 1e-300], [1e300, 0.0, 0.0]],
        edges: vec![[0, 1]],
        attributes: vec![edge.clone()],
        ..Default::default()
    };
    let far = crust.with_sizes(&Complex::new(parts.clone()).unwrap(), &Job::default());
    let far = far.unwrap_err();
    assert_eq!((far.status(), far.element().unwrap().1), (Status::CoordinateRange, 2));
    let near = ComplexParts { vertices: parts.vertices[..2].to_vec(), ..parts };
    let near = crust.with_sizes(&Complex::new(near).unwrap(), &Job::default()).unwrap();
    assert_eq!(near.attribute(Element::Edge, "thickness"), Some(&edge));
    assert_eq!((near.edges(), near.attributes().len()), (&[[0, 1]][..], 3));
}

#[test]
fn threads_and_the_order_of_rows_change_no_bit() {
    let rows = ellipsoid(3000, 0.01);
    let (mut reversed, mut random) = (rows.clone(), Random(1));
    reversed.reverse();
    let queries: Vec<_> = (0..9000).map(|_| random.cube().map(|x| 3.0 * x - 1.5)).collect();
    let bits = |threads: usize, rows: &[[f64; 3]]| {
        let crust = whole(rows);
        let job = Job::new(JobOptions { threads, ..JobOptions::default() });
        let found = crust.sizes_at(&queries, &job).unwrap();
        let of_poles = crust.poles().feature_size(&queries, &job).unwrap();
        assert_eq!(of_poles, found.feature_size);
        assert_eq!(job.stage_count(), 2);
        let bits = |values: Vec<f64>| values.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
        [bits(found.feature_size), bits(found.thickness)]
    };
    let one = bits(1, &rows);
    for threads in [2, 3, 8] {
        assert!(bits(threads, &rows) == one, "{threads} threads");
    }
    assert!(bits(3, &reversed) == one);
}

#[test]
fn queries_that_are_none_and_jobs_that_end_are_errors() {
    let crust = whole(&ellipsoid(2000, 0.0));
    let mut queries = vec![[0.1; 3]; 5000];
    for (row, x, status) in
        [(4000, f64::NAN, Status::NonFinite), (1500, 1e300, Status::CoordinateRange)]
    {
        // The first one is told, however many there are.
        for i in [0, 1, 700] {
            queries[row + i][1] = x;
        }
        for threads in [1, 3] {
            let job = Job::new(JobOptions { threads, ..JobOptions::default() });
            let error = crust.sizes_at(&queries, &job).unwrap_err();
            assert_eq!((error.status(), error.element().unwrap().1), (status, row as u64));
        }
    }
    let none = sizes(&crust, &[]);
    assert!(none.feature_size.is_empty() && none.thickness.is_empty());
    let spent = Job::default();
    spent.cancel();
    let small = Job::new(JobOptions { memory_ceiling: 10_000, ..JobOptions::default() });
    for (job, status) in [(spent, Status::Cancelled), (small, Status::OutOfMemory)] {
        let refused = [
            crust.sizes_at(&queries[..1400], &job).map(drop),
            crust.samples_to_complex(&job).map(drop),
            crust.with_sizes(crust.surface(), &job).map(drop),
        ];
        assert!(refused.into_iter().all(|refused| refused.unwrap_err().status() == status));
    }
    // In the middle of a batch, which takes longer than the callback waits.
    let stop = JobOptions { progress: Some(Box::new(|done, _| done < 0.3)), ..Default::default() };
    let job = Job::new(stop);
    let many = vec![[0.0; 3]; 4_000_000];
    assert_eq!(crust.sizes_at(&many, &job).unwrap_err().status(), Status::Cancelled);
    assert!((0.2..1.0).contains(&job.progress()));
}
