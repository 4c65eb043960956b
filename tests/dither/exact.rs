//! The sRGB curve compared with fractions, in whole numbers of any size: no rounding at all.

/// Whether the light of an sRGB code is more than `part` of `whole`.
pub fn exceeds(code: u8, part: u32, whole: u32) -> bool {
    let code = u32::from(code);
    if code <= 10 {
        // code / 255 / 12.92
        return u64::from(100 * code) * u64::from(whole) > 255 * 1292 * u64::from(part);
    }
    // ((code / 255 + 0.055) / 1.055) ^ 2.4, to the fifth power.
    let (above, below) = (1000 * code + 14_025, 269_025);
    let left = product([above; 12].into_iter().chain([whole; 5]));
    let right = product([below; 12].into_iter().chain([part; 5]));
    left.iter().rev().gt(right.iter().rev())
}

/// Digits of 32 bits, the lowest first; always as many, so that they can be compared.
fn product(factors: impl Iterator<Item = u32>) -> [u32; 16] {
    let mut digits = [0; 16];
    digits[0] = 1;
    for factor in factors {
        let mut carry = 0;
        for digit in &mut digits {
            let sum = u64::from(*digit) * u64::from(factor) + carry;
            *digit = u32::try_from(sum & 0xFFFF_FFFF).expect("masked");
            carry = sum >> 32;
        }
        assert_eq!(carry, 0, "17 factors of at most 20 bits");
    }
    digits
}

/// The first code that is on for a rank of some.
pub fn switch_code(rank: u32, ranks: u32) -> u8 {
    (0..=255).find(|&code| exceeds(code, 2 * rank + 1, 2 * ranks)).expect("white is on")
}

#[test]
fn the_exact_codes_are_those_of_the_literature() {
    let four = [50, 87, 111, 129, 145, 159, 171, 183, 193, 203, 212, 221, 229, 237, 245, 252];
    assert_eq!((0..16).map(|rank| switch_code(rank, 16)).collect::<Vec<_>>(), four);
    assert_eq!((0..4).map(|rank| switch_code(rank, 4)).collect::<Vec<_>>(), [100, 165, 208, 241]);
    assert_eq!([switch_code(0, 64), switch_code(0, 256)], [22, 7]);
}
