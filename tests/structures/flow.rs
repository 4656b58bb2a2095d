//! The flow of the distance to the samples: critical points and drivers, cores against the shapes that were sampled, orbits, errors.

use crate::flow_reference::held_center;
use crate::medial::{dual_of, labels_of, samples};
use crate::sets::{self, Random};
use medax::dual::DualOptions;
use medax::flow::{
    CoreOptions, CriticalClass, Flow, FlowComplex, FlowElement, FlowOptions, Simplex,
};
use medax::sample::{SampleOptions, Shape, sample};
use medax::{Dual, Job, JobOptions, Labels, Status};
use std::collections::BTreeMap;
use std::sync::Arc;

type Point = [f64; 3];

pub fn flow(rows: &[Point], labels: impl Fn(&Dual) -> Arc<Labels>, job: &Job) -> Flow {
    let dual = dual_of(rows, &Job::default());
    Flow::new(&dual, &labels(&dual), FlowOptions::default(), job).unwrap()
}

pub fn all_inner(dual: &Dual) -> Arc<Labels> {
    let cells = dual.triangulation().cells().len();
    Arc::new(Labels::new(dual.triangulation(), vec![true; cells]).unwrap())
}

/// Minus one to the power of the index of a critical point.
pub fn sign(simplex: Simplex) -> i64 {
    [1, -1, 1, -1][simplex.dimension()]
}

#[test]
fn critical_points_of_every_index_cancel_down_to_one() {
    let mut tried = 0;
    for set in sets::all(300) {
        let job = Job::default();
        let Ok(points) = medax::Points::new(&set.rows, Default::default(), &job) else { continue };
        let Ok(t) = medax::Triangulation::delaunay(&Arc::new(points), &job) else { continue };
        let dual = Arc::new(Dual::new(&Arc::new(t), DualOptions { facets: true }, &job).unwrap());
        let flow = Flow::new(&dual, &all_inner(&dual), Default::default(), &job).unwrap();
        let sum: i64 = flow.critical().simplices().iter().map(|&simplex| sign(simplex)).sum();
        assert_eq!(sum, 1, "{}", set.name);
        tried += 1;
    }
    assert!(tried > 10, "{tried}");
}

pub fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A cube: the middles of its edges, of its sides, and its own. Where samples are on the spheres, perturbed critical points cancel but for one.
#[test]
fn the_critical_points_of_a_cube_are_the_middles_of_its_parts() {
    let rows: Vec<Point> =
        (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(|x| 2.0 * f64::from(x))).collect();
    let flow = flow(&rows, all_inner, &Job::default());
    let mut sums: BTreeMap<[i32; 3], i64> = BTreeMap::new();
    for (&simplex, at) in flow.critical().simplices().iter().zip(flow.critical().points()) {
        assert!(at.iter().all(|x| [0.0, 1.0, 2.0].contains(x)), "{at:?}");
        *sums.entry(at.map(|x| x as i32)).or_default() += sign(simplex);
    }
    for (at, sum) in &sums {
        let middles = at.iter().filter(|&&x| x == 1).count();
        assert_eq!(*sum, [1, -1, 1, -1][middles], "{at:?}");
    }
    assert_eq!(sums.len(), 8 + 12 + 6 + 1);
}

/// On a sheet without holes all flows to one point: cut along the orbits of all Voronoi vertices it would have the more faces a sample the more samples there are. Neither a core needs that
/// nor one that is extended by all of the sheet.
#[test]
fn cores_of_a_sheet_take_memory_in_proportion_to_its_samples() {
    let shape = Shape::Ellipsoid;
    let bytes = [0.1, 0.05].map(|spacing| {
        let dual = dual_of(&samples(shape, spacing), &Job::default());
        let labels = labels_of(shape, &dual);
        let flow = Flow::new(&dual, &labels, Default::default(), &Job::default()).unwrap();
        let all: Vec<u32> = (0..dual.facets().unwrap().len() as u32).collect();
        [&[][..], &all].map(|facets| {
            let job = Job::default();
            let core = flow.core(CoreOptions::default(), facets, &job).unwrap();
            assert_eq!(core.complex().topology(&Job::default()).unwrap().betti, [1, 0, 0]);
            job.memory_peak() as f64 / dual.triangulation().coords().len() as f64
        })
    });
    let [coarse, fine] = bytes;
    assert!((0..2).all(|i| fine[i] < 1.2 * coarse[i]), "{bytes:?}");
}

