//! Textures and samplers against what they are by their words, on random and hostile input.

mod pictures;

use aquatint::{
    Light,
    fragment::texture::{
        BLACK_AND_WHITE, Bilinear, ClampToEdge, Filter, LightTexture, Mirror, Nearest, Repeat, SRGB_4, SRGB_16,
        Sampler, Srgb, Texels, Texture, TextureError, Wrap,
    },
};
use proptest::prelude::*;

/// The code of a texel by the words of the format: rows of whole bytes, the leftmost in the high bits.
fn code(bytes: &[u8], width: usize, bits: usize, (column, row): (usize, usize)) -> u8 {
    let row_bytes = (width * bits).div_ceil(8);
    let bytes: Vec<_> = bytes[row * row_bytes..][..row_bytes].iter().map(|byte| format!("{byte:08b}")).collect();
    let text = bytes.concat();
    u8::from_str_radix(&text[column * bits..][..bits], 2).expect("bits")
}

/// Which texel of `size` stands at a place, by the words of the wrap.
type WrapSlowly = fn(i64, i64) -> i64;

fn repeat(texel: i64, size: i64) -> i64 {
    texel.rem_euclid(size)
}

fn clamp(texel: i64, size: i64) -> i64 {
    texel.clamp(0, size - 1)
}

fn mirror(texel: i64, size: i64) -> i64 {
    let there = texel.rem_euclid(2 * size);
    there.min(2 * size - 1 - there)
}

/// A picture of lights, and a place in it.
#[derive(Debug)]
struct Case {
    lights: Vec<Light>,
    size_log2: [u32; 2],
    place: [i32; 2],
}

impl Case {
    fn texture(&self) -> LightTexture<'_> {
        let [width, height] = self.size_log2.map(|log2| 1 << log2);
        LightTexture::new(&self.lights, width, height).expect("a texture")
    }

    /// The light of any texel, wrapped.
    fn light(&self, wrap: WrapSlowly, [x, y]: [i64; 2]) -> Light {
        let [width, height] = self.size_log2.map(|log2| 1_i64 << log2);
        let at = wrap(y, height) * width + wrap(x, width);
        self.lights[usize::try_from(at).expect("in range")]
    }

    /// The exact light between the centres of texels.
    fn between(&self, wrap: WrapSlowly) -> f64 {
        let [(x, across), (y, down)] = self.place.map(|v| {
            let from_centre = f64::from(v) / 65_536.0 - 0.5;
            (from_centre.floor(), from_centre - from_centre.floor())
        });
        #[expect(clippy::cast_possible_truncation, reason = "whole numbers")]
        let [x, y] = [x, y].map(|v| v as i64);
        let row = |y: i64| {
            let [near, far] = [x, x + 1].map(|x| f64::from(self.light(wrap, [x, y]).0));
            near * (1.0 - across) + far * across
        };
        row(y) * (1.0 - down) + row(y + 1) * down
    }
}

fn cases() -> impl Strategy<Value = Case> {
    let place = prop_oneof![
        4 => -600_000..600_000_i32,
        2 => any::<i32>(),
        2 => (-20..20_i32, -3..=3_i32).prop_map(|(half, more)| (half << 15) + more),
        1 => (0..200_000_i32).prop_map(|v| i32::MIN + v),
        1 => (0..200_000_i32).prop_map(|v| i32::MAX - v),
    ];
    let place = prop::array::uniform2(place);
    (0..4_u32, 0..4_u32, place).prop_flat_map(|(width, height, place)| {
        let light = prop_oneof![Just(0), Just(u16::MAX), any::<u16>()].prop_map(Light);
        prop::collection::vec(light, 1 << (width + height)).prop_map(move |lights| Case {
            lights,
            size_log2: [width, height],
            place,
        })
    })
}

