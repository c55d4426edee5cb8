package enlightenment.mesh;

import enlightenment.math.InvalidValueException;
import enlightenment.mesh.input.MeshSource;
import java.io.IOException;
import java.util.Optional;

/** Makes a mesh of numbers of a file, whose indices it has checked. */
interface MeshMaking {
    /** The most corners of a polygon. */
    int MOST_CORNERS = 1 << 16;

    /** The mesh, as of the constructor of {@link TriangleMesh}. */
    TriangleMesh mesh() throws IOException;

    /**
     * The mesh; empty if no triangle has an area.
     *
     * @throws IOException naming the source, also for numbers that are not finite
     */
    default Optional<TriangleMesh> withArea(MeshSource source) throws IOException {
        try {
            return Optional.of(mesh());
        } catch (InvalidValueException e) {
            if (e.key().equals("indices")) {
                return Optional.empty();
            }
            throw source.failure(e.getMessage());
        }
    }
}
