package enlightenment.importer.pbrt;

import enlightenment.importer.support.ImportNotes;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshBuilder;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Reads shapes. Files of meshes are read once. */
final class Shapes {
    private static final Set<String> OLD = Set.of("cone", "paraboloid", "hyperboloid", "heightfield", "nurbs");

    /** The most triangles that a subdivision surface may have. */
    private static final long MOST_SUBDIVIDED = 1L << 22;

    private final TokenSource files;
    private final ImportNotes notes;
    private final Map<Path, Form> filesRead = new HashMap<>();

    Shapes(TokenSource files, ImportNotes notes) {
        this.files = files;
        this.notes = notes;
    }

    /** The shape of a type; empty, with a note, if it is left out. */
    Optional<Form> read(String type, Parameters p) {
        switch (type) {
            case "sphere":
                return Optional.of(sphere(p));
            case "disk":
                return Optional.of(disk(p));
            case "cylinder":
                return Optional.of(cylinder(p));
            case "trianglemesh":
                return triangles(p);
            case "bilinearmesh":
                return patches(p);
            case "plymesh":
                return Optional.of(ply(p));
            case "loopsubdiv":
                return subdivided(p);
            default:
                if (!type.equals("curve") && !OLD.contains(type)) {
                    throw p.place().failure("pbrt-v4 has no shape of the kind " + Plain.quoted(type));
                }
                note(p, "a shape of the kind " + Plain.quoted(type) + " is left out");
                return Optional.empty();
        }
    }

    private void note(Parameters p, String message) {
        notes.add(p.place().shown(), message);
    }

    private Form sphere(Parameters p) {
        double r = p.positive("radius", 1);
        double a = p.number("zmin", -r);
        double b = p.number("zmax", r);
        double phi = phiMax(p);
        if (Math.min(a, b) <= -r && Math.max(a, b) >= r && phi == 360) {
            return new Form.Ball(r);
        }
        note(p, "a part of a sphere becomes triangles");
        return Form.Triangles.of(Tessellation.sphere(r, Math.min(a, b), Math.max(a, b), phi));
    }

    private Form disk(Parameters p) {
        double r = p.positive("radius", 1);
        double inner = p.number("innerradius", 0);
        double phi = phiMax(p);
        if (!(inner >= 0 && inner < r)) {
            throw p.place().failure("the inner radius of a disk must be at least 0 and less than its radius");
        }
        if (inner == 0 && phi == 360) {
            return new Form.Plate(p.number("height", 0), r);
        }
        note(p, "a disk with a hole, or a part of one, becomes triangles");
        return Form.Triangles.of(Tessellation.disk(p.number("height", 0), r, inner, phi));
    }

    private Form cylinder(Parameters p) {
        double r = p.positive("radius", 1);
        double a = Math.min(p.number("zmin", -1), p.number("zmax", 1));
        double b = Math.max(p.number("zmin", -1), p.number("zmax", 1));
        double phi = phiMax(p);
        if (phi == 360) {
            return new Form.Tube(r, a, b);
        }
        note(p, "a part of a cylinder becomes triangles");
        return Form.Triangles.of(Tessellation.cylinder(r, a, b, phi));
    }

    private static double phiMax(Parameters p) {
        return Math.min(360, p.positive("phimax", 360));
    }

    private Optional<Form> triangles(Parameters p) {
        double[] points = p.tuples("P", 3);
        int[] indices = p.has("indices") || points.length != 9 ? p.integers("indices") : new int[] {0, 1, 2};
        double[] uv = p.tuples(p.has("st") ? "st" : "uv", 2);
        double[] normals = p.tuples("N", 3);
        requireAll(p, points, indices, 3);
        requireEach(p, "uv", uv.length, 2, points.length / 3);
        requireEach(p, "N", normals.length, 3, points.length / 3);
        MeshBuilder mesh = new MeshBuilder();
        for (int i = 0; i < points.length; i += 3) {
            mesh.vertex(points[i], points[i + 1], points[i + 2]);
        }
        for (int i = 0; i < normals.length; i += 3) {
            mesh.normal(normals[i], normals[i + 1], normals[i + 2]);
        }
        for (int i = 0; i < uv.length; i += 2) {
            mesh.uv(uv[i], uv[i + 1]);
        }
        boolean hasArea = false;
        for (int i = 0; i < indices.length; i += 3) {
            mesh.triangle(indices[i], indices[i + 1], indices[i + 2]);
            Vec3 a = point(points, indices[i]);
            hasArea |= point(points, indices[i + 1])
                            .minus(a)
                            .cross(point(points, indices[i + 2]).minus(a))
                            .maxAbs()
                    > 0;
        }
        if (!hasArea) {
            note(p, "a mesh without an area is left out");
            return Optional.empty();
        }
        return Optional.of(Form.Triangles.of(mesh.build()));
    }

