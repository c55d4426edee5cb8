package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Sphere;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A face of a solid of glass where another solid fills the place is no interface: nothing is hidden by it, by any method. */
class HiddenFacesTest {
    /** The most that a standard error may be of what is expected. */
    private static final double NOISE = 0.01;

    private static Material glass(double index, int priority, double roughness) {
        return new Glass(linear(1, 1, 1), index, 1, priority, true).withRoughness(roughness);
    }

    private static Scene.Builder floor(int maxBounces) {
        return GreyFloor.scene(0.4, 1, PhysicalScenes.atMost(maxBounces, 0));
    }

    /** A pool that eye, floor and lamps are in, and glass between them that the water takes the place of. */
    private static Scene pool(Light light, boolean hasHidden, boolean hasBubble) {
        Scene.Builder scene = floor(1).object(new Box(at(-3, -1, -3), at(3, 4, 3)), glass(1.33, 1, 0))
                .light(light);
        if (hasHidden) {
            scene.object(new Box(at(-2, 0.6, -2), at(2, 1, 2)), glass(1.5, 0, 0));
        }
        if (hasBubble) {
            scene.object(Sphere.of(at(0, -9, 0), 0.1), glass(1, 0, 0));
        }
        return scene.build();
    }

    private static double mean(BuiltInMethod method, Scene scene, int antialias, int seed) {
        return Rendered.mean(
                scene,
                RenderSettings.of(scene)
                        .withMethod(method)
                        .withAntialias(antialias)
                        .withSeed(seed));
    }

    private static Statistics means(BuiltInMethod method, Scene scene, int antialias, int seeds) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
        return Statistics.of(Rendered.means(Rendered.seeds(scene, settings, 1, seeds), 0, 0, 4, 4, 0));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE, false", "RAYTRACE, true", "CLUSTER, false", "CLUSTER, true"})
    void aPointLightShinesThroughHiddenGlassAsIfThatWereNotThere(BuiltInMethod method, boolean hasBubble) {
        double shown = mean(method, pool(GreyFloor.point(), true, hasBubble), 4, 1);
        assertEquals(GreyFloor.belowPoint(), shown, 0.001 * shown);
        assertEquals(mean(method, pool(GreyFloor.point(), false, hasBubble), 4, 1), shown, 0.001 * shown);
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aLampShinesThroughHiddenGlassAsIfThatWereNotThere(BuiltInMethod method) {
        Light lamp = PhysicalScenes.sphereLight(0, 2, 0, 0.4, 5);
        Statistics clear = means(BuiltInMethod.RAYTRACE, pool(lamp, false, false), 8, 8);
        int antialias = method == BuiltInMethod.LIGHT ? 120 : 10;
        GreyFloor.assertSame(method.word(), means(method, pool(lamp, true, false), antialias, 8), clear, NOISE);
    }

    /** Glass of index 1, far from all that is seen, makes the glass of the scene differ from its surroundings in more than one way. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aBubbleThatIsNotSeenChangesNoBit(BuiltInMethod method) {
        Light lamp = PhysicalScenes.sphereLight(0, 2, 0, 0.4, 5);
        assertArrayEquals(picture(method, pool(lamp, true, false)), picture(method, pool(lamp, true, true)));
        assertArrayEquals(picture(method, slabs(0.6, false)), picture(method, slabs(0.6, true)));
    }

    private static float[] picture(BuiltInMethod method, Scene scene) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(8);
        return Renderer.render(scene, settings).toArray();
    }

    /** A slab of rough glass and one that begins in it, or on it: of the priority of which the place is filled. */
    private static Scene slabs(double bottom, boolean hasBubble) {
        Scene.Builder scene = floor(1000)
                .object(new Box(at(-1, 0.5, -1), at(1, 0.7, 1)), glass(1.5, 1, 0.7))
                .object(new Box(at(-1, bottom, -1), at(1, 0.9, 1)), glass(1.2, 0, 0.7))
                .light(PhysicalScenes.panel(0, 1.4, 0, 0.8, Rgb.gray(5), false));
        if (hasBubble) {
            scene.object(Sphere.of(at(0, -9, 0), 0.1), glass(1, 0, 0));
        }
        return scene.build();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.6, 0.7})
    void roughSlabsThatOverlapOrTouchAreAsBrightByEachMethod(double bottom) {
        Scene scene = slabs(bottom, false);
        Statistics one = means(BuiltInMethod.RAYTRACE, scene, 25, 8);
        Statistics two = means(BuiltInMethod.BIDIRECTIONAL, scene, 40, 8);
        Statistics three = means(BuiltInMethod.LIGHT, scene, 60, 8);
        GreyFloor.assertSame("bidirectional", two, one, NOISE);
        GreyFloor.assertSame("light", three, one, NOISE);
    }
}
