package enlightenment.mesh;

import enlightenment.check.Check;
import enlightenment.math.InvalidValueException;
import enlightenment.mesh.input.MeshSource;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;

/**
 * Reads files of triangle meshes (PLY, OBJ, STL, Mitsuba's {@code .serialized}), and writes PLY. The content of a file says which it is, and the
 * end of its name where the content does not.
 *
 * <p>Files are not trusted. What is broken, or larger than the rest of the file can be, is refused by an {@link IOException} whose message has the
 * name of the file and the place: the line of a text, else the element, counted from 0. Memory stays in proportion to the file, and for compressed
 * data to what they inflate to. Triangles without an area are left out and counted ({@link TriangleMesh#dropped()}).
 *
 * <p>Coordinates in text are rounded correctly: to floats in OBJ, STL and where a PLY file says {@code float}, else to doubles.
 *
 * <p>All methods may be called by several threads at once.
 */
public final class MeshFiles {
    /** The default limit of triangles in one file. */
    public static final long MAX_TRIANGLES = 100_000_000;

    /** Bytes that show which format a file has. */
    private static final int START = 128;

    private MeshFiles() {}

    /**
     * Reads the parts of a file: one for each material of an OBJ file that has a triangle with an area, in the order of first use, one for each
     * shape of a {@code .serialized} file, in the file's order, else one.
     *
     * @param maxTriangles the limit of triangles in all parts
     */
    public static List<Part> read(Path file, long maxTriangles) throws IOException {
        return readFile(file, maxTriangles).parts();
    }

    /**
     * Reads the parts of a file whose content is in memory, see {@link #read(Path, long)}.
     *
     * @param name for messages, and for the format
     */
    public static List<Part> read(byte[] content, String name, long maxTriangles) throws IOException {
        return read(MeshSource.of(content, name), maxTriangles).parts();
    }

    /** Reads the parts of a file and the names of the material libraries that it uses, see {@link #read(Path, long)}. */
    public static Contents readFile(Path file, long maxTriangles) throws IOException {
        return read(MeshSource.of(file), maxTriangles);
    }

    /**
     * Reads one shape of a {@code .serialized} file.
     *
     * @param shape its number, counted from 0
     */
    public static Part readShape(Path file, int shape, long maxTriangles) throws IOException {
        MeshSource source = MeshSource.of(file);
        return checked(source, () -> SerializedReader.read(source, shape, maxTriangles));
    }

    /** Writes a mesh as a binary PLY file, which reads back as an equal one. The stream is flushed, not closed. */
    public static void writePly(TriangleMesh mesh, OutputStream out) throws IOException {
        PlyWriter.write(mesh, out);
    }

    private interface Reading<T> {
        T read() throws IOException;
    }

    private static <T> T checked(MeshSource source, Reading<T> reading) throws IOException {
        try {
            return reading.read();
        } catch (InvalidValueException e) {
            throw source.failure(e.getMessage());
        }
    }

    private static Contents read(MeshSource source, long maxTriangles) throws IOException {
        return checked(source, () -> readAny(source, maxTriangles));
    }

    private static Contents readAny(MeshSource source, long maxTriangles) throws IOException {
        byte[] start = source.start(START);
        String text = new String(start, StandardCharsets.ISO_8859_1);
        if (text.startsWith("\u001f\u008b")) {
            throw source.failure("is compressed by gzip; a mesh is read from what gunzip makes of it");
        }
        String name = source.name.toLowerCase(Locale.ROOT);
        if (SerializedReader.isSerialized(start) || name.endsWith(".serialized")) {
            return new Contents(SerializedReader.read(source, maxTriangles), List.of(), false);
        }
        if (text.matches("(?is)ply[\n\r].*") || name.endsWith(".ply")) {
            PlyReader ply = new PlyReader(source, maxTriangles);
            return single(source, ply::mesh, ply.hasColors());
        }
        if (name.endsWith(".obj")) {
            return ObjReader.read(source, maxTriangles);
        }
        boolean isSolid = text.strip().toLowerCase(Locale.ROOT).startsWith("solid");
        if (isSolid || StlReader.isBinary(source, start)) {
            return single(source, () -> StlReader.read(source, start, maxTriangles), false);
        }
        throw source.failure(
                name.endsWith(".stl")
                        ? "neither begins with solid nor has the size of a binary STL file, 84 + 50 bytes a triangle"
                        : "is no PLY, STL or .serialized file, and not named .obj: it begins with "
                                + Plain.quoted(text.substring(0, Math.min(16, text.length()))));
    }

