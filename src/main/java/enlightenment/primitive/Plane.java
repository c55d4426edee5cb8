package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.Products;

/** The plane of a flat primitive: its crossing with a ray, and the point, normal and texture coordinates of a hit. */
final class Plane {
    private final Vec3 a;

    /** The exact unit normal if rounding made the vertices collinear, or null. */
    private final Vec3 degenerate;

    /** The normal, with a largest component in [1, 2) or near it. */
    final Vec3 n;

    /** The squared length of {@link #n}. */
    final double nn;

    /** Dual vectors of the edges: their dot products with an offset from a are its coordinates along {@code right} and {@code up}. */
    private final Vec3 toU;

    private final Vec3 toV;

    /** The axis that the plane is perpendicular to, or -1. */
    final int axis;

    /** The unit normal of a plane perpendicular to an axis; else not used. */
    private final double unitX;

    private final double unitY;
    private final double unitZ;

    /** The coordinate on that axis, the same for every vertex. */
    final double coordinate;

    /**
     * The plane through a and the other vertices; its normal, which points outside, is up × right.
     *
     * @param degenerate the exact unit normal if rounding made the vertices collinear, else null
     */
    Plane(Vec3 degenerate, Vec3 a, Vec3 up, Vec3 right, Vec3... others) {
        this.a = a;
        this.degenerate = degenerate;
        if (degenerate != null) {
            n = degenerate;
            nn = degenerate.lengthSquared();
            toU = Vec3.ZERO;
            toV = Vec3.ZERO;
            axis = -1;
            coordinate = 0;
            unitX = 0;
            unitY = 0;
            unitZ = 0;
            return;
        }
        // p = s·right + r·up is solved by s = (up × p)·n/n² = p·(n × up)/n², and r alike. Powers of two are taken out
        // of
        // the edges first, which is exact: the fourth power of a tiny size could underflow.
        int e = -up.exponent();
        int f = -right.exponent();
        Vec3 u = up.scaledBy(e);
        Vec3 r = right.scaledBy(f);
        Vec3 m = u.cross(r);
        int g = -m.exponent();
        n = m.scaledBy(g);
        nn = n.lengthSquared();
        double inverse = 1 / nn;
        toU = n.cross(u).times(inverse).scaledBy(f + g);
        toV = r.cross(n).times(inverse).scaledBy(e + g);
        axis = axis(a, others);
        coordinate = axis < 0 ? 0 : a.component(axis);
        unitX = axis == 0 ? Math.signum(n.x()) : 0;
        unitY = axis == 1 ? Math.signum(n.y()) : 0;
        unitZ = axis == 2 ? Math.signum(n.z()) : 0;
    }

    /** The exact unit normal if rounding made the vertices collinear, or null. */
    Vec3 degenerateNormal() {
        return degenerate;
    }

    private static int axis(Vec3 a, Vec3... others) {
        for (int k = 0; k < 3; k++) {
            boolean flat = true;
            for (Vec3 v : others) {
                flat &= v.component(k) == a.component(k);
            }
            if (flat) {
                return k;
            }
        }
        return -1;
    }

    /** The ray parameter at which the ray's line meets the plane; infinite or NaN where they are parallel. */
    double distance(Ray ray) {
        if (axis == 0) {
            return (coordinate - ray.ox) / ray.dx;
        }
        if (axis == 1) {
            return (coordinate - ray.oy) / ray.dy;
        }
        if (axis == 2) {
            return (coordinate - ray.oz) / ray.dz;
        }
        return Products.accurateDot(n.x(), n.y(), n.z(), a.x() - ray.ox, a.y() - ray.oy, a.z() - ray.oz)
                / Products.accurateDot(n.x(), n.y(), n.z(), ray.dx, ray.dy, ray.dz);
    }

    /** Fills the hit's point, normal, side and face for a crossing at t. */
    void complete(Ray ray, double t, Hit hit) {
        double x = Math.fma(t, ray.dx, ray.ox);
        double y = Math.fma(t, ray.dy, ray.oy);
        double z = Math.fma(t, ray.dz, ray.oz);
        double towards;
        if (axis < 0) {
            double off = Products.accurateDot(n.x(), n.y(), n.z(), x - a.x(), y - a.y(), z - a.z()) / nn;
            hit.setPoint(Math.fma(-off, n.x(), x), Math.fma(-off, n.y(), y), Math.fma(-off, n.z(), z));
            hit.setNormal(n.x(), n.y(), n.z());
            towards = Products.accurateDot(n.x(), n.y(), n.z(), ray.dx, ray.dy, ray.dz);
        } else {
            // The coordinate of an axis-aligned plane is assigned, not computed, so that coincident planes tie exactly.
            hit.setPoint(axis == 0 ? coordinate : x, axis == 1 ? coordinate : y, axis == 2 ? coordinate : z);
            hit.nx = unitX;
            hit.ny = unitY;
            hit.nz = unitZ;
            towards = unitX * ray.dx + unitY * ray.dy + unitZ * ray.dz;
        }
        hit.side = towards < 0 ? Ray.OUTSIDE : Ray.INSIDE;
        hit.face = 0;
    }

    /** Sets u and v so that the point a + u·right + (1 − v)·up is the hit's point. */
    void textureCoordinates(Hit hit) {
        double x = hit.px - a.x();
        double y = hit.py - a.y();
        double z = hit.pz - a.z();
        hit.u = Watertight.clamp01(Products.dot(toU.x(), toU.y(), toU.z(), x, y, z));
        hit.v = Watertight.clamp01(1 - Products.dot(toV.x(), toV.y(), toV.z(), x, y, z));
    }

    /** The numbers of the plane for code on another device. */
    double[] flatForm() {
        return new double[] {
            a.x(),
            a.y(),
            a.z(),
            n.x(),
            n.y(),
            n.z(),
            nn,
            toU.x(),
            toU.y(),
            toU.z(),
            toV.x(),
            toV.y(),
            toV.z(),
            axis,
            coordinate,
            unitX,
            unitY,
            unitZ
        };
    }
}
