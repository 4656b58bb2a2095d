//! Points on which predicates are hard: every kind of closeness and of scale.

/// A small deterministic generator (SplitMix64).
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Less than `n`.
    pub fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// Uniform in [-1, 1].
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// An integer within [-n, n].
    pub fn integer(&mut self, n: u64) -> f64 {
        self.below(2 * n + 1) as f64 - n as f64
    }

    pub fn triple(&mut self, mut coordinate: impl FnMut(&mut Self) -> f64) -> [f64; 3] {
        std::array::from_fn(|_| coordinate(self))
    }
}

/// 2^k for a normal number.
pub fn power_of_two(k: i32) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
}

/// `x` moved by so many representable steps.
pub fn nudge(x: f64, steps: i64) -> f64 {
    if x == 0.0 { x } else { f64::from_bits(x.to_bits().wrapping_add_signed(steps)) }
}

/// A float with a random exponent from `low` to `high` and a random mantissa, or zero.
pub fn anything(random: &mut Random, low: i32, high: i32) -> f64 {
    if random.below(16) == 0 {
        return 0.0;
    }
    let exponent = low + random.below((high - low) as u64) as i32;
    let mantissa = match random.below(3) {
        0 => 1.0,
        1 => 1.0 + random.below(16) as f64 / 16.0,
        _ => 1.0 + (random.bits() >> 12) as f64 / (1u64 << 52) as f64,
    };
    let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
    sign * mantissa * power_of_two(exponent)
}

/// An integer that is a few units, or close to 2^top.
fn extreme(random: &mut Random, top: i32) -> f64 {
    let scale = if random.below(2) == 0 { 1.0 } else { power_of_two(top - 2) };
    scale * random.integer(4)
}

/// The names of the kinds of [`five`].
pub const KINDS: [&str; 13] = [
    "uniform",
    "small lattice",
    "large lattice",
    "far lattice",
    "near one line",
    "near one plane",
    "near one sphere",
    "poles of one sample",
    "balls through one lattice point",
    "wide integers",
    "mixed scales",
    "smallest",
    "largest",
];

/// Five weighted points of a kind. Weights: none, tied, or fitting the kind.
pub fn five(random: &mut Random, kind: &str) -> [[f64; 4]; 5] {
    let mut rows = match kind {
        "uniform" => each(random, |r| [r.unit(), r.unit(), r.unit(), r.unit()]),
        "small lattice" => {
            each(random, |r| [r.integer(2), r.integer(2), r.integer(2), r.integer(3)])
        }
        "large lattice" => {
            let n = 1 << (4 + random.below(26));
            each(random, |r| [r.integer(n), r.integer(n), r.integer(n), r.integer(n)])
        }
        "far lattice" => {
            let origin = random.triple(|r| (r.bits() as i64 >> 20) as f64 * 128.0);
            let step = power_of_two(random.below(4) as i32);
            each(random, |r| {
                let [x, y, z] = origin.map(|x| x + step * r.integer(3));
                [x, y, z, step * step * r.integer(3)]
            })
        }
        "near one line" => near_line(random),
        "near one plane" => near_plane(random),
        "near one sphere" => near_sphere(random),
        "poles of one sample" => one_sample(random),
        "balls through one lattice point" => lattice_balls(random),
        "wide integers" => {
            // Differences of as many bits as one or two limbs hold, or a few more or less.
            let top = [60, 124][random.below(2) as usize] + random.below(6) as i32;
            each(random, |r| {
                let [x, y, z] = r.triple(|r| extreme(r, top));
                [x, y, z, extreme(r, 2 * top + 3)]
            })
        }
        "mixed scales" => each(random, |r| {
            let [x, y, z] = r.triple(|r| anything(r, -160, 200));
            [x, y, z, anything(r, -320, 400)]
        }),
        "smallest" => each(random, |r| {
            let [x, y, z] = r.triple(|r| anything(r, -160, -157));
            [x, y, z, anything(r, -320, -316)]
        }),
        "largest" => each(random, |r| {
            let [x, y, z] = r.triple(|r| anything(r, 196, 200));
            [x, y, z, anything(r, 392, 400)]
        }),
        _ => unreachable!("no such kind"),
    };
    match random.below(4) {
        0 => rows.iter_mut().for_each(|row| row[3] = 0.0),
        1 => {
            let weights = [rows[0][3], rows[1][3]];
            rows.iter_mut().for_each(|row| row[3] = weights[random.below(2) as usize]);
        }
        _ => {}
    }
    // Now and then two points are one, or share a coordinate.
    match random.below(24) {
        0 => rows[random.below(5) as usize] = rows[random.below(5) as usize],
        1 => {
            let axis = random.below(4) as usize;
            rows[random.below(5) as usize][axis] = rows[random.below(5) as usize][axis];
        }
        _ => {}
    }
    rows
}

