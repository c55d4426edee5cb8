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
 * All that a page shows, at one moment.
 *
 * @param version counts changes of any of this
 * @param picture counts changes of what is to be seen
 * @param frame the last picture, or null
 * @param size of the view; null until there is a scene
 * @param moment the frame of the scene's animation that is shown; empty if it is the scene as its file's own numbers say
 * @param problems of the file or of the render, one in a line; the picture is then the last one that could be made
 * @param note of the last action, or ""
 * @param isMoved whether camera or exposure differ from the file's
 * @param isUpToDate whether the picture shows the camera as it is now
 * @param kept the picture that others are compared with, or null
 * @param layers as they were rendered last
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

    /** The last picture as it is shown; null if there is none. */
    Image shown() {
        Image image = frame == null ? null : frame.image();
        return image == null || image.encoding() == Color.Encoding.DISPLAY
                ? image
                : image.withCurve(image.curve().withExposure(exposure));
    }
}
