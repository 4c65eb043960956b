//! Solids in every fill mode: against a reference in doubles, and against probes that other renderers have failed.

mod compare;
#[path = "../exact/mod.rs"]
mod exact;
mod meshes;
mod models;
mod modes;
mod probes;
mod reference;
mod renderer;

use exact::Random;

/// The probes in which nothing hides anything else.
macro_rules! convex_probes {
    ($renderer:ty) => {
        #[test]
        fn shared_edges_are_drawn_once() {
            probes::shared_edges::are_drawn_once::<$renderer>();
        }

        #[test]
        fn triangles_through_the_near_plane() {
            probes::near_plane::six_cases::<$renderer>();
            probes::near_plane::anywhere::<$renderer>();
        }

        #[test]
        fn shared_edges_that_are_cut_are_watertight() {
            probes::watertight::cut_edges::<$renderer>();
        }

        #[test]
        fn far_vertices() {
            probes::far_vertices::cover_all_or_are_refused::<$renderer>();
        }

        #[test]
        fn triangles_without_area_and_slivers() {
            probes::degenerate::without_area::<$renderer>();
            probes::degenerate::slivers::<$renderer>();
            probes::degenerate::ties::<$renderer>();
        }
    };
}

/// All probes for each fill mode. What has no depth is for convex solids.
macro_rules! fill_modes {
    ($($mode:ident: $renderer:ty),* $(,)?) => { $(
        mod $mode {
            use super::{modes, probes};

            convex_probes! { $renderer }

            #[test]
            fn walls_behind_and_through_walls() {
                probes::depth_pairs::one_behind_the_other::<$renderer>();
                probes::depth_pairs::one_through_the_other::<$renderer>();
            }
        }
    )* };
}

fill_modes! {
    gouraud: modes::Gouraud,
    gouraud_with_8_bits_of_depth: modes::Gouraud8,
    gouraud_with_32_bits_of_depth: modes::Gouraud32,
    flat_by_face: modes::FlatByFace,
    flat_by_corners: modes::FlatByCorners,
    phong: modes::Phong,
    textured: modes::UnlitTexture,
    textured_in_light: modes::LitTexture,
    affine: modes::Affine,
    shader: modes::Negative,
}

mod convex {
    use super::{modes, probes};

    convex_probes! { modes::Convex }
}
