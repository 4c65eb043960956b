//! Pictures row by row, without a frame and without a depth buffer. Lecture 5.4.
//!
//! ```text
//!   faces ─▶ buckets of rows ─▶ active faces ─▶ spans of a row ─▶ runs that are seen ─▶ shade ─▶ send
//!   once a picture              those that      left to right      the scanline
//!                               reach the row                      algorithm
//! ```

mod active;
mod buckets;

use core::{convert::Infallible, fmt, ops::Range};

use heapless::vec::{Vec, VecView};

use self::buckets::{Buckets, NONE};
pub use self::{
    active::{ActiveFace, WaitingFace},
    buckets::RowBucket,
};
use super::{
    Bounds, DrawError, Instance, MeshVertex, Scene,
    listed::{intersection, list, prepare},
    surface::Surface,
};
use crate::{
    fragment::shade::Shading,
    geometry::light::Lighting,
    hidden::scanline::{Full, RowDepth, Scanline, VisibleRun},
    illumination::Illumination,
    list::swap,
    num::{index_u16, low_index, low_u16},
    space::Rect,
    target::Target,
};

/// What a picture by rows is made in, lent by the caller.
#[derive(Debug)]
pub struct ScanlineMemory<'m, F> {
    /// One for each vertex of all instances.
    pub vertices: &'m mut [MeshVertex],
    /// Room for the faces that show in the picture: those that face the eye, about half of closed solids.
    pub faces: &'m mut VecView<WaitingFace>,
    /// At least one. With as many as there are rows, the room for active faces is counted to the face; with fewer,
    /// more may be asked for than are active at once.
    pub buckets: &'m mut [RowBucket],
    /// Room for the faces that reach into one row.
    pub active: &'m mut VecView<ActiveFace<F>>,
    /// As much as for active faces.
    pub order: &'m mut VecView<u16>,
    /// At least one; rows with more runs are resolved part by part. Twice as many as active faces is plenty.
    pub runs: &'m mut VecView<VisibleRun>,
}

/// A picture that is drawn row by row, from above: while it is sent, or into memory for one row.
///
/// Every pixel of a surface is given once. To the pixel it is the picture of [`draw_mesh`](super::draw_mesh) with a depth buffer
/// of 32 bits that all instances share.
///
/// Memory: that of [`ScanlineMemory`], and on the stack 170 bytes an instance. Cost on a Cortex-M0, of flat triangles: some 200
/// instructions for each row that a face reaches, some 150 for each run that is seen, and 5,000 a face with vertices of its own.
///
/// ```
/// use aquatint::{Dithered, Frame, Levels, Rect, Rows, Window, pipeline::{Scanlines, SceneMemory}};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
/// # use aquatint::{Angle, Light, Matrix, Scalar, Vector3, View, World, model::solids::CUBE, pipeline::{Camera, Instance, Scene}};
/// # use aquatint::geometry::{light::Lamp, projection::Lens, viewport::Viewport};
/// # let one = Scalar::ONE;
/// # let lens = Lens { field_of_view: Angle::from_degrees(40.0), aspect: one * 2, near: one, far: one * 8 };
/// # let camera = Camera {
/// #     view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, one * -4),
/// #     projection: Matrix::perspective(lens)?,
/// #     viewport: Viewport::new(Rect::new(0, 0, 400, 240))?,
/// # };
/// # let light = Lamp { direction: Vector3::new(one, one, one), ambient: Light(9000), diffuse: Light(50_000) };
/// # let scene = Scene { camera, light };
/// # let send = |_: &[u8]| {};
///
/// // A panel of 400 × 240, and 50 bytes for its pixels.
/// let instances = [Instance::new(CUBE, Matrix::IDENTITY)];
/// let mut memory = SceneMemory::<24, 12, 12>::NEW;
/// let mut picture = Scanlines::new(Rect::new(0, 0, 400, 240), memory.lend());
/// picture.begin(&instances, &scene)?;
/// let mut line = Frame::<BinaryColor, Rows, _>::with_array([0; 50], 400, 1)?;
/// while let Some(row) = picture.row() {
///     line.clear(BinaryColor::Off)?;
///     picture.draw_row(&mut Dithered::new(&mut Window::band(&mut line, row), Levels::ONE_BIT))?;
///     send(line.bytes());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Scanlines<'s, S: Shading, I, const N: usize> {
    surfaces: Vec<Surface<'s, S, I>, N>,
    /// Until they are lent to the surfaces.
    vertices: &'s mut [MeshVertex],
    faces: &'s mut VecView<WaitingFace>,
    buckets: Buckets<'s>,
    active: &'s mut VecView<ActiveFace<S::Face>>,
    order: &'s mut VecView<u16>,
    runs: &'s mut VecView<VisibleRun>,
    window: Rect,
    row: i32,
}

