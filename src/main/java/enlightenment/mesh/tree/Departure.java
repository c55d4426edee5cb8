package enlightenment.mesh.tree;

import enlightenment.mesh.TriangleMesh;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * The triangle that a ray leaves. The ray's origin is a rounded point of it, so that the sign of a distance between the origin and a triangle
 * that touches this one says nothing; what the triangles' corners say is exact up to their own rounding.
 *
 * <p>Where an edge is shared: on the side that the ray travels on, a neighbour that is not raised above the triangle is never met. One that is
 * raised is met where the ray turns to its plane and passes between its other two edges; the shared edge needs no test, since what is beyond
 * it is below the triangle. At a corner, all triangles of the fan around it are seen from the triangle's centroid instead, as the cones that
 * they are next to the corner: all decide alike then, and a closed fan has no gap.
 */
final class Departure {
    /** No shared edge. */
    static final int NO_EDGE = -1;

    /** All three corners are shared. */
    static final int ALL = 3;

    private static final double ROUNDED = Scale.gamma(16);

    /** How many times its error the origin is away from a corner that it is taken to be. */
    private static final double NEAR = 4;

    /** Bounds how far each coordinate of the origin is off. */
    double tolerance;

    /** The corner that the origin cannot be told from: 0, 1 or 2; else −1. */
    int corner;

    private TriangleMesh mesh;
    private int triangle;
    private int side;
    private final int[] vertices = new int[3];
    private final double[] normal = new double[3];
    private boolean hasNormal;
    private boolean isReady;

    /** The corner of the triangle that does not lie on the edge that {@link #sharedEdge} found, and that of the neighbour. */
    private int opposite;

    private int neighbours;

    void set(TriangleMesh of, int from, int travels, double largest, double error) {
        mesh = of;
        triangle = from;
        side = travels;
        tolerance = error + ROUNDED * largest;
        isReady = false;
    }

    /**
     * Finds the corner that the origin cannot be told from.
     *
     * @param corners three coordinates of each corner, relative to the ray's origin
     */
    void findCorner(double[] corners) {
        corner = -1;
        double near = NEAR * tolerance;
        for (int k = 0; k < 3; k++) {
            boolean isNear = Math.abs(corners[3 * k]) <= near
                    && Math.abs(corners[3 * k + 1]) <= near
                    && Math.abs(corners[3 * k + 2]) <= near;
            corner = isNear ? k : corner;
        }
    }

    /** Looks at the triangle; only a ray that comes near a triangle that touches it needs that. */
    void prepare() {
        if (isReady) {
            return;
        }
        isReady = true;
        hasNormal = false;
        for (int k = 0; k < 3; k++) {
            vertices[k] = mesh.vertex(triangle, k);
        }
    }

    /** A coordinate of the centroid. */
    double centroid(int axis) {
        double sum = mesh.coordinate(vertices[0], axis)
                + mesh.coordinate(vertices[1], axis)
                + mesh.coordinate(vertices[2], axis);
        return sum / 3;
    }

    /** Which corner of another triangle is the one that the ray starts at; −1 if none is. */
    int cornerAt(int other) {
        for (int k = 0; k < 3; k++) {
            if (mesh.data().vertices.areInOnePlace(vertices[corner], mesh.vertex(other, k))) {
                return k;
            }
        }
        return -1;
    }

    /** The edge that another triangle shares, k from its corner k to the next one; {@link #NO_EDGE} or {@link #ALL}. */
    int sharedEdge(int other) {
        int shared = 0;
        int left = 0;
        opposite = 3;
        for (int k = 0; k < 3; k++) {
            int v = mesh.vertex(other, k);
            int own = mesh.data().vertices.areInOnePlace(vertices[0], v)
                    ? 0
                    : mesh.data().vertices.areInOnePlace(vertices[1], v)
                            ? 1
                            : mesh.data().vertices.areInOnePlace(vertices[2], v) ? 2 : -1;
            if (own < 0) {
                left = k;
            } else {
                shared++;
                opposite -= own;
            }
        }
        neighbours = left;
        return shared == 3 ? ALL : shared == 2 ? (left + 1) % 3 : NO_EDGE;
    }

    /** Whether the neighbour that {@link #sharedEdge} was asked about is raised above the triangle, on the side that the ray travels on. */
    boolean isRaised(int other) {
        return side * height(mesh.vertex(other, neighbours)) > 0;
    }

    /** On which side of that neighbour's plane the triangle lies: the sign is that of a direction along the neighbour's normal. */
    double sideOf(int other) {
        double[] n = new double[3];
        mesh.data().normal(other, n);
        return along(n, mesh.vertex(other, (neighbours + 1) % 3), vertices[opposite]);
    }

    /** Whether another triangle lies in this one's plane, as far as corners say. */
    boolean isInPlane(int other) {
        for (int k = 0; k < 3; k++) {
            double h = height(mesh.vertex(other, k));
            double n = Math.abs(normal[0]) + Math.abs(normal[1]) + Math.abs(normal[2]);
            if (!(Math.abs(h) <= ROUNDED * n * mesh.maxAbs())) {
                return false;
            }
        }
        return true;
    }

    private double height(int vertex) {
        if (!hasNormal) {
            mesh.data().normal(triangle, normal);
            hasNormal = true;
        }
        return along(normal, vertices[0], vertex);
    }

    private double along(double[] n, int from, int to) {
        return Products.accurateDot(
                n[0],
                n[1],
                n[2],
                mesh.coordinate(to, 0) - mesh.coordinate(from, 0),
                mesh.coordinate(to, 1) - mesh.coordinate(from, 1),
                mesh.coordinate(to, 2) - mesh.coordinate(from, 2));
    }
}
