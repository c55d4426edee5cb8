package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.render.aov.AuxiliaryPicture;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is told of the beginnings of paths: reflectance, direct light and the rest. */
class PathPartPassTest {
    private static final int SIDE = 24;

    private static RenderSettings settings(Scene scene, double samples) {
        return RenderSettings.of(scene)
                .withSize(SIDE, SIDE)
                .withThreads(2)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
    }

    private static RenderResult render(Scene scene, RenderSettings settings) {
        return Renderer.render(RenderRequest.of(scene, settings)
                .withAuxiliary(
                        RenderResult.Auxiliary.ALBEDO, RenderResult.Auxiliary.DIRECT, RenderResult.Auxiliary.INDIRECT));
    }

    private static Scene shipped(String name) {
        return SceneReader.read(Path.of("scenes/" + name + ".json"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"cornell-box", "caustics", "lamp-room"})
    void directLightAndTheRestAddUpToThePicture(String name) {
        Scene scene = shipped(name);
        RenderResult result = render(scene, settings(scene, 3));
        float[] picture = result.image().toArray();
        float[] direct = result.auxiliary().get(RenderResult.Auxiliary.DIRECT).toArray();
        float[] rest = result.auxiliary().get(RenderResult.Auxiliary.INDIRECT).toArray();
        for (int i = 0; i < picture.length; i++) {
            assertEquals(picture[i], direct[i] + rest[i], 1e-6f * (picture[i] + 1));
            // Of the same paths, and nothing is negative.
            assertTrue(rest[i] >= -1e-6f * (picture[i] + 1), name + " " + i + ": " + rest[i]);
        }
        assertEquals(
                Color.Encoding.LINEAR,
                result.auxiliary().get(RenderResult.Auxiliary.DIRECT).encoding());
    }

    /** A ball in the light of a lamp and of the surroundings. */
    private static Scene ball(int bounces) {
        return Scene.builder()
                .size(SIDE, SIDE)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -5), ExactPoint.of(0, 0, 0), Vec3.Y, 30))
                .shading(new Shading.Physical(OptionalInt.of(bounces), new Rgb(0.5, 0.25, 0.125)))
                .object(new Sphere(ExactPoint.of(0, 0, 0), 1, 0), Material.Matte.of(color(0.5, 1, 0.25)))
                .object(new Sphere(ExactPoint.of(0, 2, 0), 0.9, 0), Material.Matte.of(color(0.5, 0.5, 0.5)))
                .light(new Light.Sphere(ExactPoint.of(0, 0.5, -4), 0.1, DisplayRgb.WHITE))
                .build();
    }

    private static Texture color(double r, double g, double b) {
        return new Texture.Solid(new Rgb(r, g, b));
    }

    @Test
    void withOneBounceThereIsNothingButDirectLight() {
        RenderResult one = render(ball(1), settings(ball(1), 5));
        RenderResult more = render(ball(9), settings(ball(9), 5));
        assertArrayEquals(
                one.image().toArray(),
                more.auxiliary().get(RenderResult.Auxiliary.DIRECT).toArray());
        assertFalse(Arrays.equals(one.image().toArray(), more.image().toArray()));
        for (float rest : one.auxiliary().get(RenderResult.Auxiliary.INDIRECT).toArray()) {
            assertEquals(0, rest);
        }
    }

    @Test
    void reflectanceIsTheLinearColorOfWhatIsSeen() {
        Image albedo = render(ball(9), settings(ball(9), 2)).auxiliary().get(RenderResult.Auxiliary.ALBEDO);
        assertEquals(0.5f, albedo.component(SIDE / 2, SIDE / 2, 0));
        assertEquals(1f, albedo.component(SIDE / 2, SIDE / 2, 1));
        assertEquals(0.25f, albedo.component(SIDE / 2, SIDE / 2, 2));
        assertEquals(0, albedo.component(0, SIDE - 1, 0));
    }

    @Test
    void theBytesDependNeitherOnThreadsNorOnTilesNorOnACrop() {
        Scene scene = shipped("lamp-room");
        RenderSettings settings = settings(scene, 2.5);
        Map<RenderResult.Auxiliary, Image> whole = render(scene, settings).auxiliary();
        Map<RenderResult.Auxiliary, Image> otherwise =
                render(scene, settings.withThreads(3).withTileSize(8)).auxiliary();
        RenderSettings.Crop crop = new RenderSettings.Crop(5, 7, 11, 9);
        Map<RenderResult.Auxiliary, Image> part =
                render(scene, settings.withCrop(crop)).auxiliary();
        whole.forEach((kind, image) -> {
            assertArrayEquals(image.toArray(), otherwise.get(kind).toArray(), kind.word());
            for (int y = 0; y < crop.height(); y++) {
                for (int x = 0; x < crop.width(); x++) {
                    assertEquals(
                            image.component(crop.x() + x, crop.y() + y, 1),
                            part.get(kind).component(x, y, 1),
                            kind.word());
                }
            }
        });
    }

    @Test
    void thePictureIsTheSameWithoutThem() {
        Scene scene = shipped("caustics");
        RenderSettings settings = settings(scene, 2);
        assertArrayEquals(
                Renderer.render(scene, settings).toArray(),
                render(scene, settings).image().toArray());
    }

    @Test
    void classicShadingDoesNotTellThemApart() {
        Scene scene = shipped("cube");
        assertTrue(scene.shading() instanceof Shading.Classic);
        InvalidValueException e = assertThrows(InvalidValueException.class, () -> render(scene, settings(scene, 1)));
        assertEquals("auxiliary", e.key());
        assertTrue(e.problem().contains("physical shading"), e.problem());
    }

    @Test
    void reflectanceIsShownWithoutTheExposureOfThePicture() {
        DisplayCurve bright = DisplayCurve.SRGB.withExposure(3);
        Image grey = new Image(1, 1, new float[] {0.25f, 0.25f, 0.25f}, bright);
        assertEquals(
                0.5371f,
                AuxiliaryPicture.of(RenderResult.Auxiliary.ALBEDO, grey).image().displayed(0, 0, 0),
                1e-3f);
        assertEquals(
                1f,
                AuxiliaryPicture.of(RenderResult.Auxiliary.DIRECT, grey).image().displayed(0, 0, 0));
    }
}