#[test]
fn cores_of_smooth_shapes_have_their_homotopy_type() {
    for (shape, spacing, betti) in [
        (Shape::Ellipsoid, 0.2, [1, 0, 0]),
        (Shape::Capsule, 0.15, [1, 0, 0]),
        (Shape::Torus, 0.12, [1, 1, 0]),
        (Shape::Genus3, 0.1, [1, 3, 0]),
        (Shape::Trefoil, 0.12, [1, 1, 0]),
    ] {
        let job = Job::default();
        let flow = flow(&samples(shape, spacing), |dual| labels_of(shape, dual), &job);
        for repair in [false, true] {
            let options = CoreOptions { repair, ..Default::default() };
            let core = flow.core(options, &[], &job).unwrap();
            let core = core.complex();
            assert_eq!(core.topology(&job).unwrap().betti, betti, "{shape:?}");
            assert!(core.validate(&job).unwrap().is_valid(), "{shape:?}");
            // It lies within the shape.
            assert!(core.vertices().iter().all(|&p| shape.value(p) < 0.0), "{shape:?}");
        }
    }
}

#[test]
fn threads_change_nothing() {
    let rows = samples(Shape::Genus3, 0.12);
    let found: Vec<_> = [1, 2, 8]
        .into_iter()
        .map(|threads| {
            let job = || Job::new(JobOptions { threads, ..Default::default() });
            let flow = flow(&rows, |dual| labels_of(Shape::Genus3, dual), &job());
            let facets: Vec<u32> = (0..flow.dual().facets().unwrap().len() as u32).collect();
            let core = flow.core(CoreOptions::default(), &[], &job()).unwrap();
            let extended = flow.core(CoreOptions::default(), &facets, &job()).unwrap();
            let orbits = flow.orbits(&rows[..1000], &job()).unwrap();
            let critical = flow.critical_complex(&job()).unwrap();
            let complex = FlowComplex::new(&Arc::new(flow), &job()).unwrap();
            let whole = (
                complex.complex(&job()).unwrap(),
                complex.edge_of_vertex().to_vec(),
                complex.face_of_edge().to_vec(),
            );
            (core.complex().clone(), extended.complex().clone(), orbits, critical, whole)
        })
        .collect();
    assert!(found[0] == found[1] && found[0] == found[2]);
}

/// The critical points in whose manifolds a face lies, found from the face against the flow, are those whose manifolds, found along it, have the face.
#[test]
fn critical_sets_are_the_manifolds_that_hold_an_element() {
    let mut random = Random(9);
    let rows: Vec<Point> = (0..40).map(|_| random.cube()).collect();
    let job = Job::default();
    let flow = Arc::new(flow(&rows, all_inner, &job));
    let complex = FlowComplex::new(&flow, &job).unwrap();
    let faces = (0..complex.faces().len() as u32).map(FlowElement::Face);
    let vertices = (0..complex.vertex_count() as u32).map(FlowElement::Vertex);
    let edges = (0..complex.edges().len() as u32).map(FlowElement::Edge);
    let elements: Vec<FlowElement> = vertices.chain(edges).chain(faces).collect();
    let sets = complex.critical_sets(&elements, &job).unwrap();
    let mut expected = vec![Vec::new(); elements.len()];
    for (row, &simplex) in (0..).zip(flow.critical().simplices()) {
        let seeds: Vec<FlowElement> = match simplex {
            Simplex::Sample(v) => (0..)
                .zip(flow.dual().facets().unwrap().edges())
                .filter(|(_, ends)| ends.contains(&v))
                .flat_map(|(facet, _)| complex.elements_of(Simplex::Edge(facet)).unwrap())
                .collect(),
            simplex => complex.elements_of(simplex).unwrap(),
        };
        for element in complex.closure(&seeds, &job).unwrap() {
            expected[elements.binary_search(&element).unwrap()].push(row);
        }
    }
    for (i, expected) in expected.iter().enumerate() {
        assert_eq!(sets.row(i), expected, "{:?}", elements[i]);
    }
    // And what can reach an element is what has it in its closure.
    for &element in elements.iter().step_by(97) {
        let upstream = complex.upstream(&[element], &job).unwrap();
        for &other in elements.iter().step_by(31) {
            let reaches = complex.closure(&[other], &job).unwrap().contains(&element);
            assert_eq!(upstream.contains(&other), reaches, "{other:?} {element:?}");
        }
    }
}

