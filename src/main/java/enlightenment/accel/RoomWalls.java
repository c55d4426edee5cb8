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

    /** By axis: the largest and the least coordinate of all walls. */
    private final double[] ends = new double[WALLS];

    private boolean isRoom;

    /** Sets the walls: rectangles, of which those across each axis begin where the array says. */
    void set(RectanglePrimitive[] rectangles, int[] rectangleIds, int[] firstAcross) {
        isRoom = firstAcross[3] >= FEWEST;
        Arrays.fill(byDigits, null);
        for (int axis = 0; axis < 3; axis++) {
            ends[2 * axis] = Double.NEGATIVE_INFINITY;
            ends[2 * axis + 1] = Double.POSITIVE_INFINITY;
        }
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
            // Of two in one plane a ray may meet either.
            isRoom = n < 2 || n == 2 && coordinate(rectangles[first], axis) != coordinate(rectangles[first + 1], axis);
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
            ends[2 * c] = Math.max(ends[2 * c], box.max().component(c));
            ends[2 * c + 1] = Math.min(ends[2 * c + 1], box.min().component(c));
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
        int x = (int) (bits(ix) >>> SIGN);
        int y = (int) (bits(iy) >>> SIGN);
        int z = (int) (bits(iz) >>> SIGN);
        // Those behind the ray are far behind, or one is where it starts.
        double[] w = at;
        long behindX = bits((ray.ox - w[1 - x]) * ix - slack) >>> SIGN;
        long behindY = bits((ray.oy - w[3 - y]) * iy - slack) >>> SIGN;
        long behindZ = bits((ray.oz - w[5 - z]) * iz - slack) >>> SIGN;
        int near = (int) behindX * (2 - x) + (int) behindY * (6 - 3 * y) + (int) behindZ * (18 - 9 * z);
        if (near != 0 && (ray.start == null || byDigits[near] != ray.start)) {
            return false;
        }
        int wall = nearest(ray, state, x, 2 + y, 4 + z, ix, iy, iz, slack);
        if (wall < 0 || walls[wall] == ray.start) {
            return false;
        }
        return state.met > state.t() + slack
                || meets(ray, state, wall, slack)
                || leaves(ray, state.met, x, 2 + y, 4 + z, ix, iy, iz, slack);
    }

    /**
     * The wall whose plane the ray meets first, of three that are ahead; the state is told where.
     *
     * @return -1 if that may be another one, or before the ray begins
     */
    private int nearest(Ray ray, Closest state, int x, int y, int z, double ix, double iy, double iz, double slack) {
        long gapX = bits(at[x] - ray.ox);
        long gapY = bits(at[y] - ray.oy);
        long gapZ = bits(at[z] - ray.oz);
        // Numbers that are not negative are in the order of their bits.
        long tx = bits(Double.longBitsToDouble(gapX) * ix);
        long ty = bits(Double.longBitsToDouble(gapY) * iy);
        long tz = bits(Double.longBitsToDouble(gapZ) * iz);
        if ((tx | ty | tz) < 0) {
            return -1;
        }
        long isY = ty - tx >> SIGN;
        long less = choose(tx, ty, isY);
        long isZ = tz - less >> SIGN;
        long least = choose(less, tz, isZ);
        long next = Math.min(less ^ tz ^ least, tx ^ ty ^ less);
        double t = Double.longBitsToDouble(least);
        if (!(t > ray.tMin + slack && Double.longBitsToDouble(next) > t + slack)) {
            return -1;
        }
        long gap = choose(choose(gapX, gapY, isY), gapZ, isZ);
        long slope = choose(choose(bits(ray.dx), bits(ray.dy), isY), bits(ray.dz), isZ);
        state.met = Double.longBitsToDouble(gap) / Double.longBitsToDouble(slope);
        return (int) choose(choose(x, y, isY), z, isZ);
    }

    /** The second number where all bits of the choice are set, the first where none is. */
    private static long choose(long first, long second, long choice) {
        return first ^ (first ^ second) & choice;
    }

    /** Takes the wall if the ray meets its plane well within it. */
    private boolean meets(Ray ray, Closest state, int wall, double slack) {
        double met = state.met;
        double x = Math.fma(met, ray.dx, ray.ox);
        double y = Math.fma(met, ray.dy, ray.oy);
        double z = Math.fma(met, ray.dz, ray.oz);
        double margin = slack * (Math.abs(ray.dx) + Math.abs(ray.dy) + Math.abs(ray.dz));
        double[] b = boxes;
        int k = BOX * wall;
        long outside = bits(x - b[k] - margin)
                | bits(b[k + 1] - x - margin)
                | bits(y - b[k + 2] - margin)
                | bits(b[k + 3] - y - margin)
                | bits(z - b[k + 4] - margin)
                | bits(b[k + 5] - z - margin);
        if (outside < 0) {
            return false;
        }
        state.take(ray, walls[wall], ids[wall], met);
        return true;
    }

    /** Whether the ray is beyond all walls by then, on its way away from them: through the open side of the room. */
    private boolean leaves(Ray ray, double met, int x, int y, int z, double ix, double iy, double iz, double slack) {
        double margin = slack * (Math.abs(ray.dx) + Math.abs(ray.dy) + Math.abs(ray.dz));
        double gapX = (ends[x] - Math.fma(met, ray.dx, ray.ox)) * ix;
        double gapY = (ends[y] - Math.fma(met, ray.dy, ray.oy)) * iy;
        double gapZ = (ends[z] - Math.fma(met, ray.dz, ray.oz)) * iz;
        return (bits(Math.fma(margin, Math.abs(ix), gapX))
                        | bits(Math.fma(margin, Math.abs(iy), gapY))
                        | bits(Math.fma(margin, Math.abs(iz), gapZ)))
                < 0;
    }

    private static long bits(double v) {
        return Double.doubleToRawLongBits(v);
    }
}