impl<'s, S: Shading, I: Illumination, const N: usize> Scanlines<'s, S, I, N> {
    /// A picture of the pixels of a window, without instances: [begin](Self::begin) it.
    #[must_use]
    pub fn new(window: Rect, memory: ScanlineMemory<'s, S::Face>) -> Self {
        const { assert!(N <= 256, "the instance of a face is a byte") };
        const { assert!(!S::DROPS, "a shading that leaves out pixels does not hide what is behind them") };
        let ScanlineMemory { vertices, faces, buckets, active, order, runs } = memory;
        let (surfaces, buckets, row) = (Vec::new(), Buckets::new(buckets), window.bottom);
        Self { surfaces, vertices, faces, buckets, active, order, runs, window, row }
    }

    /// Does everything that comes before the first row: vertices are transformed and lit, faces listed.
    ///
    /// Once, and apart from [`new`](Self::new), so that nothing large is moved on the stack of a small core.
    ///
    /// # Errors
    /// [`DrawError`]. Then there is no row to draw. Once there is one, nothing can run out.
    pub fn begin<B: Bounds, L: Lighting<Illumination = I>>(
        &mut self,
        instances: &'s [Instance<'_, S, B>; N],
        scene: &Scene<L>,
    ) -> Result<(), DrawError<Infallible>> {
        self.active.clear();
        self.order.clear();
        self.surfaces.clear();
        self.window = self.window.intersection(scene.camera.viewport.rect());
        self.row = self.window.bottom;
        self.buckets.empty_for(self.window);
        prepare(instances, scene, core::mem::take(&mut self.vertices), &mut self.surfaces)?;
        self.list()?;
        let (most, room) = (self.buckets.most_active(), self.active.capacity().min(self.order.capacity()));
        if most > room || self.runs.capacity() == 0 || self.buckets.is_empty() {
            return Err(DrawError::TooFewActive { needed: most.max(1) });
        }
        self.row = self.window.top;
        Ok(())
    }

    /// The row that is drawn next; `None` when all have been.
    #[must_use]
    pub fn row(&self) -> Option<i32> {
        (self.row < self.window.bottom).then_some(self.row)
    }

    /// Draws the next row. Every pixel of a surface is given once, from left to right; where none is, `target` stays as it is.
    /// The targets of all rows show light alike.
    ///
    /// # Errors
    /// What the target says. The row counts as drawn.
    #[inline(never)]
    pub fn draw_row<T: Target<Color = S::Color>>(&mut self, target: &mut T) -> Result<(), T::Error> {
        if self.row >= self.window.bottom {
            return Ok(());
        }
        self.activate();
        self.sort();
        let drawn = self.paint(target);
        self.row += 1;
        self.step();
        drawn
    }

    /// Puts the faces that can be seen into the buckets of their first rows.
    #[inline(never)]
    fn list(&mut self) -> Result<(), DrawError<Infallible>> {
        let Self { surfaces, faces, buckets, window, .. } = self;
        faces.clear();
        list(surfaces, *window, &mut |listed, _, _, pixels| {
            let place = index_u16(faces.len());
            if place == NONE || faces.is_full() {
                return false;
            }
            let mut face = WaitingFace::new(listed, pixels.top);
            face.next = buckets.insert(place, &pixels.rows());
            faces.push(face).is_ok()
        })
    }

    /// Takes up the faces that begin in this row.
    #[inline(never)]
    fn activate(&mut self) {
        let mut at = self.buckets.first(self.row);
        while let Some(face) = self.faces.get(usize::from(at)) {
            if i32::from(face.first_row) == self.row {
                let slot = index_u16(self.active.len());
                if let Some(active) = face.begin(&self.surfaces, (self.row, at), self.window) {
                    // There is room for both: they were counted.
                    let _ = (self.active.push(active), self.order.push(slot));
                }
            }
            at = face.next;
        }
    }

    /// Insertion sort by the left ends: from row to row little changes.
    #[inline(never)]
    fn sort(&mut self) {
        let (mut place, mut farthest) = (0, i32::MIN);
        while let Some(&slot) = self.order.get(place) {
            let left = self.left(slot);
            if left < farthest {
                self.sink(place, left);
            } else {
                farthest = left;
            }
            place += 1;
        }
    }

    #[inline]
    fn left(&self, slot: u16) -> i32 {
        self.active.get(usize::from(slot)).map_or(i32::MIN, ActiveFace::start)
    }

    /// Moves a face to the left, behind those that are not right of it.
    fn sink(&mut self, mut place: usize, left: i32) {
        while let Some(before) = place.checked_sub(1) {
            if self.order.get(before).is_none_or(|&slot| self.left(slot) <= left) {
                break;
            }
            swap(self.order, before, place);
            place = before;
        }
    }

    /// Resolves and shades the row; if it has more runs than there is room for, part by part.
    fn paint<T: Target<Color = S::Color>>(&mut self, target: &mut T) -> Result<(), T::Error> {
        let mut columns = self.window.columns();
        while !columns.is_empty() {
            let mut end = columns.end;
            // One column has one run, for which there is room.
            while self.resolve(columns.start..end).is_err() && end - columns.start > 1 {
                end = columns.start + (end - columns.start) / 2;
            }
            for run in self.runs.iter() {
                let Some(active) = self.active.get_mut(usize::from(run.surface())) else { continue };
                let Some(surface) = self.surfaces.get(usize::from(active.instance)) else { continue };
                surface.shading.paint(&surface.light, &mut active.face, (self.row, run.columns()), target)?;
            }
            columns.start = end;
        }
        Ok(())
    }

    /// Finds who is seen in some columns.
    #[inline(never)]
    fn resolve(&mut self, columns: Range<i32>) -> Result<(), Full> {
        let (active, mut scanline) = (&*self.active, Scanline::new(self.runs));
        let depths = |slot: u16| active.get(usize::from(slot)).map_or(RowDepth::FARTHEST, |face| face.depth);
        for &slot in self.order.iter() {
            if let Some(face) = active.get(usize::from(slot)) {
                scanline.add(intersection(face.columns(), &columns), slot, &depths)?;
            }
        }
        Ok(())
    }

    /// Goes down a row: drops the faces that end, moves the others on.
    #[inline(never)]
    fn step(&mut self) {
        let (mut slot, window) = (0, self.window.columns());
        while let Some(face) = self.active.get_mut(slot) {
            if i32::from(face.end_row) > self.row {
                face.advance(self.row, &window);
                slot += 1;
            } else {
                self.active.swap_remove(slot);
                // The last face has taken its slot.
                let (gone, last) = (low_index(slot), low_index(self.active.len()));
                self.order.retain(|&other| u32::from(other) != gone);
                for other in self.order.iter_mut().filter(|other| u32::from(**other) == last) {
                    *other = low_u16(gone.cast_signed());
                }
            }
        }
    }
}

impl<S: Shading, I, const N: usize> fmt::Debug for Scanlines<'_, S, I, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { faces, active, window, row, .. } = self;
        let (faces, active) = (faces.len(), active.len());
        write!(f, "Scanlines {{ window: {window:?}, row: {row}, faces: {faces}, active: {active} }}")
    }
}
