package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.camera.Camera;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.json.tree.MemberSpans;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SceneEditTest {
    private static final String TEXT =
            """
            // A "camera": { "eye": [9, 9, 9] } that is none.
            {
              "name": "a \\"camera\\": {",
              /* The view. */
              "camera": { "eye": [0, 1.50, -3e0], // as measured: "eye"
                  "type": "perspective",
                "lookAt": [0,0,0] /* the middle */, "fieldOfView": 40.0 },
              "image": { "width": 8, "height": 6 },
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "matte", "color": "#ffffff" } } ]
            }
            """;

    private static final Camera.Perspective BEFORE =
            new Camera.Perspective(ExactPoint.of("0", "1.5", "-3"), ExactPoint.ORIGIN, Vec3.Y, 40);

    private static Scene read(String text) {
        return SceneReader.readString(text, Path.of("scenes"), "");
    }

    @Test
    void onlyTheValuesThatDifferAreReplaced() {
        assertEquals(BEFORE, read(TEXT).camera());
        Camera after = new Camera.Perspective(ExactPoint.of("1", "2.25", "-3"), ExactPoint.ORIGIN, Vec3.Y, 35);
        String expected = TEXT.replace("[0, 1.50, -3e0]", "[1, 2.25, -3]").replace("40.0", "35");
        assertEquals(expected, SceneEdit.withCamera(TEXT, BEFORE, after));
        assertEquals(after, read(expected).camera());
    }

    @Test
    void aKeyThatIsNotThereIsAddedBehindTheOthers() {
        Camera after = new Camera.Perspective(BEFORE.eye(), BEFORE.lookAt(), Vec3.X, 40);
        String edited =
                SceneEdit.withCamera(TEXT, BEFORE, new Camera.Perspective(BEFORE.eye(), BEFORE.lookAt(), Vec3.X, 40));
        // The default direction is not in the file; written cameras always have it.
        assertEquals(TEXT.replace("40.0 }", "40.0, \"up\": [1, 0, 0] }"), edited);
        assertEquals(after, read(edited).camera());
    }

    @Test
    void theSameCameraLeavesTheTextAsItIs() {
        assertSame(TEXT, SceneEdit.withCamera(TEXT, BEFORE, BEFORE));
    }

    @Test
    void aByteOrderMarkAndWindowsLineEndsStay() {
        String text = "\ufeff" + TEXT.replace("\n", "\r\n");
        Camera after = new Camera.Perspective(BEFORE.eye(), BEFORE.lookAt(), BEFORE.up(), 35);
        assertEquals(text.replace("40.0", "35"), SceneEdit.withCamera(text, BEFORE, after));
    }

    @Test
    void exposureIsReplacedOrAddedWithItsPart() {
        String without = TEXT.replace("\"image\"", "\"shading\": { \"model\": \"physical\" },\n  \"image\"");
        String added = SceneEdit.withExposure(without, 1.5);
        assertEquals(without.replace("} } ]\n", "} } ],\n  \"display\": { \"exposure\": 1.5 }\n"), added);
        assertEquals(1.5, read(added).display().exposure());
        String empty = without.replace("\"image\"", "\"display\": {},\n  \"image\"");
        assertEquals(empty.replace("{},", "{ \"exposure\": -2 },"), SceneEdit.withExposure(empty, -2));
        assertEquals(added.replace("1.5 }", "0 }"), SceneEdit.withExposure(added, 0));
    }

    static Stream<Path> shippedScenes() throws Exception {
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            return files.filter(f -> f.toString().endsWith(".json")).sorted().toList().stream();
        }
    }

    /** Two lines of a shipped scene at most differ for each value that does, and what is read is what was written. */
    @ParameterizedTest
    @MethodSource("shippedScenes")
    void eyesOfShippedScenesMove(Path file) throws Exception {
        String text = Files.readString(file);
        MemberSpans camera = MemberSpans.of(text, List.of("camera"));
        MemberSpans.Span eye = camera.values().get("eye");
        Optional<Camera> moved = moved(text, file);
        if (eye == null || moved.isEmpty()) {
            return;
        }
        Camera before = SceneReader.read(file).camera();
        String edited = SceneEdit.withCamera(text, before, moved.get());
        assertEquals(text.substring(0, eye.start()), edited.substring(0, eye.start()));
        int behind = text.length() - eye.end();
        assertEquals(text.substring(eye.end()), edited.substring(edited.length() - behind));
        assertEquals(
                moved.get(),
                SceneReader.readString(edited, file.toAbsolutePath().getParent(), "")
                        .camera());
    }

    private static Optional<Camera> moved(String text, Path file) {
        Camera camera = SceneReader.read(file).camera();
        Vec3 step = new Vec3(0.25, 0.5, 0.125);
        if (camera instanceof Camera.Perspective c
                && MemberSpans.of(text, List.of("camera")).has("up")) {
            return Optional.of(new Camera.Perspective(
                    c.eye().plus(step), c.lookAt(), c.up(), c.fieldOfView(), c.axis(), c.handedness(), c.lens()));
        }
        return camera instanceof Camera.Window w
                ? Optional.of(new Camera.Window(
                        w.eye().plus(step),
                        w.lowerLeft(),
                        w.upperLeft(),
                        w.upperRight(),
                        w.lowerRight(),
                        w.pupilRadius()))
                : Optional.empty();
    }

    @Test
    void otherKindsOfCamerasAndOtherTextsAreRefused() {
        Camera other = new Camera.Isometric(ExactPoint.ORIGIN, 2);
        assertThrows(IllegalArgumentException.class, () -> SceneEdit.withCamera(TEXT, BEFORE, other));
        assertThrows(IllegalArgumentException.class, () -> SceneEdit.withExposure("[1]", 1));
        assertThrows(IllegalArgumentException.class, () -> SceneEdit.withExposure("{ \"a\": ", 1));
    }

    @Test
    void theTextOfACameraIsReadBack() {
        MemberSpans.Span span = MemberSpans.of(TEXT, List.of()).values().get("camera");
        Camera camera = new Camera.Orthographic(ExactPoint.of("1", "2", "0.3"), ExactPoint.ORIGIN, Vec3.Z, 4);
        String text = TEXT.substring(0, span.start()) + SceneEdit.json(camera) + TEXT.substring(span.end());
        assertEquals(camera, read(text).camera());
    }
}