/// On a sphere all cuts of a facet may end in one place, with a sign or without: their order must hang on neither.
#[test]
fn complexes_of_cospherical_samples_fit_together() {
    for seed in 0..4 {
        let options = SampleOptions { spacing: 0.2, seed, ..Default::default() };
        let samples = sample(Shape::Sphere, options, &Job::default()).unwrap();
        let flow = Arc::new(flow(samples.points(), all_inner, &Job::default()));
        let complex = FlowComplex::new(&flow, &Job::default()).unwrap();
        let found = complex.validate(&Job::default()).unwrap();
        assert!(found.first.is_none(), "{seed}: {found:?}");
    }
}

/// Samples a unit of rounding off a plane make Voronoi edges of which one end is 2^50 times as far away as the other: orbits cross them as exactly near this one.
#[test]
fn nothing_flows_nearer_to_samples_beside_far_voronoi_vertices() {
    for (shape, spacing, seed) in
        [(Shape::Bracket, 0.3, 0), (Shape::Box, 0.15, 2), (Shape::Bracket, 0.15, 1)]
    {
        let options = SampleOptions { spacing, seed, ..Default::default() };
        let samples = sample(shape, options, &Job::default()).unwrap();
        let flow = Arc::new(flow(samples.points(), all_inner, &Job::default()));
        let complex = FlowComplex::new(&flow, &Job::default()).unwrap();
        let found = complex.validate(&Job::default()).unwrap();
        assert!(found.first.is_none(), "{shape:?} {seed}: {found:?}");
    }
}

/// Its Voronoi cell would be a void, were it not open to the outside by one facet, which no extension may close.
#[test]
fn a_sample_within_the_solid_makes_no_void() {
    let mut rows = samples(Shape::Sphere, 0.2);
    rows.push([0.3, 0.2, 0.1]);
    let flow = flow(&rows, |dual| labels_of(Shape::Sphere, dual), &Job::default());
    let all: Vec<u32> = (0..flow.dual().facets().unwrap().len() as u32).collect();
    for facets in [&[][..], &all] {
        let core = flow.core(CoreOptions::default(), facets, &Job::default()).unwrap();
        let betti = core.complex().topology(&Job::default()).unwrap().betti;
        assert_eq!(betti, [1, 0, 0], "{} facets", facets.len());
    }
}

