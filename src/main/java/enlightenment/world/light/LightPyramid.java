package enlightenment.world.light;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;
import enlightenment.primitive.CubePrimitive;
import enlightenment.primitive.Primitive;
import java.util.Arrays;

/**
 * The pyramids of segments from points to a rectangular light, and the boxes of primitives beside them. Decides most of the occluders that
 * the bounding ball of the light leaves in doubt. Immutable.
 *
 * <p>A pyramid and a box are disjoint if one side of the pyramid, or a plane parallel to the light, or one of the box's own faces separates
 * them. These are not all separating planes (S. Gottschalk, M. Lin and D. Manocha, "OBBTree", 1996); if none of them separates, the
 * primitive is tested needlessly.
 */
public final class LightPyramid {
    /** Bounds the roundings of a product of two coordinates, relative to the square of the largest. */
    private static final double ERROR = Scale.gamma(64);

    private static final double RIGHT_ANGLE_ERROR = Scale.gamma(64);

    /** By id: centre and three half edges of the box, along the light's edges and its normal; the centre from the light's corner. */
    private static final int BOX = 12;

    private final double[] boxes;
    private final Vec3 corner;
    private final Vec3 right;
    private final Vec3 up;
    private final Vec3 normal;
    private final double width;
    private final double length;

    /** Bounds the sums of the coordinates of all boxes and of the light. */
    private final double scale;

    private LightPyramid(LightBody light, Vec3 normal, Primitive[] primitives) {
        corner = new Vec3(light.x, light.y, light.z);
        width = light.right.length();
        length = light.up.length();
        right = light.right.normalized();
        up = light.up.normalized();
        this.normal = normal;
        boxes = new double[BOX * primitives.length];
        double reach = light.bounds().maxAbs();
        for (int id = 0; id < primitives.length; id++) {
            reach = Math.max(reach, primitives[id].bounds().maxAbs());
            set(primitives[id], BOX * id);
        }
        scale = 6 * reach;
    }

    /** The pyramids of a light; null if it is not a rectangle. */
    public static LightPyramid of(LightBody light, Primitive[] primitives) {
        Vec3 across = light.right.cross(light.up);
        boolean isRectangle = across.maxAbs() > 0
                && Math.abs(light.right.normalized().dot(light.up.normalized())) <= RIGHT_ANGLE_ERROR;
        return isRectangle ? new LightPyramid(light, across.normalized(), primitives) : null;
    }

    /**
     * The pyramids for code on another device: corner, unit edges, normal, the lengths of the edges and the scale; then twelve numbers for
     * each primitive, as they are found by id.
     */
    public double[] flatForm() {
        double[] own = {
            corner.x(),
            corner.y(),
            corner.z(),
            right.x(),
            right.y(),
            right.z(),
            up.x(),
            up.y(),
            up.z(),
            normal.x(),
            normal.y(),
            normal.z(),
            width,
            length,
            scale
        };
        double[] all = Arrays.copyOf(own, own.length + boxes.length);
        System.arraycopy(boxes, 0, all, own.length, boxes.length);
        return all;
    }

    private void set(Primitive p, int at) {
        Bounds box = p.bounds();
        Vec3 half = box.max().minus(box.min()).times(0.5);
        Vec3 center = box.center();
        Vec3 x = new Vec3(half.x(), 0, 0);
        Vec3 y = new Vec3(0, half.y(), 0);
        Vec3 z = new Vec3(0, 0, half.z());
        if (p instanceof CubePrimitive c) {
            center = c.center();
            x = c.edge(0).times(0.5);
            y = c.edge(1).times(0.5);
            z = c.edge(2).times(0.5);
        }
        put(center.minus(corner), at);
        put(x, at + 3);
        put(y, at + 6);
        put(z, at + 9);
    }

    private void put(Vec3 v, int at) {
        boxes[at] = v.dot(right);
        boxes[at + 1] = v.dot(up);
        boxes[at + 2] = v.dot(normal);
    }

    /** The apex of a pyramid. A mutable work object, one per thread. */
    static final class Apex {
        private LightPyramid light;

        /** The light's corner relative to the apex. */
        private double x;

        private double y;
        private double z;

        /** Bounds the roundings of coordinates, and of products of two. */
        private double slack;

        private double slack2;

        /** Sets the apex. */
        void set(LightPyramid from, double px, double py, double pz) {
            // Skips storing an unchanged reference, which saves the GC write barrier.
            if (light != from) {
                light = from;
            }
            Vec3 c = from.corner;
            double dx = c.x() - px;
            double dy = c.y() - py;
            double dz = c.z() - pz;
            x = Products.dot(from.right.x(), from.right.y(), from.right.z(), dx, dy, dz);
            y = Products.dot(from.up.x(), from.up.y(), from.up.z(), dx, dy, dz);
            z = Products.dot(from.normal.x(), from.normal.y(), from.normal.z(), dx, dy, dz);
            double size = from.scale + Math.abs(px) + Math.abs(py) + Math.abs(pz);
            slack = ERROR * size;
            slack2 = slack * size;
        }

        /** Whether no segment from the apex to the light certainly meets the primitive with this id. False where in doubt. */
        boolean misses(int id) {
            double[] b = light.boxes;
            int at = BOX * id;
            double cx = b[at] + x;
            double cy = b[at + 1] + y;
            double cz = b[at + 2] + z;
            double depth = Math.abs(b[at + 5]) + Math.abs(b[at + 8]) + Math.abs(b[at + 11]) + slack;
            // The coordinate towards the light, which may grow or fall.
            double ahead = z > 0 ? cz : -cz;
            if (ahead < -depth || ahead - depth > Math.abs(z)) {
                return true;
            }
            double beyondX = x + light.width;
            double beyondY = y + light.length;
            double side = z > 0 ? 1 : -1;
            return side * (x * cz - z * cx) > across(b, at + 3, at + 5, x)
                    || side * (z * cx - beyondX * cz) > across(b, at + 3, at + 5, beyondX)
                    || side * (y * cz - z * cy) > across(b, at + 4, at + 5, y)
                    || side * (z * cy - beyondY * cz) > across(b, at + 4, at + 5, beyondY);
        }

        /**
         * The extent of the box across the side of the pyramid through an edge at a coordinate.
         *
         * @param i index of that coordinate of the box's first edge; k is the index of its depth
         */
        private double across(double[] b, int i, int k, double edge) {
            return Math.abs(z * b[i] - edge * b[k])
                    + Math.abs(z * b[i + 3] - edge * b[k + 3])
                    + Math.abs(z * b[i + 6] - edge * b[k + 6])
                    + slack2;
        }
    }
}
