package enlightenment.view;

import enlightenment.camera.Camera;
import enlightenment.image.Image;
import enlightenment.json.JsonText;
import enlightenment.math.Vec3;
import enlightenment.scene.Animation;
import enlightenment.view.frame.Frame;
import java.util.Locale;
import java.util.Optional;
import tools.jackson.core.JsonGenerator;

/** The state of a view as JSON; docs/guide/view.md describes it. */
final class ViewJson {
    private ViewJson() {}

    /**
     * The state of a view.
     *
     * @param title the title of the page
     * @param refusal the reason why the view cannot be saved, or ""
     */
    static String state(Snapshot s, String title, String refusal) {
        return JsonText.of(json -> {
            json.writeStartObject();
            json.writeStringProperty("title", title);
            json.writeNumberProperty("version", s.version());
            json.writeNumberProperty("picture", s.frame() == null ? 0 : s.picture());
            json.writeNumberProperty(
                    "samples", s.frame() == null ? 0 : s.frame().samples());
            json.writeNumberProperty("shrink", s.frame() == null ? 0 : s.frame().shrink());
            json.writeBooleanProperty("current", s.isUpToDate());
            json.writeBooleanProperty("finished", s.isUpToDate() && s.frame().isFinal());
            json.writeNumberProperty("width", s.size() == null ? 0 : s.size().width());
            json.writeNumberProperty("height", s.size() == null ? 0 : s.size().height());
            camera(json, s);
            if (s.isLinear()) {
                json.writeNumberProperty("exposure", s.exposure());
            } else {
                json.writeNullProperty("exposure");
            }
            animation(json, s);
            json.writeBooleanProperty("moved", s.isMoved());
            json.writeStringProperty("refusal", refusal);
            json.writeStringProperty("note", s.note());
            json.writeBooleanProperty("albedo", s.isLinear());
            json.writeArrayPropertyStart("layers");
            for (Layer layer : Layer.values()) {
                if (LayerPicture.exists(layer, s)) {
                    json.writeString(layer.word());
                }
            }
            json.writeEndArray();
            json.writeNumberProperty("kept", s.kept() == null ? 0 : s.kept().number());
            json.writeNumberProperty(
                    "keptSamples", s.kept() == null ? 0 : s.kept().samples());
            json.writeArrayPropertyStart("problems");
            s.problems().forEach(json::writeString);
            json.writeEndArray();
            json.writeEndObject();
        });
    }

    private static void animation(JsonGenerator json, Snapshot s) {
        Optional<Animation> animation =
                s.scene() == null ? Optional.empty() : s.scene().animation();
        json.writeNumberProperty("frames", animation.map(Animation::frames).orElse(0));
        json.writeNumberProperty(
                "framesPerSecond", animation.map(Animation::framesPerSecond).orElse(0.0));
        if (s.moment().isPresent()) {
            json.writeNumberProperty("frame", s.moment().getAsInt());
        } else {
            json.writeNullProperty("frame");
        }
    }

    private static void camera(JsonGenerator json, Snapshot s) {
        Camera camera = s.viewpoint() == null ? null : s.viewpoint().camera();
        json.writeStringProperty("camera", camera == null ? "" : camera.type());
        json.writeBooleanProperty("turns", !(camera instanceof Camera.Isometric));
        json.writeBooleanProperty(
                "focuses", camera instanceof Camera.Perspective c && c.lens().isPresent());
        if (camera instanceof Camera.Perspective c) {
            json.writeNumberProperty("fieldOfView", c.fieldOfView());
        } else {
            json.writeNullProperty("fieldOfView");
        }
    }

    /**
     * Object, material, hit and colour of a pixel.
     *
     * @param view the state of the view, with its last picture
     * @param x place in the picture, 0..1 from its left
     * @param y place in the picture, 0..1 from its top
     */
    static String pixel(PixelProbe pixel, Snapshot view, double x, double y) {
        Frame frame = view.frame();
        return JsonText.of(json -> {
            json.writeStartObject();
            json.writeStringProperty("object", pixel.object().orElse("nothing"));
            if (pixel.material().isPresent()) {
                json.writeStringProperty("material", pixel.material().get());
            }
            if (pixel.isHit()) {
                json.writeNumberProperty("depth", pixel.depth());
                vector(json, "point", pixel.point());
                vector(json, "normal", pixel.normal());
            }
            if (frame != null) {
                Image picture = frame.image();
                int column = Math.min((int) (x * picture.width()), picture.width() - 1);
                int row = Math.min((int) (y * picture.height()), picture.height() - 1);
                light(json, frame, column, row);
                json.writeStringProperty("unit", picture.encoding().name().toLowerCase(Locale.ROOT));
            }
            json.writeEndObject();
        });
    }

    /** Value, standard error and number of samples of a pixel of the picture. */
    private static void light(JsonGenerator json, Frame frame, int column, int row) {
        json.writeArrayPropertyStart("value");
        for (int c = 0; c < 3; c++) {
            json.writeNumber(frame.image().component(column, row, c));
        }
        json.writeEndArray();
        frame.detail().noise().ifPresent(noise -> {
            json.writeArrayPropertyStart("error");
            for (int c = 0; c < 3; c++) {
                json.writeNumber((float) noise.deviation(column, row, c));
            }
            json.writeEndArray();
        });
        json.writeNumberProperty("samples", frame.detail().samples().component(column, row, 0));
    }

    /** A vector with float precision. */
    private static void vector(JsonGenerator json, String key, Vec3 v) {
        json.writeArrayPropertyStart(key);
        json.writeNumber((float) v.x());
        json.writeNumber((float) v.y());
        json.writeNumber((float) v.z());
        json.writeEndArray();
    }
}
