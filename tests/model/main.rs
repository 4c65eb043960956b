//! Modelling: assemblies against a slow one, solids by their geometry, the converter on good and broken files.

mod assembly;
mod convert;
mod solids;
