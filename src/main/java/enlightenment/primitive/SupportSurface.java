package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import java.util.Arrays;

/**
 * The surface that a face of a primitive is part of: a plane, a sphere, a cone or cylinder of revolution, a torus. Two faces share
 * an area only if their support surfaces are the same, so coincidence of faces is decided by them. All tests compare coordinates
 * in the frame with a tolerance that the caller derives from the roundings of placing.
 */
public interface SupportSurface {

    /**
     * Whether the two faces are parts of the same surface.
     *
     * @param other the surface of another face
     * @param tolerance bounds how far rounding may move points of the same surface apart, a length in the frame
     */
    boolean coincides(SupportSurface other, double tolerance);

    /** Whether the surface passes through the point, up to the tolerance. */
    boolean passes(Vec3 point, double tolerance);

    /**
     * Whether two faces whose surfaces coincide have an area in common. Conservative: true where in doubt.
     */
    boolean overlaps(SupportSurface other, double tolerance);

    /**
     * A length that grows with the face: a face that lies within another one of the same surface has a smaller extent. For a flat
     * face it is half the perimeter. It is accurate to a few roundings of the coordinates, however thin the face is.
     */
    double extent();

    /** The outward direction at a point of a surface without edges, of any length; null for all others. */
    default Vec3 outward(Vec3 point) {
        return null;
    }

    /** Whether no line meets the surface more than once. */
    default boolean isFlat() {
        return false;
    }

    /**
     * A flat face.
     *
     * @param unitNormal the plane's normal, of length 1: the outward normal of the face
     * @param corners of a convex polygon that encloses the face, in order
     * @param extent half of the face's perimeter
     */
    record Plane(Vec3 unitNormal, Vec3[] corners, double extent) implements SupportSurface {
        /** Planes whose normals have a smaller cosine than this do not coincide. */
        private static final double ALMOST_PARALLEL = 0.5;

        /** The face with these corners. */
        static Plane of(Vec3 normal, Vec3... corners) {
            double perimeter = 0;
            for (int i = 0; i < corners.length; i++) {
                perimeter += corners[(i + 1) % corners.length].minus(corners[i]).length();
            }
            return new Plane(normal.normalized(), corners, perimeter / 2);
        }

        /** The face of a disk; its corners are those of a square around it. */
        static Plane ofDisk(Vec3 center, Vec3 unitNormal, double radius) {
            Vec3 a = Disks.seam(unitNormal).times(radius);
            Vec3 b = unitNormal.cross(a);
            Vec3[] corners = {
                center.plus(a).plus(b),
                center.plus(b).minus(a),
                center.minus(a).minus(b),
                center.plus(a).minus(b)
            };
            return new Plane(unitNormal, corners, Math.PI * radius);
        }

        @Override
        public boolean coincides(SupportSurface other, double tolerance) {
            // Far from its corners a small polygon's plane is less well known: one plane must contain the other's
            // corners.
            return other instanceof Plane o
                    && Math.abs(unitNormal.dot(o.unitNormal)) > ALMOST_PARALLEL
                    && (passesAll(o.corners, tolerance) || o.passesAll(corners, tolerance));
        }

        /** Whether all these points lie in the plane. */
        private boolean passesAll(Vec3[] points, double tolerance) {
            for (Vec3 p : points) {
                if (!passes(p, tolerance)) {
                    return false;
                }
            }
            return true;
        }

        @Override
        public boolean passes(Vec3 point, double tolerance) {
            return Math.abs(unitNormal.dot(point.minus(corners[0]))) <= tolerance;
        }

        @Override
        public boolean overlaps(SupportSurface other, double tolerance) {
            return other instanceof Plane o && !o.isBesideEdgeOf(this, tolerance) && !isBesideEdgeOf(o, tolerance);
        }

        /** Whether this polygon lies entirely on the outer side of an edge of the other. */
        private boolean isBesideEdgeOf(Plane o, double tolerance) {
            Vec3 inside = o.middle();
            for (int i = 0; i < o.corners.length; i++) {
                Vec3 a = o.corners[i];
                Vec3 edge = o.corners[(i + 1) % o.corners.length].minus(a);
                Vec3 across = o.unitNormal.cross(edge);
                Vec3 outward = across.dot(inside.minus(a)) > 0 ? across.negated() : across;
                double length = edge.length();
                boolean beside = length > 0;
                for (Vec3 p : corners) {
                    beside &= outward.dot(p.minus(a)) >= -tolerance * length;
                }
                if (beside) {
                    return true;
                }
            }
            return false;
        }

