//! What of an inner structure is asked for.

use super::PairMesh;
use crate::complex::{Complex, Element, Values};
use crate::error::{ElementKind, Error, Result, Status};
use crate::index::NONE;
use crate::job::{Room, Run};
use std::collections::{BTreeSet, HashMap, HashSet};

/// Faces and edges of the inner structure that stay, and their corners, which stay where they are.
pub(super) struct Target {
    faces: Vec<bool>,
    edges: HashSet<[u32; 2]>,
    /// For each inner vertex, whether it is a corner of one of these.
    pub is_fixed: Vec<bool>,
    /// How many of the facets and edges asked for are not there.
    pub missing: usize,
}

impl Target {
    pub fn is_asked(&self, face: u32) -> bool {
        self.faces[face as usize]
    }

    pub fn is_edge_asked(&self, [v, w]: [u32; 2]) -> bool {
        self.edges.contains(&[v.min(w), v.max(w)])
    }

    /// The faces and edges that have a piece of a complex in them, whose `samples` tell of which Voronoi facets and edges its faces and loose edges are.
    pub fn new(mesh: &PairMesh, of: &Complex, room: &mut Room<'_>, run: &Run<'_>) -> Result<Self> {
        let (facets, triangles) = wanted(of, room, run)?;
        let mut its = Target {
            faces: room.vec(mesh.faces.len())?,
            edges: HashSet::new(),
            is_fixed: room.filled(mesh.inner.len(), false)?,
            missing: 0,
        };
        let mut found: HashSet<[u32; 2]> = HashSet::new();
        for item in run.watch((0..).zip(mesh.faces.iter())) {
            let (face, corners) = item?;
            let mut samples =
                [2 * face, 2 * face + 1].map(|element| mesh.sample_of(mesh.ring(element)[0]));
            samples.sort_unstable();
            let is_asked = facets.contains_key(&samples);
            its.faces.push(is_asked);
            if is_asked {
                room.keep(size_of::<[u32; 2]>())?;
                found.insert(samples);
                corners.iter().for_each(|&v| its.is_fixed[v as usize] = true);
            }
        }
        // Where samples are cospherical a facet may be an edge or a vertex, an edge a vertex, and several edges one, with more than three samples round it.
        let flat = facets.into_keys().filter(|facet| !found.contains(facet));
        let flat: BTreeSet<Vec<u32>> =
            flat.map(Vec::from).chain(triangles.into_keys().map(Vec::from)).collect();
        if !flat.is_empty() {
            its.add_edges(mesh, flat, room, run)?;
        }
        Ok(its)
    }

    /// Adds the edges that have some samples round them, and counts the samples that have neither an edge nor a vertex in common.
    fn add_edges(
        &mut self,
        mesh: &PairMesh,
        all: BTreeSet<Vec<u32>>,
        room: &mut Room<'_>,
        run: &Run<'_>,
    ) -> Result<()> {
        let mut of_sample: HashMap<u32, Vec<&Vec<u32>>> = HashMap::new();
        for samples in &all {
            room.keep(size_of::<[u64; 8]>())?;
            of_sample.entry(samples[0]).or_default().push(samples);
        }
        let mut found: HashSet<&Vec<u32>> = HashSet::new();
        for item in run.watch(samples_of_edges(mesh, room, run)?) {
            let (edge, round) = item?;
            let near = round.iter().filter_map(|sample| of_sample.get(sample)).flatten();
            for &samples in near.filter(|its| its.iter().all(|v| round.contains(v))) {
                edge.iter().for_each(|&v| self.is_fixed[v as usize] = true);
                room.keep(size_of::<[u32; 8]>())?;
                self.edges.insert(edge);
                found.insert(samples);
            }
        }
        let mut nodes = room
            .collect(mesh.nodes.iter().map(|&[b, v]| [mesh.sample_of_boundary[b as usize], v]))?;
        nodes.sort_unstable();
        let has = |sample: u32, v: u32| nodes.binary_search(&[sample, v]).is_ok();
        for samples in all.iter().filter(|&samples| !found.contains(samples)) {
            run.poll()?;
            let begin = nodes.partition_point(|&[sample, _]| sample < samples[0]);
            let at = nodes[begin..].iter().take_while(|node| node[0] == samples[0]);
            let vertex = at.map(|node| node[1]).find(|&v| samples.iter().all(|&s| has(s, v)));
            match vertex {
                Some(v) => self.is_fixed[v as usize] = true,
                None => self.missing += 1,
            }
        }
        Ok(())
    }
}

type Wanted<const N: usize> = HashMap<[u32; N], ()>;

/// The pairs of samples of the facets, and the triples of the edges, that a complex has pieces of. An edge within a facet stands for the facet.
fn wanted(of: &Complex, room: &mut Room<'_>, run: &Run<'_>) -> Result<(Wanted<2>, Wanted<3>)> {
    let (mut facets, mut triangles) = (HashMap::new(), HashMap::new());
    for samples in run.watch(rows::<2>(of, Element::Face, of.faces().len())?) {
        let mut samples = *samples?;
        samples.sort_unstable();
        room.insert(&mut facets, samples, ())?;
    }
    for samples in run.watch(rows::<3>(of, Element::Edge, of.edges().len())?) {
        let mut samples = *samples?;
        samples.sort_unstable();
        match samples {
            [a, b, NONE] => room.insert(&mut facets, [a, b], ())?,
            _ => room.insert(&mut triangles, samples, ())?,
        };
    }
    Ok((facets, triangles))
}

/// The attribute `samples` of the faces or the loose edges of a complex.
fn rows<const N: usize>(of: &Complex, element: Element, count: usize) -> Result<&[[u32; N]]> {
    if count == 0 {
        return Ok(&[]);
    }
    let attribute = of.attribute(element, "samples").filter(|its| its.width() == N);
    match attribute.map(|its| its.values()) {
        Some(Values::U32(values)) => Ok(values.as_chunks::<N>().0),
        _ => {
            let (name, kind) = match element {
                Element::Face => ("faces", ElementKind::Face),
                _ => ("loose edges", ElementKind::Edge),
            };
            let message = format!(
                "the {name} of the complex have no attribute 'samples' of {N} indices, by which their Voronoi facets are known"
            );
            Err(Error::new(Status::InvalidArgument, message).at(kind, 0))
        }
    }
}

/// The samples round each inner edge.
pub(super) fn samples_of_edges(
    mesh: &PairMesh,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<HashMap<[u32; 2], BTreeSet<u32>>> {
    let mut edges: HashMap<[u32; 2], BTreeSet<u32>> = HashMap::new();
    for ring in run.watch(mesh.rings.iter()) {
        let ring = ring?;
        for (&m, &n) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let [v, w] = [m, n].map(|node| mesh.nodes[node as usize][1]);
            if v < w {
                room.keep(size_of::<u32>())?;
                edges.entry([v, w]).or_default().insert(mesh.sample_of(m));
            }
        }
    }
    Ok(edges)
}