fn is_right<W: Wrap + Copy>(case: &Case, wrap: W, slowly: WrapSlowly) -> Result<(), TestCaseError> {
    let ([u, v], sampler) = (case.place, Sampler::new(case.texture()).with_wrap(wrap));
    let nearest = case.light(slowly, [u, v].map(|v| i64::from(v >> 16)));
    prop_assert_eq!(sampler.sample(u, v), nearest);
    let error = f64::from(sampler.with_filter(Bilinear).sample(u, v).0) - case.between(slowly);
    prop_assert!(error.abs() <= 65_535.0 / 256.0 + 0.5, "off by {error}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn every_wrap_and_filter_is_right_at_any_place(case in cases()) {
        is_right(&case, Repeat, repeat)?;
        is_right(&case, ClampToEdge, clamp)?;
        is_right(&case, Mirror, mirror)?;
    }

    #[test]
    fn bilinear_light_at_256ths_of_a_texel_is_the_nearest(mut case in cases()) {
        case.place = case.place.map(|v| v & !0xFF);
        let [u, v] = case.place;
        let error = f64::from(Sampler::new(case.texture()).with_filter(Bilinear).sample(u, v).0) - case.between(repeat);
        prop_assert!(error.abs() <= 0.500_001, "off by {error}");
    }

    #[test]
    fn at_the_centres_of_texels_both_filters_give_the_texel(case in cases()) {
        let [u, v] = case.place.map(|v| v >> 16 << 16 | 0x8000);
        let sampler = Sampler::new(case.texture());
        prop_assert_eq!(sampler.with_filter(Bilinear).sample(u, v), sampler.sample(u, v));
        let sampler = sampler.with_wrap(Mirror);
        prop_assert_eq!(sampler.with_filter(Bilinear).sample(u, v), sampler.sample(u, v));
        let sampler = sampler.with_wrap(ClampToEdge);
        prop_assert_eq!(sampler.with_filter(Bilinear).sample(u, v), sampler.sample(u, v));
    }

    #[test]
    fn codes_are_read_as_they_are_packed(
        bytes in prop::collection::vec(any::<u8>(), 64), width_log2 in 0..4_u32, height_log2 in 0..3_u32, at in any::<(u8, u8)>(),
    ) {
        let (width, height) = (1_u32 << width_log2, 1_u32 << height_log2);
        let (column, row) = (u32::from(at.0) % width, u32::from(at.1) % height);
        let code = |bits| usize::from(code(&bytes, width as usize, bits, (column as usize, row as usize)));
        let table = core::array::from_fn(|i| Light(u16::try_from(i).expect("small") * 199));
        let texel = |texture: Result<&dyn Texels, TextureError>| texture.expect("a texture").texel(column, row);
        let bits_1 = Texture::new(&bytes, width, height, &BLACK_AND_WHITE);
        prop_assert_eq!(texel(bits_1.as_ref().map(|t| t as _).map_err(|&e| e)), BLACK_AND_WHITE[code(1)]);
        let bits_2 = Texture::new(&bytes, width, height, &SRGB_4);
        prop_assert_eq!(texel(bits_2.as_ref().map(|t| t as _).map_err(|&e| e)), SRGB_4[code(2)]);
        let bits_4 = Texture::new(&bytes, width, height, &SRGB_16);
        prop_assert_eq!(texel(bits_4.as_ref().map(|t| t as _).map_err(|&e| e)), SRGB_16[code(4)]);
        let bits_8: Result<Texture<'_, &[Light; 256]>, _> = Texture::new(&bytes, width, height, &table);
        prop_assert_eq!(texel(bits_8.as_ref().map(|t| t as _).map_err(|&e| e)), table[code(8)]);
        let srgb = Texture::new(&bytes, width, height, Srgb);
        let wanted = Light::from_srgb(u8::try_from(code(8)).expect("a byte"));
        prop_assert_eq!(texel(srgb.as_ref().map(|t| t as _).map_err(|&e| e)), wanted);
    }

    #[test]
    fn a_texel_beside_the_texture_does_no_harm(column in any::<u32>(), row in any::<u32>()) {
        let lights = [Light(1); 8];
        let codes = Texture::new(&[0xFF; 4], 8, 4, &BLACK_AND_WHITE).expect("a texture").texel(column, row);
        prop_assert!(BLACK_AND_WHITE.contains(&codes));
        let light = LightTexture::new(&lights, 2, 4).expect("a texture").texel(column, row);
        prop_assert!([Light(1), Light::BLACK].contains(&light));
    }

    #[test]
    fn texture_coordinates_of_meshes_are_4_12(case in cases(), uv in any::<[u16; 2]>()) {
        let sampler = Sampler::new(case.texture());
        // A texture is 4096 wide.
        let texel = |axis: usize| i64::from(uv[axis]) * (1 << case.size_log2[axis]) / 4096;
        prop_assert_eq!(sampler.sample_uv(uv), case.light(repeat, [texel(0), texel(1)]));
    }

    #[test]
    fn the_functions_of_the_modes_take_any_number(texel in any::<i32>(), mask in any::<u32>(), place in any::<[i32; 2]>()) {
        prop_assert!(Repeat::wrap(texel, mask) <= mask && ClampToEdge::wrap(texel, mask) <= mask);
        prop_assert!(Mirror::wrap(texel, mask) <= mask);
        let grey = Endless([99, 7]);
        prop_assert_eq!(Nearest::sample::<Mirror>(&grey, [mask, mask], place), Light(77));
        prop_assert_eq!(Bilinear::sample::<Repeat>(&grey, [mask, mask], place), Light(77));
        prop_assert_eq!(Sampler::new(&grey).with_filter(Bilinear).sample_uv([1, u16::MAX]), Light(77));
    }
}