fn each(random: &mut Random, mut row: impl FnMut(&mut Random) -> [f64; 4]) -> [[f64; 4]; 5] {
    std::array::from_fn(|_| row(random))
}

/// Points of a line a few ulps off.
fn near_line(random: &mut Random) -> [[f64; 4]; 5] {
    let (origin, direction) = (random.triple(Random::unit), random.triple(Random::unit));
    each(random, |r| {
        let t = r.unit();
        let p: [f64; 3] =
            std::array::from_fn(|i| nudge(origin[i] + t * direction[i], r.integer(1) as i64));
        [p[0], p[1], p[2], r.unit()]
    })
}

/// Points of a plane a few ulps off, with a random normal and offset.
fn near_plane(random: &mut Random) -> [[f64; 4]; 5] {
    let frame = [random.triple(Random::unit), random.triple(Random::unit)];
    let origin = random.triple(|r| 3.0 * r.unit());
    each(random, |r| {
        let (s, t) = (r.unit(), r.unit());
        let p: [f64; 3] = std::array::from_fn(|i| {
            let x = origin[i] + s * frame[0][i] + t * frame[1][i];
            nudge(x, r.integer(1) as i64)
        });
        [p[0], p[1], p[2], r.unit()]
    })
}

/// Points of a sphere a few ulps off, with weights 0 a few ulps off.
fn near_sphere(random: &mut Random) -> [[f64; 4]; 5] {
    let centre = random.triple(|r| 3.0 * r.unit());
    let radius = random.unit().abs() + 0.1;
    each(random, |r| {
        let direction = r.triple(Random::unit);
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
        let p: [f64; 3] = std::array::from_fn(|i| {
            nudge(centre[i] + radius * direction[i] / length, r.integer(1) as i64)
        });
        [p[0], p[1], p[2], r.integer(2) * power_of_two(-53)]
    })
}

/// Balls round random centres through one point: its power to all of them is nearly zero.
fn one_sample(random: &mut Random) -> [[f64; 4]; 5] {
    let sample = random.triple(Random::unit);
    each(random, |r| {
        let p = r.triple(Random::unit);
        let square: f64 = (0..3).map(|i| (p[i] - sample[i]) * (p[i] - sample[i])).sum();
        [p[0], p[1], p[2], nudge(square, r.integer(1) as i64)]
    })
}

/// Balls round long lattice vectors that span little, all but touching one point: determinants of
/// a few units, of numbers with many digits.
fn lattice_balls(random: &mut Random) -> [[f64; 4]; 5] {
    let n = (1 << (3 + random.below(28))) as f64;
    each(random, |r| {
        let (i, j) = (r.integer(1), r.integer(1));
        let p = [i * n + j * (n - 1.0), i * (n - 1.0) + j * (n - 2.0), r.integer(1)];
        let square: f64 = p.iter().map(|x| x * x).sum();
        [p[0], p[1], p[2], square + r.integer(1)]
    })
}
