package enlightenment.scene.json;

import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.material.Medium;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import java.util.List;

/** Reads and writes participating media, those of solids and the medium that fills a scene. */
final class Media {
    private static final String LOOK = "\"color\" and \"meanFreePath\"";
    private static final String PHYSICS = "\"scatteringCoefficient\" and \"absorptionCoefficient\"";

    private Media() {}

    /** The medium of a part of its own; null after a problem. */
    static Medium read(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, PartKeys.MEDIUM, values);
        return f == null ? null : read(f);
    }

    /** The medium of a part that may have further keys; null after a problem. */
    static Medium read(Fields f) {
        boolean isPhysics = f.has("scatteringCoefficient") || f.has("absorptionCoefficient");
        boolean isLook = f.has("color") || f.has("meanFreePath");
        if (!isLook && !isPhysics) {
            f.problem("color", "missing; a medium has either " + LOOK + " or " + PHYSICS);
            return null;
        }
        List<String> keys =
                isLook ? List.of("color", "meanFreePath") : List.of("scatteringCoefficient", "absorptionCoefficient");
        if (isLook) {
            refuse(f, "scatteringCoefficient");
            refuse(f, "absorptionCoefficient");
        }
        for (String key : keys) {
            if (!f.has(key)) {
                f.problem(key, "missing; a medium has either " + LOOK + " or " + PHYSICS);
            }
        }
        double anisotropy = f.number("anisotropy", 0);
        Rgb second = f.bands(keys.get(1), Rgb.WHITE);
        if (isLook) {
            Color color = f.color("color", DisplayRgb.WHITE);
            return f.make(() -> new Medium.Colored(color, second, anisotropy));
        }
        Rgb first = f.bands(keys.get(0), Rgb.WHITE);
        return f.make(() -> new Medium.Coefficients(first, second, anisotropy));
    }

    private static void refuse(Fields f, String key) {
        if (f.has(key)) {
            f.problem(key, "stands beside " + LOOK + "; a medium has either these or " + PHYSICS);
        }
    }

    static JsonObjectBuilder write(Medium medium, JsonObjectBuilder p) {
        if (medium instanceof Medium.Colored c) {
            p.color("color", c.color()).bands("meanFreePath", c.meanFreePath());
        } else if (medium instanceof Medium.Coefficients c) {
            p.bands("scatteringCoefficient", c.scattering()).bands("absorptionCoefficient", c.absorption());
        } else {
            throw Family.unknown(medium);
        }
        return p.numberUnless(0, "anisotropy", medium.anisotropy());
    }
}
