//! Rows and pages, and what odd panels take: pictures in the source, and a slow reference.

use aquatint::{
    TooSmall,
    display::{
        reencode::{it8951_bytes, it8951_in_place, it8951_words, st7306_bytes, st7306_tiles},
        transpose::{BitOrder, Transpose},
    },
};
use proptest::{collection::vec, prelude::*};

const GUARD: u8 = 0xA5;

// Rows and pages.

#[test]
fn a_letter_of_rows_becomes_columns() {
    #[rustfmt::skip]
    let rows = [
        0b1111_0000, 0b1000_0000,
        0b1000_1000, 0b0000_0000,
        0b1000_1000, 0b0000_0000,
        0b1111_0000, 0b0000_0000,
        0b1000_0000, 0b0000_0000,
        0b1000_0000, 0b0000_0000,
        0b1000_0000, 0b0000_0000,
        0b0000_0000, 0b0000_0000,
        0b0000_0000, 0b1000_0000,
    ];
    #[rustfmt::skip]
    let pages = [
        0b0111_1111, 0b0000_1001, 0b0000_1001, 0b0000_1001, 0b0000_0110, 0, 0, 0, 0b0000_0001,
        0, 0, 0, 0, 0, 0, 0, 0, 0b0000_0001,
    ];
    let (mut to_pages, mut to_rows) = ([GUARD; 18], [GUARD; 18]);
    assert_eq!(Transpose::new(9, 9).rows_to_pages(&rows, &mut to_pages), Ok(()));
    assert_eq!(Transpose::new(9, 9).pages_to_rows(&pages, &mut to_rows), Ok(()));
    assert_eq!((to_pages, to_rows), (pages, rows));
}

#[test]
fn whoever_is_too_small_is_told() {
    let transpose = Transpose::new(9, 9);
    assert_eq!(transpose.rows_to_pages(&[0; 17], &mut [0; 18]), Err(TooSmall { needed: 18 }));
    assert_eq!(transpose.rows_to_pages(&[0; 18], &mut [0; 17]), Err(TooSmall { needed: 18 }));
    assert_eq!(transpose.pages_to_rows(&[0; 17], &mut [0; 18]), Err(TooSmall { needed: 18 }));
    assert_eq!(transpose.pages_to_rows(&[0; 18], &mut [0; 17]), Err(TooSmall { needed: 18 }));
    for (width, height) in [(u32::MAX, u32::MAX), (u32::MAX, 1), (9, u32::MAX)] {
        assert!(Transpose::new(width, height).rows_to_pages(&[0; 99], &mut [0; 99]).is_err());
        assert!(Transpose::new(width, height).pages_to_rows(&[0; 99], &mut [0; 99]).is_err());
    }
    for (width, height) in [(0, 0), (0, 9), (9, 0), (0, u32::MAX), (u32::MAX, 0)] {
        assert_eq!(Transpose::new(width, height).rows_to_pages(&[], &mut []), Ok(()));
        assert_eq!(Transpose::new(width, height).pages_to_rows(&[], &mut []), Ok(()));
    }
}

fn order() -> impl Strategy<Value = BitOrder> {
    prop_oneof![Just(BitOrder::HighFirst), Just(BitOrder::LowFirst)]
}

const fn bit(order: BitOrder, place: usize) -> usize {
    match order {
        BitOrder::HighFirst => 7 - place % 8,
        BitOrder::LowFirst => place % 8,
    }
}

/// A picture in rows and the same in pages, a pixel at a time; padding is zeros.
fn both(width: usize, height: usize, orders: (BitOrder, BitOrder), pixels: &[bool]) -> (Vec<u8>, Vec<u8>) {
    let (stride, mut pages) = (width.div_ceil(8), vec![0; width * height.div_ceil(8)]);
    let mut rows = vec![0; stride * height];
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        rows[y * stride + x / 8] |= u8::from(pixels[y * width + x]) << bit(orders.0, x);
        pages[y / 8 * width + x] |= u8::from(pixels[y * width + x]) << bit(orders.1, y);
    }
    (rows, pages)
}

/// What fills memory so that neither padding nor what is behind may count: ones where zeros belong.
fn with_dirty_padding(mut rows: Vec<u8>, width: usize, order: BitOrder) -> Vec<u8> {
    let dirty = (width..width.next_multiple_of(8)).fold(0, |dirty, x| dirty | 1 << bit(order, x));
    for line in rows.chunks_mut(width.div_ceil(8).max(1)) {
        *line.last_mut().expect("not empty") |= dirty;
    }
    rows
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn every_pixel_is_at_its_place(
        (width, height) in (0..150_usize, 0..40_usize),
        orders in (order(), order()),
        pixels in vec(any::<bool>(), 150 * 40),
    ) {
        let (rows, pages) = both(width, height, orders, &pixels);
        let size = |size: usize| u32::try_from(size).expect("small");
        let transpose = Transpose::new(size(width), size(height)).with_orders(orders.0, orders.1);

        let mut memory = vec![GUARD; pages.len() + 70];
        let dirty = with_dirty_padding(rows.clone(), width, orders.0);
        transpose.rows_to_pages(&[&dirty[..], &[0xFF; 9]].concat(), &mut memory)?;
        prop_assert_eq!(&memory[..pages.len()], &pages[..]);
        prop_assert!(memory[pages.len()..].iter().all(|byte| *byte == GUARD));

        let mut memory = vec![GUARD; rows.len() + 70];
        let mut dirty = pages;
        for (at, byte) in dirty.iter_mut().enumerate() {
            let below = (at / width * 8..at / width * 8 + 8).filter(|y| *y >= height);
            *byte |= below.fold(0, |dirty, y| dirty | 1 << bit(orders.1, y));
        }
        transpose.pages_to_rows(&[&dirty[..], &[0xFF; 70]].concat(), &mut memory)?;
        prop_assert_eq!(&memory[..rows.len()], &rows[..]);
        prop_assert!(memory[rows.len()..].iter().all(|byte| *byte == GUARD));
    }
}

