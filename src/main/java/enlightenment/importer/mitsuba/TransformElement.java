package enlightenment.importer.mitsuba;

import enlightenment.importer.support.Affine;
import enlightenment.math.Vec3;

/** Transforms: steps that are applied one after the other, the first one first. */
final class TransformElement {
    private TransformElement() {}

    /** The map of an element's steps. */
    static Affine map(XmlElement transform) {
        Affine map = Affine.IDENTITY;
        for (XmlElement step : transform.children()) {
            map = step(step).after(map);
        }
        return map;
    }

    private static Affine step(XmlElement e) {
        try {
            return switch (e.tag()) {
                case "translate" -> {
                    Vec3 v = Properties.vector(e);
                    yield Affine.translate(v.x(), v.y(), v.z());
                }
                case "scale" -> {
                    Vec3 v = Properties.vector(e, 1);
                    yield Affine.scale(v.x(), v.y(), v.z());
                }
                case "rotate" -> rotation(e);
                case "matrix" -> matrix(e);
                case "lookat" -> Affine.lookAt(point(e, "origin"), point(e, "target"), up(e));
                default ->
                    throw e.failure("is no step of a transform: those are translate, scale, rotate, matrix, lookat");
            };
        } catch (IllegalArgumentException problem) {
            throw e.failure(problem.getMessage());
        }
    }

    private static Affine rotation(XmlElement e) {
        Vec3 axis = Properties.vector(e);
        if (axis.maxAbs() == 0) {
            throw e.failure("turns about an axis without a direction");
        }
        return Affine.rotate(axis, Properties.number(e, e.attribute("angle")));
    }

    private static Affine matrix(XmlElement e) {
        double[] m = Properties.numbers(e, e.attribute("value"));
        if (m.length == 9) {
            return new Affine(
                    new Vec3(m[0], m[1], m[2]),
                    new Vec3(m[3], m[4], m[5]),
                    new Vec3(m[6], m[7], m[8]),
                    new Vec3(0, 0, 0));
        }
        if (m.length != 16) {
            throw e.failure("must be 16 numbers, row by row, or 9, not " + m.length);
        }
        return Affine.ofRows(m);
    }

    private static Vec3 point(XmlElement e, String key) {
        double[] v = Properties.numbers(e, e.attribute(key));
        if (v.length != 3) {
            throw e.failure("must be three numbers in " + key);
        }
        return new Vec3(v[0], v[1], v[2]);
    }

    /** Without an up, any that is not along the view. */
    private static Vec3 up(XmlElement e) {
        if (e.has("up")) {
            Vec3 up = point(e, "up");
            if (up.maxAbs() > 0) {
                return up;
            }
        }
        Vec3 d = point(e, "target").minus(point(e, "origin"));
        return d.x() == 0 && d.z() == 0 ? Vec3.Z : Vec3.Y;
    }
}
