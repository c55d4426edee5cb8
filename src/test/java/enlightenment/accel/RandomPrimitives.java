package enlightenment.accel;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import java.util.SplittableRandom;

/** Random primitives to build hierarchies of. */
final class RandomPrimitives {
    private final SplittableRandom random;

    RandomPrimitives(long seed) {
        random = new SplittableRandom(seed);
    }

    Vec3 vector(double halfWidth) {
        return new Vec3(signed(halfWidth), signed(halfWidth), signed(halfWidth));
    }

    private double signed(double halfWidth) {
        return (2 * random.nextDouble() - 1) * halfWidth;
    }

    private static ExactPoint point(Vec3 v) {
        return ExactPoint.of(v.x(), v.y(), v.z());
    }

    /** Primitives of every kind in turn, their sizes spread evenly over the decades from 1e-6 to 1e3. */
    Primitive[] ofAllKinds(int n) {
        Primitive[] all = new Primitive[n];
        for (int i = 0; i < n; i++) {
            double size = StrictMath.pow(10, -6 + 9 * random.nextDouble());
            all[i] = Primitives.place(shape(i % 10, vector(10 + 3 * size), size), SceneFrame.WORLD);
        }
        return all;
    }

    private Shape shape(int kind, Vec3 p, double size) {
        Vec3 q = vector(size);
        Vec3 r = vector(size);
        switch (kind) {
            case 0:
                return Sphere.of(point(p), size);
            case 1:
                return new Rectangle(
                        point(p), point(p).plus(q), point(p).plus(q).plus(r), point(p).plus(r));
            case 2:
                return new Triangle(point(p), point(p.plus(q)), point(p.plus(r)));
            case 3:
                Vec3 extent = new Vec3(0.1 * size + Math.abs(q.x()), size, 0.1 * size + Math.abs(q.z()));
                return new Box(point(p), point(p.plus(extent)));
            case 4:
                return new Cube(point(p), size, vector(180));
            case 5:
                return new Torus(point(p), vector(1), size, size * (0.01 + 0.9 * random.nextDouble()));
            case 6:
                return new Disk(point(p), vector(1), size);
            case 7:
                return new Cylinder(point(p), point(p.plus(q)), size, random.nextBoolean());
            case 8:
                return new Cone(point(p), point(p.plus(q)), size, size * random.nextInt(3) / 2, random.nextBoolean());
            default:
                // Parallel to the axes, on whole numbers: meets others in shared planes.
                double e = Math.max(1, Math.rint(size));
                Vec3 c = new Vec3(Math.rint(p.x()), Math.rint(p.y()), Math.rint(p.z()));
                return new Rectangle(
                        point(c),
                        point(c.plus(new Vec3(0, e, 0))),
                        point(c.plus(new Vec3(e, e, 0))),
                        point(c.plus(new Vec3(e, 0, 0))));
        }
    }

    /** Spheres evenly spread in a cube of half width 1, of a radius that fills about a tenth of it. */
    Primitive[] spheres(int n) {
        double radius = 0.3 / StrictMath.cbrt(n);
        Primitive[] all = new Primitive[n];
        for (int i = 0; i < n; i++) {
            all[i] = Primitives.place(Sphere.of(point(vector(1)), radius), SceneFrame.WORLD);
        }
        return all;
    }

    /** A ray into the crowd; some run parallel to an axis, some start at whole numbers. */
    Ray ray(double halfWidth) {
        Vec3 o = vector(halfWidth);
        Vec3 d = vector(1);
        int special = random.nextInt(8);
        if (special == 0) {
            d = new Vec3(0.0, -0.0, d.z());
        } else if (special == 1) {
            d = new Vec3(d.x(), 0.0, d.z());
            o = new Vec3(Math.rint(o.x()), Math.rint(o.y()), Math.rint(o.z()));
        } else if (special == 2) {
            d = Vec3.ZERO.minus(o).plus(vector(2));
        }
        return Ray.of(o, d);
    }

    double uniform() {
        return random.nextDouble();
    }

    int index(int n) {
        return random.nextInt(n);
    }
}
