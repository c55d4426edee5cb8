package enlightenment.importer.pbrt;

import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ImportNotes;
import enlightenment.importer.support.PlacedShapes;
import enlightenment.importer.support.UvMap;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.mesh.TriangleMesh;

/** Makes shapes of the scene of {@link Form}s. */
final class PlacedForms {
    private final PlacedShapes shapes;

    PlacedForms(ImportNotes notes) {
        shapes = new PlacedShapes(notes, false);
    }

    /** The shape under a map. */
    Shape place(Form form, Affine map, Place place) {
        if (form instanceof Form.Ball ball) {
            double r = ball.radius();
            return shapes.sphere(map.after(Affine.scale(r, r, r)), false, place.shown());
        } else if (form instanceof Form.Plate plate) {
            Affine local = Affine.translate(0, 0, plate.height())
                    .after(Affine.scale(plate.radius(), plate.radius(), plate.radius()));
            return shapes.disk(map.after(local), false, place.shown());
        } else if (form instanceof Form.Tube tube) {
            Affine local = Affine.translate(0, 0, tube.zMin())
                    .after(Affine.scale(tube.radius(), tube.radius(), tube.zMax() - tube.zMin()));
            return shapes.cylinder(map.after(local), false, place.shown());
        } else if (form instanceof Form.Triangles t) {
            return new Mesh(t.mesh(), t.origin(), map.transform());
        }
        throw new AssertionError("no shape of " + form);
    }

    /** The form as triangles with texture coordinates under a map. */
    static Form textured(Form form, UvMap uv) {
        TriangleMesh mesh = triangles(form);
        if (form instanceof Form.Triangles t && mesh.hasUv() && uv.equals(UvMap.IDENTITY)) {
            return t;
        }
        return Form.Triangles.of(mesh.hasUv() ? mapped(mesh, uv) : unshared(mesh, uv));
    }

    /** The form as triangles, with texture coordinates where it is a quadric. */
    static TriangleMesh triangles(Form form) {
        if (form instanceof Form.Ball ball) {
            return Tessellation.sphere(ball.radius(), -ball.radius(), ball.radius(), 360);
        } else if (form instanceof Form.Plate plate) {
            return Tessellation.disk(plate.height(), plate.radius(), 0, 360);
        } else if (form instanceof Form.Tube tube) {
            return Tessellation.cylinder(tube.radius(), tube.zMin(), tube.zMax(), 360);
        } else if (form instanceof Form.Triangles t) {
            return t.mesh();
        }
        throw new AssertionError("no triangles of " + form);
    }

    private static TriangleMesh mapped(TriangleMesh mesh, UvMap map) {
        float[] uv = new float[2 * mesh.vertices()];
        for (int v = 0; v < mesh.vertices(); v++) {
            uv[2 * v] = (float) map.u(mesh.uv(v, 0), mesh.uv(v, 1));
            uv[2 * v + 1] = (float) map.v(mesh.uv(v, 0), mesh.uv(v, 1));
        }
        return mesh.withUv(uv);
    }

    /** Triangles without texture coordinates have (0, 0), (1, 0), (1, 1) in pbrt. */
    private static TriangleMesh unshared(TriangleMesh mesh, UvMap map) {
        MeshBuilder all = new MeshBuilder();
        for (int t = 0; t < mesh.triangles(); t++) {
            int first = all.vertices();
            for (int corner = 0; corner < 3; corner++) {
                int v = mesh.vertex(t, corner);
                Vec3 p = mesh.position(v);
                all.vertex(p.x(), p.y(), p.z());
                if (mesh.hasNormals()) {
                    Vec3 n = mesh.normal(v);
                    all.normal(n.x(), n.y(), n.z());
                }
                double u = corner == 0 ? 0 : 1;
                double w = corner == 2 ? 1 : 0;
                all.uv(map.u(u, w), map.v(u, w));
            }
            all.triangle(first, first + 1, first + 2);
        }
        return all.build();
    }
}
