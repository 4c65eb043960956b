//! The generator of the blue-noise masks: void-and-cluster, on integers, so that every machine agrees.
//!
//! R. A. Ulichney, "The void-and-cluster method for dither array generation", SPIE 1913, 1993. Sigma is 1.9, the
//! filter wraps around. It is linear: the tightest cluster of the zeros is the largest void of the ones, so that the
//! last two phases are one.

/// Ranks of `size` × `size` cells, row by row, each once.
pub fn ranks(size: usize, seed: u32) -> Vec<usize> {
    let mut field = Field::new(size);
    field.scatter(size * size / 10, seed);
    field.even_out();
    let (start, count) = (field.clone(), field.ones.iter().filter(|&&one| one).count());
    let mut ranks = vec![0; size * size];
    for rank in (0..count).rev() {
        let cell = field.tightest_cluster();
        field.toggle(cell);
        ranks[cell] = rank;
    }
    field = start;
    for rank in count..size * size {
        let cell = field.largest_void();
        field.toggle(cell);
        ranks[cell] = rank;
    }
    ranks
}

/// Cells that are one or zero, and how crowded each place is.
#[derive(Clone)]
struct Field {
    size: usize,
    ones: Vec<bool>,
    crowd: Vec<i64>,
    filter: Vec<i64>,
}

impl Field {
    fn new(size: usize) -> Self {
        let distance = |at: usize| at.min(size - at);
        let weight = |cell: usize| {
            let square = distance(cell % size).pow(2) + distance(cell / size).pow(2);
            let square = f64::from(u32::try_from(square).expect("small"));
            fixed((-square / (2.0 * 1.9 * 1.9)).exp())
        };
        let cells = size * size;
        Self { size, ones: vec![false; cells], crowd: vec![0; cells], filter: (0..cells).map(weight).collect() }
    }

    /// Sets random cells.
    fn scatter(&mut self, count: usize, mut state: u32) {
        let mut left = count;
        while left > 0 {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let cell = usize::try_from(state >> 8).expect("24 bits") % self.ones.len();
            if !self.ones[cell] {
                self.toggle(cell);
                left -= 1;
            }
        }
    }

    /// Moves ones from clusters to voids until the same one would move back.
    fn even_out(&mut self) {
        loop {
            let cluster = self.tightest_cluster();
            self.toggle(cluster);
            let void = self.largest_void();
            self.toggle(void);
            if void == cluster {
                return;
            }
        }
    }

    fn toggle(&mut self, cell: usize) {
        self.ones[cell] = !self.ones[cell];
        let sign = if self.ones[cell] { 1 } else { -1 };
        let (left, top) = (cell % self.size, cell / self.size);
        for y in 0..self.size {
            let row = &self.filter[(y + self.size - top) % self.size * self.size..][..self.size];
            for x in 0..self.size {
                self.crowd[y * self.size + x] += sign * row[(x + self.size - left) % self.size];
            }
        }
    }

    fn tightest_cluster(&self) -> usize {
        let ones = (0..self.ones.len()).filter(|&cell| self.ones[cell]);
        ones.min_by_key(|&cell| (-self.crowd[cell], cell)).expect("a one")
    }

    fn largest_void(&self) -> usize {
        let zeros = (0..self.ones.len()).filter(|&cell| !self.ones[cell]);
        zeros.min_by_key(|&cell| (self.crowd[cell], cell)).expect("a zero")
    }
}

/// With 30 fraction bits.
#[allow(clippy::cast_possible_truncation, reason = "at most 2^30")]
fn fixed(value: f64) -> i64 {
    (value * f64::from(1 << 30)).round() as i64
}
