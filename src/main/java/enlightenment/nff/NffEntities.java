package enlightenment.nff;

import enlightenment.color.DisplayRgb;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Reads one entity after the other. */
final class NffEntities {
    private static final Set<String> KEYS = Set.of("v", "b", "l", "f", "c", "s", "p", "pp");
    private static final Set<String> VIEW_KEYS = Set.of("from", "at", "up", "angle", "hither", "resolution");
    private static final int MAX_VERTICES = 1_000_000;

    private final Tokens tokens;
    private final NffSceneBuilder scene;

    NffEntities(Tokens tokens, NffSceneBuilder scene) {
        this.tokens = tokens;
        this.scene = scene;
    }

    /** After a problem: what follows up to the next entity belongs to the broken one. */
    void skipToNext() {
        while (!tokens.peek().isEnd() && !KEYS.contains(tokens.peek().text())) {
            tokens.take();
        }
    }

    void readNext() throws NffSyntaxException {
        NffToken key = tokens.take();
        switch (key.text()) {
            case "v" -> view(key);
            case "b" -> scene.background(color("the background's"));
            case "l" -> light(key);
            case "f" -> fill(key);
            case "c" -> cone(key);
            case "s" -> scene.sphere(key, tokens.point("the sphere's centre"), tokens.number("the sphere's radius"));
            case "p" -> polygon(key, false);
            case "pp" -> polygon(key, true);
            default ->
                throw new NffSyntaxException(
                        key,
                        "expected an entity (v, b, l, f, c, s, p or pp), not " + key.quoted()
                                + (key.startsLikeNumber() ? ": more numbers than the entity before it has" : ""));
        }
    }

    private DisplayRgb color(String whose) throws NffSyntaxException {
        double r = unit(whose + " red");
        double g = unit(whose + " green");
        return new DisplayRgb(r, g, unit(whose + " blue"));
    }

    private double unit(String what) throws NffSyntaxException {
        NffToken t = tokens.peek();
        double v = tokens.number(what);
        if (v < 0 || v > 1) {
            throw new NffSyntaxException(t, "expected " + what + " in 0..1, not " + t.quoted());
        }
        return v;
    }

    private double notNegative(String what) throws NffSyntaxException {
        NffToken t = tokens.peek();
        double v = tokens.number(what);
        if (v < 0) {
            throw new NffSyntaxException(t, "expected " + what + " of at least 0, not " + t.quoted());
        }
        return v;
    }

    private void light(NffToken key) throws NffSyntaxException {
        ExactPoint position = tokens.point("the light's");
        if (!tokens.peek().startsLikeNumber()) {
            scene.light(key, position, new Vec3(1, 1, 1));
            return;
        }
        double r = notNegative("the light's red");
        double g = notNegative("the light's green");
        scene.light(key, position, new Vec3(r, g, notNegative("the light's blue")));
    }

    private void fill(NffToken key) throws NffSyntaxException {
        DisplayRgb color = color("the fill's");
        double diffuse = notNegative("Kd");
        double specular = notNegative("Ks");
        tokens.number("Shine");
        double transmittance = notNegative("T");
        double index = tokens.number("the index of refraction");
        scene.fill(key, new NffFill(color, diffuse, specular, transmittance, index));
    }

    private void cone(NffToken key) throws NffSyntaxException {
        ExactPoint base = tokens.point("the base's centre");
        double baseRadius = tokens.number("the base's radius");
        ExactPoint apex = tokens.point("the apex's centre");
        double apexRadius = tokens.number("the apex's radius");
        if (base.equals(apex)) {
            throw new NffSyntaxException(key, "expected a cone whose base and apex are different points");
        }
        if (baseRadius * apexRadius < 0) {
            throw new NffSyntaxException(key, "expected a cone with two radii of the same sign");
        }
        scene.cone(key, base, baseRadius, apex, apexRadius);
    }

    private void polygon(NffToken key, boolean patch) throws NffSyntaxException {
        int n = tokens.count("the number of vertices", 3, MAX_VERTICES);
        List<ExactPoint> vertices = new ArrayList<>();
        for (int i = 1; i <= n; i++) {
            vertices.add(tokens.point("vertex " + i + " of " + n + ":"));
            if (patch) {
                tokens.direction("the normal of vertex " + i + " of " + n + ":");
            }
        }
        scene.polygon(key, vertices, patch);
    }

    private void view(NffToken key) throws NffSyntaxException {
        if (scene.hasView()) {
            throw new NffSyntaxException(key, "expected only one view in the file");
        }
        ExactPoint from = null;
        ExactPoint at = null;
        Vec3 up = null;
        double angle = 0;
        BigDecimal hither = BigDecimal.ZERO;
        int width = 0;
        int height = 0;
        Set<String> seen = new HashSet<>();
        while (VIEW_KEYS.contains(tokens.peek().text())) {
            NffToken k = tokens.take();
            if (!seen.add(k.text())) {
                throw new NffSyntaxException(k, "expected \"" + k.text() + "\" only once in a view");
            }
            switch (k.text()) {
                case "from" -> from = tokens.point("from");
                case "at" -> at = tokens.point("at");
                case "up" -> up = tokens.direction("up");
                case "angle" -> angle = angle();
                case "hither" -> hither = tokens.decimal("hither");
                default -> {
                    width = tokens.count("the resolution in x", 1, Scene.MAX_SIDE);
                    height = tokens.count("the resolution in y", 1, Scene.MAX_SIDE);
                }
            }
        }
        requireAll(seen);
        scene.view(key, new NffView(from, at, up, angle, hither.doubleValue(), width, height));
    }

    private void requireAll(Set<String> seen) throws NffSyntaxException {
        for (String required : List.of("from", "at", "up", "angle", "resolution")) {
            if (!seen.contains(required)) {
                NffToken next = tokens.peek();
                throw new NffSyntaxException(next, "expected \"" + required + "\" in the view, not " + next.quoted());
            }
        }
    }

    private double angle() throws NffSyntaxException {
        NffToken t = tokens.peek();
        double v = tokens.number("the view's angle");
        if (!(v > 0 && v < 180)) {
            throw new NffSyntaxException(t, "expected the view's angle between 0 and 180 degrees, not " + t.quoted());
        }
        return v;
    }
}
