//! Flow closures against wedges traced through the Voronoi diagram, facet by facet (Giesen, Ramos, Sadri, section 5, figures 9, 10 and 12), in floats, for samples in general position.
//!
//! Nothing is cut beforehand: what flows is an interval of a Voronoi edge, and where the edge is crossed a wedge from the driver through the ends of the interval. In
//! line 9 of figure 12 the inclusion is a proper one: where the Voronoi face of the driver is the edge, the flow runs along it.

mod diagram;
mod trace;

use crate::flow::{all_inner, flow, sub};
use crate::medial::samples;
use crate::sets::{Random, shuffled};
use diagram::{Corner, Diagram, Point, length, sorted};
use medax::complex::{Element, Values};
use medax::flow::{Flow, FlowComplex, FlowElement, Simplex};
use medax::sample::Shape;
use medax::{Complex, Job, NONE};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use trace::trace;

/// What is reached, in lengths and areas within reach.
#[derive(Debug, Default)]
struct Reached {
    /// By facets.
    areas: BTreeMap<u32, f64>,
    /// By Voronoi edges: all, and what is on the rim of no part of a facet.
    edges: BTreeMap<u32, f64>,
    loose: BTreeMap<u32, f64>,
    /// By facets, where orbits of Voronoi vertices cross what is not reached otherwise; those to infinity as often as there are.
    hairs: BTreeMap<u32, f64>,
    endless: BTreeMap<u32, f64>,
    /// Voronoi vertices.
    vertices: BTreeSet<u32>,
}

impl Reached {
    fn add_hair(&mut self, facet: u32, length: f64) {
        match length {
            f64::INFINITY => *self.endless.entry(facet).or_default() += 1.0,
            _ => *self.hairs.entry(facet).or_default() += length,
        }
    }
}

/// All of a flow complex, and the facet of each of its edges that crosses one.
struct Whole<'a> {
    diagram: &'a Diagram,
    complex: FlowComplex,
    facet_of_face: Vec<u32>,
    facet_of_edge: Vec<u32>,
}

impl<'a> Whole<'a> {
    fn new(diagram: &'a Diagram, flow: &Arc<Flow>) -> Self {
        let complex = FlowComplex::new(flow, &Job::default()).unwrap();
        let of_face = (0..).zip(complex.faces_of_facet().windows(2));
        let facet_of_face: Vec<u32> =
            of_face.flat_map(|(f, row)| (row[0]..row[1]).map(move |_| f)).collect();
        let mut facet_of_edge = vec![NONE; complex.edges().len()];
        for (face, row) in complex.faces().offsets().windows(2).enumerate() {
            for &edge in &complex.face_edges()[row[0] as usize..row[1] as usize] {
                facet_of_edge[edge as usize] = facet_of_face[face];
            }
        }
        Whole { diagram, complex, facet_of_face, facet_of_edge }
    }

    fn place(&self, vertex: u32) -> Point {
        let centers = &self.diagram.centers;
        match (vertex as usize).checked_sub(centers.len()) {
            None => centers[vertex as usize],
            Some(point) => self.complex.points()[point],
        }
    }

    /// A face as a polygon of its facet.
    fn polygon(&self, face: usize) -> Vec<Corner> {
        let its = &self.diagram.facets[self.facet_of_face[face] as usize];
        let begin = self.complex.faces().offsets()[face] as usize;
        let rim = self.complex.faces().row(face);
        let mut polygon = Vec::new();
        for (i, &v) in rim.iter().enumerate() {
            if v != NONE {
                polygon.push(Corner::Finite(its.plane(self.place(v))));
                continue;
            }
            for side in [(i + rim.len() - 1) % rim.len(), i] {
                let edge = self.complex.face_edges()[begin + side] as usize;
                let ends = self.complex.edges()[edge];
                let finite = its.plane(self.place(ends[usize::from(ends[0] == NONE)]));
                let direction = match self.complex.triangle_of_edge().get(edge) {
                    Some(&triangle) => {
                        let ray = &self.diagram.edges[triangle as usize];
                        its.direction(sub(ray.to, ray.from))
                    }
                    None => finite,
                };
                polygon.push(Corner::Infinite(finite, direction));
            }
        }
        polygon
    }

