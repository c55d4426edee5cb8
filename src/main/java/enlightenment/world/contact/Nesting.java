package enlightenment.world.contact;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.SupportSurface;

/** Whether one solid certainly lies within another, with nothing of it at the other's surface. */
final class Nesting {
    /** Of the prism around a cylinder or cone, whose corners are looked at. */
    private static final int SIDES = 16;

    /** How much farther from the axis than its faces the corners of a regular prism are. */
    private static final double CORNER = 1 / StrictMath.cos(Math.PI / SIDES);

    private Nesting() {}

    /**
     * Whether that is sure: the other one is convex, and the corners of a polyhedron around the first are in it; of balls it is always known.
     *
     * @param margin how far the surfaces are at least from each other then: more than roundings
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
