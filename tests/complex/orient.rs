//! Orientation: shuffled directions are put right, shells of voids included.

use super::shapes::*;
use medax::complex::{Attribute, Element, Measure, Values};
use medax::{Complex, Job, Status};

fn oriented(builder: &Builder) -> Complex {
    let complex = builder.build().oriented(&Job::default()).unwrap();
    assert!(complex.validate(&Job::default()).unwrap().is_valid());
    complex
}

fn measure(complex: &Complex) -> Measure {
    complex.measure(&Job::default()).unwrap()
}

fn is_oriented(complex: &Complex) -> bool {
    complex.topology(&Job::default()).unwrap().oriented
}

/// Turns about half of the faces round, and starts each elsewhere.
fn shuffled(mut builder: Builder, random: &mut Random) -> Builder {
    for face in &mut builder.faces {
        let n = face.len();
        face.rotate_left(random.below(n));
        if random.below(2) == 0 {
            face.reverse();
        }
    }
    builder
}

#[test]
fn solids_point_out_and_voids_in() {
    let mut random = Random(3);
    let keep: [&dyn Fn([u32; 3]) -> bool; 5] = [
        &|_| true,
        // An onion: a ball in a void in a ball in a void in a ball.
        &|p| p.iter().map(|&k| k.abs_diff(4)).max().unwrap() % 2 == 0,
        // Voids in a row, the last one with something in it.
        &|p| {
            !(p[1] % 4 == 1 && p[2] == 1 && p[0] == 1 || p[1] > 4 && p[1] < 8 && p[0] > 4)
                || p == [6, 6, 6]
        },
        // A bracket with a tunnel.
        &|p| p[0] != 2 || p[1] != 2,
        // Cubes that touch along edges and in corners.
        &|p| (p[0] + p[1]) % 2 == 0 && p[2] == 3,
    ];
    for keep in keep {
        let solid = cubes([9, 9, 9], keep);
        let skin = outer_facets(&solid);
        let right = skin.build();
        let volume = solid.cells.len() as f64 / 6.0;
        assert_eq!(measure(&right).volume, volume);
        let fixed = oriented(&shuffled(skin, &mut random));
        assert!(is_oriented(&fixed));
        assert_eq!(measure(&fixed).volume, volume);
        assert_eq!(measure(&fixed).area, measure(&right).area);
        // Nothing is left to do.
        assert_eq!(fixed.oriented(&Job::default()).unwrap(), fixed);
    }
}

/// A box with outward quads.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Builder {
    Builder::new(8)
        .faces(&[
            [0, 1, 3, 2],
            [4, 6, 7, 5],
            [0, 4, 5, 1],
            [2, 3, 7, 6],
            [0, 2, 6, 4],
            [1, 5, 7, 3],
        ])
        .place(|i| std::array::from_fn(|k| if i >> (2 - k) & 1 == 1 { high[k] } else { low[k] }))
}

/// Boxes nested at random on a lattice, never touching; returns the volume of the material.
fn nest(low: [i64; 3], high: [i64; 3], depth: i64, random: &mut Random, into: &mut Builder) -> f64 {
    let corner = |p: [i64; 3]| p.map(|x| x as f64);
    *into = into.clone().and(&cuboid(corner(low), corner(high)));
    let own = (0..3).map(|k| (high[k] - low[k]) as f64).product::<f64>();
    let mut volume = if depth % 2 == 0 { own } else { -own };
    // Slabs along x, with a gap between, each of which may hold a box.
    let mut x = low[0] + 1;
    while x + 2 < high[0] {
        let end = (x + 2 + random.below(12) as i64).min(high[0] - 1);
        let (y, z) = (low[1] + 1, low[2] + 1);
        let room = high[1] - 1 - y > 0 && high[2] - 1 - z > 0 && end > x;
        if room && random.below(4) > 0 {
            volume += nest([x, y, z], [end, high[1] - 1, high[2] - 1], depth + 1, random, into);
        }
        x = end + 1;
    }
    volume
}

#[test]
fn nested_boxes_alternate() {
    for seed in 0..30 {
        let mut random = Random(seed);
        let mut boxes = Builder::new(0);
        let volume = nest([0; 3], [60, 24, 24], 0, &mut random, &mut boxes);
        let boxes = shuffled(boxes, &mut random);
        let fixed = oriented(&boxes);
        assert!(is_oriented(&fixed));
        assert_eq!(measure(&fixed).volume, volume, "seed {seed}");
        // Far away and tiny: a power of two leaves everything as it was.
        let mut far = boxes;
        far.vertices.iter_mut().for_each(|p| *p = p.map(|x| x * 2f64.powi(-300)));
        let far = far.build().oriented(&Job::default()).unwrap();
        assert_eq!(far.faces(), fixed.faces());
    }
}

