package enlightenment.accel;

import enlightenment.frame.Bounds;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.RectanglePrimitive;
import java.util.Arrays;

/**
 * The walls of a room whose edges are parallel to the axes, at most two across each: the plane that a ray from within meets first is one of
 * the three that the signs of its direction name, and mostly it meets the wall there. Where that is not beyond doubt this says so.
 *
 * <p>What the processor cannot guess, which of the walls it is, is found without a branch.
 */
final class RoomWalls {
    /** Two across each axis: first that with the larger coordinate, which directions with the sign bit 0 lead to. */
    private static final int WALLS = 6;

    private static final int BOX = 6;

    /** Fewer are tested one by one as soon. */
    private static final int FEWEST = 4;

    private static final int SIGN = Long.SIZE - 1;

    private final RectanglePrimitive[] walls = new RectanglePrimitive[WALLS];
    private final int[] ids = new int[WALLS];

    /** The coordinate on the axis that it is across; infinite if there is none. */
    private final double[] at = new double[WALLS];

    /** By wall: its extent on the three axes, infinite on the one that it is across. */
    private final double[] boxes = new double[BOX * WALLS];

    /** By a number of three digits to the base of 3, one for each axis: the wall, if only one digit is not 0. */
    private final Primitive[] byDigits = new Primitive[27];

    private boolean isRoom;

    /** Sets the walls: rectangles, of which those across each axis begin where the array says. */
    void set(RectanglePrimitive[] rectangles, int[] rectangleIds, int[] firstAcross) {
        isRoom = firstAcross[3] >= FEWEST;
        Arrays.fill(byDigits, null);
        int unit = 1;
        for (int axis = 0; axis < 3 && isRoom; axis++) {
            int first = firstAcross[axis];
            int n = firstAcross[axis + 1] - first;
            at[2 * axis] = Double.POSITIVE_INFINITY;
            at[2 * axis + 1] = Double.NEGATIVE_INFINITY;
            for (int k = first; k < first + Math.min(n, 2); k++) {
                double here = coordinate(rectangles[k], axis);
                boolean isLower = n == 1
                        ? isLower(rectangles, firstAcross[3], axis, here)
                        : here < coordinate(rectangles[2 * first + 1 - k], axis);
                int wall = 2 * axis + (isLower ? 1 : 0);
                put(wall, rectangles[k], rectangleIds[k], axis);
                byDigits[isLower ? 2 * unit : unit] = rectangles[k];
            }
            isRoom = n <= 2 && at[2 * axis] > at[2 * axis + 1];
            unit *= 3;
        }
    }

    private static double coordinate(RectanglePrimitive wall, int axis) {
        return wall.bounds().min().component(axis);
    }

    /** Whether the only wall across an axis is on the lower side of most. */
    private static boolean isLower(RectanglePrimitive[] rectangles, int n, int axis, double here) {
        double above = 0;
        for (int k = 0; k < n; k++) {
            Bounds box = rectangles[k].bounds();
            above += box.min().component(axis) - here + (box.max().component(axis) - here);
        }
        return above > 0;
    }

    private void put(int wall, RectanglePrimitive r, int id, int axis) {
        walls[wall] = r;
        ids[wall] = id;
        at[wall] = coordinate(r, axis);
        Bounds box = r.bounds();
        for (int c = 0; c < 3; c++) {
            boxes[BOX * wall + 2 * c] =
                    c == axis ? Double.NEGATIVE_INFINITY : box.min().component(c);
            boxes[BOX * wall + 2 * c + 1] =
                    c == axis ? Double.POSITIVE_INFINITY : box.max().component(c);
        }
    }

    /**
     * Offers the wall that the ray meets.
     *
     * @param ix the inverse of the direction, finite
     * @param slack more than roundings add to the distance from any of the planes
     * @return false, having offered nothing, if it may be more than one or another
     */
    boolean search(Ray ray, Closest state, double ix, double iy, double iz, double slack) {
        if (!isRoom) {
            return false;
        }
        double[] w = at;
        int x = (int) (bits(ix) >>> SIGN);
        int y = (int) (bits(iy) >>> SIGN);
        int z = (int) (bits(iz) >>> SIGN);
        // Those behind the ray are far behind, or one is where it starts.
        long behindX = bits((ray.ox - w[1 - x]) * ix - slack) >>> SIGN;
        long behindY = bits((ray.oy - w[3 - y]) * iy - slack) >>> SIGN;
        long behindZ = bits((ray.oz - w[5 - z]) * iz - slack) >>> SIGN;
        int near = (int) behindX * (2 - x) + (int) behindY * (6 - 3 * y) + (int) behindZ * (18 - 9 * z);
        if (near != 0 && (ray.start == null || byDigits[near] != ray.start)) {
            return false;
        }
        // Numbers that are not negative are in the order of their bits.
        long tx = bits((w[x] - ray.ox) / ray.dx);
        long ty = bits((w[2 + y] - ray.oy) / ray.dy);
        long tz = bits((w[4 + z] - ray.oz) / ray.dz);
        long less = Math.min(tx, ty);
        long least = Math.min(less, tz);
        double t = Double.longBitsToDouble(least);
        double next = Double.longBitsToDouble(Math.min(Math.max(tx, ty), Math.max(less, tz)));
        if (!(t > ray.tMin + slack && next > t + slack)) {
            return false;
        }
        int wall = least == tx ? x : least == ty ? 2 + y : 4 + z;
        return t > state.t() + slack || takes(ray, state, wall, t, slack);
    }

    private boolean takes(Ray ray, Closest state, int wall, double t, double slack) {
        double[] b = boxes;
        int k = BOX * wall;
        double x = Math.fma(t, ray.dx, ray.ox);
        double y = Math.fma(t, ray.dy, ray.oy);
        double z = Math.fma(t, ray.dz, ray.oz);
        double margin = slack * (Math.abs(ray.dx) + Math.abs(ray.dy) + Math.abs(ray.dz));
        long outside = bits(x - b[k] - margin)
                | bits(b[k + 1] - x - margin)
                | bits(y - b[k + 2] - margin)
                | bits(b[k + 3] - y - margin)
                | bits(z - b[k + 4] - margin)
                | bits(b[k + 5] - z - margin);
        if (outside < 0 || walls[wall] == ray.start) {
            return false;
        }
        state.take(ray, walls[wall], ids[wall], t);
        return true;
    }

    private static long bits(double v) {
        return Double.doubleToRawLongBits(v);
    }
}
