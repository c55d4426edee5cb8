package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.mesh.tree.ShaftTriangles;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Ray;

/**
 * Narrows a union of meshes to the triangles that segments of a cone may hit, where many segments are to come. A mutable work object, one
 * per thread.
 */
final class UnionNarrowing {
    /**
     * With fewer segments than this, finding the triangles may take longer than what it saves; from 2 to 32 it makes no difference in Ajar.
     * Has no influence on any result.
     */
    private static final int FEWEST_RAYS = 8;

    private final ShaftTriangles triangles = new ShaftTriangles();

    /** The box in which the segments end: least, then largest coordinates. */
    private final double[] ends;

    /** The apex of the segments. */
    private double x;

    private double y;
    private double z;
    private boolean isPaying;
    private boolean isNarrowed;

    /** @param ends receives the box in which the segments of a cone end before it begins: least, then largest coordinates */
    UnionNarrowing(double[] ends) {
        this.ends = ends;
    }

    /**
     * Begins a cone.
     *
     * @param rays how many segments are to come
     */
    void begin(BallCone cone, int rays) {
        x = cone.x;
        y = cone.y;
        z = cone.z;
        isPaying = rays >= FEWEST_RAYS;
        isNarrowed = false;
    }

    /** Lets rays hit everything again. */
    void end() {
        isNarrowed = false;
    }

    /** Narrows a union; returns whether no segment can hit it. */
    boolean clears(MeshUnion union) {
        isNarrowed = isPaying && union.narrow(x, y, z, ends, triangles);
        return isNarrowed && triangles.size() == 0;
    }

    /** Whether the union has a crossing with tMin ≤ t ≤ tMax. */
    boolean blocks(MeshUnion union, Ray ray, double tMax) {
        return isNarrowed ? union.blocks(ray, triangles, tMax) : union.blocks(ray, tMax);
    }
}
