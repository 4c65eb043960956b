//! The template in `examples/template`, as the desk draws it: a whole turn, and the frames that `.ci/pico` compares with
//! those of the emulated board.

#[path = "../examples/template/src/picture.rs"]
mod picture;

use aquatint::Angle;
use embedded_graphics::{image::GetPixel, pixelcolor::BinaryColor, prelude::*};
use picture::{Memory, STEP, Screen, draw};

const FRAMES_A_TURN: u16 = 128;
/// So many are told to `.ci/pico`.
const TOLD: u16 = 4;

fn screen() -> Screen {
    Screen::with_array([0; 1024], 128, 64).expect("large enough")
}

fn is_lit(screen: &Screen, at: Point) -> bool {
    screen.pixel(at).is_some_and(BinaryColor::is_on)
}

/// The pixels, row by row.
fn text(screen: &Screen) -> String {
    screen.bounding_box().points().map(|at| if is_lit(screen, at) { '#' } else { '.' }).collect()
}

/// Two rows a line.
fn half_blocks(screen: &Screen) -> Vec<String> {
    let sign = |x, y| match [y, y + 1].map(|y| is_lit(screen, Point::new(x, y))) {
        [false, false] => ' ',
        [true, false] => '▀',
        [false, true] => '▄',
        [true, true] => '█',
    };
    (0..64).step_by(2).map(|y| (0..128).map(|x| sign(x, y)).collect::<String>().trim_end().into()).collect()
}

#[test]
fn a_whole_turn_is_drawn() {
    let (mut screen, mut memory, mut turn) = (screen(), Memory::NEW, Angle(0));
    let mut frames = Vec::new();
    for number in 0..=FRAMES_A_TURN {
        draw(&mut screen, &mut memory, turn).expect("its constants are in range, and its memory is large enough");
        frames.push(text(&screen));
        if number < TOLD {
            println!("frame {number} {}", text(&screen));
        }
        turn.0 = turn.0.wrapping_add(STEP);
    }
    assert!(frames.windows(2).all(|pair| pair[0] != pair[1]), "it turns");
    assert_eq!(frames.first(), frames.last(), "a turn is whole");
}

#[test]
fn the_first_frame() {
    let (mut screen, mut memory) = (screen(), Memory::NEW);
    draw(&mut screen, &mut memory, Angle(0)).expect("drawn");
    let drawn = half_blocks(&screen);
    let expected: Vec<&str> = FIRST_FRAME.lines().skip(1).collect();
    assert_eq!(drawn, expected, "\n{}", drawn.join("\n"));
}