/// Says that it is larger than a texture can be.
struct Endless([u32; 2]);

impl Texels for Endless {
    fn size_log2(&self) -> [u32; 2] {
        self.0
    }

    fn texel(&self, _column: u32, _row: u32) -> Light {
        Light(77)
    }
}

#[test]
fn what_is_no_texture_is_refused() {
    let new = |bytes: &[u8], width, height| Texture::new(bytes, width, height, &BLACK_AND_WHITE).err();
    for (width, height) in [(0, 1), (1, 0), (3, 4), (4, 12), (8192, 1), (1, 8192), (u32::MAX, 1), (1 << 31, 1 << 31)] {
        assert_eq!(new(&[0; 99], width, height), Some(TextureError::Size), "{width} by {height}");
        assert_eq!(LightTexture::new(&[Light(0); 99], width, height).err(), Some(TextureError::Size));
    }
    assert_eq!(new(&[0; 7], 2, 8), Some(TextureError::TooSmall { needed: 8 }), "a byte a row");
    assert_eq!(new(&[0; 8], 2, 8), None);
    assert_eq!(new(&[0; 31], 64, 4), Some(TextureError::TooSmall { needed: 32 }));
    assert_eq!(new(&[], 4096, 4096), Some(TextureError::TooSmall { needed: 1 << 21 }));
    let lights = [Light(0); 7];
    assert_eq!(LightTexture::new(&lights, 2, 4).err(), Some(TextureError::TooSmall { needed: 8 }));
    let text = TextureError::TooSmall { needed: 8 }.to_string();
    assert_eq!(text, "8 bytes or lights are needed");
}

#[test]
fn the_largest_texture_reaches_to_its_last_texel() {
    let mut bytes = vec![0; 1 << 21];
    bytes[(1 << 21) - 1] = 1;
    let sampler = Sampler::new(Texture::new(&bytes, 4096, 4096, &BLACK_AND_WHITE).expect("a texture"));
    assert_eq!(sampler.uv_shifts(), [16, 16]);
    let last = 4095 << 16;
    assert_eq!([sampler.sample(last, last), sampler.sample(-1, -1)], [Light::WHITE; 2]);
    assert_eq!(sampler.sample(last, last - 1), Light::BLACK);
    let clamped = sampler.with_wrap(ClampToEdge);
    assert_eq!([clamped.sample(i32::MAX, i32::MAX), clamped.sample(i32::MIN, i32::MIN)], [Light::WHITE, Light::BLACK]);
}
