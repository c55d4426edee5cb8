package enlightenment.view;

import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.view.camera.Viewpoint;
import enlightenment.view.frame.Frame;
import enlightenment.view.frame.Kept;
import java.util.List;
import java.util.OptionalInt;

/**
 * The state of a view at one moment, as a page shows it. Immutable.
 *
 * @param version number of changes of the state so far
 * @param picture number of changes of the picture and the layers so far
 * @param frame the last picture, or null
 * @param scene the scene as it was read; null until a file was read
 * @param viewpoint the camera of the view; null until there is a scene
 * @param size size of the picture at full resolution; null until there is a scene
 * @param exposure the exposure of the view, in stops
 * @param moment the animation frame, counted from 0; empty if no track has been applied
 * @param problems problems of the file or of the render, one in a line; the picture is then the last that could be rendered
 * @param note a note about the last action, or ""
 * @param isMoved whether camera or exposure differ from the file's
 * @param isUpToDate whether the picture shows the current scene, camera and size
 * @param kept the picture that others are compared with, or null
 * @param layers the auxiliary images, each as it was rendered last
 */
record Snapshot(
        long version,
        long picture,
        Frame frame,
        Scene scene,
        Viewpoint viewpoint,
        ViewSize size,
        double exposure,
        OptionalInt moment,
        List<String> problems,
        String note,
        boolean isMoved,
        boolean isUpToDate,
        Kept kept,
        Layers layers) {
    boolean isLinear() {
        return scene != null && scene.shading() instanceof Shading.Physical;
    }

    /** The last picture with the exposure of the view; null if there is none. */
    Image shown() {
        Image image = frame == null ? null : frame.image();
        return image == null || image.encoding() == Color.Encoding.DISPLAY
                ? image
                : image.withCurve(image.curve().withExposure(exposure));
    }
}
