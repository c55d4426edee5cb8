package enlightenment.scene.json;

import enlightenment.geometry.Transform;
import enlightenment.geometry.Transform.Matrix;
import enlightenment.geometry.Transform.Rotate;
import enlightenment.geometry.Transform.RotateAbout;
import enlightenment.geometry.Transform.Scale;
import enlightenment.geometry.Transform.Step;
import enlightenment.geometry.Transform.Translate;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import java.util.ArrayList;
import java.util.List;

/** Reads and writes transforms: lists of steps, each an object of one key, applied first to last. */
final class Transforms {
    static final Keys SCALE = Keys.of("scaleStep", "a step of a transform", "scale", "");
    static final Keys ROTATE = Keys.of("rotateStep", "a step of a transform", "rotate", "");
    static final Keys ABOUT = Keys.of("rotateAboutStep", "a step of a transform", "axis angle", "");
    static final Keys TRANSLATE = Keys.of("translateStep", "a step of a transform", "translate", "");
    static final Keys MATRIX = Keys.of("matrixStep", "a step of a transform", "matrix", "");

    static final List<Keys> ALL = List.of(SCALE, ROTATE, ABOUT, TRANSLATE, MATRIX);

    private static final String STEP =
            "a step: {\"scale\": ...}, {\"rotate\": [x, y, z]}, {\"axis\": [x, y, z], \"angle\": ...},"
                    + " {\"translate\": [x, y, z]} or {\"matrix\": [12 numbers]}";

    private Transforms() {}

    /** The transform of a part; the identity where it has none, null after a problem. */
    static Transform read(Fields f) {
        if (!f.has("transform")) {
            return Transform.IDENTITY;
        }
        JsonPointer place = f.at("transform");
        Values values = f.values();
        JsonValue.Arr a = values.array(f.get("transform"), place, -1, "an array of steps");
        List<Step> steps = new ArrayList<>();
        for (int i = 0; a != null && i < a.size(); i++) {
            steps.add(step(a.get(i), place.child(i), values));
        }
        return a == null || steps.contains(null)
                ? null
                : values.make(f.get("transform"), place, () -> Transform.of(steps));
    }

    private static Step step(JsonValue v, JsonPointer place, Values values) {
        JsonValue.Obj o = values.object(v, place, STEP);
        if (o == null) {
            return null;
        }
        for (Keys keys : ALL) {
            if (o.get(keys.required().get(0)) != null) {
                Fields f = Fields.of(v, place, keys, values);
                return f == null ? null : step(keys, f);
            }
        }
        List<String> kinds = ALL.stream().map(k -> k.required().get(0)).toList();
        values.problems().add(v, place, "must be " + STEP + ", not " + Values.describe(o, kinds));
        return null;
    }

    private static Step step(Keys keys, Fields f) {
        if (keys == SCALE) {
            Vec3 factors = factors(f);
            return f.make(() -> new Scale(factors));
        } else if (keys == ROTATE) {
            Vec3 degrees = f.angles("rotate", Vec3.ZERO);
            return f.make(() -> new Rotate(degrees));
        } else if (keys == ABOUT) {
            Vec3 axis = f.direction("axis", Vec3.Y);
            double angle = f.number("angle");
            return f.make(() -> new RotateAbout(axis, angle));
        } else if (keys == TRANSLATE) {
            ExactPoint offset = f.point("translate");
            return f.make(() -> new Translate(offset));
        }
        return matrix(f);
    }

    /** The factors along the axes; a single number is used for all three. */
    private static Vec3 factors(Fields f) {
        if (f.get("scale") instanceof JsonValue.Num) {
            double s = f.number("scale");
            return new Vec3(s, s, s);
        }
        return f.values().vector(f.get("scale"), f.at("scale"), "a factor, or three factors [x, y, z]");
    }

    private static Step matrix(Fields f) {
        Values values = f.values();
        JsonPointer place = f.at("matrix");
        JsonValue.Arr a =
                values.array(f.get("matrix"), place, 12, "an array of 12 numbers: three rows of four, offsets last");
        if (a == null) {
            return null;
        }
        Vec3[] rows = new Vec3[3];
        for (int k = 0; k < 3; k++) {
            rows[k] = new Vec3(
                    values.number(a.get(4 * k), place.child(4 * k)),
                    values.number(a.get(4 * k + 1), place.child(4 * k + 1)),
                    values.number(a.get(4 * k + 2), place.child(4 * k + 2)));
        }
        ExactPoint offset = new ExactPoint(
                values.exact(a.get(3), place.child(3)),
                values.exact(a.get(7), place.child(7)),
                values.exact(a.get(11), place.child(11)));
        return f.make(() -> new Matrix(rows[0], rows[1], rows[2], offset));
    }

    /** Puts the steps; the identity has none and no key. */
    static void write(Transform transform, JsonObjectBuilder p) {
        List<JsonValue> steps = new ArrayList<>();
        for (Step step : transform.steps()) {
            JsonObjectBuilder s = p.child("transform", steps.size());
            if (step instanceof Scale scale) {
                write(scale.factors(), s);
            } else if (step instanceof Rotate rotate) {
                s.vector("rotate", rotate.degrees());
            } else if (step instanceof RotateAbout about) {
                s.vector("axis", about.axis()).number("angle", about.degrees());
            } else if (step instanceof Translate move) {
                s.point("translate", move.offset());
            } else if (step instanceof Matrix m) {
                s.matrix("matrix", m);
            } else {
                throw Family.unknown(step);
            }
            steps.add(s.json());
        }
        if (!steps.isEmpty()) {
            p.put("transform", JsonValue.Arr.of(steps));
        }
    }

    private static void write(Vec3 factors, JsonObjectBuilder s) {
        boolean isOne = factors.x() == factors.y() && factors.y() == factors.z();
        if (isOne
                && !s.child("scale").animated("0")
                && !s.child("scale").animated("1")
                && !s.child("scale").animated("2")) {
            s.number("scale", factors.x());
        } else {
            s.vector("scale", factors);
        }
    }
}
