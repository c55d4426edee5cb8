package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Where two solids of glass touch, their common surface is that of the solid that would fill an overlap, from whichever side light comes:
 * contact is the limit of a small overlap, and paths from the eye and from lights find the same.
 */
class TouchingGlassTest {
    /** An overlap that no ray's path is changed by. */
    private static final double OVERLAP = 1e-9;

    /** Noise beside tints that are wrong by a factor of 1.25 or more. */
    private static final double COARSE = 0.03;

    private static final double[] BELOW = {1, 0.5, 0.8};
    private static final double[] ABOVE = {0.3, 1, 0.6};

    private static Material glass(double[] color, double index, int priority, double roughness) {
        return new Glass(linear(color[0], color[1], color[2]), index, 1, priority, true).withRoughness(roughness);
    }

    /** Slabs on each other above a floor, seen from a height; the upper one is sunk by an overlap into the lower one. */
    private static Scene.Builder slabs(double eye, double half, double overlap, Material lower, Material upper) {
        return GreyFloor.scene(eye, half, PhysicalScenes.shading(0))
                .object(new Box(at(-half, 0.5, -half), at(half, 0.7, half)), lower)
                .object(new Box(at(-half, 0.7 - overlap, -half), at(half, 0.9, half)), upper);
    }

    /** By band. */
    private static Statistics[] means(BuiltInMethod method, Scene scene, int antialias) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(antialias);
        List<Image> pictures = Rendered.seeds(scene, settings, 1, 8);
        return IntStream.range(0, 3)
                .mapToObj(band -> Statistics.of(Rendered.means(pictures, 0, 0, 4, 4, band)))
                .toArray(Statistics[]::new);
    }

    private static Scene tinted(double eye, double overlap, int lower, int upper) {
        return slabs(eye, 4, overlap, glass(BELOW, 1, lower, 0), glass(ABOVE, 1, upper, 0))
                .light(GreyFloor.point())
                .build();
    }

    /** Light has each tint once, and that of the slab of greater priority once more; twice so where the eye looks through them as well. */
    @ParameterizedTest
    @CsvSource({
        "RAYTRACE, 0.4, 1, 0",
        "RAYTRACE, 0.4, 0, 1",
        "RAYTRACE, 1.2, 1, 0",
        "RAYTRACE, 1.2, 0, 1",
        "CLUSTER, 0.4, 1, 0",
        "CLUSTER, 0.4, 0, 1",
        "LIGHT, 0.4, 1, 0",
        "LIGHT, 0.4, 0, 1",
        "LIGHT, 1.2, 1, 0",
        "LIGHT, 1.2, 0, 1",
        "BIDIRECTIONAL, 0.4, 1, 0",
        "BIDIRECTIONAL, 1.2, 0, 1",
        "METROPOLIS, 0.4, 1, 0"
    })
    void theTintBetweenTouchingSlabsIsThatOfTheOneThatFillsOverlaps(
            BuiltInMethod method, double eye, int lower, int upper) {
        int antialias = method == BuiltInMethod.LIGHT ? 20 : 4;
        for (double overlap : new double[] {0, OVERLAP}) {
            Statistics[] found = means(method, tinted(eye, overlap, lower, upper), antialias);
            for (int band = 0; band < 3; band++) {
                double once = BELOW[band] * ABOVE[band] * (lower > upper ? BELOW : ABOVE)[band];
                double expected = GreyFloor.belowPoint() * (eye > 1 ? once * once : once);
                GreyFloor.assertSame(
                        method + ", band " + band + ", overlap " + overlap,
                        found[band],
                        new Statistics(expected, 0),
                        COARSE);
            }
        }
    }

    private static Scene rough(double overlap, double lower, double upper, int priority) {
        return slabs(
                        0.4,
                        1,
                        overlap,
                        glass(new double[] {1, 1, 1}, 1.5, 0, lower),
                        glass(new double[] {1, 1, 1}, 1.2, priority, upper))
                .light(PhysicalScenes.panel(0, 1.4, 0, 0.8, Rgb.gray(5), false))
                .build();
    }

    /** Slabs of different roughness scatter light at their common face from either side by one roughness: that of where they overlap a little. */
    @ParameterizedTest
    @CsvSource({"0.5, 0.9, -1", "0.5, 0.9, 1", "0, 0.7, -1"})
    void roughInterfacesOfTouchingSlabsAreReciprocal(double lower, double upper, int priority) {
        Scene scene = rough(0, lower, upper, priority);
        Statistics eye = means(BuiltInMethod.RAYTRACE, rough(OVERLAP, lower, upper, priority), 28)[0];
        GreyFloor.assertSame("raytrace", means(BuiltInMethod.RAYTRACE, scene, 28)[0], eye, 0.015);
        GreyFloor.assertSame("bidirectional", means(BuiltInMethod.BIDIRECTIONAL, scene, 24)[0], eye, 0.015);
        GreyFloor.assertSame("light", means(BuiltInMethod.LIGHT, scene, 55)[0], eye, 0.015);
    }

    /** What a pass of caustics finds by paths from lights is what the eye finds in the other methods. */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1"})
    void tintedSlabsThatTouchMakeTheSameCausticsFromEitherSide(int lower, int upper) {
        Scene scene = slabs(0.4, 1, 0, glass(BELOW, 1.5, lower, 0), glass(ABOVE, 1.5, upper, 0))
                .light(PhysicalScenes.panel(0, 1.4, 0, 0.8, Rgb.gray(5), false))
                .build();
        Scene joined = slabs(0.4, 1, OVERLAP, glass(BELOW, 1.5, lower, 0), glass(ABOVE, 1.5, upper, 0))
                .light(PhysicalScenes.panel(0, 1.4, 0, 0.8, Rgb.gray(5), false))
                .build();
        Statistics[] overlap = means(BuiltInMethod.BIDIRECTIONAL, joined, 12);
        for (BuiltInMethod method : BuiltInMethod.values()) {
            Statistics[] contact = means(method, scene, method == BuiltInMethod.BIDIRECTIONAL ? 12 : 40);
            for (int band = 0; band < 3; band++) {
                GreyFloor.assertSame(method + ", band " + band, contact[band], overlap[band], COARSE);
            }
        }
    }
}
