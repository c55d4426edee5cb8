package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.math.Check.InvalidValueException;
import enlightenment.math.Point;
import enlightenment.math.Vec3;

/** Reads the camera. */
final class CameraBinder {
    private CameraBinder() {}

    /** The camera, or null after a problem. */
    static Camera read(Fields f, Problems problems) {
        String type = f.requiredWord("type", "a type of camera", "window", "perspective", "orthographic", "isometric");
        if (type == null) {
            return null;
        }
        try {
            switch (type) {
                case "window":
                    return window(f);
                case "perspective":
                    return perspective(f);
                case "orthographic":
                    return orthographic(f);
                default:
                    f.only("an isometric camera", "type", "lookAt", "height");
                    Point lookAt = f.point("lookAt");
                    double height = f.number("height");
                    return f.sound() ? new Camera.Isometric(lookAt, height) : null;
            }
        } catch (InvalidValueException e) {
            // The window's corners are checked as an array "", but are keys of their own.
            String key = e.key().equals("/2") ? "upperRight" : e.key();
            problems.at(f.object, key, e.getMessage());
            return null;
        }
    }

    private static Camera window(Fields f) {
        f.only("a window camera", "type", "eye", "lowerLeft", "upperLeft", "upperRight", "lowerRight", "pupilRadius");
        Point eye = f.point("eye");
        Point lowerLeft = f.point("lowerLeft");
        Point upperLeft = f.point("upperLeft");
        Point upperRight = f.point("upperRight");
        Point lowerRight = f.point("lowerRight");
        double pupilRadius = f.number("pupilRadius", 0);
        return f.sound() ? new Camera.Window(eye, lowerLeft, upperLeft, upperRight, lowerRight, pupilRadius) : null;
    }

    private static Camera perspective(Fields f) {
        f.only("a perspective camera", "type", "eye", "lookAt", "up", "fieldOfView");
        Point eye = f.point("eye");
        Point lookAt = f.point("lookAt");
        Vec3 up = f.direction("up");
        double fieldOfView = f.number("fieldOfView");
        return f.sound() ? new Camera.Perspective(eye, lookAt, up, fieldOfView) : null;
    }

    private static Camera orthographic(Fields f) {
        f.only("an orthographic camera", "type", "eye", "lookAt", "up", "height");
        Point eye = f.point("eye");
        Point lookAt = f.point("lookAt");
        Vec3 up = f.direction("up");
        double height = f.number("height");
        return f.sound() ? new Camera.Orthographic(eye, lookAt, up, height) : null;
    }
}
