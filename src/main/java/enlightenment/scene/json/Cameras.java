package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.math.Vec3;
import java.util.Map;

/** The camera. */
final class Cameras {
    static final Family<Camera> FAMILY = new Family<Camera>(
                    "camera", "a camera", null, Map.of(), Cameras::read, Cameras::write)
            .with("window", Camera.Window.class, "eye lowerLeft upperLeft upperRight lowerRight | pupilRadius")
            .with("perspective", Camera.Perspective.class, "eye lookAt fieldOfView | up")
            .with("orthographic", Camera.Orthographic.class, "eye lookAt height | up")
            .with("isometric", Camera.Isometric.class, "lookAt height |");

    private Cameras() {}

    private static Camera read(String type, Fields f) {
        return switch (type) {
            case "window" -> window(f);
            case "perspective" -> perspective(f);
            case "orthographic" -> orthographic(f);
            case "isometric" -> isometric(f);
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
                    .number("fieldOfView", c.fieldOfView());
        } else if (value instanceof Camera.Orthographic c) {
            p.point("eye", c.eye())
                    .point("lookAt", c.lookAt())
                    .vector("up", c.up())
                    .number("height", c.height());
        } else if (value instanceof Camera.Isometric c) {
            p.point("lookAt", c.lookAt()).number("height", c.height());
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
        return f.make(() -> new Camera.Perspective(eye, lookAt, up, fieldOfView));
    }

    private static Camera orthographic(Fields f) {
        var eye = f.point("eye");
        var lookAt = f.point("lookAt");
        Vec3 up = f.direction("up", Vec3.Y);
        double height = f.number("height");
        return f.make(() -> new Camera.Orthographic(eye, lookAt, up, height));
    }

    private static Camera isometric(Fields f) {
        var lookAt = f.point("lookAt");
        double height = f.number("height");
        return f.make(() -> new Camera.Isometric(lookAt, height));
    }
}
