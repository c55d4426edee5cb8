package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.math.Vec3;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonValue;
import java.util.Map;
import java.util.Optional;

/** Reads and writes the camera. */
final class Cameras {
    static final Family<Camera> FAMILY = new Family<Camera>(
                    "camera", "a camera", null, Map.of(), Cameras::read, Cameras::write)
            .with("window", Camera.Window.class, "eye lowerLeft upperLeft upperRight lowerRight | pupilRadius")
            .with(
                    "perspective",
                    Camera.Perspective.class,
                    "eye lookAt fieldOfView | up fieldOfViewAxis handedness lens")
            .with("orthographic", Camera.Orthographic.class, "eye lookAt height | up handedness")
            .with("isometric", Camera.Isometric.class, "lookAt height |")
            .with("panorama", Camera.Panorama.class, "eye lookAt | up handedness eyeSeparation");

    private Cameras() {}

    private static Camera read(String type, Fields f) {
        return switch (type) {
            case "window" -> window(f);
            case "perspective" -> perspective(f);
            case "orthographic" -> orthographic(f);
            case "isometric" -> isometric(f);
            case "panorama" -> panorama(f);
            default -> throw Family.unknown(type);
        };
    }

    private static void write(Camera value, JsonObjectBuilder p) {
        if (value instanceof Camera.Window w) {
            p.point("eye", w.eye())
                    .point("lowerLeft", w.lowerLeft())
                    .point("upperLeft", w.upperLeft())
                    .point("upperRight", w.upperRight())
                    .point("lowerRight", w.lowerRight())
                    .numberUnless(0, "pupilRadius", w.pupilRadius());
        } else if (value instanceof Camera.Perspective c) {
            p.point("eye", c.eye())
                    .point("lookAt", c.lookAt())
                    .vector("up", c.up())
                    .number("fieldOfView", c.fieldOfView())
                    .wordUnless(Camera.FieldOfViewAxis.VERTICAL, "fieldOfViewAxis", c.axis())
                    .wordUnless(Camera.Handedness.LEFT, "handedness", c.handedness());
            c.lens()
                    .ifPresent(
                            lens -> p.put("lens", write(lens, p.child("lens")).json()));
        } else if (value instanceof Camera.Orthographic c) {
            p.point("eye", c.eye())
                    .point("lookAt", c.lookAt())
                    .vector("up", c.up())
                    .number("height", c.height())
                    .wordUnless(Camera.Handedness.LEFT, "handedness", c.handedness());
        } else if (value instanceof Camera.Isometric c) {
            p.point("lookAt", c.lookAt()).number("height", c.height());
        } else if (value instanceof Camera.Panorama c) {
            p.point("eye", c.eye())
                    .point("lookAt", c.lookAt())
                    .vector("up", c.up())
                    .numberUnless(0, "eyeSeparation", c.eyeSeparation())
                    .wordUnless(Camera.Handedness.LEFT, "handedness", c.handedness());
        } else {
            throw Family.unknown(value);
        }
    }

    /** The camera, or null after a problem. */
    static Camera read(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, FAMILY, values);
        return f == null ? null : FAMILY.read(f);
    }

    private static Camera window(Fields f) {
        var eye = f.point("eye");
        var lowerLeft = f.point("lowerLeft");
        var upperLeft = f.point("upperLeft");
        var upperRight = f.point("upperRight");
        var lowerRight = f.point("lowerRight");
        double pupilRadius = f.number("pupilRadius", 0);
        return f.make(() -> new Camera.Window(eye, lowerLeft, upperLeft, upperRight, lowerRight, pupilRadius));
    }

    private static Camera perspective(Fields f) {
        var eye = f.point("eye");
        var lookAt = f.point("lookAt");
        Vec3 up = f.direction("up", Vec3.Y);
        double fieldOfView = f.number("fieldOfView");
        Camera.FieldOfViewAxis axis = f.word("fieldOfViewAxis", Camera.FieldOfViewAxis.VERTICAL);
        Camera.Handedness handedness = f.word("handedness", Camera.Handedness.LEFT);
        Optional<Camera.Lens> lens = f.has("lens") ? Optional.ofNullable(lens(f)) : Optional.empty();
        return f.make(() -> new Camera.Perspective(eye, lookAt, up, fieldOfView, axis, handedness, lens));
    }

    private static Camera orthographic(Fields f) {
        var eye = f.point("eye");
        var lookAt = f.point("lookAt");
        Vec3 up = f.direction("up", Vec3.Y);
        double height = f.number("height");
        Camera.Handedness handedness = f.word("handedness", Camera.Handedness.LEFT);
        return f.make(() -> new Camera.Orthographic(eye, lookAt, up, height, handedness));
    }

    /** The lens of a perspective camera; null after a problem. */
    private static Camera.Lens lens(Fields camera) {
        Fields f = Fields.of(camera.get("lens"), camera.at("lens"), PartKeys.LENS, camera.values());
        if (f == null) {
            return null;
        }
        double radius = f.number("radius");
        double focusDistance = f.number("focusDistance");
        int blades = f.integer("blades", 0, Camera.Lens.MOST_BLADES, 0);
        double rotation = f.number("rotation", 0);
        return f.make(() -> new Camera.Lens(radius, focusDistance, blades, rotation));
    }

    private static JsonObjectBuilder write(Camera.Lens lens, JsonObjectBuilder p) {
        return p.number("radius", lens.radius())
                .number("focusDistance", lens.focusDistance())
                .wholeUnless(0, "blades", lens.blades())
                .numberUnless(0, "rotation", lens.rotation());
    }

    private static Camera panorama(Fields f) {
        var eye = f.point("eye");
        var lookAt = f.point("lookAt");
        Vec3 up = f.direction("up", Vec3.Y);
        double eyeSeparation = f.number("eyeSeparation", 0);
        Camera.Handedness handedness = f.word("handedness", Camera.Handedness.LEFT);
        return f.make(() -> new Camera.Panorama(eye, lookAt, up, eyeSeparation, handedness));
    }

    private static Camera isometric(Fields f) {
        var lookAt = f.point("lookAt");
        double height = f.number("height");
        return f.make(() -> new Camera.Isometric(lookAt, height));
    }
}
