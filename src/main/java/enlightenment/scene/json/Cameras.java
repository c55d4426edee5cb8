package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.math.Vec3;
import java.util.List;

/** The camera. */
final class Cameras {
    static final Family<Camera> FAMILY = new Family<Camera>("camera", "a camera", null, List.of(), List.of())
            .with(
                    "window",
                    Camera.Window.class,
                    "eye lowerLeft upperLeft upperRight lowerRight | pupilRadius",
                    Cameras::window,
                    (w, p) -> p.point("eye", w.eye())
                            .point("lowerLeft", w.lowerLeft())
                            .point("upperLeft", w.upperLeft())
                            .point("upperRight", w.upperRight())
                            .point("lowerRight", w.lowerRight())
                            .numberUnless(0, "pupilRadius", w.pupilRadius()))
            .with(
                    "perspective",
                    Camera.Perspective.class,
                    "eye lookAt fieldOfView | up",
                    Cameras::perspective,
                    (c, p) -> p.point("eye", c.eye())
                            .point("lookAt", c.lookAt())
                            .vector("up", c.up())
                            .number("fieldOfView", c.fieldOfView()))
            .with(
                    "orthographic",
                    Camera.Orthographic.class,
                    "eye lookAt height | up",
                    Cameras::orthographic,
                    (c, p) -> p.point("eye", c.eye())
                            .point("lookAt", c.lookAt())
                            .vector("up", c.up())
                            .number("height", c.height()))
            .with("isometric", Camera.Isometric.class, "lookAt height |", Cameras::isometric, (c, p) -> p.point(
                            "lookAt", c.lookAt())
                    .number("height", c.height()));

    private Cameras() {}

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