#[test]
fn solids_side_by_side_are_apart() {
    // A wall in common by coordinates, not by index; subdivided, so that vertices touch walls.
    let left = outer_facets(&cubes([2, 3, 3], |_| true));
    let mut right = cuboid([2.0, 0.0, 0.0], [4.0, 3.0, 3.0]);
    let both = shuffled(left.clone().and(&right), &mut Random(1));
    assert_eq!(measure(&oriented(&both)).volume, 18.0 + 18.0);
    // A void that touches its hull from within.
    right = cuboid([0.0, 1.0, 1.0], [1.0, 2.0, 2.0]);
    let touching = shuffled(left.and(&right), &mut Random(2));
    assert_eq!(measure(&oriented(&touching)).volume, 18.0 - 1.0);
}

#[test]
fn open_patches_agree_with_most_of_their_faces() {
    let mut band = band(6, false);
    band.faces[3].reverse();
    band.faces[8].reverse();
    let fixed = oriented(&band);
    assert!(is_oriented(&fixed));
    let turned = |f: usize| fixed.faces().row(f) != band.faces[f];
    assert_eq!((0..12).filter(|&f| turned(f)).collect::<Vec<_>>(), [3, 8]);
    // The first vertex stays first.
    assert!((0..12).all(|f| fixed.faces().row(f)[0] == band.faces[f][0]));
    assert_eq!(
        fixed.triangles()[3],
        [fixed.faces().row(3)[0], fixed.faces().row(3)[1], fixed.faces().row(3)[2]]
    );
}

#[test]
fn what_cannot_be_oriented_stays() {
    for shape in [band(5, true), projective_plane(), wrapped_grid(4, 3, true, true)] {
        let shape = shuffled(shape, &mut Random(7));
        assert_eq!(oriented(&shape), shape.build());
    }
    // Next to a sphere, the sphere is put right. A shell without volume has no outside.
    let mixed = tetrahedron().and(&band(5, true)).and(&torus(3, 3));
    let mut inside_out = mixed.clone();
    inside_out.faces[..4].iter_mut().for_each(|f| f.reverse());
    let fixed = oriented(&inside_out);
    assert!((0..4).all(|f| fixed.faces().row(f)[0] == inside_out.faces[f][0]));
    assert_eq!(measure(&fixed).volume, 1.0 / 6.0);
    assert!((4..mixed.faces.len()).all(|f| fixed.faces().row(f) == mixed.faces[f]));
}

#[test]
fn faces_listed_twice_follow_each_other() {
    let mut shape = tetrahedron();
    let again: Vec<Vec<u32>> = shape.faces.iter().rev().cloned().collect();
    shape.faces.extend(again);
    let shape = shuffled(shape, &mut Random(11));
    assert_eq!(measure(&oriented(&shape)).volume, 2.0 / 6.0);
}

#[test]
fn everything_else_is_kept() {
    let mut parts = tetrahedron().edges(&[[0, 3]]).tets(&[[0, 1, 2, 3]]).parts();
    let values = Values::F64(vec![1.0, 2.0, 3.0, 4.0]);
    parts.attributes.push(Attribute::new("label", Element::Face, 1, values).unwrap());
    let complex = Complex::new(parts).unwrap();
    assert_eq!(complex.oriented(&Job::default()).unwrap(), complex);
    let spent = Job::default();
    spent.cancel();
    assert_eq!(complex.oriented(&spent).unwrap_err().status(), Status::Cancelled);
    assert_eq!(complex.measure(&spent).unwrap_err().status(), Status::Cancelled);
}

#[test]
fn measures_of_any_size() {
    let cube = cuboid([1.0; 3], [3.0; 3]);
    assert_eq!(measure(&cube.build()), Measure { area: 24.0, volume: 8.0 });
    assert_eq!(measure(&Builder::new(0).build()), Measure { area: 0.0, volume: 0.0 });
    let scaled = |s: f64| {
        let mut cube = cube.clone();
        cube.vertices.iter_mut().for_each(|p| *p = p.map(|x| x * s));
        measure(&cube.build())
    };
    let tiny = scaled(2f64.powi(-350));
    assert_eq!((tiny.area, tiny.volume), (24.0 * 2f64.powi(-700), 8.0 * 2f64.powi(-1050)));
    assert_eq!(scaled(2f64.powi(500)).area, 24.0 * 2f64.powi(1000));
    assert_eq!(scaled(2f64.powi(900)).volume, f64::INFINITY);
    // Far from the origin nothing cancels.
    let mut far = cube.clone();
    far.vertices.iter_mut().for_each(|p| *p = p.map(|x| x + 1e9));
    assert_eq!(measure(&far.build()).volume, 8.0);
}