/// Theorem 3.17 facet by facet, in the complex of which every facet is cut; here those are that a search of whole Voronoi faces suspects.
#[test]
fn facets_that_cannot_extend_a_core_are_those_whose_closures_have_other_critical_points() {
    let job = Job::default();
    let rows = samples(Shape::Trefoil, 0.25);
    let flow = Arc::new(flow(&rows, |dual| labels_of(Shape::Trefoil, dual), &job));
    let all = FlowComplex::new(&flow, &job).unwrap();
    let cells = flow.dual().centers().len();
    let critical = flow.critical();
    let class: BTreeMap<Simplex, CriticalClass> =
        critical.simplices().iter().copied().zip(critical.classes().iter().copied()).collect();
    let is_other = |simplex| class[&simplex] != CriticalClass::Inner;
    let (mut staying, mut leaving) = (Vec::new(), 0);
    for facet in 0..flow.dual().facets().unwrap().len() as u32 {
        let options = CoreOptions { repair: false, ..Default::default() };
        let core = flow.core(options, &[facet], &job).unwrap();
        if core.taken() + core.excluded().leaving == 0 {
            continue;
        }
        let own = all.elements_of(Simplex::Edge(facet)).unwrap();
        let is_left = all.closure(&own, &job).unwrap().into_iter().any(|element| match element {
            FlowElement::Vertex(v) if all.edge_of_vertex()[v as usize] == medax::NONE => {
                is_other(match (v as usize).checked_sub(cells) {
                    None => Simplex::Cell(v),
                    Some(point) => Simplex::Triangle(all.triangle_of_point()[point]),
                })
            }
            _ => false,
        });
        let is_left =
            is_left || class.get(&Simplex::Edge(facet)).is_some_and(|c| *c != CriticalClass::Inner);
        assert_eq!(core.excluded().leaving, usize::from(is_left), "facet {facet}");
        if is_left { leaving += 1 } else { staying.push(facet) }
    }
    assert!(leaving > 5 && staying.len() > 100, "{leaving} {}", staying.len());
    // All at once they are the same.
    let facets: Vec<u32> = (0..flow.dual().facets().unwrap().len() as u32).collect();
    let core = flow.core(CoreOptions::default(), &facets, &job).unwrap();
    assert_eq!((core.taken(), core.excluded().leaving), (staying.len(), leaving));
}

/// What comes to a Voronoi vertex goes on from there as all that does, however many samples tie.
#[test]
fn orbits_through_voronoi_vertices_never_come_back() {
    let rows = [
        [2.0, 1.0, 4.0],
        [3.0, 1.0, 5.0],
        [4.0, 0.0, 5.0],
        [2.0, 2.0, 5.0],
        [0.0, 0.0, 3.0],
        [1.0, 1.0, 4.0],
    ];
    let flow = flow(&rows, all_inner, &Job::default());
    let steps = || (0..24).map(|i| 0.25 * f64::from(i));
    let starts: Vec<Point> =
        steps().flat_map(|x| steps().map(move |y| [x - 1.0, y - 1.0, 5.5 - 0.5 * x])).collect();
    let orbits = flow.orbits(&starts, &Job::default()).unwrap();
    for (i, start) in starts.iter().enumerate() {
        let range = orbits.offsets()[i] as usize..orbits.offsets()[i + 1] as usize;
        let distances = &orbits.distances()[range];
        assert!(distances.is_sorted_by(|a, b| *a <= b * (1.0 + 1e-9)), "{start:?}: {distances:?}");
    }
}

#[test]
fn what_cannot_be_is_an_error() {
    let job = Job::default();
    let rows = samples(Shape::Sphere, 0.4);
    let dual = dual_of(&rows, &job);
    let labels = all_inner(&dual);
    let refused = |dual: &Arc<Dual>, labels: &Arc<Labels>, least_slope: f64| {
        Flow::new(dual, labels, FlowOptions { least_slope }, &job).unwrap_err().status()
    };
    for slope in [0.0, 1.0, f64::NAN, -1.0] {
        assert_eq!(refused(&dual, &labels, slope), Status::InvalidArgument);
    }
    let plain = Arc::new(Dual::new(dual.triangulation(), Default::default(), &job).unwrap());
    assert_eq!(refused(&plain, &labels, 0.5), Status::InvalidArgument);
    let other = dual_of(&samples(Shape::Sphere, 0.5), &job);
    assert_eq!(refused(&other, &labels, 0.5), Status::Mismatch);
    let flow = Arc::new(Flow::new(&dual, &labels, Default::default(), &job).unwrap());
    let count = flow.dual().facets().unwrap().len() as u32;
    for error in [
        flow.core(CoreOptions::default(), &[0, count], &job).unwrap_err(),
        flow.closure(&[Simplex::Cell(0), Simplex::Edge(count)], &job).unwrap_err(),
        FlowComplex::new(&flow, &job)
            .unwrap()
            .closure(&[FlowElement::Vertex(u32::MAX)], &job)
            .unwrap_err(),
    ] {
        assert_eq!(error.status(), Status::InvalidArgument);
    }
    let queries = [[0.0; 3], [0.0, f64::NAN, 0.0]];
    assert_eq!(flow.orbits(&queries, &job).unwrap_err().status(), Status::NonFinite);
    assert_eq!(flow.at(&[[1e300, 0.0, 0.0]], &job).unwrap_err().status(), Status::CoordinateRange);
    assert_eq!(flow.at(&[], &job).unwrap(), []);
}

