package enlightenment.world.light;

import enlightenment.color.DisplayRgb;
import enlightenment.emitter.Emitter;
import enlightenment.emitter.PointEmitter;
import enlightenment.emitter.RectangleEmitter;
import enlightenment.emitter.SphereEmitter;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Sizes;

/** A light of classic shading in the frame. Physical shading has {@link PhysicalLight}s: lights there are surfaces, and surfaces that glow are lights. */
public final class ClassicLight extends LightBody {
    /** The light's form, which samples points on it. */
    public final Emitter emitter;

    /** Whether the light has no extent, so that it has a single sample: {@link Emitter#isDelta}. */
    public final boolean isDelta;

    /** The display-referred colour, 0..1. */
    public final double r;

    public final double g;
    public final double b;

    public ClassicLight(Light light, SceneFrame frame) {
        this(light, Form.of(light, frame));
    }

    private ClassicLight(Light light, Form form) {
        super(
                form.at,
                form.radius,
                form.right,
                form.up,
                form.emitter.ballCenter(),
                form.emitter.ballRadius(),
                form.surface);
        emitter = form.emitter;
        isDelta = emitter.isDelta();
        DisplayRgb c = light.color().display();
        r = c.r();
        g = c.g();
        b = c.b();
    }

    /** The geometry of a light in the frame. */
    private record Form(Vec3 at, double radius, Vec3 right, Vec3 up, Emitter emitter, Primitive surface) {
        static Form of(Light light, SceneFrame frame) {
            if (light instanceof Light.Sphere s) {
                Vec3 at = frame.toFrame(s.center());
                double radius = Sizes.inFrame(s.radius(), frame);
                Primitive surface = Primitives.place(Sphere.of(s.center(), s.radius()), frame);
                return new Form(at, radius, Vec3.ZERO, Vec3.ZERO, new SphereEmitter(at, radius), surface);
            }
            if (light instanceof Light.Rectangle q) {
                Vec3 at = frame.toFrame(q.lowerLeft());
                // Differences of exact corners are rounded once, so that a small light far away keeps its area.
                Vec3 right = new SceneFrame(q.lowerLeft(), frame.exponent()).toFrame(q.lowerRight());
                Vec3 up = new SceneFrame(q.lowerLeft(), frame.exponent()).toFrame(q.upperLeft());
                Primitive surface = Primitives.place(
                        new Rectangle(q.lowerLeft(), q.upperLeft(), q.upperRight(), q.lowerRight()), frame);
                return new Form(at, 0, right, up, new RectangleEmitter(at, right, up), surface);
            }
            if (light instanceof Light.Point p) {
                Vec3 at = frame.toFrame(p.position());
                return new Form(at, 0, Vec3.ZERO, Vec3.ZERO, new PointEmitter(at), null);
            }
            throw new AssertionError("no compiled form of the light " + light.type());
        }
    }
}
