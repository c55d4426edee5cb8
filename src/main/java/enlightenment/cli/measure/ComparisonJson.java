package enlightenment.cli.measure;

import enlightenment.cli.terminal.Version;
import enlightenment.image.ImageError;
import enlightenment.json.JsonText;
import tools.jackson.core.JsonGenerator;

/** The JSON of a comparison, with all digits; docs/guide/compare.md lists the keys. */
final class ComparisonJson {
    private ComparisonJson() {}

    static String of(Comparison c) {
        return JsonText.of(json -> comparison(json, c));
    }

    private static void comparison(JsonGenerator json, Comparison c) {
        ImageError error = c.error();
        json.writeStartObject();
        json.writeStringProperty("enlightenment", Version.number());
        json.writeStringProperty("test", c.test().toString());
        json.writeStringProperty("reference", c.reference().toString());
        json.writeNumberProperty("width", c.flip().width());
        json.writeNumberProperty("height", c.flip().height());
        json.writeNumberProperty("rmse", error.rmse());
        json.writeNumberProperty("relativeMse", error.relativeMeanSquaredError());
        json.writeNumberProperty("meanAbsoluteError", error.meanAbsoluteError());
        json.writeNumberProperty("psnr", error.psnr());
        if (c.light() != null) {
            light(json, c.light());
        }
        json.writeObjectPropertyStart("flip");
        json.writeNumberProperty("mean", c.flip().mean());
        json.writeNumberProperty("largest", (double) c.flip().largest());
        json.writeNumberProperty("pixelsPerDegree", c.pixelsPerDegree());
        json.writeEndObject();
        json.writeObjectPropertyStart("largestDifference");
        json.writeNumberProperty("value", error.largest().difference());
        json.writeNumberProperty("column", error.largest().column());
        json.writeNumberProperty("row", error.largest().row());
        json.writeStringProperty("channel", error.largest().channelName());
        json.writeEndObject();
        if (c.maxRmse() != null) {
            json.writeNumberProperty("maxRmse", c.maxRmse().doubleValue());
            json.writeBooleanProperty("passed", c.passed());
        }
        json.writeEndObject();
    }

    private static void light(JsonGenerator json, ImageError.OfLight light) {
        json.writeObjectPropertyStart("light");
        number(json, "relative", light.relative());
        number(json, "rmse", light.rmse());
        number(json, "red", light.red());
        number(json, "green", light.green());
        number(json, "blue", light.blue());
        json.writeEndObject();
    }

    /** Left out where it is infinite or not known, since the reference is black. */
    private static void number(JsonGenerator json, String key, double value) {
        if (Double.isFinite(value)) {
            json.writeNumberProperty(key, value);
        }
    }
}