    /// What is reached from some Voronoi faces.
    fn closure(&self, seeds: &[Simplex]) -> Reached {
        let elements = seeds.iter().flat_map(|&seed| self.complex.elements_of(seed).unwrap());
        let elements: Vec<FlowElement> = elements.collect();
        let closure = self.complex.closure(&elements, &Job::default()).unwrap();
        let mut reached = Reached::default();
        let mut is_rim = vec![false; self.complex.edges().len()];
        for &element in &closure {
            let FlowElement::Face(face) = element else { continue };
            let facet = self.facet_of_face[face as usize];
            let area = self.diagram.area(facet, &self.polygon(face as usize));
            *reached.areas.entry(facet).or_default() += area;
            let row = &self.complex.faces().offsets()[face as usize..face as usize + 2];
            for &edge in &self.complex.face_edges()[row[0] as usize..row[1] as usize] {
                is_rim[edge as usize] = true;
            }
        }
        for &element in &closure {
            match element {
                FlowElement::Vertex(v) if (v as usize) < self.diagram.centers.len() => {
                    reached.vertices.insert(v);
                }
                FlowElement::Edge(edge) => self.add_edge(edge, is_rim[edge as usize], &mut reached),
                _ => {}
            }
        }
        reached
    }

    fn add_edge(&self, edge: u32, is_rim: bool, reached: &mut Reached) {
        let [from, to] = self.complex.edges()[edge as usize];
        match self.complex.triangle_of_edge().get(edge as usize) {
            Some(&triangle) => {
                let its = &self.diagram.edges[triangle as usize];
                let along = length(sub(its.to, its.from));
                let share = |v: u32| match v {
                    NONE => f64::INFINITY,
                    v => length(sub(self.place(v), its.from)) / along,
                };
                let length = its.length([share(from), share(to)]);
                *reached.edges.entry(triangle).or_default() += length;
                *reached.loose.entry(triangle).or_default() += if is_rim { 0.0 } else { length };
            }
            None if is_rim => {}
            None => {
                let facet = self.facet_of_edge[edge as usize];
                let is_endless = to == NONE;
                let far = || length(sub(self.place(to), self.place(from)));
                reached.add_hair(facet, if is_endless { f64::INFINITY } else { far() });
            }
        }
    }
}

/// What of a complex is bounded: areas of its faces, lengths of its loose edges.
fn bounded(diagram: &Diagram, complex: &Complex) -> Reached {
    let numbers = |element, name: &str| match complex.attribute(element, name).unwrap().values() {
        Values::U32(numbers) => numbers,
        other => panic!("{name} is {other:?}"),
    };
    let mut reached = Reached::default();
    for (face, &facet) in numbers(Element::Face, "facet").iter().enumerate() {
        let its = &diagram.facets[facet as usize];
        let corner = |&v: &u32| Corner::Finite(its.plane(complex.vertices()[v as usize]));
        let polygon: Vec<Corner> = complex.faces().row(face).iter().map(corner).collect();
        *reached.areas.entry(facet).or_default() += diagram.area(facet, &polygon);
    }
    for (ends, samples) in
        complex.edges().iter().zip(numbers(Element::Edge, "samples").chunks_exact(3))
    {
        let [from, to] = ends.map(|v| complex.vertices()[v as usize]);
        match *samples {
            [p, q, NONE] => {
                reached.add_hair(diagram.facet_of[&sorted([p, q])], length(sub(to, from)))
            }
            [p, q, r] => {
                let edge = diagram.edge_of[&sorted([p, q, r])];
                let its = &diagram.edges[edge as usize];
                let along = length(sub(its.to, its.from));
                let shares = [from, to].map(|at| length(sub(at, its.from)) / along);
                *reached.loose.entry(edge).or_default() += its.length(shares);
            }
            _ => unreachable!(),
        }
    }
    let cells = numbers(Element::Vertex, "cell").iter().copied();
    reached.vertices = cells.filter(|&cell| cell != NONE).collect();
    reached
}