        private Vec3 middle() {
            Vec3 sum = Vec3.ZERO;
            for (Vec3 p : corners) {
                sum = sum.plus(p);
            }
            return sum.times(1.0 / corners.length);
        }

        @Override
        public boolean isFlat() {
            return true;
        }
    }

    /** A whole sphere. */
    record Ball(Vec3 center, double radius) implements SupportSurface {
        @Override
        public boolean coincides(SupportSurface other, double tolerance) {
            return other instanceof Ball o
                    && center.minus(o.center).maxAbs() <= tolerance
                    && Math.abs(radius - o.radius) <= tolerance;
        }

        @Override
        public boolean passes(Vec3 point, double tolerance) {
            return Math.abs(outward(point).length() - radius) <= tolerance;
        }

        @Override
        public Vec3 outward(Vec3 point) {
            return point.minus(center);
        }

        @Override
        public boolean overlaps(SupportSurface other, double tolerance) {
            return true;
        }

        @Override
        public double extent() {
            return radius;
        }
    }

    /**
     * The lateral surface of a cylinder, cone or frustum.
     *
     * @param base centre of one end
     * @param top centre of the other end
     * @param axis from base to top, more accurate than the difference of the two
     * @param baseRadius radius at the base, at least 0
     * @param topRadius radius at the top, at least 0
     */
    record Lateral(Vec3 base, Vec3 top, Vec3 axis, double baseRadius, double topRadius) implements SupportSurface {
        @Override
        public boolean coincides(SupportSurface other, double tolerance) {
            // Far from a short surface its axis is less well known: one surface must contain the other's ends.
            return other instanceof Lateral o
                    && (hasEnd(o.base, o.baseRadius, tolerance) && hasEnd(o.top, o.topRadius, tolerance)
                            || o.hasEnd(base, baseRadius, tolerance) && o.hasEnd(top, topRadius, tolerance));
        }

        /** Whether the circle of this centre and radius around the axis lies on the surface. */
        private boolean hasEnd(Vec3 center, double radius, double tolerance) {
            return across(center) <= tolerance && Math.abs(radiusAt(along(center)) - radius) <= tolerance;
        }

        private Vec3 unitAxis() {
            return axis.normalized();
        }

        private double along(Vec3 p) {
            return p.minus(base).dot(unitAxis());
        }

        private double across(Vec3 p) {
            return p.minus(base).cross(unitAxis()).length();
        }

        private double radiusAt(double along) {
            return baseRadius + (topRadius - baseRadius) * (along / axis.length());
        }

        @Override
        public boolean passes(Vec3 point, double tolerance) {
            double length = axis.length();
            double slant = Math.sqrt(length * length + (topRadius - baseRadius) * (topRadius - baseRadius));
            return Math.abs(across(point) - radiusAt(along(point))) * (length / slant) <= tolerance;
        }

        @Override
        public boolean overlaps(SupportSurface other, double tolerance) {
            Lateral o = (Lateral) other;
            double from = Math.min(along(o.base), along(o.top));
            double to = Math.max(along(o.base), along(o.top));
            return Math.min(to, axis.length()) - Math.max(from, 0) > tolerance;
        }

        @Override
        public double extent() {
            return axis.length() + baseRadius + topRadius;
        }
    }

    /**
     * A whole mesh in a place: it coincides only with the same mesh in the same place.
     *
     * @param numbers of its placing
     */
    record Facets(TriangleMesh mesh, Bounds bounds, double[] numbers) implements SupportSurface {
        @Override
        public boolean coincides(SupportSurface other, double tolerance) {
            return other instanceof Facets o
                    && o.mesh == mesh
                    && o.bounds.min().minus(bounds.min()).maxAbs() <= tolerance
                    && o.bounds.max().minus(bounds.max()).maxAbs() <= tolerance
                    && Arrays.equals(o.numbers, 3, numbers.length, numbers, 3, numbers.length);
        }

        /** Points on a mesh are not supported: lamps lie beside meshes, not on them. */
        @Override
        public boolean passes(Vec3 point, double tolerance) {
            return false;
        }

        @Override
        public boolean overlaps(SupportSurface other, double tolerance) {
            return true;
        }

        @Override
        public double extent() {
            return bounds.extent().maxAbs();
        }
    }
}
