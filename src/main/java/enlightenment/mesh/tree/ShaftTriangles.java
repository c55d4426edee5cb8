package enlightenment.mesh.tree;

import enlightenment.bvh.FloatShaft;
import enlightenment.bvh.ItemBoxes;
import enlightenment.bvh.Nodes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.numeric.Scale;

/**
 * The triangles of a mesh that may block segments from one point to several others: those whose boxes the shaft around the segments meets,
 * without those on one side of whose plane all segments stay. Conservative: a triangle too many costs a test. A mutable work object, one
 * per thread.
 */
public final class ShaftTriangles {
    /** With more triangles than this a search of the tree is quicker. */
    private static final int MOST = 32;

    /** The number of nodes at which the search ends: in long shafts along fine meshes it would take longer than what it saves. */
    private static final int MOST_VISITS = 128;

    /** Bounds the rounding of a distance from a plane, relative to the products of the coordinates involved. */
    private static final double PLANE_ERROR = Scale.gamma(64);

    /**
     * A point lies in the plane of a triangle only if the rounding of its distance is small beside the triangle: if the sides' products
     * exceed the area by no more than this.
     */
    private static final double MOST_SLENDER = 64;

    private final FloatShaft shaft = new FloatShaft();
    private final int[] stack = new int[Nodes.MAX_DEPTH];
    private final int[] found = new int[MOST];

    /** The common point of the segments, and the box at their ends, in the tree's unit. */
    private final double[] p = new double[3];

    private final double[] ends = new double[ItemBoxes.BOX];

    /** A bound of the coordinates that a distance is made of. */
    private double size;

    private double unit;
    private TriangleMesh mesh;
    private int count;

    /** Of no mesh yet. */
    public ShaftTriangles() {}

    /**
     * Finds the triangles of a mesh that is placed by a move.
     *
     * @param x the common point of the segments: x, y, z
     * @param box the box at their ends: least, then largest coordinates
     * @param dx where the mesh's origin is: dx, dy, dz
     * @return whether they are few enough to be known
     */
    public boolean find(
            TriangleTree tree, double x, double y, double z, double[] box, double dx, double dy, double dz) {
        mesh = tree.mesh;
        unit = tree.unit;
        size = 3 * tree.reach;
        set(0, x, box, dx);
        set(1, y, box, dy);
        set(2, z, box, dz);
        count = 0;
        return shaft.set(p[0], p[1], p[2], ends, tree.reach) && descend(tree);
    }

    private void set(int axis, double point, double[] box, double offset) {
        p[axis] = (point - offset) * unit;
        double sum = Math.abs(point) + Math.abs(offset);
        for (int k = axis; k < ItemBoxes.BOX; k += 3) {
            ends[k] = (box[k] - offset) * unit;
            sum += Math.abs(box[k]) + Math.abs(offset);
        }
        size += sum * unit;
    }

    private boolean descend(TriangleTree tree) {
        float[] boxes = tree.boxes;
        int[] child = tree.child;
        int depth = 1;
        stack[0] = 0;
        int visits = 0;
        while (depth > 0) {
            if (++visits > MOST_VISITS) {
                return false;
            }
            int node = stack[--depth];
            for (int side = 0; side < 2; side++) {
                if (!shaft.meets(boxes, Nodes.NODE * node + side)) {
                    continue;
                }
                int link = child[2 * node + side];
                if (link >= 0) {
                    stack[depth++] = link;
                } else if (!add(tree.order, Nodes.first(link), Nodes.end(link))) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Adds those triangles of a leaf that may block a segment; returns whether there is room. */
    private boolean add(int[] order, int first, int end) {
        for (int i = first; i < end; i++) {
            if (!staysBeside(order[i])) {
                if (count == MOST) {
                    return false;
                }
                found[count++] = order[i];
            }
        }
        return true;
    }

    /** Whether no segment crosses the plane of a triangle, for certain; one that begins or ends in it does not cross it. */
    private boolean staysBeside(int triangle) {
        int a = mesh.vertex(triangle, 0);
        int b = mesh.vertex(triangle, 1);
        int c = mesh.vertex(triangle, 2);
        double ax = unit * mesh.coordinate(a, 0);
        double ay = unit * mesh.coordinate(a, 1);
        double az = unit * mesh.coordinate(a, 2);
        double ux = unit * mesh.coordinate(b, 0) - ax;
        double uy = unit * mesh.coordinate(b, 1) - ay;
        double uz = unit * mesh.coordinate(b, 2) - az;
        double vx = unit * mesh.coordinate(c, 0) - ax;
        double vy = unit * mesh.coordinate(c, 1) - ay;
        double vz = unit * mesh.coordinate(c, 2) - az;
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double products = (Math.abs(ux) + Math.abs(uy) + Math.abs(uz)) * (Math.abs(vx) + Math.abs(vy) + Math.abs(vz));
        double error = PLANE_ERROR * products * size;
        if (!(error >= Double.MIN_NORMAL)) {
            return false;
        }
        double height = nx * (p[0] - ax) + ny * (p[1] - ay) + nz * (p[2] - az);
        if (height > error) {
            return nearest(nx, ny, nz, ax, ay, az) >= -error;
        }
        if (height < -error) {
            return nearest(-nx, -ny, -nz, ax, ay, az) >= -error;
        }
        return products <= MOST_SLENDER * Math.max(Math.abs(nx), Math.max(Math.abs(ny), Math.abs(nz)))
                && (nearest(nx, ny, nz, ax, ay, az) >= -error || nearest(-nx, -ny, -nz, ax, ay, az) >= -error);
    }

    /** The least height of the end points above a plane. */
    private double nearest(double nx, double ny, double nz, double ax, double ay, double az) {
        return nx * (ends[nx > 0 ? 0 : 3] - ax) + ny * (ends[ny > 0 ? 1 : 4] - ay) + nz * (ends[nz > 0 ? 2 : 5] - az);
    }

    /** The number of triangles. */
    public int size() {
        return count;
    }

    /** A triangle. */
    int get(int k) {
        return found[k];
    }
}
