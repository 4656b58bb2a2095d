//! Real meshes, with the topology that `MANIFEST.md` beside them gives.

use super::shapes::*;
use medax::io::read_complex;
use medax::{Complex, Job};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The folder of the models, or nothing, said plainly.
fn data() -> Option<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: {} is not there", folder.display());
    None
}

fn builder(complex: &Complex) -> Builder {
    let mut builder = Builder { vertices: complex.vertices().to_vec(), ..Builder::default() };
    builder.faces = complex.faces().iter().map(|f| f.to_vec()).collect();
    builder
}

/// The mesh as the manifest counts it: equal positions merged, collapsed triangles and unused
/// vertices left out.
fn welded(complex: &Complex) -> Builder {
    let mut first: BTreeMap<[u64; 3], u32> = BTreeMap::new();
    let mut mesh = builder(complex);
    let of: Vec<u32> = (mesh.vertices.iter().zip(0..))
        .map(|(p, v)| *first.entry(p.map(|x| (x + 0.0).to_bits())).or_insert(v))
        .collect();
    mesh.faces.iter_mut().flatten().for_each(|v| *v = of[*v as usize]);
    mesh.faces.retain(|f| f[0] != f[1] && f[1] != f[2] && f[2] != f[0]);
    mesh.compact()
}

/// File, components, Euler characteristic, genus where the manifest gives one, boundary edges and loops.
type Model = (&'static str, u64, i64, Option<u64>, u64, u64);

const MODELS: [Model; 14] = [
    ("3holes.off", 1, -4, Some(3), 0, 0),
    ("fandisk.off", 1, 2, Some(0), 0, 0),
    ("rocker-arm.obj", 1, 0, Some(1), 0, 0),
    ("mannequin.off", 1, 2, Some(0), 0, 0),
    ("foot.off", 1, 2, Some(0), 0, 0),
    ("foot_hole.off", 1, 1, None, 44, 1),
    ("ant.off", 1, 2, Some(0), 0, 0),
    ("abc_plate_00000329.obj", 1, -4, Some(3), 0, 0),
    ("octopus.off", 4, 8, Some(0), 0, 0),
    ("refined_elephant.off", 1, -4, Some(3), 0, 0),
    ("stanford-bunny.obj", 1, -3, None, 223, 5),
    ("igea.ply", 1, 2, Some(0), 0, 0),
    ("dragon.ply", 1, -108, Some(55), 0, 0),
    ("cavity_and_ring.off", 3, 4, Some(1), 0, 0),
];

#[test]
fn topology_of_the_models() {
    let Some(folder) = data() else { return };
    for (name, components, euler, genus, edges, loops) in MODELS {
        let complex = read_complex(folder.join(name), &Job::default()).unwrap();
        let t = welded(&complex).build().topology(&Job::default()).unwrap();
        assert_eq!((t.components, t.euler_characteristic), (components, euler), "{name}");
        assert_eq!((t.boundary_edges, t.boundary_loops), (edges, loops), "{name}");
        assert_eq!(t.closed, edges == 0, "{name}");
        if let Some(genus) = genus {
            assert_eq!(t.genus, Some(genus), "{name}");
            assert_eq!(t.betti, [components, 2 * genus, components], "{name}");
        } else {
            // No closed pieces: b2 = 0, and the Euler characteristic leaves b1.
            assert_eq!(t.betti, [1, (1 - euler) as u64, 0], "{name}");
        }
    }
}

#[test]
fn topology_by_index() {
    let Some(folder) = data() else { return };
    let topology = |name: &str| {
        let complex = read_complex(folder.join(name), &Job::default()).unwrap();
        complex.topology(&Job::default()).unwrap()
    };
    let t = topology("dragon.ply");
    assert_eq!((t.components, t.boundary_edges, t.euler_characteristic), (151, 4270, -197));
    assert!(!t.closed);
    let t = topology("stanford-bunny.obj");
    assert_eq!((t.isolated_vertices, t.components), (1113, 1114));
    assert_eq!((t.euler_characteristic, t.boundary_loops), (-3 + 1113, 5));
}

#[test]
fn directions_are_put_right() {
    let Some(folder) = data() else { return };
    for name in ["cavity_and_ring.off", "rocker-arm.obj", "fandisk.off", "refined_elephant.off"] {
        let complex = read_complex(folder.join(name), &Job::default()).unwrap();
        let mut mesh = builder(&complex);
        let mut random = Random(1);
        for face in &mut mesh.faces {
            if random.below(2) == 0 {
                face[1..].reverse();
            }
        }
        let fixed = mesh.build().oriented(&Job::default()).unwrap();
        assert!(fixed.topology(&Job::default()).unwrap().oriented, "{name}");
        // The files point out of the material.
        assert_eq!(fixed.faces(), complex.faces(), "{name}");
    }
}
