//! Lists that change places without a panic left in the code, as `swap`, `insert` and `remove` of core and heapless leave one.

use heapless::vec::VecView;

/// Exchanges two items. Nothing happens if there are not two such places.
#[inline]
pub(crate) fn swap<T>(items: &mut [T], one: usize, other: usize) {
    if let Ok([one, other]) = items.get_disjoint_mut([one, other]) {
        core::mem::swap(one, other);
    }
}

/// Makes the last item the first; the others move on by one.
#[inline]
pub(crate) fn last_to_front<T: Copy>(items: &mut [T]) {
    let Some(&last) = items.last() else { return };
    let mut moved = last;
    for item in items {
        core::mem::swap(item, &mut moved);
    }
}

/// Puts an item before the one at a place, or at the end. Gives it back if the list is full.
#[inline]
pub(crate) fn insert<T: Copy>(list: &mut VecView<T>, place: usize, item: T) -> Result<(), T> {
    list.push(item)?;
    last_to_front(list.get_mut(place..).unwrap_or_default());
    Ok(())
}

/// Takes out the item at a place, if there is one; those behind it move up.
#[inline]
pub(crate) fn remove<T: Copy>(list: &mut VecView<T>, place: usize) {
    let Some([gone, behind @ ..]) = list.get_mut(place..) else { return };
    let mut hole = gone;
    for item in behind {
        *hole = *item;
        hole = item;
    }
    list.pop();
}

#[cfg(test)]
mod tests {
    use super::*;
    use heapless::Vec;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn as_the_lists_of_heapless(items in prop::collection::vec(any::<u8>(), 0..12), at in 0..15_usize, to in 0..15_usize) {
            let own: Vec<u8, 12> = items.iter().copied().collect();
            let count = own.len();
            let (mut list, mut other) = (own.clone(), own.clone());
            let result = insert(&mut list, at, 99);
            prop_assert_eq!(result.is_ok(), count < 12);
            if count < 12 {
                other.insert(at.min(count), 99).expect("room");
            }
            prop_assert_eq!(&list, &other);

            let (mut list, mut other) = (own.clone(), own.clone());
            remove(&mut list, at);
            if at < count {
                other.remove(at);
            }
            prop_assert_eq!(&list, &other);

            let (mut list, mut other) = (own.clone(), own.clone());
            swap(&mut list, at, to);
            if at < count && to < count {
                other.swap(at, to);
            }
            prop_assert_eq!(&list, &other);

            let (mut list, mut other) = (own.clone(), own);
            last_to_front(&mut list);
            other.rotate_right(usize::from(count > 0));
            prop_assert_eq!(list, other);
        }
    }
}
