//! Light and its sRGB encoding.

/// How much light each of a panel's codes gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Response {
    /// Code n of N gives n/(N-1) of the range of light between the darkest and the lightest code,
    /// as drive currents or pulse widths in equal steps do. To the eye most of these codes are
    /// light.
    LinearLight,
    /// The codes are spaced as sRGB values: code n of N gives the light of the sRGB value n/(N-1).
    /// To the eye the steps are about equal.
    Srgb,
}

impl Response {
    /// The fraction of the range of light, 0 to 1, that `code` of `levels` codes gives.
    ///
    /// A code beyond the last counts as the last.
    #[must_use]
    pub fn light(self, code: u8, levels: u16) -> f32 {
        let last = levels.saturating_sub(1).max(1);
        let fraction = (f32::from(code) / f32::from(last)).min(1.0);
        match self {
            Self::LinearLight => fraction,
            Self::Srgb => decode(fraction),
        }
    }
}

/// The light of an sRGB channel value.
pub(crate) fn to_light(channel: u8) -> f32 {
    decode(f32::from(channel) / 255.0)
}

/// The sRGB channel value of an amount of light.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the range of a channel first")]
pub(crate) fn to_channel(light: f32) -> u8 {
    let encoded = if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    (encoded * 255.0).round().clamp(0.0, 255.0) as u8
}

fn decode(encoded: f32) -> f32 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::{Response, to_channel, to_light};

    #[test]
    fn every_channel_value_survives_the_way_through_light() {
        for channel in 0..=u8::MAX {
            assert_eq!(to_channel(to_light(channel)), channel);
        }
    }

    #[test]
    fn the_ends_of_both_responses_are_no_light_and_all_of_it() {
        for response in [Response::LinearLight, Response::Srgb] {
            for levels in [2, 4, 16, 256] {
                let last = u8::try_from(levels - 1).expect("at most 256 levels");
                assert!(response.light(0, levels).abs() < f32::EPSILON);
                assert!((response.light(last, levels) - 1.0).abs() < f32::EPSILON);
            }
        }
    }

    #[test]
    fn no_code_and_no_count_of_levels_leaves_the_range() {
        for response in [Response::LinearLight, Response::Srgb] {
            for levels in [0, 1, 2, 3, u16::MAX] {
                for code in [0, 1, u8::MAX] {
                    assert!((0.0..=1.0).contains(&response.light(code, levels)));
                }
            }
        }
    }
}
