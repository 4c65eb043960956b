//! Files written, read back with a decoder, and compared pixel by pixel.

use std::error::Error;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;

use aquatint_simulator::{Animation, Panel, Picture, SaveError, Zoom, save_png};
use png::{BitDepth, ColorType, Decoder, Reader, Transformations};

type Outcome = Result<(), Box<dyn Error>>;

fn open(path: &Path) -> Result<Reader<BufReader<File>>, Box<dyn Error>> {
    let mut decoder = Decoder::new(BufReader::new(File::open(path)?));
    decoder.set_transformations(Transformations::EXPAND);
    Ok(decoder.read_info()?)
}

fn next(reader: &mut Reader<BufReader<File>>) -> Result<Picture, Box<dyn Error>> {
    let mut rgb = vec![0; reader.output_buffer_size().ok_or("too large")?];
    let frame = reader.next_frame(&mut rgb)?;
    Ok(Picture::from_rgb(frame.width, frame.height, rgb)?)
}

/// A picture in which pixel n has the colour that `colour` gives for n.
fn picture(width: u32, height: u32, colour: impl Fn(u32) -> [u8; 3]) -> Picture {
    let rgb = (0..width * height).flat_map(colour).collect();
    Picture::from_rgb(width, height, rgb).expect("three bytes a pixel")
}

fn greys(levels: u32) -> impl Fn(u32) -> [u8; 3] {
    move |pixel| [(pixel * 7 % levels).to_be_bytes()[3]; 3]
}

fn colourful(pixel: u32) -> [u8; 3] {
    let [_, high, middle, low] = (pixel * 77).to_be_bytes();
    [high, middle, low]
}

#[test]
fn every_depth_is_read_back_as_it_was_written() -> Outcome {
    let directory = tempfile::tempdir()?;
    let path = directory.path().join("picture.png");
    for (levels, depth) in [
        (1, BitDepth::One),
        (2, BitDepth::One),
        (3, BitDepth::Two),
        (16, BitDepth::Four),
        (17, BitDepth::Eight),
        (256, BitDepth::Eight),
    ] {
        let written = picture(37, 19, greys(levels));
        save_png(&written, &path)?;
        let mut reader = open(&path)?;
        assert_eq!(reader.info().color_type, ColorType::Indexed);
        assert_eq!(reader.info().bit_depth, depth, "{levels} colours");
        assert!(next(&mut reader)? == written, "{levels} colours");
    }
    Ok(())
}

#[test]
fn more_than_256_colours_are_read_back_as_well() -> Outcome {
    let directory = tempfile::tempdir()?;
    let path = directory.path().join("picture.png");
    let written = picture(37, 19, colourful);
    save_png(&written, &path)?;
    let mut reader = open(&path)?;
    assert_eq!(reader.info().color_type, ColorType::Rgb);
    assert!(next(&mut reader)? == written);
    Ok(())
}

#[test]
fn a_panel_at_twice_its_size_is_a_small_file() -> Outcome {
    let directory = tempfile::tempdir()?;
    let path = directory.path().join("panel.png");
    let checks = [0b1010_1010; 50].repeat(240);
    let zoom = Zoom { scale: 2, gap: 0 };
    save_png(&Panel::SHARP_400X240.render(&checks, zoom)?, &path)?;
    assert!(fs::metadata(&path)?.len() < 1000);
    Ok(())
}

#[test]
fn an_animation_is_read_back_frame_by_frame() -> Outcome {
    let directory = tempfile::tempdir()?;
    let path = directory.path().join("animation.png");
    let frames: Vec<Picture> = (0..5).map(|frame| picture(13, 7, move |pixel| greys(3)(pixel + frame))).collect();
    read_back(&frames, &path)?;
    assert_eq!(open(&path)?.info().bit_depth, BitDepth::Two);
    Ok(())
}

#[test]
fn an_animation_that_becomes_colourful_is_read_back_as_well() -> Outcome {
    let directory = tempfile::tempdir()?;
    let path = directory.path().join("animation.png");
    let plain = picture(37, 19, greys(3));
    let frames = [plain.clone(), picture(37, 19, colourful), plain];
    read_back(&frames, &path)?;
    assert_eq!(open(&path)?.info().color_type, ColorType::Rgb);
    Ok(())
}