/// Looked at: a dodecahedron lit from above left, a star on a grey disc, the name.
#[rustfmt::skip]
const FIRST_FRAME: &str = "
                                                                                         ▄▄▄▀▀▀▀▀▀▀▀▀▀▄▄▄
                     ▄▄▄ ▄▄▄ ▄▄▄ ▄▄▄ ▄▄▄ ▄▄▄                                         ▄▄▀▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▀▀▄▄
                   ██████████████████████████                                     ▄█▀ ▀ ▀ ▀ ▀ ▀ █▄▀ ▀ ▀ ▀ ▀ ▀▀█▄
                 ▄██▀███▀███▀███▀███▀███▀███▀█▄                                 ▄▀▀ ▀ ▀ ▀ ▀ ▀ ▀▄██▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▄
                ▄██████████████████████████████▄                              ▄█▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀████ ▀ ▀ ▀ ▀ ▀ ▀ ▀ █▄
               █▀███▀███▀███▀███▀███▀███▀███▀███▀                            ▄▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ █████▄▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▀▄
             ▄████████████████████████████████████▄                         ▄▀▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▄██████▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▄
             ███▀███▀███▀███▀███▀███▀███▀███▀███▀██▄                       ▄▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀████████ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▀▄
           ██████████████████████████████████████████                      █▀ ▀▄█▄█▄█▄█▄█▄█▄█████████▄█▄█▄█▄█▄█▄█▄█ ▀ █
         ▄██▀███▀███▀███▀███▀███▀███▀███▀███▀███▀███▀█▄                   █ ▀ ▀ ▀▀██████████████████████████████▀▀▀ ▀ ▀█
         ▄▀▀▀██████████████████████████████████████▀▀                     █ ▀ ▀ ▀ ▀▀██████████████████████████▀ ▀ ▀ ▀ ▀█
       ▄▀ ▀▄▀ ▀█▀███▀███▀███▀███▀███▀███▀███▀███▀ ▀   ▀                   █ ▀ ▀ ▀ ▀ ▀ ▀████████████████████▀▀ ▀ ▀ ▀ ▀ ▀█
        ▀▄▀ ▀▄▀ ▀▄▀▀████████████████████████▀▀  ▀   ▀   ▀                 █ ▀ ▀ ▀ ▀ ▀ ▀ ▀███████████████▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀█
      ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀▀▀█▀███▀███▀███▀███▀▀▀   ▀   ▀   ▀                   █ ▀ ▀ ▀ ▀ ▀ ▀ ▀████████████████ ▀ ▀ ▀ ▀ ▀ ▀ ▀█
     ▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀█████████████▀ ▀   ▀   ▀   ▀   ▀                  █▀ ▀ ▀ ▀ ▀ ▀ █████████████████▄▀ ▀ ▀ ▀ ▀ ▀ █
    ▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀▀██▀█▀▀  ▀   ▀   ▀   ▀   ▀   ▀                ▀█ ▀ ▀ ▀ ▀ ▀▄████████▀▀████████▀ ▀ ▀ ▀ ▀ ▀▄▀
    ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀▀▀   ▀   ▀   ▀   ▀   ▀   ▀   ▀               ▀▄▀ ▀ ▀ ▀ ▀██████▀▀ ▀ ▀ ▀██████ ▀ ▀ ▀ ▀ █▀
  ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄  ▀   ▀   ▀   ▀   ▀   ▀   ▀                  ▀█ ▀ ▀ ▀ ████▀ ▀ ▀ ▀ ▀ ▀ ▀▀███▄▀ ▀ ▀ ▀▄▀
  ▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀   ▀   ▀   ▀   ▀   ▀   ▀   ▀                 ▀█▀ ▀ ▀▄█▀▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▀▀█▀ ▀ ▀ █▀
  ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄  ▀   ▀   ▀   ▀   ▀   ▀   ▀                     ▀▄▀ ▀▀▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ █▀
    ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀   ▀   ▀   ▀   ▀   ▀   ▀                         ▀██ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▄█▀
      ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄  ▀   ▀   ▀   ▀   ▀   ▀   ▀                          ▀▀▄█ ▀ ▀ ▀ ▀ ▀ ▀ ▀ ▀▄█▀▀
      ▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀   ▀   ▀   ▀   ▀   ▀   ▀                                ▀▀▀█▄█▄█▄█▄█▄▀▀▀
        ▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄  ▀   ▀   ▀   ▀   ▀   ▀
        ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀   ▀   ▀   ▀   ▀   ▀                                                       ▄
          ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄  ▀   ▀   ▀   ▀   ▀   ▀                                                 █   ▀▀            █
            ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀   ▀   ▀   ▀   ▀   ▀                ▄▄▄ ▄    ▄▄▄ ▄  ▄     ▄    ▄▄▄ ▄  ▄█▄  ▄   ▄ ▄▄▄▄   ▄█▄
            ▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄▀ ▀▄  ▀   ▀   ▀   ▀   ▀                █▀   ▀█  █▀   ▀█  █     █  █▀   ▀█   █   █   █▀   ▀▄   █
              ▀ ▀ ▀ ▀ ▀ ▀▄▀ ▀▄▀ ▀   ▀   ▀   ▀   ▀                  █     █  █     █  █     █  █     █   █   █   █     █   █
                                                                   ▀▄▄▄▄██  ▀▄▄▄▄██  ▀█▄▄▄▀█  ▀▄▄▄▄██   █▄▄ █   █     █   █▄▄
                                                                                  █
                                                                                  ▀";

/// What the README shows of the template are its lines, in its order.
#[test]
fn the_readme_shows_the_template() {
    let readme = include_str!("../README.md");
    let section = readme.split("## From `cargo new` to a picture").nth(1).expect("a section");
    let shown = |fence| section.split(fence).nth(1).and_then(|rest| rest.split("```").next()).expect("a block");
    for (shown, own) in [
        (shown("```toml\n"), include_str!("../examples/template/Cargo.toml")),
        (shown("```rs\n"), include_str!("../examples/template/src/main.rs")),
    ] {
        let mut own = own.lines();
        for line in shown.lines().filter(|line| !line.is_empty()) {
            assert!(own.any(|own| own.ends_with(line)), "not in the template, or not in this order: {line}");
        }
    }
}