/// The point of a Delaunay simplex that is nearest to its Voronoi face is looked for among the centres of all its sides.
#[test]
fn drivers_are_the_nearest_points_of_simplices() {
    let mut random = Random(11);
    let rows: Vec<Point> = (0..200).map(|_| random.cube()).collect();
    let flow = flow(&rows, all_inner, &Job::default());
    let t = flow.dual().triangulation();
    let coords = t.coords();
    let facets = flow.dual().facets().unwrap();
    // The centre of a simplex, if it holds it.
    let held = |simplex: &[u32]| {
        let corners: Vec<Point> = simplex.iter().map(|&v| coords[v as usize]).collect();
        held_center(&corners)
    };
    let place = |simplex: Simplex| match simplex {
        Simplex::Sample(v) => coords[v as usize],
        Simplex::Edge(facet) => held(&facets.edges()[facet as usize]).unwrap(),
        Simplex::Triangle(triangle) => {
            let [cell, slot] = flow.triangles()[triangle as usize];
            held(&t.facet(cell, slot as usize)).unwrap()
        }
        Simplex::Cell(cell) => held(&t.cells()[cell as usize]).unwrap(),
    };
    let nearest = |simplex: &[u32], x: Point| -> f64 {
        let sides = (1..1u32 << simplex.len())
            .map(|bits| (0..simplex.len()).filter(move |i| bits >> i & 1 == 1).map(|i| simplex[i]))
            .map(|side| side.collect::<Vec<_>>());
        // The nearest point of the hull lies where the foot of x in a side is in that side: for a point of the Voronoi face its centre.
        let feet = sides.filter_map(|side| match side[..] {
            [v] => Some(coords[v as usize]),
            _ => held(&side),
        });
        feet.map(|foot| dot(sub(foot, x), sub(foot, x))).fold(f64::INFINITY, f64::min)
    };
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.max(b).max(1e-9);
    for cell in 0..t.cells().len() as u32 {
        let x = flow.dual().centers()[cell as usize];
        let at = place(flow.driver_of_cell(cell));
        let found = dot(sub(at, x), sub(at, x));
        assert!(near(found, nearest(&t.cells()[cell as usize], x)), "cell {cell}");
    }
    for (triangle, &[cell, slot]) in (0..).zip(flow.triangles()) {
        let x = flow.dual().centers()[cell as usize];
        let at = place(flow.driver_of_triangle(triangle));
        let found = dot(sub(at, x), sub(at, x));
        assert!(near(found, nearest(&t.facet(cell, slot as usize), x)), "triangle {triangle}");
    }
}

/// Points of a set that orbits can be asked for: random ones, Voronoi vertices, middles of edges, samples.
fn queries(flow: &Flow, random: &mut Random, count: usize) -> Vec<Point> {
    let coords = flow.dual().triangulation().coords();
    let mut queries: Vec<Point> = (0..count).map(|_| random.cube()).collect();
    queries.extend(flow.dual().centers().iter().filter(|c| c.iter().all(|x| x.abs() < 4.0)));
    queries.extend(coords);
    for [p, q] in flow.dual().facets().unwrap().edges() {
        let [p, q] = [p, q].map(|&v| coords[v as usize]);
        queries.push(std::array::from_fn(|k| (p[k] + q[k]) / 2.0));
    }
    queries
}

