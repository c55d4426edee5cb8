package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.json.JsonText;
import enlightenment.view.frame.ErrorPoint;
import java.util.List;

/** Answers of {@link LookPages} as JSON; docs/guide/view.md describes them. */
final class LookJson {
    private LookJson() {}

    /** Size, explanation, scale and legend of a layer. */
    static String layer(Layer layer, LayerPicture picture) {
        return JsonText.of(json -> {
            json.writeStartObject();
            json.writeStringProperty("layer", layer.word());
            json.writeNumberProperty("width", picture.image().width());
            json.writeNumberProperty("height", picture.image().height());
            json.writeStringProperty("explanation", picture.explanation());
            json.writeArrayPropertyStart("marks");
            picture.marks().forEach(json::writeString);
            json.writeEndArray();
            json.writeArrayPropertyStart("legend");
            for (Legend.Entry entry : picture.legend().entries()) {
                json.writeStartObject();
                json.writeStringProperty("name", entry.name());
                json.writeStringProperty("color", entry.color());
                json.writeNumberProperty("share", entry.share());
                json.writeEndObject();
            }
            json.writeEndArray();
            json.writeNumberProperty("more", picture.legend().more());
            picture.rmse().ifPresent(v -> json.writeNumberProperty("rmse", v));
            picture.noise().ifPresent(v -> json.writeNumberProperty("noise", v));
            json.writeEndObject();
        });
    }

    /** The name of the object or material at a pixel. */
    static String name(String name) {
        return JsonText.of(json -> {
            json.writeStartObject();
            json.writeStringProperty("name", name);
            json.writeEndObject();
        });
    }

    /** The leading components of a pixel, up to the first that is not finite. */
    static String values(Image numbers, int components, int x, int y) {
        return JsonText.of(json -> {
            json.writeStartObject();
            json.writeArrayPropertyStart("values");
            for (int c = 0; c < components && Float.isFinite(numbers.component(x, y, c)); c++) {
                json.writeNumber(numbers.component(x, y, c));
            }
            json.writeEndArray();
            json.writeEndObject();
        });
    }

    /** Estimated errors of the picture over time. */
    static String convergence(List<ErrorPoint> points) {
        return JsonText.of(json -> {
            json.writeStartObject();
            json.writeArrayPropertyStart("points");
            for (ErrorPoint p : points) {
                json.writeStartObject();
                json.writeNumberProperty("seconds", p.seconds());
                json.writeNumberProperty("samples", p.samples());
                json.writeNumberProperty("error", p.rmse());
                json.writeEndObject();
            }
            json.writeEndArray();
            json.writeEndObject();
        });
    }
}
