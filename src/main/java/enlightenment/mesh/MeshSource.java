package enlightenment.mesh;

import enlightenment.check.Check;
import java.nio.file.Path;
import java.util.Objects;

/**
 * Where a mesh comes from: a file, a part of it, and what is made of its normals.
 *
 * @param file the file; where scenes have no folder, a name
 * @param part which part of the file, counted from 0: the shape of a file of several; 0 for other files
 * @param normals which normals its vertices have
 * @param crease for {@link Normals#SMOOTH}: normals of triangles that differ by more than so many degrees, 0..180, do not count for another
 */
public record MeshSource(Path file, int part, Normals normals, double crease) {
    /** Which normals vertices have. */
    public enum Normals {
        /** Those of the file, if it has some. */
        FILE,
        /** None: triangles are flat. */
        FLAT,
        /** The mean of those of the triangles around a vertex. */
        SMOOTH
    }

    /** @throws enlightenment.math.InvalidValueException for a crease out of range or a part below 0 */
    public MeshSource {
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(normals, "normals");
        Check.that(part >= 0, "part", "must be at least 0, not " + part);
        Check.range("crease", crease, 0, 180);
    }

    /** The mesh of a file, with the normals that are asked for. */
    public TriangleMesh shaped(TriangleMesh read) {
        return switch (normals) {
            case FILE -> read;
            case FLAT -> read.flat();
            case SMOOTH -> read.smooth(crease);
        };
    }
}
