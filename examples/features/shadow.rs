//! What a panel shows, kept beside it: the bytes that were sent, where they were sent to.

use aquatint::Rect;

use super::{BYTES, PANEL, Screen};
use crate::panel::in_bytes;

/// Bytes in a line of the panel, and its lines.
const STRIDE: i32 = in_bytes(PANEL)[1];

/// The bytes of a panel.
pub struct Shadow {
    bytes: [u8; BYTES],
    /// First byte of a line, the one behind the last, and the line that `at` is in.
    window: [i32; 3],
    at: i32,
}

impl Shadow {
    pub const NEW: Self = Self { bytes: [0; BYTES], window: [0; 3], at: 0 };

    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

impl Screen for Shadow {
    fn window(&mut self, area: Rect) {
        let [first, end, line, _] = in_bytes(area);
        (self.window, self.at) = ([first, end, line], first);
    }

    fn data(&mut self, bytes: &[u8]) {
        let [first, end, line] = &mut self.window;
        for &byte in bytes {
            let place = usize::try_from(*line * STRIDE + self.at).ok();
            if let Some(shown) = place.and_then(|place| self.bytes.get_mut(place)) {
                *shown = byte;
            }
            self.at += 1;
            if self.at == *end {
                (self.at, *line) = (*first, *line + 1);
            }
        }
    }
}
