//! Random numbers that are the same on every machine.

/// The generator xoshiro256** (Blackman, Vigna 2021, *Scrambled linear pseudorandom number
/// generators*), its state filled by splitmix64 as they advise.
pub(super) struct Random([u64; 4]);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        let mut state = seed;
        Random(std::array::from_fn(|_| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        }))
    }

    fn next(&mut self) -> u64 {
        let [a, b, c, d] = &mut self.0;
        let result = b.wrapping_mul(5).rotate_left(7).wrapping_mul(9);
        let shifted = *b << 17;
        *c ^= *a;
        *d ^= *b;
        *b ^= *c;
        *a ^= *d;
        *c ^= shifted;
        *d = d.rotate_left(45);
        result
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    pub(super) fn uniform(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [-1, 1).
    pub(super) fn signed(&mut self) -> f64 {
        2.0 * self.uniform() - 1.0
    }

    /// Two independent numbers of the normal distribution with mean 0 and deviation 1
    /// (Marsaglia's polar method).
    pub(super) fn normal_pair(&mut self) -> [f64; 2] {
        loop {
            let (x, y) = (self.signed(), self.signed());
            let square = x * x + y * y;
            if square > 0.0 && square < 1.0 {
                let factor = (-2.0 * libm::log(square) / square).sqrt();
                return [x * factor, y * factor];
            }
        }
    }

    /// A uniform point of the unit sphere (Marsaglia 1972, *Choosing a point from the surface
    /// of a sphere*).
    pub(super) fn direction(&mut self) -> [f64; 3] {
        loop {
            let (x, y) = (self.signed(), self.signed());
            let square = x * x + y * y;
            if square < 1.0 {
                let factor = 2.0 * (1.0 - square).sqrt();
                return [x * factor, y * factor, 1.0 - 2.0 * square];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stream_is_the_published_one() {
        // The first outputs of xoshiro256** for the state 1, 2, 3, 4, as its authors' C code
        // gives them.
        let mut random = Random([1, 2, 3, 4]);
        assert_eq!([0; 4].map(|_| random.next()), [11520, 0, 1509978240, 1215971899390074240]);
        // The first output of splitmix64 for the seed 1234567, from its reference listing.
        assert_eq!(Random::new(1234567).0[0], 6457827717110365317);
    }

    #[test]
    fn moments_are_those_of_the_distributions() {
        let mut random = Random::new(1);
        let count = 100_000;
        let (mut first, mut second, mut fourth) = (0.0, 0.0, 0.0);
        let mut directions = [0.0; 3];
        for _ in 0..count / 2 {
            for x in random.normal_pair() {
                first += x;
                second += x * x;
                fourth += x * x * x * x;
            }
            let d = random.direction();
            assert!((d.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15);
            directions = std::array::from_fn(|i| directions[i] + d[i] * d[i]);
        }
        let n = f64::from(count);
        // Five standard errors each: 1, sqrt 2 and sqrt 96 over sqrt n.
        let error = 5.0 / n.sqrt();
        assert!((first / n).abs() < error);
        assert!((second / n - 1.0).abs() < error * 2f64.sqrt());
        assert!((fourth / n - 3.0).abs() < error * 96f64.sqrt());
        for square in directions {
            assert!((square / (n / 2.0) - 1.0 / 3.0).abs() < error);
        }
    }
}
