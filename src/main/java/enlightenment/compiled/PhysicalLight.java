package enlightenment.compiled;

import enlightenment.color.Rgb;
import enlightenment.emitter.Emitter;
import enlightenment.emitter.PointEmitter;
import enlightenment.emitter.RectangleEmitter;
import enlightenment.emitter.SphereEmitter;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.RectanglePrimitive;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.primitive.SupportSurface;

/**
 * A light of physical shading: a face of a primitive that glows, or a point. What glows is a surface like any other: rays meet it, and it
 * occludes what is behind it.
 */
public final class PhysicalLight extends LightBody {
    private static final int NO_PRIMITIVE = -1;

    /** The light's form: points on it, as they are seen from somewhere. */
    public final Emitter form;

    /** The id of the primitive that glows; -1 for a point. */
    public final int id;

    /** Which of its faces. */
    public final int face;

    /** Whether it has no extent: then the three numbers are its intensity, per squared unit of length of the frame. */
    public final boolean isPoint;

    /** Whether it shines from both sides, or only from the one that its normal points to. */
    public final boolean isTwoSided;

    /** Radiance, or the intensity of a point: linear, by band. */
    public final double r;

    public final double g;
    public final double b;

    /** Whether no segment from outside to a point of it that is seen from there crosses it before. */
    public final boolean hidesNothingOfItself;

    /** The unit normal of a flat light, or zero. */
    private final Vec3 normal;

    private PhysicalLight(
            Emitter form,
            Vec3 at,
            Vec3 right,
            Vec3 up,
            double radius,
            Primitive surface,
            int id,
            int face,
            Rgb glow,
            boolean isTwoSided) {
        super(at, radius, right, up, form.ballCenter(), form.ballRadius(), surface);
        this.form = form;
        this.id = id;
        this.face = face;
        this.isTwoSided = isTwoSided;
        isPoint = surface == null;
        r = glow.r();
        g = glow.g();
        b = glow.b();
        hidesNothingOfItself = surface != null && (surface.isFlat() || surface.isConvex());
        Vec3 n = surface != null && surface.support(face) instanceof SupportSurface.Plane plane
                ? plane.unitNormal()
                : Vec3.ZERO;
        normal = n;
    }

    /** Positive if a point is on the side that the normal of a flat light points to, negative if it is on the other. */
    public double facing(double px, double py, double pz) {
        return normal.x() * (px - x) + normal.y() * (py - y) + normal.z() * (pz - z);
    }

    /** A point light of an intensity per squared unit of length of the frame. */
    static PhysicalLight point(Vec3 position, Rgb intensity) {
        return new PhysicalLight(
                new PointEmitter(position), position, Vec3.ZERO, Vec3.ZERO, 0, null, NO_PRIMITIVE, 0, intensity, true);
    }

    /** A face of a primitive that glows. */
    static PhysicalLight glowing(Primitive p, int id, int face, Rgb radiance, boolean isTwoSided) {
        if (p instanceof SpherePrimitive s) {
            Emitter form = new SphereEmitter(s.center(), s.radius());
            return new PhysicalLight(
                    form, s.center(), Vec3.ZERO, Vec3.ZERO, s.radius(), p, id, face, radiance, isTwoSided);
        }
        if (p instanceof RectanglePrimitive && p.support(0) instanceof SupportSurface.Plane plane) {
            Vec3[] corners = plane.corners();
            Vec3 up = corners[1].minus(corners[0]);
            Vec3 right = corners[3].minus(corners[0]);
            Emitter form = new RectangleEmitter(corners[0], right, up);
            return new PhysicalLight(form, corners[0], right, up, 0, p, id, face, radiance, isTwoSided);
        }
        throw new AssertionError("no light of the form " + p.getClass());
    }
}