fn read_back(frames: &[Picture], path: &Path) -> Outcome {
    let size = (frames[0].width(), frames[0].height());
    let mut animation = Animation::create(path, size, 25)?;
    for frame in frames {
        animation.push(frame)?;
    }
    assert!(!path.exists(), "no file before it is finished");
    animation.finish()?;

    let mut reader = open(path)?;
    let control = reader.info().animation_control().ok_or("no animation")?;
    assert_eq!(usize::try_from(control.num_frames)?, frames.len());
    assert_eq!(control.num_plays, 0, "for ever");
    for frame in frames {
        assert!(next(&mut reader)? == *frame);
        let timing = reader.info().frame_control().ok_or("no timing")?;
        assert_eq!((timing.delay_num, timing.delay_den), (1, 25));
    }
    Ok(())
}

#[test]
fn a_frame_of_another_size_is_refused_and_the_rest_is_kept() -> Outcome {
    let directory = tempfile::tempdir()?;
    let path = directory.path().join("animation.png");
    let mut animation = Animation::create(&path, (2, 2), 0)?;
    animation.push(&Picture::filled(2, 2, [1; 3]))?;
    let error = animation.push(&Picture::filled(3, 2, [1; 3])).expect_err("too wide");
    assert_eq!(error.to_string(), "expected a frame of 2x2, found 3x2");
    animation.finish()?;
    assert!(next(&mut open(&path)?)? == Picture::filled(2, 2, [1; 3]));
    Ok(())
}

#[test]
fn an_animation_of_nothing_leaves_nothing() -> Outcome {
    let directory = tempfile::tempdir()?;
    let path = directory.path().join("animation.png");
    let error = Animation::create(&path, (2, 2), 25)?.finish().expect_err("no frames");
    assert!(matches!(error, SaveError::NoFrames));
    drop(Animation::create(&path, (2, 2), 25)?);
    assert_eq!(fs::read_dir(directory.path())?.count(), 0);
    Ok(())
}

#[test]
fn a_picture_of_nothing_leaves_what_was_there() -> Outcome {
    let directory = tempfile::tempdir()?;
    let path = directory.path().join("picture.png");
    fs::write(&path, "something else")?;
    assert!(save_png(&Picture::filled(0, 0, [0; 3]), &path).is_err());
    assert_eq!(fs::read(&path)?, b"something else");
    assert_eq!(fs::read_dir(directory.path())?.count(), 1);
    Ok(())
}

#[test]
fn where_nothing_can_be_written_nothing_is_left() -> Outcome {
    let directory = tempfile::tempdir()?;
    let dot = Picture::filled(1, 1, [0; 3]);

    // Not a directory, for any user: permissions would not stop an administrator.
    let file = directory.path().join("file");
    fs::write(&file, "")?;
    let below = file.join("picture.png");
    let error = save_png(&dot, &below).expect_err("below a file");
    let start = format!("cannot write {}: ", below.display());
    assert!(error.to_string().starts_with(&start), "{error}");
    assert!(Animation::create(&below, (1, 1), 25).is_err());

    // A name that is taken, by a directory.
    let taken = directory.path().join("taken");
    fs::create_dir(&taken)?;
    assert!(save_png(&dot, &taken).is_err());

    assert_eq!(fs::read_dir(directory.path())?.count(), 2);
    Ok(())
}

#[cfg(unix)]
#[test]
fn a_file_is_as_readable_as_any_other() -> Outcome {
    use std::os::unix::fs::PermissionsExt;

    let directory = tempfile::tempdir()?;
    let path = directory.path().join("picture.png");
    let other = directory.path().join("other");
    save_png(&Picture::filled(1, 1, [0; 3]), &path)?;
    fs::write(&other, "")?;
    let mode = |path: &Path| fs::metadata(path).map(|data| data.permissions().mode());
    assert_eq!(mode(&path)?, mode(&other)?);
    Ok(())
}
