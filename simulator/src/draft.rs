//! A file that is there whole or not at all.

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

/// A file under a name of its own, beside the one it will replace. Dropped, it is gone.
#[derive(Debug)]
pub(crate) struct Draft {
    file: NamedTempFile,
    path: PathBuf,
}

impl Draft {
    pub(crate) fn create(path: &Path) -> io::Result<Self> {
        // Beside it, because a file cannot be renamed from one file system to another.
        let directory = match path.parent() {
            Some(parent) if parent != Path::new("") => parent,
            _ => Path::new("."),
        };
        let file = readable_by_others(&mut Builder::new()).prefix(".unfinished-").tempfile_in(directory)?;
        let path = path.to_path_buf();
        Ok(Self { file, path })
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the file and gives it its name.
    pub(crate) fn publish(mut self, write: impl FnOnce(&mut BufWriter<&mut File>) -> io::Result<()>) -> io::Result<()> {
        let mut writer = BufWriter::new(self.file.as_file_mut());
        write(&mut writer)?;
        writer.into_inner()?;
        self.file.persist(&self.path)?;
        Ok(())
    }
}

/// Temporary files are private by default; this one becomes a file like any other, as private as
/// the user's mask makes it.
#[cfg(unix)]
fn readable_by_others<'a, 'b>(builder: &'a mut Builder<'b, 'b>) -> &'a mut Builder<'b, 'b> {
    use std::os::unix::fs::PermissionsExt;
    builder.permissions(std::fs::Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn readable_by_others<'a, 'b>(builder: &'a mut Builder<'b, 'b>) -> &'a mut Builder<'b, 'b> {
    builder
}
