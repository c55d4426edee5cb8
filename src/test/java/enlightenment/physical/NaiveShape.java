package enlightenment.physical;

import enlightenment.geometry.Box;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Triangle;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;

/** A shape as a textbook has it: plain formulas in doubles, for scenes of a size of about 1 in which nothing coincides. */
abstract class NaiveShape {
    /** No hit. */
    static final double NONE = Double.POSITIVE_INFINITY;

    /** The least t above {@code from} at which o + t·d lies on the surface, or {@link #NONE}. */
    abstract double hit(Vec3 o, Vec3 d, double from);

    /** The unit normal at a point of the surface: outwards where there is an inside, else to the front. */
    abstract Vec3 normal(Vec3 p);

    /** The normal by which a point is shaded, as long as 1 and on the side of {@link #normal}. */
    Vec3 shadingNormal(Vec3 p) {
        return normal(p);
    }

    /** Whether the point is inside; false for what has no volume. */
    boolean contains(Vec3 p) {
        return false;
    }

    /** The volume, 0 for what has none: where solids overlap, the smaller one counts. */
    double volume() {
        return 0;
    }

    /** Texture coordinates of a point of the surface, u to the right and v downwards. */
    double[] texture(Vec3 p) {
        throw new UnsupportedOperationException("no texture coordinates for this shape");
    }

    static NaiveShape of(Shape shape) {
        if (shape instanceof Sphere s) {
            return new Ball(at(s.center()), s.radius());
        }
        if (shape instanceof Rectangle r) {
            return new Flat(at(r.upperLeft()), at(r.upperRight()), at(r.lowerLeft()), false);
        }
        if (shape instanceof Triangle t) {
            return new Flat(at(t.a()), at(t.b()), at(t.c()), true);
        }
        if (shape instanceof Disk d) {
            return new Round(at(d.center()), d.normal().normalized(), d.radius());
        }
        if (shape instanceof Box b) {
            return new Bricks(at(b.min()), at(b.max()));
        }
        if (shape instanceof Cube c) {
            return new Turned(at(c.center()), c.radius() / Math.sqrt(3), c.rotation());
        }
        if (shape instanceof Cylinder c) {
            return new Tube(at(c.base()), at(c.top()), c.radius(), c.capped());
        }
        if (shape instanceof Mesh m) {
            return new NaiveMesh(m);
        }
        throw new UnsupportedOperationException("no naive form of a " + shape.type());
    }

    static Vec3 at(ExactPoint p) {
        return new Vec3(p.x().doubleValue(), p.y().doubleValue(), p.z().doubleValue());
    }

    /** A ball. */
    static final class Ball extends NaiveShape {
        private final Vec3 center;
        private final double radius;

        Ball(Vec3 center, double radius) {
            this.center = center;
            this.radius = radius;
        }

        @Override
        double hit(Vec3 o, Vec3 d, double from) {
            Vec3 m = o.minus(center);
            double a = d.dot(d);
            double b = m.dot(d);
            double root = b * b - a * (m.dot(m) - radius * radius);
            if (root < 0) {
                return NONE;
            }
            double first = (-b - Math.sqrt(root)) / a;
            double second = (-b + Math.sqrt(root)) / a;
            return first > from ? first : second > from ? second : NONE;
        }

        @Override
        Vec3 normal(Vec3 p) {
            return p.minus(center).normalized();
        }

        @Override
        boolean contains(Vec3 p) {
            return p.minus(center).length() < radius;
        }

        @Override
        double volume() {
            return 4 / 3.0 * Math.PI * radius * radius * radius;
        }

        @Override
        double[] texture(Vec3 p) {
            Vec3 n = normal(p);
            double longitude = Math.atan2(n.x(), -n.z()) / (2 * Math.PI);
            return new double[] {longitude < 0 ? longitude + 1 : longitude, Math.acos(n.y()) / Math.PI};
        }
    }

    /** A parallelogram or a triangle, by its upper left corner and the corners to the right of it and below it. */
    static final class Flat extends NaiveShape {
        private final Vec3 corner;
        private final Vec3 across;
        private final Vec3 down;
        private final Vec3 cross;
        private final boolean half;