#[test]
fn orbits_end_in_critical_points_or_at_infinity_and_distances_grow() {
    let mut random = Random(5);
    let cloud: Vec<Point> = (0..300).map(|_| random.cube()).collect();
    let cube = (0..64).map(|i| [i & 3, i >> 2 & 3, i >> 4].map(f64::from)).collect();
    for rows in [cloud, samples(Shape::Genus3, 0.15), cube] {
        let flow = flow(&rows, all_inner, &Job::default());
        let queries = queries(&flow, &mut random, 1000);
        let orbits = flow.orbits(&queries, &Job::default()).unwrap();
        assert_eq!(orbits.len(), queries.len());
        let mut infinite = 0;
        for (i, row) in orbits.offsets().windows(2).enumerate() {
            let row = row[0] as usize..row[1] as usize;
            assert_eq!(orbits.points()[row.start], queries[i]);
            let distances = &orbits.distances()[row.clone()];
            let grows = distances.windows(2).all(|pair| pair[1] >= pair[0] * (1.0 - 1e-9) - 1e-12);
            assert!(grows, "{i}: {distances:?}");
            let last = orbits.points()[row.end - 1];
            match orbits.ends()[i] {
                medax::NONE => infinite += 1,
                end => {
                    let to = sub(last, flow.critical().points()[end as usize]);
                    assert!(dot(to, to) < 1e-20, "{i}");
                }
            }
            let mut faces = orbits.simplices()[row].to_vec();
            faces.dedup();
            let count = faces.len();
            faces.sort();
            faces.dedup();
            assert_eq!(faces.len(), count, "{i}: a face is entered twice");
        }
        assert!(infinite > 0 && infinite < queries.len() / 2, "{infinite}");
    }
}

#[test]
fn the_flow_at_a_point_is_that_of_its_nearest_samples() {
    let mut random = Random(6);
    let rows: Vec<Point> = (0..100).map(|_| random.cube()).collect();
    let flow = flow(&rows, all_inner, &Job::default());
    let coords = flow.dual().triangulation().coords();
    let queries = queries(&flow, &mut random, 1000);
    let length = |v: Point| dot(v, v).sqrt();
    for (&x, at) in queries.iter().zip(flow.at(&queries, &Job::default()).unwrap()) {
        let distance = coords.iter().map(|&p| length(sub(p, x))).fold(f64::INFINITY, f64::min);
        assert!((at.distance - distance).abs() <= 1e-12, "{x:?}");
        assert!((length(at.vector) * distance - length(sub(x, at.driver))).abs() <= 1e-12);
        assert!((at.angle.cos() - length(at.vector)).abs() < 1e-9 || distance == 0.0);
    }
    // A critical point is its own driver.
    for (&x, at) in flow
        .critical()
        .points()
        .iter()
        .zip(flow.at(flow.critical().points(), &Job::default()).unwrap())
    {
        if at.simplex.dimension() == 0 {
            // Rounding has moved it off its Voronoi face.
            continue;
        }
        assert!(length(sub(x, at.driver)) < 1e-12, "{x:?} {at:?}");
    }
}

#[test]
fn flows_of_every_kind_of_set_and_their_complexes_are_valid() {
    let mut tried = 0;
    for set in sets::all(200) {
        let job = Job::default();
        let Ok(points) = medax::Points::new(&set.rows, Default::default(), &job) else { continue };
        let Ok(t) = medax::Triangulation::delaunay(&Arc::new(points), &job) else { continue };
        let dual = Arc::new(Dual::new(&Arc::new(t), DualOptions { facets: true }, &job).unwrap());
        let flow = Flow::new(&dual, &all_inner(&dual), Default::default(), &job).unwrap();
        let report = flow.validate(&job).unwrap();
        assert!(report.is_valid(), "{}: {report:?}", set.name);
        let complex = FlowComplex::new(&Arc::new(flow), &job).unwrap();
        let report = complex.validate(&job).unwrap();
        assert!(report.is_valid(), "{}: {report:?}", set.name);
        tried += 1;
    }
    assert!(tried > 10, "{tried}");
}