    private static Vec3 point(double[] p, int i) {
        return new Vec3(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
    }

    private static void requireAll(Parameters p, double[] points, int[] indices, int each) {
        if (points.length == 0 || indices.length == 0 || indices.length % each != 0) {
            throw p.place()
                    .failure("a mesh must have points, \"point3 P\", and \"integer indices\", " + each
                            + " for each face; there are " + points.length / 3 + " points and " + indices.length
                            + " indices");
        }
        for (int v : indices) {
            if (v < 0 || v >= points.length / 3) {
                throw p.place()
                        .failure("an index must be one of " + points.length / 3 + " points, counted from 0, not " + v);
            }
        }
    }

    private static void requireEach(Parameters p, String name, int numbers, int each, int vertices) {
        if (numbers != 0 && numbers != each * vertices) {
            throw p.place()
                    .failure("a mesh must have " + each + " numbers of " + Plain.quoted(name) + " for each of "
                            + vertices + " points, not " + numbers);
        }
    }

    private Optional<Form> patches(Parameters p) {
        double[] points = p.tuples("P", 3);
        int[] indices = p.has("indices") || points.length != 12 ? p.integers("indices") : new int[] {0, 1, 2, 3};
        double[] uv = p.tuples("uv", 2);
        double[] normals = p.tuples("N", 3);
        requireAll(p, points, indices, 4);
        requireEach(p, "uv", uv.length, 2, points.length / 3);
        requireEach(p, "N", normals.length, 3, points.length / 3);
        MeshBuilder mesh = new MeshBuilder();
        for (int i = 0; i < indices.length; i += 4) {
            Vec3[] corners = new Vec3[4];
            Vec3[] n = normals.length == 0 ? null : new Vec3[4];
            double[] st = {0, 0, 1, 0, 0, 1, 1, 1};
            for (int k = 0; k < 4; k++) {
                int v = indices[i + k];
                corners[k] = point(points, v);
                if (n != null) {
                    n[k] = point(normals, v);
                }
                if (uv.length > 0) {
                    st[2 * k] = uv[2 * v];
                    st[2 * k + 1] = uv[2 * v + 1];
                }
            }
            if (Tessellation.addPatch(mesh, corners, st, n)) {
                note(p, "a curved bilinear patch becomes triangles");
            }
        }
        return Optional.of(Form.Triangles.of(mesh.build()));
    }

    private Form ply(Parameters p) {
        Path file = files.file(p.string("filename", ""), p.place());
        if (p.has("displacement")) {
            note(p, "the displacement of a mesh is left out");
        }
        return filesRead.computeIfAbsent(file, f -> {
            try {
                List<MeshFiles.Part> parts = MeshFiles.read(f, MeshFiles.MAX_TRIANGLES);
                MeshFiles.Origin origin = new MeshFiles.Origin(f, "", MeshFiles.Origin.Normals.FILE, 180);
                return new Form.Triangles(origin.of(parts), Optional.of(origin));
            } catch (IOException e) {
                throw p.place().failure(e.getMessage());
            }
        });
    }

    private Optional<Form> subdivided(Parameters p) {
        double[] points = p.tuples("P", 3);
        int[] indices = p.integers("indices");
        requireAll(p, points, indices, 3);
        int levels = p.integer("levels", 3, 0, 16);
        int fitting = levels;
        while (fitting > 0 && ((long) indices.length / 3) << (2 * fitting) > MOST_SUBDIVIDED) {
            fitting--;
        }
        if (fitting < levels) {
            note(p, "a surface is subdivided " + fitting + " times instead of " + levels);
        }
        Vec3[] all = new Vec3[points.length / 3];
        for (int i = 0; i < all.length; i++) {
            all[i] = point(points, i);
        }
        Optional<TriangleMesh> fine = LoopSubdivision.of(all, indices, fitting);
        if (fine.isEmpty()) {
            note(p, "a surface whose edges more than two triangles share is not subdivided");
        }
        return Optional.of(Form.Triangles.of(fine.orElseGet(() -> TriangleMesh.of(points, indices))));
    }
}
