package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.math.Vec3;
import java.util.List;

/** Reads the camera. */
final class Cameras {
    private static final Fields.Family FAMILY = new Fields.Family("a camera", Vocabulary.CAMERAS, List.of(), List.of());

    private Cameras() {}

    /** The camera, or null after a problem. */
    static Camera read(JsonValue v, JsonPointer place, Values values) {
        Fields f = Fields.of(v, place, FAMILY, null, values);
        if (f == null) {
            return null;
        }
        switch (f.type(null)) {
            case "window":
                return window(f);
            case "perspective":
                return perspective(f);
            case "orthographic":
                return orthographic(f);
            default:
                return isometric(f);
        }
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
