package enlightenment.world.light;

import enlightenment.accel.ConeJudge;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.primitive.SupportSurface;
import java.util.Arrays;

/**
 * Finds the primitives that can occlude a light from a point.
 *
 * <p>For a point P and a light inside a ball, every shadow ray runs inside the cone with apex P around the ball. A
 * primitive whose bounding ball does not intersect that cone can block none of them. Bounds are conservative: a candidate
 * too many costs a test, one too few would be a wrong picture. See docs/notes/occluders.md.
 *
 * <p>A flat primitive (a wall of the room) blocks none of them if point and light lie on the same side of its plane. That depends
 * only on the two: nothing else in the scene changes it.
 */
public final class OccluderSet {
    /** Bounds the rounding of a distance from a plane, relative to the coordinates involved. */
    private static final double PLANE_ERROR = Scale.gamma(16);

    private static final int NO_PLANE = -1;

    private final int count;

    /** By id: centre and radius of the primitive's bounding ball. */
    private final double[] balls;

    /** By id: whether the primitive is its bounding ball. */
    private final boolean[] isBall;

    /** By id: the index of a flat primitive's plane; {@link #NO_PLANE} for others. */
    private final int[] planeAt;

    /** Unit normals and offsets of planes. */
    private final double[] planes;

    public OccluderSet(Primitive[] primitives, LightBody[] lights, boolean few) {
        count = primitives.length;
        balls = new double[4 * count];
        isBall = new boolean[count];
        planeAt = new int[count];
        int flat = 0;
        for (int id = 0; id < count; id++) {
            setBall(primitives[id], id);
            planeAt[id] = primitives[id].isFlat() ? 4 * flat++ : NO_PLANE;
        }
        planes = new double[4 * flat];
        for (int id = 0; id < count; id++) {
            if (planeAt[id] != NO_PLANE && primitives[id].support(0) instanceof SupportSurface.Plane p) {
                setPlane(p.unitNormal(), p.corners()[0], planeAt[id]);
            }
        }
        for (LightBody light : lights) {
            light.sides = few ? sides(light) : null;
        }
    }

    /**
     * Whether a primitive may occlude the light from any point of the scene's surfaces. A flat one does not if all primitives and the light
     * lie on one side of its plane, like the walls of a room.
     */
    public boolean mayOcclude(int id, LightBody light, Primitive[] primitives) {
        int k = planeAt[id];
        if (k == NO_PLANE) {
            return true;
        }
        byte common = sidesOf(light, k);
        for (Primitive p : primitives) {
            Bounds box = p.bounds();
            double least = -planes[k + 3];
            double most = -planes[k + 3];
            for (int c = 0; c < 3; c++) {
                double a = planes[k + c] * box.min().component(c);
                double b = planes[k + c] * box.max().component(c);
                least += Math.min(a, b);
                most += Math.max(a, b);
            }
            double error = PLANE_ERROR * (3 * box.maxAbs() + Math.abs(planes[k + 3]));
            common &= (byte) ((least >= -error ? LightBody.ABOVE : 0) | (most <= error ? LightBody.BELOW : 0));
        }
        return common == 0;
    }

    /**
     * A primitive for code on another device: centre and radius of the ball around it, then unit normal and offset of its plane, if it has
     * one.
     */
    public double[] flatForm(int id) {
        double[] all = Arrays.copyOfRange(balls, 4 * id, 4 * id + 8);
        for (int k = 0; k < 4; k++) {
            all[4 + k] = planeAt[id] == NO_PLANE ? 0 : planes[planeAt[id] + k];
        }
        return all;
    }

    /** Whether a primitive is the ball around it. */
    public boolean isBall(int id) {
        return isBall[id];
    }

    /** Whether a primitive lies in a plane. */
    public boolean hasPlane(int id) {
        return planeAt[id] != NO_PLANE;
    }

    /** Of a primitive that {@link #hasPlane lies in a plane}: whether no point of a light is below that plane, or none above it. */
    public boolean isOnSide(int id, LightBody light, boolean above) {
        return (sidesOf(light, planeAt[id]) & (above ? LightBody.ABOVE : LightBody.BELOW)) != 0;
    }

    private void setPlane(Vec3 n, Vec3 point, int at) {
        planes[at] = n.x();
        planes[at + 1] = n.y();
        planes[at + 2] = n.z();
        planes[at + 3] = n.dot(point);
    }

    private byte[] sides(LightBody light) {
        byte[] sides = new byte[count];
        for (int id = 0; id < count; id++) {
            sides[id] = planeAt[id] == NO_PLANE ? 0 : sidesOf(light, planeAt[id]);
        }
        return sides;
    }

    private byte sidesOf(LightBody light, int k) {
        return light.sidesOf(planes[k], planes[k + 1], planes[k + 2], planes[k + 3], PLANE_ERROR);
    }

    private void setBall(Primitive p, int id) {
        Bounds box = p.bounds();
        Vec3 c = box.center();
        double radius = box.max().minus(c).length();
        if (p instanceof SpherePrimitive s) {
            c = s.center();
            radius = s.radius();
            isBall[id] = true;
        }
        balls[4 * id] = c.x();
        balls[4 * id + 1] = c.y();
        balls[4 * id + 2] = c.z();
        balls[4 * id + 3] = radius;
    }

