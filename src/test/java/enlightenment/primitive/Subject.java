package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.util.List;

/**
 * A primitive to intersect: as the renderer does it, as textbooks do it, and exactly.
 *
 * @param kind the scene format's word for it
 * @param ours the renderer's primitive
 * @param naive the textbook's form
 * @param truth decimal arithmetic
 * @param center the middle of its bounds
 * @param size its largest extent
 */
record Subject(String kind, Primitive ours, NaiveForms.Form naive, Truth truth, Vec3 center, double size) {
    static final List<String> KINDS = List.of("sphere", "cylinder", "cone", "torus", "box", "triangle");

    private static Subject of(String kind, Primitive ours, NaiveForms.Form naive, Truth truth) {
        Vec3 center = ours.bounds().min().times(0.5).plus(ours.bounds().max().times(0.5));
        return new Subject(
                kind, ours, naive, truth, center, ours.bounds().extent().maxAbs());
    }

    static Subject sphere(Vec3 center, double radius) {
        SpherePrimitive p = new SpherePrimitive(center, radius, new Vec3(0, 0, -1));
        return of("sphere", p, NaiveForms.sphere(center, radius), Truth.of(ExactSolid.of(p)));
    }

    static Subject cylinder(Vec3 base, Vec3 top, double radius) {
        CylinderPrimitive p = new CylinderPrimitive(base, top, radius, true);
        return of("cylinder", p, NaiveForms.cylinder(base, top, radius), Truth.of(ExactSolid.of(p)));
    }

    static Subject cone(Vec3 base, Vec3 apex, double radius) {
        ConePrimitive p = new ConePrimitive(base, apex, radius, 0, true);
        return of("cone", p, NaiveForms.cone(base, apex, radius), Truth.of(ExactSolid.of(p)));
    }

    static Subject torus(Vec3 center, Vec3 axis, double major, double minor) {
        TorusPrimitive p = new TorusPrimitive(center, axis.normalized(), major, minor);
        return of("torus", p, NaiveForms.torus(center, axis, major, minor), Truth.torus(center, axis, major, minor));
    }

    static Subject box(Vec3 min, Vec3 max) {
        return of("box", new BoxPrimitive(min, max), NaiveForms.box(min, max), Truth.box(min, max));
    }

    static Subject triangle(Vec3 a, Vec3 b, Vec3 c) {
        return of("triangle", new TrianglePrimitive(a, b, c), NaiveForms.triangle(a, b, c), Truth.triangle(a, b, c));
    }

    /** The subject of a line of intersection-vectors.jsonl. */
    static Subject of(Vectors.Case c) {
        return switch (c.kind()) {
            case "sphere" -> sphere(c.triple("center"), c.number("radius"));
            case "cylinder" -> cylinder(c.triple("p1"), c.triple("p2"), c.number("radius"));
            case "cone" -> cone(c.triple("base"), c.triple("apex"), c.number("radius"));
            case "torus" -> torus(c.triple("center"), c.triple("axis"), c.number("major"), c.number("minor"));
            default -> throw new IllegalArgumentException(c.kind());
        };
    }

    /** A subject of about the given size, with its middle at the given place. */
    static Subject random(String kind, RandomRays random, double size, Vec3 at) {
        double r = size * (0.2 + 0.3 * random.uniform());
        Vec3 half = random.direction().times(size * (0.2 + 0.3 * random.uniform()));
        return switch (kind) {
            case "sphere" -> sphere(at, r);
            case "cylinder" -> cylinder(at.minus(half), at.plus(half), r);
            case "cone" -> cone(at.minus(half), at.plus(half), r);
            case "torus" -> torus(at, half, r, r * (0.1 + 0.5 * random.uniform()));
            case "box" -> {
                Vec3 h = new Vec3(r, size * (0.1 + 0.4 * random.uniform()), size * (0.1 + 0.4 * random.uniform()));
                yield box(at.minus(h), at.plus(h));
            }
            case "triangle" ->
                triangle(
                        at.plus(random.direction().times(r)),
                        at.plus(random.direction().times(r)),
                        at.plus(random.direction().times(r)));
            default -> throw new IllegalArgumentException(kind);
        };
    }

    /** A hit somewhere on the surface. */
    Hit surfacePoint(RandomRays random) {
        Hit hit = new Hit();
        while (true) {
            Vec3 o = center.plus(random.direction().times(3 * size));
            Vec3 target = center.plus(random.inCube().times(size / 2));
            if (ours.intersect(Ray.of(o, target.minus(o)), hit)) {
                return hit;
            }
        }
    }
}