// ST7306.

/// The table of `set_pixel` in the driver `st7306` 0.10: the byte of three and the bit of a pixel.
#[rustfmt::skip]
const ST7306: [[(usize, u8); 12]; 2] = [
    [(0, 0x80), (0, 0x20), (0, 0x08), (0, 0x02), (1, 0x80), (1, 0x20), (1, 0x08), (1, 0x02), (2, 0x80), (2, 0x20), (2, 0x08), (2, 0x02)],
    [(0, 0x40), (0, 0x10), (0, 0x04), (0, 0x01), (1, 0x40), (1, 0x10), (1, 0x04), (1, 0x01), (2, 0x40), (2, 0x10), (2, 0x04), (2, 0x01)],
];

proptest! {
    #[test]
    fn tiles_are_those_of_the_driver(
        width in 0..70_usize,
        upper in vec(any::<u8>(), 9),
        lower in vec(any::<u8>(), 0..10),
    ) {
        let mut expected = vec![0; width.div_ceil(12) * 3];
        for (row, places) in [&upper, &lower].into_iter().zip(ST7306) {
            for x in (0..width).filter(|x| row.get(x / 8).is_some_and(|byte| byte & (0x80 >> (x % 8)) != 0)) {
                let (byte, mask) = places[x % 12];
                expected[x / 12 * 3 + byte] |= mask;
            }
        }
        let columns = u32::try_from(width).expect("small");
        let mut memory = vec![GUARD; expected.len() + 9];
        prop_assert_eq!(st7306_tiles([&upper, &lower], columns, &mut memory), Ok(()));
        prop_assert_eq!(&memory[..expected.len()], &expected[..]);
        prop_assert_eq!(&memory[expected.len()..], [GUARD; 9]);
        if let Some(short) = memory.get_mut(..expected.len().wrapping_sub(1)) {
            prop_assert_eq!(st7306_tiles([&upper, &lower], columns, short), Err(TooSmall { needed: expected.len() }));
        }
    }

    // IT8951.

    #[test]
    fn words_are_those_of_the_driver(width in 0..70_usize, row in vec(any::<u8>(), 0..36)) {
        let mut expected = vec![0; width.div_ceil(4) * 2];
        for x in 0..width {
            let pixel = row.get(x / 2).map_or(0, |byte| if x % 2 == 0 { byte >> 4 } else { byte & 15 });
            // `bit_and_byte_pos` in the driver `it8951` 0.5.1.
            expected[(x / 2) ^ 1] |= pixel << (x % 2 * 4);
        }
        let columns = u32::try_from(width).expect("small");
        let mut memory = vec![GUARD; expected.len() + 9];
        prop_assert_eq!(it8951_words(&row, columns, &mut memory), Ok(()));
        prop_assert_eq!(&memory[..expected.len()], &expected[..]);
        prop_assert_eq!(&memory[expected.len()..], [GUARD; 9]);

        let whole = row.len() / 2 * 2;
        let mut in_place = row.clone();
        it8951_in_place(&mut in_place);
        let mut words = vec![0; whole];
        it8951_words(&row, u32::try_from(whole * 2).expect("small"), &mut words)?;
        prop_assert_eq!(&in_place[..whole], &words[..]);
        prop_assert_eq!(&in_place[whole..], &row[whole..]);
        it8951_in_place(&mut in_place);
        prop_assert_eq!(in_place, row);
    }
}

#[test]
fn four_pixels_of_the_driver_s_own_test() {
    // `test_pixel_single_row_packed`: A, B, C, D become DC, BA.
    let mut words = [0; 2];
    assert_eq!(it8951_words(&[0xAB, 0xCD], 4, &mut words), Ok(()));
    assert_eq!(words, [0xDC, 0xBA]);
}

#[test]
fn the_widest_rows_need_more_than_there_is() {
    assert_eq!(st7306_bytes(u32::MAX), 357_913_942 * 3);
    assert_eq!(it8951_bytes(u32::MAX), 1 << 31);
    assert_eq!(st7306_tiles([&[], &[]], u32::MAX, &mut [0; 9]), Err(TooSmall { needed: st7306_bytes(u32::MAX) }));
    assert_eq!(it8951_words(&[], u32::MAX, &mut [0; 9]), Err(TooSmall { needed: 1 << 31 }));
    assert_eq!(st7306_tiles([&[], &[]], 0, &mut []), Ok(()));
    assert_eq!(it8951_words(&[], 0, &mut []), Ok(()));
}