        Flat(Vec3 corner, Vec3 right, Vec3 below, boolean half) {
            this.corner = corner;
            this.across = right.minus(corner);
            this.down = below.minus(corner);
            this.half = half;
            // (upper left − lower left) × (lower right − lower left)
            this.cross = across.cross(down);
        }

        double area() {
            return cross.length();
        }

        /** The volume between half of it and a point behind it. */
        double cone(Vec3 p) {
            return corner.minus(p).dot(cross) / 6;
        }

        /** The mirror image of a point. */
        Vec3 mirrored(Vec3 p) {
            Vec3 n = cross.normalized();
            return p.minus(n.times(2 * p.minus(corner).dot(n)));
        }

        @Override
        double hit(Vec3 o, Vec3 d, double from) {
            double t = corner.minus(o).dot(cross) / d.dot(cross);
            if (!(t > from) || t == NONE) {
                return NONE;
            }
            double[] at = texture(o.plus(d.times(t)));
            boolean within = at[0] >= 0 && at[1] >= 0 && (half ? at[0] + at[1] <= 1 : at[0] <= 1 && at[1] <= 1);
            return within ? t : NONE;
        }

        @Override
        Vec3 normal(Vec3 p) {
            return cross.normalized();
        }

        @Override
        double[] texture(Vec3 p) {
            Vec3 m = p.minus(corner);
            double square = cross.dot(cross);
            return new double[] {
                m.cross(down).dot(cross) / square, across.cross(m).dot(cross) / square
            };
        }
    }

    /** A disk. */
    static final class Round extends NaiveShape {
        private final Vec3 center;
        private final Vec3 normal;
        private final double radius;

        Round(Vec3 center, Vec3 normal, double radius) {
            this.center = center;
            this.normal = normal;
            this.radius = radius;
        }

        @Override
        double hit(Vec3 o, Vec3 d, double from) {
            double t = center.minus(o).dot(normal) / d.dot(normal);
            boolean met =
                    t > from && t < NONE && o.plus(d.times(t)).minus(center).length() <= radius;
            return met ? t : NONE;
        }

        @Override
        Vec3 normal(Vec3 p) {
            return normal;
        }
    }

    /** A box parallel to the axes. */
    static final class Bricks extends NaiveShape {
        private final double[] min;
        private final double[] max;

        Bricks(Vec3 min, Vec3 max) {
            this.min = new double[] {min.x(), min.y(), min.z()};
            this.max = new double[] {max.x(), max.y(), max.z()};
        }

        @Override
        double hit(Vec3 o, Vec3 d, double from) {
            double[] start = {o.x(), o.y(), o.z()};
            double[] along = {d.x(), d.y(), d.z()};
            double enter = Double.NEGATIVE_INFINITY;
            double leave = NONE;
            for (int k = 0; k < 3; k++) {
                double a = (min[k] - start[k]) / along[k];
                double b = (max[k] - start[k]) / along[k];
                enter = Math.max(enter, Math.min(a, b));
                leave = Math.min(leave, Math.max(a, b));
            }
            return !(enter <= leave) ? NONE : enter > from ? enter : leave > from ? leave : NONE;
        }

        @Override
        Vec3 normal(Vec3 p) {
            double[] at = {p.x(), p.y(), p.z()};
            double[] n = new double[3];
            double nearest = NONE;
            int face = 0;
            for (int k = 0; k < 6; k++) {
                double distance = Math.abs(at[k / 2] - (k % 2 == 0 ? min[k / 2] : max[k / 2]));
                if (distance < nearest) {
                    nearest = distance;
                    face = k;
                }
            }
            n[face / 2] = face % 2 == 0 ? -1 : 1;
            return new Vec3(n[0], n[1], n[2]);
        }

        @Override
        boolean contains(Vec3 p) {
            return p.x() > min[0]
                    && p.x() < max[0]
                    && p.y() > min[1]
                    && p.y() < max[1]
                    && p.z() > min[2]
                    && p.z() < max[2];
        }

        @Override
        double volume() {
            return (max[0] - min[0]) * (max[1] - min[1]) * (max[2] - min[2]);
        }
    }

