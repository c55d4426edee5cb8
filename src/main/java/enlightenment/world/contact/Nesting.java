package enlightenment.world.contact;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SupportSurface;

/** Decides whether one solid certainly lies within another, nowhere at the other's surface. */
final class Nesting {
    /** The number of sides of the prism around a cylinder or cone whose corners are tested. */
    private static final int SIDES = 16;

    /** The distance of a regular prism's corners from its axis, relative to that of its faces. */
    private static final double CORNER = 1 / StrictMath.cos(Math.PI / SIDES);

    private Nesting() {}

    /**
     * Whether that is certain: the outer solid is convex and contains the corners of a polyhedron around the inner one; for balls the
     * answer is exact.
     *
     * @param margin the least distance of the surfaces, more than roundings
     */
    static boolean isWithin(Primitive inner, Primitive outer, double margin) {
        if (!outer.isConvex()) {
            return false;
        }
        for (int face = 0; face < inner.faceCount(); face++) {
            SupportSurface support = inner.support(face);
            if (support instanceof SupportSurface.Ball a && outer.support(0) instanceof SupportSurface.Ball b) {
                return a.center().minus(b.center()).length() + a.radius() + margin < b.radius();
            }
            if (support instanceof SupportSurface.Lateral side) {
                return isPrismWithin(side, outer, margin);
            }
        }
        return isBoxWithin(CoincidentSurfaces.widened(inner.bounds(), margin), outer);
    }

    private static boolean isPrismWithin(SupportSurface.Lateral side, Primitive outer, double margin) {
        Vec3 axis = side.axis().normalized();
        Vec3 across = axis.cross(Math.abs(axis.x()) < Math.abs(axis.y()) ? Vec3.X : Vec3.Y)
                .normalized();
        Vec3 third = axis.cross(across);
        for (int k = 0; k < SIDES; k++) {
            double angle = 2 * Math.PI * k / SIDES;
            Vec3 out = across.times(StrictMath.cos(angle)).plus(third.times(StrictMath.sin(angle)));
            Vec3 base = side.base().plus(out.times(CORNER * (side.baseRadius() + margin)));
            Vec3 top = side.top().plus(out.times(CORNER * (side.topRadius() + margin)));
            if (!contains(outer, base.minus(axis.times(margin))) || !contains(outer, top.plus(axis.times(margin)))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isBoxWithin(Bounds box, Primitive outer) {
        Vec3 a = box.min();
        Vec3 b = box.max();
        for (int corner = 0; corner < 8; corner++) {
            double x = (corner & 1) == 0 ? a.x() : b.x();
            double y = (corner & 2) == 0 ? a.y() : b.y();
            double z = (corner & 4) == 0 ? a.z() : b.z();
            if (!outer.contains(x, y, z)) {
                return false;
            }
        }
        return true;
    }

    private static boolean contains(Primitive solid, Vec3 p) {
        return solid.contains(p.x(), p.y(), p.z());
    }
}
