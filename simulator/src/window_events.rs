//! What the user does to a window.

use std::cell::RefCell;
use std::rc::Rc;

use minifb::InputCallback;

/// Something the user did.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Event {
    /// A key went down, or is held down and repeats.
    Key(Key),
    /// The mouse moved with the left button down.
    Drag {
        /// Pixels to the right.
        dx: i32,
        /// Pixels down.
        dy: i32,
    },
}

/// A key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Key {
    /// A key that types a character, as the keyboard layout and the shift key have it.
    Character(char),
    /// Arrow up.
    Up,
    /// Arrow down.
    Down,
    /// Arrow left.
    Left,
    /// Arrow right.
    Right,
    /// Escape.
    Escape,
    /// Enter, also that of the number pad.
    Enter,
    /// The space bar.
    Space,
}

impl Key {
    /// The keys that type nothing that could be seen.
    fn unprinted(key: minifb::Key) -> Option<Self> {
        match key {
            minifb::Key::Up => Some(Self::Up),
            minifb::Key::Down => Some(Self::Down),
            minifb::Key::Left => Some(Self::Left),
            minifb::Key::Right => Some(Self::Right),
            minifb::Key::Escape => Some(Self::Escape),
            minifb::Key::Enter | minifb::Key::NumPadEnter => Some(Self::Enter),
            minifb::Key::Space => Some(Self::Space),
            _ => None,
        }
    }
}

/// What happened and was not yet asked for, shared with the callback that hears of keys.
///
/// A callback, because the keys that minifb can be asked for are those that are down at that
/// moment: a quick tap, down and up between two frames, would be lost.
#[derive(Clone, Debug, Default)]
pub(crate) struct Queue(Rc<RefCell<Vec<Event>>>);

impl Queue {
    /// Adds an event. A drag goes on with the drag before.
    pub(crate) fn push(&self, event: Event) {
        let mut events = self.0.borrow_mut();
        match (events.last_mut(), event) {
            (Some(Event::Drag { dx, dy }), Event::Drag { dx: x, dy: y }) => {
                *dx = dx.saturating_add(x);
                *dy = dy.saturating_add(y);
            }
            _ => events.push(event),
        }
    }

    pub(crate) fn drain(&self) -> Vec<Event> {
        self.0.take()
    }
}

impl InputCallback for Queue {
    fn add_char(&mut self, code_point: u32) {
        let printed =
            char::from_u32(code_point).filter(|character| !character.is_control() && !character.is_whitespace());
        if let Some(character) = printed {
            self.push(Event::Key(Key::Character(character)));
        }
    }

    fn set_key_state(&mut self, key: minifb::Key, down: bool) {
        if let Some(key) = Key::unprinted(key).filter(|_| down) {
            self.push(Event::Key(key));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Event, Key, Queue};
    use minifb::InputCallback;

    #[test]
    fn keys_arrive_in_order_and_once() {
        let queue = Queue::default();
        let mut callback = queue.clone();
        callback.set_key_state(minifb::Key::Q, true);
        callback.add_char(u32::from('q'));
        callback.set_key_state(minifb::Key::Q, false);
        callback.set_key_state(minifb::Key::Space, true);
        callback.add_char(u32::from(' '));
        callback.set_key_state(minifb::Key::Escape, true);
        callback.add_char(0x1b);
        let keys = [Key::Character('q'), Key::Space, Key::Escape];
        assert_eq!(queue.drain(), keys.map(Event::Key));
        assert!(queue.drain().is_empty());
    }

    #[test]
    fn drags_add_up_until_something_else_happens() {
        let queue = Queue::default();
        queue.push(Event::Drag { dx: 1, dy: 2 });
        queue.push(Event::Drag { dx: 3, dy: -5 });
        queue.push(Event::Key(Key::Up));
        queue.push(Event::Drag { dx: 1, dy: 0 });
        assert_eq!(queue.drain(), [Event::Drag { dx: 4, dy: -3 }, Event::Key(Key::Up), Event::Drag { dx: 1, dy: 0 },]);
    }
}
