//! Products of whole numbers of any size, and all colours: the oracles of the other files.

use std::cmp::Ordering;

/// The product of powers, lowest 32 bits first, without zeros at the end.
pub fn product(powers: &[(u64, u32)]) -> Vec<u32> {
    let mut digits = vec![1_u32];
    for factor in powers.iter().flat_map(|(base, exponent)| (0..*exponent).map(move |_| *base)) {
        let mut carry = 0_u128;
        for digit in &mut digits {
            let sum = u128::from(*digit) * u128::from(factor) + carry;
            *digit = u32::try_from(sum & 0xFFFF_FFFF).expect("32 bits");
            carry = sum >> 32;
        }
        while carry > 0 {
            digits.push(u32::try_from(carry & 0xFFFF_FFFF).expect("32 bits"));
            carry >>= 32;
        }
        while digits.last() == Some(&0) {
            digits.pop();
        }
    }
    digits
}

/// How two products compare.
pub fn compare(a: &[(u64, u32)], b: &[(u64, u32)]) -> Ordering {
    let (a, b) = (product(a), product(b));
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

/// All 16,777,216 colours.
pub fn all_colours() -> impl Iterator<Item = [u8; 3]> {
    (0..1_u32 << 24).map(|number| {
        let [blue, green, red, _] = number.to_le_bytes();
        [red, green, blue]
    })
}

/// Colours of some channels, with the ends of the range.
pub fn some_colours(step: usize) -> impl Iterator<Item = [u8; 3]> {
    let channel = move || (0..=255_u8).step_by(step).chain([1, 2, 127, 128, 253, 254, 255]);
    channel().flat_map(move |red| channel().flat_map(move |green| channel().map(move |blue| [red, green, blue])))
}

#[test]
fn products_are_exact() {
    assert_eq!(product(&[(10, 20)]), [0x6310_0000, 0x6BC7_5E2D, 0x5]);
    assert_eq!(compare(&[(3, 100)], &[(9, 50)]), Ordering::Equal);
    assert_eq!(compare(&[(2, 65)], &[(2, 64), (3, 1)]), Ordering::Less);
    assert_eq!(compare(&[(7, 3)], &[(0, 1)]), Ordering::Greater);
}
