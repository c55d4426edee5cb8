package enlightenment.mesh;

import enlightenment.check.Check;
import enlightenment.text.Plain;
import enlightenment.text.Suggestion;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * Where a mesh comes from: a file, a part of it, and what is made of its normals.
 *
 * @param file the file; where scenes have no folder, a name
 * @param part the name of the material whose triangles are meant, or the number of a shape from 0; "" for all of the file
 * @param normals which normals its vertices have
 * @param crease for {@link Normals#SMOOTH}: the angle in degrees, 0..180, beyond which normals of triangles do not count for another; else 180
 */
public record MeshOrigin(Path file, String part, Normals normals, double crease) {
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
    public MeshOrigin {
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
    public TriangleMesh of(List<MeshPart> parts) throws IOException {
        TriangleMesh read = part.isEmpty() ? JoinedMesh.of(parts) : named(parts);
        return switch (normals) {
            case FILE -> read;
            case FLAT -> read.flat();
            case SMOOTH -> read.smooth(crease);
        };
    }

    private TriangleMesh named(List<MeshPart> parts) throws IOException {
        for (MeshPart p : parts) {
            if (p.material().equals(part)) {
                return p.mesh();
            }
        }
        if (part.matches("[0-9]{1,9}") && Integer.parseInt(part) < parts.size()) {
            return parts.get(Integer.parseInt(part)).mesh();
        }
        List<String> names =
                parts.stream().map(MeshPart::material).filter(n -> !n.isEmpty()).toList();
        throw new IOException(file + " has no part " + Plain.quoted(part) + " among its " + parts.size()
                + (names.isEmpty() ? "" : Suggestion.of(part, names, "there are")));
    }
}
