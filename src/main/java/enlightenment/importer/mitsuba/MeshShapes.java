package enlightenment.importer.mitsuba;

import enlightenment.geometry.Mesh;
import enlightenment.importer.support.Affine;
import enlightenment.importer.support.UvMap;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads the meshes that shapes name; each is kept once. */
final class MeshShapes {
    private final SceneIndex scene;
    private final Map<Path, MeshFiles.Contents> files = new HashMap<>();
    private final Map<Key, TriangleMesh> meshes = new HashMap<>();

    /** What makes a mesh another one. */
    private record Key(MeshFiles.Origin origin, UvMap map, boolean isVDown) {}

    MeshShapes(SceneIndex scene) {
        this.scene = scene;
    }

    /**
     * The mesh of a shape; empty if its file cannot be found, which is noted.
     *
     * @param map what its textures do to texture coordinates
     * @param isTextured whether texture coordinates count
     * @throws IOException naming file and place if the file is broken
     */
    Optional<Mesh> mesh(Properties p, Affine toWorld, UvMap map, boolean isTextured) throws IOException {
        Path file;
        try {
            file = scene.file(p.text("filename", ""));
        } catch (IOException problem) {
            scene.note(p.element(), "a shape is left out: " + problem.getMessage());
            p.ignoreAll();
            return Optional.empty();
        }
        String type = p.element().type();
        String part = type.equals("serialized") ? Integer.toString(p.whole("shape_index", 0)) : "";
        // Mitsuba's own v runs downwards; what it flips on reading runs upwards in the file.
        boolean isVDown = !p.flag("flip_tex_coords", type.equals("obj"));
        p.ignore("flip_normals", "collapse", "to_world", "max_smooth_angle");
        MeshFiles.Origin origin = new MeshFiles.Origin(file, part, normals(p, file, part), 180);
        boolean isChanged = isTextured && (isVDown || !map.equals(UvMap.IDENTITY));
        Key key = new Key(origin, isChanged ? map : UvMap.IDENTITY, isChanged && isVDown);
        TriangleMesh triangles = meshes.get(key);
        if (triangles == null) {
            triangles = origin.of(read(file).parts());
            triangles = isChanged ? map.mapped(triangles, isVDown) : triangles;
            meshes.put(key, triangles);
        }
        return Optional.of(
                new Mesh(triangles, isChanged ? Optional.empty() : Optional.of(origin), toWorld.transform()));
    }

    /**
     * Whether the normals of a mesh point to the side from which its triangles, once they are placed, wind clockwise.
     *
     * @param isMirrored whether the map that places it mirrors
     */
    boolean isTurned(Properties p, Mesh placed, boolean isMirrored) throws IOException {
        Path file = scene.file(p.text("filename", ""));
        String type = p.element().type();
        String part = type.equals("serialized") ? Integer.toString(p.whole("shape_index", 0)) : "";
        if (normals(p, file, part) != MeshFiles.Origin.Normals.FILE) {
            // Mitsuba makes them of the triangles as to_world places them; what is around that mirrors triangle and
            // normal.
            return isMirrored != p.transform("to_world").determinant() < 0;
        }
        TriangleMesh mesh = placed.triangles();
        double sum = 0;
        for (int t = 0; t < mesh.triangles(); t++) {
            for (int corner = 0; corner < 3; corner++) {
                sum += mesh.areaNormal(t).dot(mesh.normal(mesh.vertex(t, corner)));
            }
        }
        return sum < 0 != isMirrored;
    }

    private MeshFiles.Contents read(Path file) throws IOException {
        MeshFiles.Contents known = files.get(file);
        if (known == null) {
            known = MeshFiles.readFile(file, MeshFiles.MAX_TRIANGLES);
            files.put(file, known);
        }
        return known;
    }

    /** Mitsuba makes normals where files have none, unless faces are to be flat. */
    private MeshFiles.Origin.Normals normals(Properties p, Path file, String part) throws IOException {
        if (p.flag("face_normals", false)) {
            return MeshFiles.Origin.Normals.FLAT;
        }
        TriangleMesh mesh = new MeshFiles.Origin(file, part, MeshFiles.Origin.Normals.FILE, 180)
                .of(read(file).parts());
        return mesh.hasNormals() ? MeshFiles.Origin.Normals.FILE : MeshFiles.Origin.Normals.SMOOTH;
    }

    /** The parallelogram −1..1 of the xy plane that two triangles are; empty for other meshes. */
    static Optional<Affine> parallelogram(TriangleMesh mesh) {
        if (mesh.triangles() != 2) {
            return Optional.empty();
        }
        for (int corner = 0; corner < 3; corner++) {
            Vec3 a = mesh.position(mesh.vertex(0, corner));
            Vec3 b = mesh.position(mesh.vertex(0, (corner + 1) % 3));
            Vec3 c = mesh.position(mesh.vertex(0, (corner + 2) % 3));
            List<Vec3> second = List.of(
                    mesh.position(mesh.vertex(1, 0)),
                    mesh.position(mesh.vertex(1, 1)),
                    mesh.position(mesh.vertex(1, 2)));
            Vec3 d = b.plus(c).minus(a);
            boolean isOne = second.contains(b)
                    && second.contains(c)
                    && second.stream().anyMatch(q -> isClose(q, d, b.minus(c)));
            if (isOne && mesh.areaNormal(0).dot(mesh.areaNormal(1)) > 0) {
                Vec3 u = b.minus(a).times(0.5);
                Vec3 v = c.minus(a).times(0.5);
                return Optional.of(Affine.ofColumns(u, v, u.cross(v), a.plus(u).plus(v)));
            }
        }
        return Optional.empty();
    }

    /** To the precision of printed coordinates, relative to the size. */
    private static boolean isClose(Vec3 p, Vec3 q, Vec3 size) {
        return p.minus(q).length() <= 0x1p-16 * size.length();
    }
}
