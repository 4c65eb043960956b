//! Strips, fans and polygons become the triangles that they stand for.

use aquatint::model::{
    assembly::{Assembly, RESTART},
    mesh::{Mesh, MeshError},
};
use proptest::prelude::*;

type Triangle = [u16; 3];

fn proper(triangles: impl Iterator<Item = Triangle>) -> Vec<Triangle> {
    triangles.filter(|[a, b, c]| a != b && b != c && c != a).collect()
}

/// Each run between restarts by itself.
fn strip(indices: &[u16]) -> Vec<Triangle> {
    let of = |run: &[u16]| {
        let turned = |(i, t): (usize, &[u16])| if i % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] };
        proper(run.windows(3).enumerate().map(turned))
    };
    indices.split(|&index| index == RESTART).flat_map(of).collect()
}

fn fan(indices: &[u16]) -> Vec<Triangle> {
    let of = |run: &[u16]| proper(run.get(1..).unwrap_or_default().windows(2).map(|t| [run[0], t[0], t[1]]));
    indices.split(|&index| index == RESTART).flat_map(of).collect()
}

fn indices() -> impl Strategy<Value = Vec<u16>> {
    prop::collection::vec(prop_oneof![6 => 0..6_u16, 1 => Just(RESTART)], 0..30)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5_000))]

    #[test]
    fn strips_and_fans(indices in indices()) {
        for (assembly, want) in [(Assembly::Strip(&indices), strip(&indices)), (Assembly::Fan(&indices), fan(&indices))] {
            prop_assert_eq!(assembly.triangles().collect::<Vec<_>>(), want.clone());
            let numbers: Vec<_> = assembly.faces().map(|face| face.number).collect();
            prop_assert_eq!(numbers, (0..want.len()).collect::<Vec<_>>());
            let mesh = Mesh::with_assembly(&[[0; 3]; 6], &[[0; 3]; 6], assembly).expect("indices are right");
            let normals = vec![[0; 3]; want.len()];
            prop_assert!(mesh.with_face_normals(&normals).is_ok());
            let refused = Mesh::with_assembly(&[[0; 3]; 4], &[[0; 3]; 4], assembly).err();
            let wrong = indices.iter().position(|&index| index > 3 && index != RESTART);
            prop_assert_eq!(refused, wrong.map(|at| MeshError::NoSuchIndex { at }));
        }
    }

    #[test]
    fn polygons(polygons in prop::collection::vec(prop::collection::vec(0..8_u16, 3..9), 0..6)) {
        let counts: Vec<_> = polygons.iter().map(|polygon| u8::try_from(polygon.len()).expect("few")).collect();
        let indices = polygons.concat();
        let assembly = Assembly::Polygons { counts: &counts, indices: &indices };
        let got: Vec<_> = assembly.faces().map(|face| (face.number, face.corners)).collect();
        let want = polygons.iter().enumerate().flat_map(|(number, polygon)| fan(polygon).into_iter().map(move |t| (number, t)));
        prop_assert_eq!(got, want.collect::<Vec<_>>());
        let mesh = Mesh::with_assembly(&[[0; 3]; 8], &[[0; 3]; 8], assembly).expect("indices are right");
        let normals = vec![[0; 3]; polygons.len()];
        prop_assert!(mesh.with_face_normals(&normals).is_ok());
    }

    #[test]
    fn anything_may_be_assembled(counts in any::<Vec<u8>>(), indices in any::<Vec<u16>>()) {
        let count = Assembly::Polygons { counts: &counts, indices: &indices }.triangles().count();
        prop_assert!(count <= indices.len());
        let made = Mesh::with_assembly(&[], &[], Assembly::Polygons { counts: &counts, indices: &indices });
        prop_assert!(made.is_err() || indices.is_empty());
        prop_assert!(Assembly::Strip(&indices).triangles().count() <= indices.len());
        prop_assert!(Assembly::Fan(&indices).triangles().count() <= indices.len());
    }
}
