package enlightenment.importer.pbrt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.SceneImporter;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Lights of pbrt without a surface. */
class PbrtLightTest {
    @TempDir
    private Path folder;

    private SceneImporter.Result read(String text) throws IOException {
        Path file = folder.resolve("scene.pbrt");
        Files.writeString(file, text);
        return SceneImporter.read(file, SceneImporter.Options.DEFAULT.withExtracted(folder.resolve("made")));
    }

    private Light light(String text) throws IOException {
        SceneImporter.Result s = read("WorldBegin\n" + text + " Shape \"sphere\"");
        assertEquals(List.of(), s.notes());
        return s.scene().lights().get(0);
    }

    private static void assertNear(Vec3 expected, Vec3 actual) {
        assertTrue(expected.minus(actual).maxAbs() < 1e-9, expected + " is not " + actual);
    }

    @Test
    void aSpotFallsOverTheLastDegreesOfItsCone() throws IOException {
        Light.Spot s =
                (Light.Spot) light("Rotate 90 0 0 1 LightSource \"spot\" \"point3 from\" [1 0 0] \"point3 to\" [3 0 0]"
                        + " \"float coneangle\" 40 \"float conedeltaangle\" 15 \"rgb I\" [1 2 3] \"float scale\" 2");
        assertNear(Vec3.Y, s.position().toVec3());
        assertNear(Vec3.Y, s.direction().normalized());
        assertEquals(40, s.angle());
        assertEquals(25, s.innerAngle());
        assertEquals(Emission.intensity(new Rgb(2, 4, 6)), s.emission());
    }

    @Test
    void aSpotThatSaysNothingShinesAlongZ() throws IOException {
        Light.Spot s = (Light.Spot) light("LightSource \"spot\"");
        assertEquals(new Light.Spot(ExactPoint.ORIGIN, Vec3.Z, 30, 25, Rgb.WHITE, Emission.INTENSITY_1), s);
    }

    /** The integral of the smoothstep over the cosine is half of its width. */
    @Test
    void thePowerOfASpotIsSharedByItsSolidAngle() throws IOException {
        Light.Spot s = (Light.Spot)
                light("LightSource \"spot\" \"float power\" 8 \"float coneangle\" 90 \"float conedeltaangle\" 30");
        assertEquals(
                8 / (2 * StrictMath.PI * (0.5 + 0.25)), s.emission().value().g(), 1e-12);
    }

    private void picture(int width, int height) throws IOException {
        float[] rgb = new float[3 * width * height];
        for (int x = 0; x < width; x++) {
            for (int y = 0; y < height; y++) {
                rgb[3 * (y * width + x)] = (x + 1f) / width;
            }
        }
        ImageFiles.writePng(new Image(width, height, rgb), folder.resolve("p.png"));
    }

    /** Of a picture twice as wide as high the width has twice the tangent. */
    @Test
    void aProjectionsFieldIsThatOfTheShorterSide() throws IOException {
        picture(4, 2);
        Light.Projector p =
                (Light.Projector) light("Translate 1 2 3 LightSource \"projection\" \"string filename\" \"p.png\""
                        + " \"float fov\" 90 \"float scale\" 5");
        assertEquals(2 * StrictMath.toDegrees(StrictMath.atan(2)), p.fieldOfView(), 1e-12);
        assertNear(new Vec3(1, 2, 3), p.position().toVec3());
        assertNear(Vec3.Z, p.direction());
        assertNear(Vec3.Y, p.up());
        assertEquals(Emission.intensity(Rgb.gray(5)), p.emission());
        assertEquals(
                new Texture.File(folder.resolve("p.png"), Texture.Filter.NEAREST, Texture.Encoding.SRGB), p.picture());
        picture(2, 4);
        assertEquals(
                90,
                ((Light.Projector) light("LightSource \"projection\" \"string filename\" \"p.png\"")).fieldOfView());
    }

    @Test
    void aMirroredProjectionHasAMirroredPicture() throws IOException {
        picture(4, 2);
        Light.Projector p =
                (Light.Projector) light("Scale -1 1 1 LightSource \"projection\" \"string filename\" \"p.png\"");
        Image mirrored = ImageFiles.read(p.picture().file());
        Image source = ImageFiles.read(folder.resolve("p.png"));
        for (int x = 0; x < 4; x++) {
            double expected = TransferCurve.decode(source.component(x, 0, 0));
            assertEquals(expected, mirrored.component(3 - x, 0, 0), 1.0 / 65535);
        }
    }

    @Test
    void floatsBeyondOneShareTheirScaleWithTheIntensity() throws IOException {
        float[] rgb = {8, 4, 2, 0, 0, 1};
        ImageFiles.writePfm(new Image(2, 1, rgb, Color.Encoding.LINEAR), folder.resolve("p.pfm"));
        Light.Projector p =
                (Light.Projector) light("LightSource \"projection\" \"string filename\" \"p.pfm\" \"float scale\" 3");
        assertEquals(Emission.intensity(Rgb.gray(24)), p.emission());
        assertEquals(0.25, ImageFiles.read(p.picture().file()).component(0, 0, 2), 1.0 / 65535);
        assertEquals(Texture.Encoding.LINEAR, p.picture().encoding());
    }

    @Test
    void aDistantLightAloneLightsTheScene() throws IOException {
        SceneImporter.Result s = read("WorldBegin LightSource \"distant\" Shape \"sphere\"");
        assertEquals(0, s.notes().size(), s.notes().toString());
        assertTrue(s.scene().lights().get(0) instanceof Light.Distant);
        assertEquals(
                new Shading.Background.Constant(Rgb.BLACK),
                ((Shading.Physical) s.scene().shading()).background());
    }
}
