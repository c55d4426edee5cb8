package enlightenment.geometry;

import enlightenment.frame.Bounds;
import enlightenment.math.ExactPoint;
import enlightenment.mesh.MeshOrigin;
import enlightenment.mesh.TriangleMesh;
import enlightenment.numeric.Scale;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Triangles, placed. Many objects may place the same {@link TriangleMesh}: it is kept once. If the mesh is closed it is a solid: glass and
 * media may fill it.
 *
 * @param triangles the mesh, in its own coordinates
 * @param origin where it was read from, which a scene file names; empty for one that was made otherwise
 * @param transform from the mesh's coordinates to those of the scene
 */
public record Mesh(TriangleMesh triangles, Optional<MeshOrigin> origin, Transform transform) implements Shape {
    /** All must be there. */
    public Mesh {
        Objects.requireNonNull(triangles, "triangles");
        Objects.requireNonNull(origin, "origin");
        Objects.requireNonNull(transform, "transform");
    }

    /** A mesh as it stands. */
    public static Mesh of(TriangleMesh triangles) {
        return of(triangles, Transform.IDENTITY);
    }

    /** A mesh that is placed in the scene. */
    public static Mesh of(TriangleMesh triangles, Transform transform) {
        return new Mesh(triangles, Optional.empty(), transform);
    }

    /**
     * The mesh of these triangles, as {@link TriangleMesh#of(float[], int[])} has it.
     *
     * @param positions x, y, z of each vertex
     * @param indices three vertices of each triangle, counted from 0
     */
    public static Mesh of(float[] positions, int[] indices) {
        return of(TriangleMesh.of(positions, indices));
    }

    @Override
    public String type() {
        return "mesh";
    }

    /** The corners of the mesh's box, placed. */
    @Override
    public List<ExactPoint> anchors() {
        Bounds box = new Bounds(triangles.min(), triangles.max());
        List<ExactPoint> corners = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            corners.add(transform.apply(box.corner(k)));
        }
        return corners;
    }

    /** What placing a corner rounds. */
    @Override
    public double reach() {
        double largest = 0;
        for (int k = 0; k < 3; k++) {
            largest = Math.max(largest, transform.row(k).maxAbs() * triangles.maxAbs());
        }
        return Scale.gamma(8) * 3 * largest;
    }

    @Override
    public boolean enclosesVolume() {
        return triangles.isClosed();
    }

    @Override
    public Shape placed(Transform transform) {
        return new Mesh(triangles, origin, this.transform.then(transform));
    }
}
