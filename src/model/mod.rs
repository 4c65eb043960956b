//! Modelling: what is drawn. Lecture 2.1.
//!
//! - **Takes** arrays that may live in flash.
//! - **Gives** a [`Mesh`](mesh::Mesh) whose indices are known to be right.
//! - **Memory** none: everything is borrowed.
//! - **Cost** one look at every index, at compile time for a constant.

pub mod mesh;
