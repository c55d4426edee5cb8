package enlightenment.importer.pbrt;

import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import java.util.Optional;

/** A shape of a pbrt file, in coordinates of its own. */
sealed interface Form {
    /** A whole sphere about the origin. */
    record Ball(double radius) implements Form {}

    /** A whole disk about the z axis, without a hole. */
    record Plate(double height, double radius) implements Form {}

    /** A whole cylinder about the z axis, without caps. */
    record Tube(double radius, double zMin, double zMax) implements Form {}

    /**
     * Triangles.
     *
     * @param origin the file that they come from; empty if they do not, or were changed
     */
    record Triangles(TriangleMesh mesh, Optional<MeshFiles.Origin> origin) implements Form {
        static Triangles of(TriangleMesh mesh) {
            return new Triangles(mesh, Optional.empty());
        }
    }
}
