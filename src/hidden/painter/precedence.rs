//! The tests that let one piece be drawn before another, the cheap ones first.

use super::{
    divide::{Divider, FacePlane, Line},
    piece::{PieceCorner, SortedPiece},
};

/// Whether `p` may be drawn before `q`.
pub(super) fn may_precede(corners: &[PieceCorner], p: &SortedPiece, q: &SortedPiece) -> bool {
    // Pieces of one face have no pixel in common.
    if p.is_wholly_farther(q) || p.face() == q.face() {
        return true;
    }
    let (outline_p, outline_q) = (p.corners(corners), q.corners(corners));
    // Corners of pieces are rounded, those of whole faces are exact.
    let rounded = i32::from(!p.is_whole()) + i32::from(!q.is_whole());
    are_apart(outline_p, outline_q, rounded, |corner| corner.x)
        || are_apart(outline_p, outline_q, rounded, |corner| corner.y)
        || depths_allow(corners, p, q)
        || is_apart_by_an_edge(outline_p, outline_q, rounded)
        || is_apart_by_an_edge(outline_q, outline_p, rounded)
}

/// Whether two pieces have more in common than the rounding of their corners.
pub(super) fn overlap(corners: &[PieceCorner], p: &SortedPiece, q: &SortedPiece) -> bool {
    let (outline_p, outline_q) = (p.corners(corners), q.corners(corners));
    let rounded = -i32::from(!p.is_whole()) - i32::from(!q.is_whole());
    !is_apart_by_an_edge(outline_p, outline_q, rounded) && !is_apart_by_an_edge(outline_q, outline_p, rounded)
}

/// Whether two outlines have no column, or no row, in common.
fn are_apart(a: &[PieceCorner], b: &[PieceCorner], rounded: i32, of: fn(&PieceCorner) -> i32) -> bool {
    let reach = |outline: &[PieceCorner]| {
        outline.iter().map(of).fold((i32::MAX, i32::MIN), |(least, most), v| (least.min(v), most.max(v)))
    };
    let ((a_start, a_end), (b_start, b_end)) = (reach(a), reach(b));
    a_end.saturating_add(rounded) <= b_start || b_end.saturating_add(rounded) <= a_start
}

/// Whether `p` is behind the plane of `q`, or `q` in front of the plane of `p`; of two in one plane, the later one is drawn
/// first.
fn depths_allow(corners: &[PieceCorner], p: &SortedPiece, q: &SortedPiece) -> bool {
    let [plane_p, plane_q] = [p, q].map(|piece| FacePlane::new(&piece.triangle(corners)));
    let (p_to_q, q_to_p) = (p.sides(corners, &plane_q), q.sides(corners, &plane_p));
    if p_to_q.is_within() || q_to_p.is_within() {
        return p.face() > q.face();
    }
    p_to_q.is_behind() || q_to_p.is_in_front()
}

/// Whether an edge of `a` has all of `a` on one side, and all of `b` on the other.
fn is_apart_by_an_edge(a: &[PieceCorner], b: &[PieceCorner], rounded: i32) -> bool {
    (0..a.len()).any(|edge| {
        let line = Line::of_edge(a, edge);
        let rounding = line.rounding(false);
        let reach = |outline: &[PieceCorner]| {
            let distances = outline.iter().map(|corner| line.distance(corner));
            distances.fold((i64::MAX, i64::MIN), |(least, most), v| (least.min(v), most.max(v)))
        };
        let ((a_least, a_most), (b_least, b_most)) = (reach(a), reach(b));
        let room = rounding.saturating_mul(rounded.into());
        // Corners at the same place are no edge.
        rounding > 0 && (a_most.saturating_add(room) <= b_least || b_most.saturating_add(room) <= a_least)
    })
}