    /** A cube, turned about the x axis, then the y axis, then the z axis. */
    static final class Turned extends NaiveShape {
        private final Bricks upright;
        private final Vec3 center;
        private final Vec3[] axes = new Vec3[3];

        Turned(Vec3 center, double half, Vec3 degrees) {
            this.center = center;
            upright = new Bricks(new Vec3(-half, -half, -half), new Vec3(half, half, half));
            Vec3[] units = {Vec3.X, Vec3.Y, Vec3.Z};
            for (int k = 0; k < 3; k++) {
                axes[k] = turned(turned(turned(units[k], 0, degrees.x()), 1, degrees.y()), 2, degrees.z());
            }
        }

        private static Vec3 turned(Vec3 v, int axis, double degrees) {
            double c = Math.cos(Math.toRadians(degrees));
            double s = Math.sin(Math.toRadians(degrees));
            return switch (axis) {
                case 0 -> new Vec3(v.x(), c * v.y() - s * v.z(), s * v.y() + c * v.z());
                case 1 -> new Vec3(c * v.x() + s * v.z(), v.y(), c * v.z() - s * v.x());
                default -> new Vec3(c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z());
            };
        }

        private Vec3 local(Vec3 v) {
            return new Vec3(axes[0].dot(v), axes[1].dot(v), axes[2].dot(v));
        }

        @Override
        double hit(Vec3 o, Vec3 d, double from) {
            return upright.hit(local(o.minus(center)), local(d), from);
        }

        @Override
        Vec3 normal(Vec3 p) {
            Vec3 n = upright.normal(local(p.minus(center)));
            return axes[0].times(n.x()).plus(axes[1].times(n.y())).plus(axes[2].times(n.z()));
        }

        @Override
        boolean contains(Vec3 p) {
            return upright.contains(local(p.minus(center)));
        }

        @Override
        double volume() {
            return upright.volume();
        }
    }

    /** A right circular cylinder. */
    static final class Tube extends NaiveShape {
        private final Vec3 base;
        private final Vec3 axis;
        private final double height;
        private final double radius;
        private final boolean capped;

        Tube(Vec3 base, Vec3 top, double radius, boolean capped) {
            this.base = base;
            this.axis = top.minus(base).normalized();
            this.height = top.minus(base).length();
            this.radius = radius;
            this.capped = capped;
        }

        private double along(Vec3 p) {
            return p.minus(base).dot(axis);
        }

        private Vec3 beside(Vec3 v) {
            return v.minus(axis.times(v.dot(axis)));
        }

        @Override
        double hit(Vec3 o, Vec3 d, double from) {
            Vec3 m = beside(o.minus(base));
            Vec3 e = beside(d);
            double a = e.dot(e);
            double b = m.dot(e);
            double root = b * b - a * (m.dot(m) - radius * radius);
            double best = NONE;
            for (int sign = -1; sign <= 1; sign += 2) {
                double t = (-b + sign * Math.sqrt(root)) / a;
                double h = along(o.plus(d.times(t)));
                if (t > from && t < best && h >= 0 && h <= height) {
                    best = t;
                }
            }
            for (int end = 0; capped && end < 2; end++) {
                Vec3 center = base.plus(axis.times(end * height));
                double t = center.minus(o).dot(axis) / d.dot(axis);
                if (t > from && t < best && o.plus(d.times(t)).minus(center).length() <= radius) {
                    best = t;
                }
            }
            return best;
        }

        @Override
        Vec3 normal(Vec3 p) {
            Vec3 out = beside(p.minus(base));
            double h = along(p);
            double toEnd = Math.min(Math.abs(h), Math.abs(h - height));
            if (capped && toEnd < Math.abs(out.length() - radius)) {
                return 2 * h < height ? axis.times(-1) : axis;
            }
            return out.normalized();
        }

        @Override
        boolean contains(Vec3 p) {
            double h = along(p);
            return capped && h > 0 && h < height && beside(p.minus(base)).length() < radius;
        }

        @Override
        double volume() {
            return capped ? Math.PI * radius * radius * height : 0;
        }
    }
}
