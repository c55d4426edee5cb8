package enlightenment.importer.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.importer.SceneImporter;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What cameras and lights of glTF files become. */
class GltfViewTest {
    @TempDir
    Path folder;

    private static GltfFile square() {
        GltfFile file = new GltfFile();
        file.square("");
        file.add("nodes", "{'mesh':0}");
        return file;
    }

    @Test
    void camerasAreChosenByNumberOrByTheNameOfCameraOrNode() throws IOException {
        GltfFile file = square();
        for (double angle : new double[] {0.5, 0.75, 1}) {
            String name = angle == 0.75 ? ",'name':'Side'" : "";
            file.add("cameras", "{'type':'perspective','perspective':{'yfov':" + angle + ",'znear':0.1}" + name + "}");
        }
        file.add("nodes", "{'camera':2,'name':'Top \\u0007'}");
        file.add("nodes", "{'camera':1,'name':'elsewhere'}");
        Path glb = folder.resolve("model.glb");
        Files.write(glb, file.glb());
        assertEquals(StrictMath.toDegrees(0.75), fieldOfView(glb, "1"), 1e-12);
        assertEquals(StrictMath.toDegrees(0.75), fieldOfView(glb, "Side"), 1e-12);
        assertEquals(StrictMath.toDegrees(1), fieldOfView(glb, "2"), 1e-12);
        SceneException unknown = assertThrows(SceneException.class, () -> fieldOfView(glb, "elsewhere"));
        assertTrue(unknown.getMessage().contains("its cameras are 0, 1 \"Side\", 2 \"Top"), unknown.getMessage());
        assertFalse(unknown.getMessage().contains("\u0007"), "a control character of the file");
        SceneException unused = assertThrows(SceneException.class, () -> fieldOfView(glb, "0"));
        assertTrue(unused.getMessage().contains("hangs on no node"), unused.getMessage());
    }

    private static double fieldOfView(Path glb, String camera) throws IOException {
        Scene scene = SceneImporter.read(glb, SceneImporter.Options.DEFAULT.withCamera(camera))
                .scene();
        return ((Camera.Perspective) scene.camera()).fieldOfView();
    }

    /** The trap "fov axis": yfov is the angle of the picture's height, however wide it is. */
    @Test
    void fovAxisIsVertical() throws IOException {
        GltfFile file = square();
        file.add("cameras", "{'type':'perspective','perspective':{'yfov':1.2,'aspectRatio':2,'znear':0.1}}");
        file.add("nodes", "{'camera':0,'translation':[1,2,9]}");
        SceneImporter.Result imported = file.read(folder);
        Camera.Perspective camera = (Camera.Perspective) imported.scene().camera();
        assertEquals(ExactPoint.of(1, 2, 9), camera.eye());
        assertEquals(Vec3.Y, camera.up());
        assertEquals(
                0,
                camera.eye()
                        .directionTo(camera.lookAt())
                        .normalized()
                        .minus(new Vec3(0, 0, -1))
                        .length());
        assertEquals(Camera.Handedness.RIGHT, camera.handedness(), "x points to the right");
        assertEquals(StrictMath.toDegrees(1.2), camera.fieldOfView(), 1e-12);
        assertEquals(Camera.FieldOfViewAxis.VERTICAL, camera.axis());
        assertEquals(2.0, (double) imported.scene().width() / imported.scene().height());
    }

    @Test
    void parallelViewsKeepTheirSize() throws IOException {
        GltfFile file = square();
        file.add("cameras", "{'type':'orthographic','orthographic':{'xmag':3,'ymag':2,'zfar':10,'znear':0.1}}");
        file.add("nodes", "{'camera':0,'translation':[0,0,5]}");
        Scene scene = file.read(folder).scene();
        Camera.Orthographic camera = (Camera.Orthographic) scene.camera();
        assertEquals(4, camera.height(), 1e-12);
        assertEquals(1.5, (double) scene.width() / scene.height());
        assertEquals(ExactPoint.of(0, 0, 5), camera.eye());
        assertEquals(Camera.Handedness.RIGHT, camera.handedness());
    }

    /** The trap "units of KHR_lights_punctual": candela are numbers of intensity. */
    @Test
    void unitsOfPunctualLightsStay() throws IOException {
        GltfFile file = square().with(
                        "'extensions':{'KHR_lights_punctual':{'lights':[{'type':'point','color':[1,0.5,0.25],"
                                + "'intensity':40}]}}");
        file.add("nodes", "{'translation':[1,2,3],'extensions':{'KHR_lights_punctual':{'light':0}}}");
        SceneImporter.Result imported = file.read(folder);
        assertEquals(
                List.of(new Light.Point(ExactPoint.of(1, 2, 3), Rgb.WHITE, Emission.intensity(new Rgb(40, 20, 10)))),
                imported.scene().lights());
        Shading.Physical shading = (Shading.Physical) imported.scene().shading();
        assertEquals(
                new Shading.Background.Constant(Rgb.BLACK), shading.background(), "a file with a light has no studio");
    }

    @Test
    void spotLightsShineAlongTheirNode() throws IOException {
        GltfFile file = square().with(
                        "'extensions':{'KHR_lights_punctual':{'lights':[{'type':'spot','intensity':9,'spot':"
                                + "{'innerConeAngle':" + Math.PI / 6 + ",'outerConeAngle':" + Math.PI / 3 + "}}]}}");
        file.add("nodes", "{'rotation':[1,0,0,1],'extensions':{'KHR_lights_punctual':{'light':0}}}");
        Light.Spot spot = (Light.Spot) file.read(folder).scene().lights().get(0);
        // A quarter of a turn about x takes -z to y.
        assertEquals(0, spot.direction().minus(Vec3.Y).length(), 1e-15);
        assertEquals(60, spot.angle(), 1e-12);
        assertEquals(30, spot.innerAngle(), 1e-12);
        assertEquals(Emission.intensity(new Rgb(9, 9, 9)), spot.emission());
    }

    @Test
    void luxOfDirectionalLightsAreIrradiance() throws IOException {
        GltfFile file = square().with(
                        "'extensions':{'KHR_lights_punctual':{'lights':[{'type':'directional','color':[1,0.5,0.25],"
                                + "'intensity':8}]}}");
        file.add("nodes", "{'rotation':[1,0,0,1],'scale':[3,3,3],'extensions':{'KHR_lights_punctual':{'light':0}}}");
        Light.Distant sun = (Light.Distant) file.read(folder).scene().lights().get(0);
        assertEquals(0, sun.direction().normalized().minus(Vec3.Y).length(), 1e-15);
        assertEquals(new Rgb(8, 4, 2), sun.emitted());
    }

    @Test
    void aModelAloneStandsInAStudio() throws IOException {
        SceneImporter.Result imported = square().read(folder);
        assertEquals(2, imported.scene().objects().size(), "the model and the ground");
        assertEquals(1, imported.scene().lights().size());
    }
}
