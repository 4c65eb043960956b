//! Colours without end, of which any number is passed over at once.

/// See [`endless`].
#[derive(Clone)]
pub struct Endless<F>(F);

/// What `make` gives, again and again. Unlike `core::iter::repeat_with` it jumps: a rectangle of hostile size has more
/// colours than can be counted through.
pub fn endless<T, F: FnMut() -> T>(make: F) -> Endless<F> {
    Endless(make)
}

impl<T, F: FnMut() -> T> Iterator for Endless<F> {
    type Item = T;

    fn next(&mut self) -> Option<T> {
        Some((self.0)())
    }

    fn nth(&mut self, _: usize) -> Option<T> {
        self.next()
    }
}
