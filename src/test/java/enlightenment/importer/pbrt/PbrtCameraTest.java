package enlightenment.importer.pbrt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.importer.SceneImporter;
import enlightenment.math.Vec3;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Cameras of pbrt: which rays they have. */
class PbrtCameraTest {
    @TempDir
    private Path folder;

    private SceneImporter.Result read(String text) throws IOException {
        Path file = folder.resolve("scene.pbrt");
        Files.writeString(file, text);
        return SceneImporter.read(file, SceneImporter.Options.DEFAULT);
    }

    private static final String END = "\nWorldBegin Shape \"sphere\"";

    private Camera camera(String text) throws IOException {
        return read(text + END).scene().camera();
    }

    private static String film(int width, int height) {
        return "\nFilm \"rgb\" \"integer xresolution\" " + width + " \"integer yresolution\" " + height;
    }

    private static void assertNear(Vec3 expected, Vec3 actual) {
        assertTrue(expected.minus(actual).maxAbs() < 1e-9, expected + " is not " + actual);
    }

    @Test
    void fieldOfViewIsThatOfTheSmallerSide() throws IOException {
        Camera.Perspective wide = (Camera.Perspective) camera("Camera \"perspective\" \"float fov\" 60" + film(40, 30));
        assertEquals(60, wide.fieldOfView());
        assertEquals(Camera.FieldOfViewAxis.VERTICAL, wide.axis());
        Camera.Perspective high = (Camera.Perspective) camera("Camera \"perspective\" \"float fov\" 60" + film(30, 40));
        assertEquals(60, high.fieldOfView());
        assertEquals(Camera.FieldOfViewAxis.HORIZONTAL, high.axis());
    }

    /** pbrt's camera looks along +z with +x to the right: a left-handed space. */
    @Test
    void theWorldIsLeftHanded() throws IOException {
        Camera.Perspective c = (Camera.Perspective) camera("LookAt 1 2 3 1 2 10 0 1 0\nCamera \"perspective\"");
        assertNear(new Vec3(1, 2, 3), c.eye().toVec3());
        assertNear(Vec3.Z, c.eye().directionTo(c.lookAt()));
        assertNear(Vec3.Y, c.up());
        assertEquals(Camera.Handedness.LEFT, c.handedness());
    }

    @Test
    void aScaleBeforeLookAtMirrorsThePicture() throws IOException {
        Camera.Perspective c =
                (Camera.Perspective) camera("Scale -1 1 1 LookAt 0 0 -5 0 0 0 0 1 0\nCamera \"perspective\"");
        assertEquals(Camera.Handedness.RIGHT, c.handedness());
    }

    /** The middle half of each side has half of the tangent. */
    @Test
    void aCropAroundTheMiddleIsASmallerAngle() throws IOException {
        Camera.Perspective c = (Camera.Perspective) camera(
                "Camera \"perspective\" \"float fov\" 90" + film(40, 40) + " \"float cropwindow\" [.25 .75 .25 .75]");
        assertEquals(2 * StrictMath.toDegrees(StrictMath.atan(0.5)), c.fieldOfView(), 1e-12);
    }

    @Test
    void aCropBesideTheMiddleIsAWindow() throws IOException {
        Camera.Window w = (Camera.Window)
                camera("Camera \"perspective\" \"float fov\" 90" + film(40, 40) + " \"float cropwindow\" [.5 1 .5 1]");
        // The lower right quarter, whose upper left corner is straight ahead.
        assertNear(Vec3.Z, w.eye().directionTo(w.upperLeft()).normalized());
        assertNear(
                new Vec3(1, -1, 1).normalized(),
                w.eye().directionTo(w.lowerRight()).normalized());
    }

    @Test
    void aLensHasTheUnitsOfTheScene() throws IOException {
        String lens = "Camera \"perspective\" \"float lensradius\" .5 \"float focaldistance\" 8";
        assertEquals(Optional.of(Camera.Lens.round(0.5, 8)), ((Camera.Perspective) camera(lens)).lens());
        // The world is twice as large in the camera's coordinates.
        assertEquals(
                Optional.of(Camera.Lens.round(0.25, 4)), ((Camera.Perspective) camera("Scale 2 2 2 " + lens)).lens());
        String wrong = "Camera \"perspective\" \"float lensradius\" 5000 \"float focaldistance\" 1";
        assertTrue(assertThrows(SceneException.class, () -> camera(wrong))
                .getMessage()
                .contains("the camera's lens: "));
    }

    /** phi = 2 pi u from +x towards +z, so that u = 1/2 looks at -x and u = 3/4 at -z. */
    @Test
    void theSphericalCameraHasMinusXInItsMiddle() throws IOException {
        String text = "LookAt 1 2 3 1 2 10 0 1 0\nCamera \"spherical\" \"string mapping\" \"equirectangular\"";
        Camera.Panorama p = (Camera.Panorama) camera(text);
        Vec3 forward = p.eye().directionTo(p.lookAt());
        assertNear(Vec3.X.negated(), forward);
        Vec3 right = p.handedness() == Camera.Handedness.RIGHT ? forward.cross(p.up()) : p.up().cross(forward);
        assertNear(Vec3.Z.negated(), right.normalized());
        assertEquals(0, read(text + END).notes().size());
        assertEquals(1, read("Camera \"spherical\"" + END).notes().size());
    }
}