    /**
     * Decides which primitives may occlude a light, for one cone after another. One per thread. Called for many primitives at every shaded
     * point, so it keeps the arrays and the apex in fields of its own.
     */
    public final class Judge implements ConeJudge {
        private final double[] ballOf = balls;
        private final boolean[] isBallOf = isBall;
        private final int[] planeOf = planeAt;
        private final double[] planeAtPlace = planes;

        private LightCone cone;

        /** The pyramids of the light; null if it has none. */
        private LightPyramid pyramid;

        /** The cone's apex as that of a pyramid, if it is set. */
        private final LightPyramid.Apex tip = new LightPyramid.Apex();

        private boolean hasTip;
        private int[] starts;
        private int startCount;

        /** The first id of {@code starts}, mostly the only one; or no id. */
        private int firstStart;

        /** The cone's apex, and the sum of its absolute coordinates. */
        private double x;

        private double y;
        private double z;
        private double size;

        /**
         * Sets the cone around the light.
         *
         * @param around the cone
         * @param clear begins with the ids of primitives that are known not to occlude the light
         * @param count the number of these
         */
        public Judge of(LightCone around, int[] clear, int count) {
            // Skips storing unchanged references, which saves the GC write barrier.
            if (cone != around) {
                cone = around;
            }
            if (starts != clear) {
                starts = clear;
            }
            startCount = count;
            firstStart = count > 0 ? clear[0] : -1;
            if (pyramid != around.light().pyramid) {
                pyramid = around.light().pyramid;
            }
            hasTip = false;
            x = around.x;
            y = around.y;
            z = around.z;
            size = Math.abs(x) + Math.abs(y) + Math.abs(z);
            return this;
        }

        public LightCone cone() {
            return cone;
        }

        @Override
        public int judge(int id) {
            if (id == firstStart || startCount > 1 && isLaterStart(id)) {
                return CLEAR;
            }
            int plane = planeOf[id];
            if (plane != NO_PLANE && staysBeside(id, plane)) {
                return CLEAR;
            }
            double[] b = ballOf;
            int at = 4 * id;
            double cx = b[at];
            double cy = b[at + 1];
            double cz = b[at + 2];
            double radius = b[at + 3];
            if (cone.misses(cx, cy, cz, radius) || pyramid != null && isBeside(id)) {
                return CLEAR;
            }
            return isBallOf[id] && cone.isHiddenBy(cx, cy, cz, radius) ? BLOCKS_ALL : MAY_BLOCK;
        }

        private boolean isBeside(int id) {
            if (!hasTip) {
                tip.set(pyramid, x, y, z);
                hasTip = true;
            }
            return tip.misses(id);
        }

        /**
         * Whether no segment from the apex to the light crosses the plane of a flat primitive, given the plane's index: both lie on the
         * same side of it, or one of them lies in it. A segment that only starts or ends in the plane does not cross it.
         */
        private boolean staysBeside(int id, int plane) {
            double[] p = planeAtPlace;
            double offset = p[plane + 3];
            double height = p[plane] * x + p[plane + 1] * y + p[plane + 2] * z - offset;
            double error = PLANE_ERROR * (size + Math.abs(offset));
            if (height > error) {
                return (sides(id, plane) & LightBody.ABOVE) != 0;
            }
            return height >= -error || (sides(id, plane) & LightBody.BELOW) != 0;
        }

        private boolean isLaterStart(int id) {
            for (int k = 1; k < startCount; k++) {
                if (starts[k] == id) {
                    return true;
                }
            }
            return false;
        }

        private int sides(int id, int plane) {
            LightBody light = cone.light();
            return light.sides == null ? sidesOf(light, plane) : light.sides[id];
        }
    }

    /** Decides which primitives may occlude segments from one point to several others. One per thread. */
    public final class SegmentJudge implements ConeJudge {
        private SegmentEnds ends;
        private int start;

        /**
         * Sets the end points of the segments.
         *
         * @param on the id of the primitive that they begin on and cannot hit again, or -1
         */
        public void begin(SegmentEnds to, int on) {
            ends = to;
            start = on;
        }

        @Override
        public int judge(int id) {
            if (id == start || ends.lieOn(id)) {
                return CLEAR;
            }
            int plane = planeAt[id];
            if (plane != NO_PLANE && staysBeside(plane)) {
                return CLEAR;
            }
            int at = 4 * id;
            boolean misses = ends.cone.misses(balls[at], balls[at + 1], balls[at + 2], balls[at + 3]);
            return misses ? CLEAR : MAY_BLOCK;
        }

        /** As {@link Judge#staysBeside}, for the box around the end points. */
        private boolean staysBeside(int plane) {
            double offset = planes[plane + 3];
            double height = -offset;
            double least = -offset;
            double most = -offset;
            double size = Math.abs(offset) + Math.abs(ends.cone.x) + Math.abs(ends.cone.y) + Math.abs(ends.cone.z);
            for (int c = 0; c < 3; c++) {
                double n = planes[plane + c];
                height += n * (c == 0 ? ends.cone.x : c == 1 ? ends.cone.y : ends.cone.z);
                least += n * ends.box[n > 0 ? c : c + 3];
                most += n * ends.box[n > 0 ? c + 3 : c];
            }
            double error = PLANE_ERROR * size;
            double endError = PLANE_ERROR * (ends.size + Math.abs(offset));
            if (height > error) {
                return least >= -endError;
            }
            return height >= -error || most <= endError;
        }
    }
}