    private static Contents single(MeshSource source, MeshMaking making, boolean hasColors) throws IOException {
        TriangleMesh mesh = making.withArea(source).orElseThrow(() -> source.failure("has no triangle with an area"));
        return new Contents(List.of(new Part("", mesh)), List.of(), hasColors);
    }

    /**
     * A part of a mesh file: the triangles of one material, or one shape of a {@code .serialized} file.
     *
     * @param material the name of the material, or ""
     * @param mesh its triangles
     */
    public record Part(String material, TriangleMesh mesh) {}

    /**
     * What a mesh file holds.
     *
     * @param parts at least one
     * @param materialLibraries the names of MTL files as an OBJ file has them, which are relative to its folder; else none
     * @param hasColors whether vertices have colours, which meshes do not
     */
    public record Contents(List<MeshFiles.Part> parts, List<String> materialLibraries, boolean hasColors) {
        /** Copies the lists. */
        public Contents {
            parts = List.copyOf(parts);
            materialLibraries = List.copyOf(materialLibraries);
        }
    }

    /**
     * Where a mesh comes from: a file, a part of it, and what is made of its normals.
     *
     * @param file the file; where scenes have no folder, a name
     * @param part the name of the material whose triangles are meant, or the number of a shape from 0; "" for all of the file
     * @param normals which normals its vertices have
     * @param crease for {@link Normals#SMOOTH}: the angle in degrees, 0..180, beyond which normals of triangles do not count for another; else 180
     */
    public record Origin(Path file, String part, Normals normals, double crease) {
        /** Which normals vertices have. */
        public enum Normals {
            /** Those of the file, if it has some. */
            FILE,
            /** None: triangles are flat. */
            FLAT,
            /** The mean of those of the triangles around a vertex. */
            SMOOTH
        }

        /** @throws enlightenment.math.InvalidValueException for a crease out of range, or other than 180 without smooth normals */
        public Origin {
            Objects.requireNonNull(file, "file");
            Objects.requireNonNull(normals, "normals");
            Objects.requireNonNull(part, "part");
            Check.range("crease", crease, 0, 180);
            Check.that(normals == Normals.SMOOTH || crease == 180, "crease", "means something for smooth normals only");
        }

        /**
         * The mesh that is meant.
         *
         * @param parts those of the file
         * @throws IOException if it has no such part
         */
        public TriangleMesh of(List<MeshFiles.Part> parts) throws IOException {
            TriangleMesh read = part.isEmpty() ? JoinedParts.of(parts) : named(parts);
            return switch (normals) {
                case FILE -> read;
                case FLAT -> read.flat();
                case SMOOTH -> read.smooth(crease);
            };
        }

        private TriangleMesh named(List<MeshFiles.Part> parts) throws IOException {
            for (MeshFiles.Part p : parts) {
                if (p.material().equals(part)) {
                    return p.mesh();
                }
            }
            if (part.matches("[0-9]{1,9}") && Integer.parseInt(part) < parts.size()) {
                return parts.get(Integer.parseInt(part)).mesh();
            }
            List<String> names = parts.stream()
                    .map(MeshFiles.Part::material)
                    .filter(n -> !n.isEmpty())
                    .toList();
            throw new IOException(file + " has no part " + Plain.quoted(part) + " among its " + parts.size()
                    + (names.isEmpty() ? "" : Suggestion.of(part, names, "there are")));
        }
    }
}
