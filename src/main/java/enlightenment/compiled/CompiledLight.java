package enlightenment.compiled;

import enlightenment.color.DisplayRgb;
import enlightenment.emitter.Emitter;
import enlightenment.emitter.PointEmitter;
import enlightenment.emitter.RectangleEmitter;
import enlightenment.emitter.SphereEmitter;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.math.Vec3;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Sizes;
import enlightenment.primitive.SupportSurface;

/** A light in the scene's frame. */
public final class CompiledLight {
    /** The side of a plane that its normal points to. */
    static final int ABOVE = 1;

    /** The other side. */
    static final int BELOW = 2;

    /** The light's form: points on it, as they are seen from somewhere. */
    public final Emitter emitter;

    /** Whether the light has no extent: {@link Emitter#isDelta}. */
    public final boolean isDelta;

    /** The display-referred colour, 0..1. */
    public final double r;

    public final double g;
    public final double b;

    /** Centre of a sphere, position of a point, lower left corner of a rectangle. */
    public final double x;

    public final double y;
    public final double z;

    /** Radius of a sphere; 0 otherwise. */
    public final double radius;

    /** Edges of a rectangle, from its lower left corner; zero otherwise. */
    public final Vec3 right;

    public final Vec3 up;

    /** Centre and radius of a ball around the light. */
    public final double ballX;

    public final double ballY;
    public final double ballZ;
    public final double ballRadius;

    /** The surface that rays meet; null for a light that cannot be seen. */
    public final Primitive surface;

    /** Bounds the sum of the absolute coordinates of any of its points. */
    private final double bound;

    /** By id: the {@link #sidesOf} flat primitives' planes that the light lies on; null if they are computed when needed. */
    byte[] sides;

    private final EndFaces lyingOn = new EndFaces();

    CompiledLight(Light light, SceneFrame frame) {
        DisplayRgb c = light.color().display();
        r = c.r();
        g = c.g();
        b = c.b();
        Vec3 at;
        Vec3 toRight = Vec3.ZERO;
        Vec3 toTop = Vec3.ZERO;
        if (light instanceof Light.Sphere s) {
            at = frame.toFrame(s.center());
            radius = Sizes.inFrame(s.radius(), frame);
            emitter = new SphereEmitter(at, radius);
            surface = Primitives.place(Sphere.of(s.center(), s.radius()), frame);
        } else if (light instanceof Light.Rectangle q) {
            at = frame.toFrame(q.lowerLeft());
            // Differences of exact corners, not of rounded ones: a small light far away keeps its area.
            toRight = new SceneFrame(q.lowerLeft(), frame.exponent()).toFrame(q.lowerRight());
            toTop = new SceneFrame(q.lowerLeft(), frame.exponent()).toFrame(q.upperLeft());
            radius = 0;
            emitter = new RectangleEmitter(at, toRight, toTop);
            surface = Primitives.place(
                    new Rectangle(q.lowerLeft(), q.upperLeft(), q.upperRight(), q.lowerRight()), frame);
        } else if (light instanceof Light.Point p) {
            at = frame.toFrame(p.position());
            radius = 0;
            emitter = new PointEmitter(at);
            surface = null;
        } else {
            throw new AssertionError("no compiled form of the light " + light.type());
        }
        x = at.x();
        y = at.y();
        z = at.z();
        right = toRight;
        up = toTop;
        isDelta = emitter.isDelta();
        ballX = emitter.ballCenter().x();
        ballY = emitter.ballCenter().y();
        ballZ = emitter.ballCenter().z();
        ballRadius = emitter.ballRadius();
        bound = 3 * bounds().maxAbs();
    }

    /** The faces that the light lies on: they do not occlude it. */
    public EndFaces lyingOn() {
        return lyingOn;
    }

    /** Finds the faces of these primitives that the light lies on: that coincide with it or, for a point, pass through it. */
    void lieOn(Primitive[] primitives) {
        Bounds own = bounds();
        SupportSurface shape = surface == null ? null : surface.support(0);
        for (int id = 0; id < primitives.length; id++) {
            Primitive p = primitives[id];
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
                    lyingOn.add(p, id, face, tolerance);
                }
            }
        }
    }

    /**
     * The sides of a plane that the light lies on: {@link #ABOVE} if no point of it is below, {@link #BELOW} if none is above, both
     * if all are in it.
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
    Bounds bounds() {
        return surface == null ? Bounds.of(new Vec3(x, y, z)) : surface.bounds();
    }
}
