//! The torture chamber: pictures that make a flood fill work. `true` is a wall.

/// 400 × 240, what the patterns are drawn for.
pub const WIDTH: usize = 400;
pub const HEIGHT: usize = 240;

/// Columns and rows of the corridors of a maze, which lie at odd places.
const CELLS: (usize, usize) = ((WIDTH - 1) / 2, (HEIGHT - 1) / 2);

pub type Walls = Vec<bool>;

fn drawn(is_wall: impl Fn(usize, usize) -> bool) -> Walls {
    (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| is_wall(x, y)).collect()
}

/// Small and good enough: the middle of a product.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).expect("31 bits") % limit
    }
}

pub fn noise(percent: usize) -> Walls {
    let mut random = Random(5 * percent as u64 + 1);
    let mut walls: Walls = (0..WIDTH * HEIGHT).map(|_| random.below(100) < percent).collect();
    walls[at((1, 1))] = false;
    walls
}

/// One corridor that winds to the middle.
pub fn spiral() -> Walls {
    let mut walls = vec![true; WIDTH * HEIGHT];
    let (mut x, mut y) = (1, 1);
    // Right, down, left and up; each way is two shorter than the last but one.
    let (mut across, mut down) = (WIDTH - 3, HEIGHT - 3);
    let steps: [(isize, isize); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];
    walls[at((x, y))] = false;
    for turn in 0.. {
        let length = if turn % 2 == 0 { &mut across } else { &mut down };
        let (dx, dy) = steps[turn % 4];
        for _ in 0..*length {
            (x, y) = (x.wrapping_add_signed(dx), y.wrapping_add_signed(dy));
            walls[at((x, y))] = false;
        }
        if turn > 0 {
            *length = length.saturating_sub(2);
        }
        if *length == 0 {
            return walls;
        }
    }
    walls
}

/// A maze of corridors one pixel wide without loops. `next` says which of the open ends is dug next.
fn maze(next: impl Fn(&mut Random, usize) -> usize) -> Walls {
    let mut random = Random(1);
    let mut walls = vec![true; WIDTH * HEIGHT];
    let mut ends = vec![(0_usize, 0_usize)];
    walls[at((1, 1))] = false;
    while !ends.is_empty() {
        let chosen = next(&mut random, ends.len());
        let (i, j) = ends[chosen];
        let beside = [(i + 1, j), (i.wrapping_sub(1), j), (i, j + 1), (i, j.wrapping_sub(1))];
        let solid: Vec<_> = beside
            .into_iter()
            .filter(|&(i, j)| i < CELLS.0 && j < CELLS.1 && walls[at((2 * i + 1, 2 * j + 1))])
            .collect();
        if solid.is_empty() {
            ends.swap_remove(chosen);
            continue;
        }
        let (k, l) = solid[random.below(solid.len())];
        walls[at((2 * k + 1, 2 * l + 1))] = false;
        walls[at((i + k + 1, j + l + 1))] = false;
        ends.push((k, l));
    }
    walls
}

fn at((x, y): (usize, usize)) -> usize {
    y * WIDTH + x
}

/// All of them, each with a corridor at (1, 1).
pub fn all() -> Vec<(&'static str, Walls)> {
    vec![
        ("open", drawn(|_, _| false)),
        ("comb", drawn(|x, y| x % 2 == 0 && y != 0)),
        ("comb upside down", drawn(|x, y| x % 2 == 0 && y != HEIGHT - 1)),
        ("dots", drawn(|x, y| x % 2 == 0 && y % 2 == 0)),
        ("checkerboard", drawn(|x, y| (x + y) % 2 == 1)),
        ("rows", drawn(|x, y| y % 2 == 0 && x != if y % 4 == 0 { 0 } else { WIDTH - 1 })),
        ("columns", drawn(|x, y| x % 2 == 0 && y != if x % 4 == 0 { 0 } else { HEIGHT - 1 })),
        ("spiral", spiral()),
        ("noise 20 %", noise(20)),
        ("noise 35 %", noise(35)),
        ("maze, depth first", maze(|_, ends| ends - 1)),
        ("maze, Prim", maze(Random::below)),
    ]
}
