package enlightenment.importer.gltf;

import enlightenment.importer.support.ImportNotes;
import enlightenment.math.InvalidValueException;
import enlightenment.mesh.TriangleMesh;
import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Makes meshes of the primitives of glTF meshes: triangles, strips and fans of them. Each is made once, however many nodes show it, and holds the
 * vertices that its triangles use.
 */
final class PrimitiveReader {
    private static final int TRIANGLES = 4;
    private static final int STRIP = 5;
    private static final int FAN = 6;
    private static final String[] LINES = {"points", "lines", "line loops", "line strips"};

    /** Triangles that any file may have, and how many more for each of its bytes: primitives may share accessors. */
    private static final long FREE = 1_000_000;

    private static final long PER_BYTE = 4;

    private final GltfAccessors accessors;
    private final GltfBuffers buffers;
    private final ImportNotes notes;
    private final Map<String, Optional<TriangleMesh>> meshes = new HashMap<>();
    private long triangles;

    PrimitiveReader(GltfAccessors accessors, GltfBuffers buffers, ImportNotes notes) {
        this.accessors = accessors;
        this.buffers = buffers;
        this.notes = notes;
    }

    /**
     * The mesh of a primitive; empty, with a note, if it has no triangles.
     *
     * @param frame the texture coordinates that its material uses, if any
     */
    Optional<TriangleMesh> mesh(GltfElement primitive, Optional<TextureFrame> frame) throws IOException {
        if (!meshes.containsKey(primitive.place())) {
            meshes.put(primitive.place(), make(primitive, frame));
        }
        return meshes.get(primitive.place());
    }

    private Optional<TriangleMesh> make(GltfElement primitive, Optional<TextureFrame> frame) throws IOException {
        GltfElement attributes = primitive.get("attributes");
        int mode = (int) Math.min(primitive.whole("mode", TRIANGLES), Integer.MAX_VALUE);
        if (mode < TRIANGLES) {
            notes.add(primitive.place(), LINES[mode] + " are left out");
            return Optional.empty();
        }
        if (mode > FAN) {
            throw primitive.failure("has the mode " + mode + ", which glTF 2.0 does not have");
        }
        if (!attributes.has("POSITION")) {
            refuseCompressed(primitive);
            notes.add(primitive.place(), "is left out: it has no POSITION");
            return Optional.empty();
        }
        noteLosses(primitive, attributes);
        GltfAccessors.Numbers positions = accessors.numbers(attributes, "POSITION", "VEC3");
        int[] corners = corners(primitive, mode, positions.count());
        triangles += corners.length / 3;
        if (triangles > FREE + PER_BYTE * buffers.size()) {
            throw primitive.failure("has more triangles than a file of " + buffers.size() + " bytes can have");
        }
        try {
            return Optional.of(new Corners(corners, positions.count()).mesh(attributes, positions, frame));
        } catch (InvalidValueException e) {
            // Indices are in range already: what is wrong with them is that no triangle has an area.
            if (e.key().equals("indices")) {
                notes.add(primitive.place(), "is left out: none of its triangles has an area");
                return Optional.empty();
            }
            throw primitive.failure(e.getMessage());
        }
    }

    private static void refuseCompressed(GltfElement primitive) throws IOException {
        if (primitive.extension("KHR_draco_mesh_compression").isPresent()) {
            throw primitive.failure("is compressed by Draco, which cannot be read: export without compression");
        }
    }

    private void noteLosses(GltfElement primitive, GltfElement attributes) throws IOException {
        if (attributes.has("COLOR_0")) {
            notes.add(primitive.place(), "colours of vertices are left out");
        }
        if (primitive.size("targets") > 0) {
            notes.add(primitive.place(), "morph targets are left out: the mesh has its base shape");
        }
        if (primitive.extension("KHR_materials_variants").isPresent()) {
            notes.add(primitive.place(), "material variants are left out: the mesh has its default material");
        }
    }