/// Samples in general position.
fn sets() -> [(&'static str, Vec<Point>); 3] {
    let mut random = Random(12);
    [
        ("cloud", (0..300).map(|_| random.cube()).collect()),
        ("torus", samples(Shape::Torus, 0.15)),
        ("genus 3", samples(Shape::Genus3, 0.25)),
    ]
}

/// Asserts that lengths or areas agree; those of one side that the other does not have are 0.
fn assert_near(what: &str, a: &BTreeMap<u32, f64>, b: &BTreeMap<u32, f64>, scale: f64) {
    let keys: BTreeSet<_> = a.keys().chain(b.keys()).collect();
    for key in keys {
        let [a, b] = [a, b].map(|its| its.get(key).copied().unwrap_or(0.0));
        assert!((a - b).abs() <= 1e-9 * (scale + a.max(b)), "{what} of {key}: {a}, {b}");
    }
}

/// Asserts that what is reached from some faces is the same, however it was found.
fn assert_reached(name: &str, seeds: &[Simplex], whole: &Whole<'_>) -> Reached {
    let diagram = whole.diagram;
    let [traced, found] = [trace(diagram, seeds), whole.closure(seeds)];
    let unit = diagram.diagonal;
    // But for rounding where there is hardly an area.
    let total = traced.areas.values().sum::<f64>() + 1e-4 * unit * unit;
    let name = format!("{name}, {seeds:?}");
    assert_near(&format!("{name}: areas"), &traced.areas, &found.areas, total);
    assert_near(&format!("{name}: edges"), &traced.edges, &found.edges, unit);
    assert_near(&format!("{name}: loose"), &traced.loose, &found.loose, unit);
    assert_near(&format!("{name}: hairs"), &traced.hairs, &found.hairs, unit);
    assert_near(&format!("{name}: endless"), &traced.endless, &found.endless, 0.0);
    assert_eq!(traced.vertices, found.vertices, "{name}");
    traced
}

/// Critical points of index 1 and 2; then facets, Voronoi edges and vertices at random.
fn seeds(flow: &Flow) -> (Vec<Simplex>, Vec<Simplex>) {
    let has_manifold = |simplex: &Simplex| [1, 2].contains(&simplex.dimension());
    let critical = flow.critical().simplices().iter().copied().filter(has_manifold).collect();
    let some = |count: usize, most: usize, simplex: fn(u32) -> Simplex| {
        shuffled(count, 5).into_iter().take(most).map(move |i| simplex(i as u32))
    };
    let facets = some(flow.dual().facets().unwrap().len(), 1000, Simplex::Edge);
    let edges = some(flow.triangles().len(), 300, Simplex::Triangle);
    let vertices = some(flow.dual().centers().len(), 300, Simplex::Cell);
    (critical, facets.chain(edges).chain(vertices).collect())
}

#[test]
fn unstable_manifolds_are_those_of_wedges() {
    for (name, rows) in sets() {
        let flow = Arc::new(flow(&rows, all_inner, &Job::default()));
        let diagram = Diagram::new(&flow);
        let whole = Whole::new(&diagram, &flow);
        let (critical, _) = seeds(&flow);
        let reached: Vec<Reached> =
            critical.iter().map(|&seed| assert_reached(name, &[seed], &whole)).collect();
        // There is something to compare: facets cut, hairs, edges followed in part.
        let count = |is: fn(&Reached) -> bool| reached.iter().filter(|its| is(its)).count();
        let counts = [
            count(|its| its.areas.len() > 1),
            count(|its| !its.hairs.is_empty()),
            count(|its| !its.endless.is_empty()),
            count(|its| its.areas.is_empty() && its.loose.len() > 1),
        ];
        assert!(counts.iter().all(|&count| count > 50), "{name}: {counts:?}");
    }
}

#[test]
fn closures_of_voronoi_faces_are_those_of_wedges() {
    for (name, rows) in sets() {
        let flow = Arc::new(flow(&rows, all_inner, &Job::default()));
        let diagram = Diagram::new(&flow);
        let whole = Whole::new(&diagram, &flow);
        let (_, others) = seeds(&flow);
        for &seed in &others {
            assert_reached(name, &[seed], &whole);
        }
        for several in others.chunks(7) {
            assert_reached(name, several, &whole);
        }
    }
}

/// Of what is bounded the areas are those of all of the flow complex; of what is not, cut less, as much is left out.
#[test]
fn closures_cut_alone_are_those_of_the_flow_complex() {
    for (name, rows) in sets() {
        let flow = Arc::new(flow(&rows, all_inner, &Job::default()));
        let diagram = Diagram::new(&flow);
        let whole = Whole::new(&diagram, &flow);
        let facets = flow.dual().facets().unwrap();
        let (critical, others) = seeds(&flow);
        for several in critical.chunks(1).chain(others.chunks(1)).chain(others.chunks(7)) {
            let complex = flow.closure(several, &Job::default()).unwrap();
            let (mut alone, mut all) = (bounded(&diagram, &complex), whole.closure(several));
            let name = format!("{name}, {several:?}");
            let total = all.areas.values().sum::<f64>() + 1e-4 * diagram.diagonal.powi(2);
            for (facet, &area) in &alone.areas {
                let most = all.areas.get(facet).copied().unwrap_or(0.0);
                assert!(area <= most + 1e-9 * (total + most), "{name}: {facet}");
            }
            for its in [&mut alone, &mut all] {
                its.areas.retain(|&facet, _| !facets.is_unbounded(facet as usize));
                its.loose.retain(|&edge, _| diagram.edges[edge as usize].last == 1.0);
            }
            assert_near(&format!("{name}: areas"), &alone.areas, &all.areas, total);
            assert_near(&format!("{name}: loose"), &alone.loose, &all.loose, diagram.diagonal);
            assert_near(&format!("{name}: hairs"), &alone.hairs, &all.hairs, diagram.diagonal);
            assert_eq!(alone.vertices, all.vertices, "{name}");
        }
    }
}
