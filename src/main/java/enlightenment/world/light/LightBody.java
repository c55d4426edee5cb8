package enlightenment.world.light;

import enlightenment.accel.Accelerator;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SupportSurface;
import enlightenment.world.contact.CoincidentSurfaces;
import enlightenment.world.contact.TouchedBoxes;

/** The geometry of a light for shadow rays and for the search of its occluders. Immutable once the scene is compiled. */
public class LightBody {
    /** The side of a plane that its normal points to. */
    static final int ABOVE = 1;

    /** The side of a plane opposite to its normal. */
    static final int BELOW = 2;

    /** Centre of a ball, position of a point, lower left corner of a rectangle. */
    public final double x;

    public final double y;
    public final double z;

    /** Radius of a ball; 0 otherwise. */
    public final double radius;

    /** Edges of a rectangle, from its lower left corner; zero otherwise. */
    public final Vec3 right;

    public final Vec3 up;

    /** Centre and radius of the light's bounding ball. */
    public final double ballX;

    public final double ballY;
    public final double ballZ;
    public final double ballRadius;

    /** The surface that rays hit; null for a light that cannot be hit. */
    public final Primitive surface;

    /** Bounds the sum of the absolute coordinates of any of its points. */
    private final double bound;

    /** By id: {@link #sidesOf} the planes of flat primitives; null if they are computed on demand. */
    byte[] sides;

    /** The primitives that may occlude the light from a point of the scene's surfaces; null if they are those of all lights. */
    public Accelerator occluders;

    /** Decides occlusion more precisely than the bounding ball; null if nothing does. */
    public LightPyramid pyramid;

    private final EndFaces lyingOn = new EndFaces();

    /**
     * Makes the body: a point, a ball around a point, or a parallelogram.
     *
     * @param at the corner or centre
     * @param radius of a ball; else 0
     * @param right the edge of a rectangle, or zero
     * @param up the other edge
     * @param ballCenter centre of the bounding ball
     * @param ballRadius radius of the bounding ball
     * @param surface that rays hit; null if there is none
     */
    LightBody(Vec3 at, double radius, Vec3 right, Vec3 up, Vec3 ballCenter, double ballRadius, Primitive surface) {
        x = at.x();
        y = at.y();
        z = at.z();
        this.radius = radius;
        this.right = right;
        this.up = up;
        ballX = ballCenter.x();
        ballY = ballCenter.y();
        ballZ = ballCenter.z();
        this.ballRadius = ballRadius;
        this.surface = surface;
        bound = 3 * bounds().maxAbs();
    }

    /** The faces that the light lies on, which do not occlude it. */
    public EndFaces lyingOn() {
        return lyingOn;
    }

    /** Properties of the primitives that the light lies on; by default none is entered by light, and none covers the light. */
    interface Touched {
        /** Whether light enters a primitive by this face. */
        default boolean isEntered(int id, int face) {
            return false;
        }

        /**
         * The sides of a face, as {@link EndFaces#bit}s, on which it covers the light.
         *
         * @param isTurned whether the face's outside is on the light's inside
         */
        default int covered(int id, int face, boolean isTurned) {
            return 0;
        }
    }

    private static boolean isTurned(SupportSurface a, SupportSurface b) {
        return a instanceof SupportSurface.Plane p
                && b instanceof SupportSurface.Plane q
                && p.unitNormal().dot(q.unitNormal()) < 0;
    }

    /** Finds the faces of primitives that the light lies on: that coincide with it or, for a point, pass through it. */
    public final void lieOn(TouchedBoxes near) {
        lieOn(near, 0, -1, new Touched() {});
    }

    /**
     * As {@link #lieOn(TouchedBoxes)}, for a light that is one face of its surface.
     *
     * @param near finds the primitives
     * @param ownFace the light's face
     * @param left the id of a primitive to leave out; -1 for none
     * @param touched has the properties of the primitives
     */
    public final void lieOn(TouchedBoxes near, int ownFace, int left, Touched touched) {
        Bounds own = bounds();
        SupportSurface shape = surface == null ? null : surface.support(ownFace);
        int count = near.find(own);
        for (int k = 0; k < count; k++) {
            int id = near.ids()[k];
            if (id == left) {
                continue;
            }
            Primitive p = near.primitive(id);
            Bounds box = p.bounds();
            double tolerance = CoincidentSurfaces.tolerance(own, box);
            if (!CoincidentSurfaces.widened(own, tolerance).overlaps(box)) {
                continue;
            }
            for (int face = 0; face < p.faceCount(); face++) {
                SupportSurface s = p.support(face);
                boolean on = shape == null
                        ? s.passes(new Vec3(x, y, z), tolerance)
                        : s.coincides(shape, tolerance) && s.overlaps(shape, tolerance);
                if (on) {
                    boolean isEntered = touched.isEntered(id, face);
                    int covered = shape == null || isEntered ? 0 : touched.covered(id, face, isTurned(shape, s));
                    lyingOn.add(p, id, face, tolerance, isEntered, covered);
                }
            }
        }
    }

    /**
     * The sides of a plane that the light lies on: {@link #ABOVE} if no point of it is below, {@link #BELOW} if none is above, both if all
     * are in it.
     *
     * @param offset n·q for the plane's points q, where n = (nx, ny, nz) is its unit normal
     * @param error bounds the rounding of a distance from the plane, relative to the coordinates involved
     */
    byte sidesOf(double nx, double ny, double nz, double offset, double error) {
        double there = nx * x + ny * y + nz * z - offset;
        double toRight = nx * right.x() + ny * right.y() + nz * right.z();
        double toTop = nx * up.x() + ny * up.y() + nz * up.z();
        double least = there - radius + Math.min(toRight, 0) + Math.min(toTop, 0);
        double largest = there + radius + Math.max(toRight, 0) + Math.max(toTop, 0);
        double slack = error * (bound + Math.abs(offset));
        return (byte) ((least >= -slack ? ABOVE : 0) | (largest <= slack ? BELOW : 0));
    }

    /** A box around the light. */
    public final Bounds bounds() {
        return surface == null ? Bounds.of(new Vec3(x, y, z)) : surface.bounds();
    }
}