    /** Three vertices of each triangle. */
    private int[] corners(GltfElement primitive, int mode, int vertices) throws IOException {
        int[] all;
        if (primitive.has("indices")) {
            all = accessors.indices(primitive, "indices");
            for (int i = 0; i < all.length; i++) {
                if (all[i] < 0 || all[i] >= vertices) {
                    throw primitive.failure("index " + i + " is " + Integer.toUnsignedLong(all[i]) + ", and there are "
                            + vertices + " vertices");
                }
            }
        } else {
            all = new int[vertices];
            Arrays.setAll(all, i -> i);
        }
        if (mode == TRIANGLES && all.length % 3 != 0) {
            notes.add(primitive.place(), "the last corners are left out: they make no whole triangle");
        }
        return mode == TRIANGLES ? Arrays.copyOf(all, all.length / 3 * 3) : connected(all, mode);
    }

    /** The triangles of a strip or a fan; those of a strip turn around alternately. */
    private static int[] connected(int[] all, int mode) {
        int n = Math.max(all.length - 2, 0);
        int[] corners = new int[3 * n];
        for (int i = 0; i < n; i++) {
            corners[3 * i] = mode == FAN ? all[i + 1] : all[i];
            corners[3 * i + 1] = mode == FAN ? all[i + 2] : all[i + 1 + i % 2];
            corners[3 * i + 2] = mode == FAN ? all[0] : all[i + 2 - i % 2];
        }
        return corners;
    }

    /** The vertices that triangles use, in their order. */
    private final class Corners {
        private final int[] corners;

        /** The vertices of the accessors, by the numbers that corners have now. */
        private int[] used;

        Corners(int[] corners, int vertices) {
            this.corners = corners;
            if (corners.length < vertices) {
                used = Arrays.stream(corners).sorted().distinct().toArray();
                for (int i = 0; i < corners.length; i++) {
                    corners[i] = Arrays.binarySearch(used, corners[i]);
                }
            } else {
                used = new int[vertices];
                Arrays.setAll(used, i -> i);
            }
        }

        TriangleMesh mesh(GltfElement attributes, GltfAccessors.Numbers positions, Optional<TextureFrame> frame)
                throws IOException {
            TriangleMesh mesh = TriangleMesh.of(picked(positions.values(), 3), corners);
            if (attributes.has("NORMAL")) {
                GltfAccessors.Numbers normals = accessors.numbers(attributes, "NORMAL", "VEC3");
                requireAsMany(attributes, "NORMAL", normals, positions);
                mesh = mesh.withNormals(picked(normals.values(), 3));
            }
            return withUv(mesh, attributes, positions, frame);
        }

        /** A texture without coordinates shows its corner everywhere. */
        private TriangleMesh withUv(
                TriangleMesh mesh,
                GltfElement attributes,
                GltfAccessors.Numbers positions,
                Optional<TextureFrame> frame)
                throws IOException {
            String key = "TEXCOORD_" + frame.map(TextureFrame::set).orElse(0);
            if (!attributes.has(key) && frame.isEmpty()) {
                return mesh;
            }
            float[] uv = new float[2 * used.length];
            if (attributes.has(key)) {
                GltfAccessors.Numbers read = accessors.numbers(attributes, key, "VEC2");
                requireAsMany(attributes, key, read, positions);
                uv = picked(read.values(), 2);
            } else {
                notes.add(attributes.place(), "there is no " + key + " for the textures: their first texel is seen");
            }
            // Ours run upwards.
            for (int i = 0; i < uv.length; i += 2) {
                double u = uv[i];
                double v = uv[i + 1];
                uv[i] = (float) (frame.isPresent() ? frame.get().map().u(u, v) : u);
                uv[i + 1] = (float) (1 - (frame.isPresent() ? frame.get().map().v(u, v) : v));
            }
            return mesh.withUv(uv);
        }

        private static void requireAsMany(
                GltfElement attributes, String key, GltfAccessors.Numbers numbers, GltfAccessors.Numbers positions)
                throws IOException {
            if (numbers.count() != positions.count()) {
                throw attributes.failure(
                        key + " has " + numbers.count() + " elements, and POSITION " + positions.count());
            }
        }

        private float[] picked(float[] values, int each) {
            float[] some = new float[each * used.length];
            for (int i = 0; i < used.length; i++) {
                System.arraycopy(values, each * used[i], some, each * i, each);
            }
            return some;
        }
    }
}
