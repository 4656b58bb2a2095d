//! The point sets that triangulators are tried on.

/// A named set of rows.
pub struct Set {
    pub name: &'static str,
    pub rows: Vec<[f64; 3]>,
}

/// A stream of random numbers (SplitMix64).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn cube(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.unit())
    }

    /// Uniform on the unit sphere, up to rounding.
    pub fn sphere(&mut self) -> [f64; 3] {
        loop {
            let p = self.cube().map(|x| 2.0 * x - 1.0);
            let r = p.iter().map(|x| x * x).sum::<f64>();
            if (0.01..=1.0).contains(&r) {
                return p.map(|x| x / r.sqrt());
            }
        }
    }
}

/// A permutation of `0..n`.
pub fn shuffled(n: usize, seed: u64) -> Vec<usize> {
    let mut random = Random(seed ^ 0x5eed);
    let mut order: Vec<usize> = (0..n).collect();
    for i in (1..n).rev() {
        order.swap(i, (random.next() % (i as u64 + 1)) as usize);
    }
    order
}

/// One set of each kind, of about `n` rows.
pub fn all(n: usize) -> Vec<Set> {
    let mut random = Random(n as u64);
    let mut sets = Vec::new();
    let mut add = |name, rows| sets.push(Set { name, rows });
    let uniform: Vec<[f64; 3]> = (0..n).map(|_| random.cube()).collect();
    add("uniform", uniform.clone());
    let centres: Vec<_> = (0..5).map(|_| random.cube()).collect();
    let near = |c: [f64; 3], r: &mut Random| {
        let offset = r.cube();
        std::array::from_fn(|k| c[k] + 1e-4 * offset[k] * offset[k])
    };
    add("clustered", (0..n).map(|i| near(centres[i % 5], &mut random)).collect());
    add(
        "ellipsoid",
        (0..n).map(|_| random.sphere()).map(|[x, y, z]| [x, 0.7 * y, 0.4 * z]).collect(),
    );
    let side = (n as f64).cbrt().ceil() as usize;
    let lattice: Vec<[f64; 3]> = (0..side * side * side)
        .map(|i| [i % side, i / side % side, i / side / side].map(|x| x as f64))
        .collect();
    let order = shuffled(lattice.len(), 1);
    add("lattice", order.iter().map(|&i| lattice[i]).take(n).collect());
    add("cospherical", cospherical(n));
    let mut flat: Vec<[f64; 3]> =
        (0..n).map(|_| random.cube()).map(|[x, y, _]| [(8.0 * x).floor(), y, 0.5]).collect();
    flat.extend((0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(|x| 8.0 * f64::from(x))));
    add("coplanar and a box", flat);
    let mut double = uniform.clone();
    double.truncate(n / 2 + 4);
    double.extend_from_within(..);
    add("duplicated", double);
    let mut close = uniform.clone();
    close.truncate(n / 4 + 4);
    for i in 0..close.len() {
        for axis in 0..3 {
            let mut p = close[i];
            p[axis] = p[axis].next_up();
            close.push(p);
        }
    }
    add("one ulp apart", close);
    add("scaled by 1e-9", uniform.iter().map(|p| p.map(|x| x * 1e-9)).collect());
    add("scaled by 1e9", uniform.iter().map(|p| p.map(|x| x * 1e9)).collect());
    add("far away", uniform.iter().map(|p| p.map(|x| x + 1e9)).collect());
    add("lattice far away", lattice.iter().map(|p| p.map(|x| x * 0.5 + 1e15)).take(n).collect());
    add(
        "two lines",
        (0..n)
            .map(|i| i as f64)
            .map(|x| if (x as usize).is_multiple_of(2) { [x, 0.0, 0.0] } else { [0.0, x, 1.0] })
            .collect(),
    );
    sets
}

/// Integer points on one sphere.
fn cospherical(n: usize) -> Vec<[f64; 3]> {
    let square: i32 = if n < 50 { 9 } else { 1925 };
    let root = (f64::from(square)).sqrt() as i32;
    let mut rows = Vec::new();
    for x in -root..=root {
        for y in -root..=root {
            let zz = square - x * x - y * y;
            let z = f64::from(zz.max(0)).sqrt() as i32;
            if zz >= 0 && z * z == zz {
                rows.push([x, y, z].map(f64::from));
                rows.push([x, y, -z].map(f64::from));
            }
        }
    }
    let order = shuffled(rows.len(), 2);
    order.iter().map(|&i| rows[i]).take(n.max(8)).collect()
}

/// Weights for the rows: random ones, tied ones, and ones that hide many points.
pub fn weights(rows: &[[f64; 3]]) -> Vec<(&'static str, Vec<f64>)> {
    let mut random = Random(rows.len() as u64);
    let extent = |k: usize| {
        let (min, max) =
            rows.iter().fold((f64::MAX, f64::MIN), |(min, max), p| (min.min(p[k]), max.max(p[k])));
        max - min
    };
    let unit = (0..3).map(extent).fold(0.0, f64::max) / (rows.len() as f64).cbrt();
    let square = unit * unit;
    vec![
        ("random", rows.iter().map(|_| square * random.unit()).collect()),
        ("tied", rows.iter().map(|_| square * (random.next() % 3) as f64 / 2.0).collect()),
        ("heavy", rows.iter().map(|_| 20.0 * square * random.unit()).collect()),
    ]
}
