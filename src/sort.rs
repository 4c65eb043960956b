//! Sorting in the caller's memory: a heap, small and without a worst case.
//!
//! ```text
//!            7                the first of all on top; it goes behind the heap,
//!        5       6            the last takes its place and sinks
//!      1   4   2   3
//! ```
//!
//! - **Takes** a slice, and what comes before what.
//! - **Gives** the slice in order; what is equal in any order.
//! - **Memory** none.
//! - **Cost** `2 n log₂ n` comparisons at the most.
//!
//! J. W. J. Williams, "Algorithm 232: heapsort", Communications of the ACM 7(6), 1964; R. W. Floyd built the heap in place.

use crate::list::swap;

/// Sorts by a strict order.
pub(crate) fn heap_sort<T>(items: &mut [T], is_before: impl Fn(&T, &T) -> bool) {
    for top in (0..items.len() / 2).rev() {
        sink(items, top, &is_before);
    }
    for end in (1..items.len()).rev() {
        swap(items, 0, end);
        sink(items.get_mut(..end).unwrap_or_default(), 0, &is_before);
    }
}

/// Lets an item sink below those that come behind it in the sorted order.
fn sink<T>(items: &mut [T], mut place: usize, is_before: &impl Fn(&T, &T) -> bool) {
    loop {
        let (left, right) = (2 * place + 1, 2 * place + 2);
        let Some((last, child)) = items.get(left).map(|item| (item, left)) else { return };
        let other = items.get(right).filter(|item| is_before(last, item));
        let (last, child) = other.map_or((last, child), |item| (item, right));
        if items.get(place).is_none_or(|item| !is_before(item, last)) {
            return;
        }
        swap(items, place, child);
        place = child;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use heapless::Vec;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn sorted_as_core_sorts(numbers in prop::collection::vec(0..50_u8, 0..64)) {
            let (mut own, mut sorted): (Vec<_, 64>, Vec<_, 64>) = (numbers.iter().copied().collect(), numbers.iter().copied().collect());
            heap_sort(&mut own, |a, b| a < b);
            sorted.sort_unstable();
            prop_assert_eq!(own, sorted);
        }
    }
}
