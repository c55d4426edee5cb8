package enlightenment.emitter;

import enlightenment.frame.Basis;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Shape;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import java.util.SplittableRandom;

/** A face of a placed shape as a light that is seen from a point, and what rays find of it. */
final class SeenLight {
    final String name;
    final AreaLight light;
    final Vec3 viewer;
    final LightSample sample = new LightSample();
    private final Primitive primitive;
    private final int face;
    private final LightSides sides;
    private final Ray ray = new Ray();
    private final Hit hit = new Hit();
    private final Basis basis = new Basis();

    /** The last direction chosen around the light. */
    double x;

    double y;
    double z;

    /** The density of a direction that meets the light, summed over all crossings, and their number. */
    double density;

    int crossings;

    SeenLight(String name, Shape shape, int face, LightSides sides, Vec3 viewer) {
        this.name = name;
        this.face = face;
        this.sides = sides;
        this.viewer = viewer;
        primitive = Primitives.place(shape, SceneFrame.WORLD);
        light = AreaLights.of(primitive, face, sides);
        aim(viewer);
        basis.around(sample.cone.wx, sample.cone.wy, sample.cone.wz);
    }

    Class<?> primitiveKind() {
        return primitive.getClass();
    }

    void aim(Vec3 from) {
        light.aim(sample, from.x(), from.y(), from.z());
    }

    private double down() {
        return sample.cone.inside ? 2 : sample.cone.oneMinusCosine();
    }

    /** The solid angle of the cone around the light's ball. */
    double coneAngle() {
        return 2 * Math.PI * down();
    }

    /** Chooses a direction in that cone, evenly. */
    void choose(SplittableRandom random) {
        double drop = random.nextDouble() * down();
        double across = Math.sqrt(drop * (2 - drop));
        double angle = 2 * Math.PI * random.nextDouble();
        double s = across * Math.cos(angle);
        double t = across * Math.sin(angle);
        double w = 1 - drop;
        x = sample.cone.wx * w + basis.ax * s + basis.bx * t;
        y = sample.cone.wy * w + basis.ay * s + basis.by * t;
        z = sample.cone.wz * w + basis.az * s + basis.bz * t;
    }

    /** Which of rings · sectors parts of the cone, of equal size, a direction lies in. */
    int cell(double dx, double dy, double dz, int rings, int sectors) {
        double s = dx * basis.ax + dy * basis.ay + dz * basis.az;
        double t = dx * basis.bx + dy * basis.by + dz * basis.bz;
        double w = dx * sample.cone.wx + dy * sample.cone.wy + dz * sample.cone.wz;
        double drop = w > 0 ? (s * s + t * t) / (1 + w) : 1 - w;
        int ring = Math.min((int) (rings * drop / down()), rings - 1);
        int sector = Math.min((int) (sectors * (Math.atan2(t, s) / (2 * Math.PI) + 0.5)), sectors - 1);
        return ring * sectors + sector;
    }

    /** Follows the direction through all crossings and adds up the densities with which each is chosen. */
    void trace(double dx, double dy, double dz) {
        density = 0;
        crossings = 0;
        double from = 0;
        while (true) {
            ray.set(viewer.x(), viewer.y(), viewer.z(), dx, dy, dz, from);
            if (!primitive.intersect(ray, hit)) {
                return;
            }
            double cosine = -(hit.nx * dx + hit.ny * dy + hit.nz * dz);
            if (hit.face == face && sides.shineAt(cosine)) {
                double p = light.pdf(sample, dx, dy, dz, hit.t, cosine);
                density += p;
                crossings += p > 0 ? 1 : 0;
            }
            from = hit.t * (1 + 1e-9);
        }
    }

    /** What is done with each crossing of a line. */
    interface Crossing {
        void at(double x, double y, double z);
    }

    /** Follows a line through all of its crossings with the light. */
    void cross(Vec3 o, Vec3 d, Crossing crossing) {
        double from = 0;
        while (true) {
            ray.set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), from);
            if (!primitive.intersect(ray, hit)) {
                return;
            }
            if (hit.face == face) {
                crossing.at(hit.px, hit.py, hit.pz);
            }
            from = hit.t * (1 + 1e-9);
        }
    }

    @Override
    public String toString() {
        return name;
    }
}
