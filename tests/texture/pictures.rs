//! What textures look like.

use aquatint::{
    Light,
    fragment::texture::{BLACK_AND_WHITE, Bilinear, ClampToEdge, Mirror, SRGB_4, Sampler, Texture},
};

/// An F: it looks different in each direction.
const LETTER: [u8; 4] = [0b1110_0000, 0b1000_0000, 0b1100_0000, 0b1000_0000];

/// The light of sixteen by eight pixels, from three texels up and to the left of the corner.
fn picture(step: i32, sample: impl Fn(i32, i32) -> Light) -> String {
    let signs = ['.', ',', ':', '-', '=', '+', '*', '#'];
    let place = |pixel: i32| pixel * step + step / 2 - (3 << 16);
    let sign = |light: Light| signs[usize::from(light.to_srgb() / 32)];
    let row = |y: i32| (0..16).map(|x| sign(sample(place(x), place(y)))).collect::<String>() + "|\n";
    (0..8).map(row).collect()
}

#[test]
fn wraps() {
    let sampler = Sampler::new(Texture::new(&LETTER, 4, 4, &BLACK_AND_WHITE).unwrap());
    let repeated = "\
...#...#...#...#|
#..##..##..##..#|
...#...#...#...#|
##.###.###.###.#|
...#...#...#...#|
#..##..##..##..#|
...#...#...#...#|
##.###.###.###.#|
";
    assert_eq!(picture(1 << 16, |u, v| sampler.sample(u, v)), repeated);
    let clamped = "\
######..........|
######..........|
######..........|
######..........|
####............|
#####...........|
####............|
####............|
";
    let sampler = sampler.with_wrap(ClampToEdge);
    assert_eq!(picture(1 << 16, |u, v| sampler.sample(u, v)), clamped);
    let mirrored = "\
.####....####...|
..##......##....|
######..######..|
######..######..|
..##......##....|
.####....####...|
..##......##....|
..##......##....|
";
    let sampler = sampler.with_wrap(Mirror);
    assert_eq!(picture(1 << 16, |u, v| sampler.sample(u, v)), mirrored);
}

#[test]
fn filters() {
    // Four greys in a row, two times as large as they are.
    let sampler = Sampler::new(Texture::new(&[0b0001_1011], 4, 1, &SRGB_4).unwrap()).with_wrap(ClampToEdge);
    let row = |text: String| text.lines().next().unwrap().to_owned();
    assert_eq!(row(picture(1 << 15, |u, v| sampler.sample(u, v))), "........::++####|");
    let sampler = sampler.with_filter(Bilinear);
    assert_eq!(row(picture(1 << 15, |u, v| sampler.sample(u, v))), ".......,:-=*####|");
}
