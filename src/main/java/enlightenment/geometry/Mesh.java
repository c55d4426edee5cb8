package enlightenment.geometry;

import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TriangleMesh;
import enlightenment.numeric.Decimals;
import enlightenment.numeric.Scale;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A triangle mesh as a shape: its triangles, and where they are placed in the scene. Many objects may place the same {@link TriangleMesh}: it is
 * kept once. If the mesh is closed it is a solid: glass and media may fill it.
 *
 * @param triangles the mesh, in its own coordinates
 * @param origin where it was read from, which a scene file names; empty for one that was made otherwise
 * @param transform from the mesh's coordinates to those of the scene
 *
 */
public record Mesh(TriangleMesh triangles, Optional<MeshFiles.Origin> origin, Transform transform) implements Shape {
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

    /** Near the middle of the mesh's box, in few decimals: there may be a million instances. */
    @Override
    public List<ExactPoint> anchors() {
        return List.of(middle(step()));
    }

    private ExactPoint middle(int step) {
        Vec3 m = transform.applyLinear(triangles.min().plus(triangles.max()).times(0.5));
        ExactPoint o = transform.offset();
        return new ExactPoint(
                o.x().add(Decimals.near(m.x(), step)),
                o.y().add(Decimals.near(m.y(), step)),
                o.z().add(Decimals.near(m.z(), step)));
    }

    /** The exponent of ten that the middle is rounded to: a thousandth of the size. */
    private int step() {
        double size = size();
        return size > 0 ? (int) Math.floor(StrictMath.log10(size)) - 3 : 0;
    }

    /** How far any corner of the placed box is from its middle, at most. */
    private double size() {
        Vec3 half = triangles.max().minus(triangles.min()).times(0.5);
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            Vec3 row = transform.row(k);
            sum += Math.abs(row.x()) * half.x() + Math.abs(row.y()) * half.y() + Math.abs(row.z()) * half.z();
        }
        return sum;
    }

    /** What the box reaches beyond its middle, with what is rounded there. */
    @Override
    public double reach() {
        double largest = 0;
        for (int k = 0; k < 3; k++) {
            largest = Math.max(largest, transform.row(k).maxAbs() * triangles.maxAbs());
        }
        return 1.01 * size() + Scale.gamma(8) * 3 * largest;
    }

    /** This mesh with the front of its triangles outside, if it is closed: what is inside of a solid must not depend on how they run. */
    public Mesh outwards() {
        TriangleMesh outer = triangles.outwards();
        return outer == triangles ? this : new Mesh(outer, origin, transform);
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
