//! What is said when there is no display.
#![cfg(all(feature = "window", unix, not(target_os = "macos")))]

use std::env;
use std::process::Command;

use aquatint_simulator::{Window, WindowError, display_available};

const INSIDE: &str = "AQUATINT_SIMULATOR_TEST_INSIDE";

/// Runs the test of this name once more in a process of its own, because the display of this one
/// must not be changed under the feet of other tests. True inside that process.
fn inside(test: &str, display: Option<&str>) -> bool {
    if env::var_os(INSIDE).is_some() {
        return true;
    }
    let mut again = Command::new(env::current_exe().expect("tests are run from a file"));
    again.args(["--exact", test]).env(INSIDE, "yes").env_remove("DISPLAY");
    if let Some(display) = display {
        again.env("DISPLAY", display);
    }
    let output = again.output().expect("it ran once, it runs again");
    assert!(output.status.success(), "{output:?}");
    false
}

#[test]
fn without_a_display() {
    if inside("without_a_display", None) {
        assert!(!display_available());
        let error = Window::open("none", 10, 10).expect_err("nowhere to open it");
        assert_eq!(error.to_string(), "no window: DISPLAY names no X11 display (on Wayland, XWayland provides one)");
    }
}

#[test]
fn with_an_empty_display() {
    if inside("with_an_empty_display", Some("")) {
        assert!(!display_available());
        let error = Window::open("none", 10, 10).expect_err("nowhere to open it");
        assert_eq!(error, WindowError::NoDisplay);
    }
}

#[test]
fn with_a_display_that_does_not_answer() {
    if inside("with_a_display_that_does_not_answer", Some(":65000")) {
        let error = Window::open("none", 10, 10).expect_err("nobody there");
        let text = error.to_string();
        assert!(text.starts_with("no window: display :65000 said: "), "{text}");
        assert_eq!(text.lines().count(), 1, "{text}");
    }
}

#[test]
fn impossible_sizes_never_reach_the_display() {
    if inside("impossible_sizes_never_reach_the_display", Some(":65000")) {
        for (width, height) in [(0, 10), (10, 0), (u32::MAX, 10), (10, 16_385)] {
            let error = Window::open("none", width, height).expect_err("no such window");
            assert_eq!(error, WindowError::Size { width, height });
        }
    }
}
