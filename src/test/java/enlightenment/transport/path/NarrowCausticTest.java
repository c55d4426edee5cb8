package enlightenment.transport.path;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.world.CompiledScene;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What polished surfaces make of small lights, by paths from these, is what plain path tracing finds by chance; roughnesses and lamps are as
 * large as they may be, so that it does.
 */
class NarrowCausticTest {
    private static final String CAMERA =
            """
            "camera": { "type": "perspective", "eye": [0, 3, -4], "lookAt": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 50 },
            """;
    private static final String FLOOR = floor(matte());
    private static final String WALL =
            """
            { "type": "rectangle", "corners": [[-3, 0, 1.2], [-3, 3, 1.2], [3, 3, 1.2], [3, 0, 1.2]],
              "material": %s }
            """;

    private static String matte() {
        return "{ \"type\": \"matte\", \"color\": { \"linear\": [0.6, 0.5, 0.4] } }";
    }

    private static String floor(String material) {
        return "{ \"type\": \"rectangle\", \"corners\": [[-3, 0, -3], [-3, 0, 3], [3, 0, 3], [3, 0, -3]], \"material\": "
                + material + " }";
    }

    private static String metal(double roughness) {
        return "{ \"type\": \"glossy\", \"color\": { \"linear\": [0.9, 0.8, 0.7] }, \"roughness\": " + roughness + " }";
    }

    private static String glass(double roughness) {
        return "{ \"type\": \"glass\", \"color\": { \"linear\": [0.9, 0.8, 1] }, \"indexOfRefraction\": 1.5, \"roughness\": "
                + roughness + " }";
    }

    private static String lamp(double radius) {
        return "{ \"type\": \"sphere\", \"center\": [-1.2, 2, 0.4], \"radius\": " + radius
                + ", \"color\": \"#ffffff\", \"radiance\": [9, 6, 3] }";
    }

    private static String ball(double x, double z, String material) {
        return "{ \"type\": \"sphere\", \"center\": [" + x + ", 0.7, " + z + "], \"radius\": 0.5, \"material\": "
                + material + " }";
    }

    private static String ring(String material) {
        return "{ \"type\": \"cylinder\", \"base\": [0.5, 0, 0.2], \"top\": [0.5, 0.6, 0.2], \"radius\": 0.7, \"capped\": false,"
                + " \"material\": " + material + " }";
    }

    private static CompiledScene scene(String lights, String... objects) {
        return CausticTest.scene("", CAMERA, lights, objects);
    }

    /** How many times the usual number of paths is followed. */
    private int more = 1;

    /** Standard errors of the mean are below 1 % of the light, 0.4 % in most scenes: what is wrong by 4 % of it is found everywhere. */
    private void assertSame(CompiledScene scene) {
        assertTrue(scene.physical.caustics.takesNarrow());
        CausticTest.assertSame(scene, more * 512, more * 16_384);
    }

    @Tag("full")
    @Test
    void allOfThemWithFourTimesAsManyPaths() {
        more = 4;
        aRingOfPolishedMetal();
        aBallOfSlightlyRoughGlass();
        polishedSurfacesThatAreSeenThemselves(0.2);
        polishedSurfacesThatAreSeenThemselves(0.5);
        withMirrorsAndClearGlass();
        ofSeveralLampsTheSmallOnes();
        inFog();
        theSunBesideASky();
    }

    @Test
    void aRingOfPolishedMetal() {
        assertSame(scene(lamp(0.3), FLOOR, ring(metal(0.24))));
    }

    @Test
    void aBallOfSlightlyRoughGlass() {
        assertSame(scene(lamp(0.25), FLOOR, ball(-0.3, 0, glass(0.24))));
    }

    /** What is seen in polished surfaces is left to paths from the eye: the wall's and the floor's first lobes are narrow. */
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.5})
    void polishedSurfacesThatAreSeenThemselves(double roughness) {
        assertSame(scene(lamp(0.3), floor(metal(0.24)), ring(metal(0.24)), WALL.formatted(metal(roughness))));
        assertSame(scene(lamp(0.3), FLOOR, ring(metal(0.24)), WALL.formatted(metal(roughness))));
    }

    /** Light that goes by mirrors, clear glass and rough metal, in any order. */
    @Test
    void withMirrorsAndClearGlass() {
        String mirror = "{ \"type\": \"mirror\", \"color\": { \"linear\": [0.9, 0.9, 0.9] } }";
        assertSame(scene(lamp(0.3), FLOOR, ring(metal(0.24)), WALL.formatted(mirror)));
        assertSame(scene(lamp(0.3), FLOOR, ring(metal(0.24)), ball(-0.8, -0.3, glass(0))));
    }

    /** A large lamp beside it is found from the eye. */
    @Test
    void ofSeveralLampsTheSmallOnes() {
        String large =
                """
                { "type": "sphere", "center": [1.8, 1.6, -0.6], "radius": 0.7, "color": "#ffffff", "radiance": [1, 2, 3] }
                """;
        CompiledScene scene = scene(lamp(0.3) + ", " + large, FLOOR, ring(metal(0.24)), ball(-0.6, -0.4, glass(0.2)));
        assertTrue(scene.physical.caustics.takesNarrow(0));
        assertFalse(scene.physical.caustics.takesNarrow(1));
        assertSame(scene);
    }

    @Test
    void inFog() {
        String fog =
                """
                { "type": "box", "min": [-3, -1, -3], "max": [3, 1.5, 3],
                  "material": { "type": "scattering", "scatteringCoefficient": [0.2, 0.1, 0.3], "absorptionCoefficient": [0.1, 0.2, 0] } }
                """;
        assertSame(scene(lamp(0.3), FLOOR, ring(metal(0.24)), fog));
    }

    @Test
    void theSunBesideASky() {
        String sky = ", \"background\": { \"type\": \"sky\", \"elevation\": 60, \"azimuth\": -60, \"turbidity\": 3 }";
        CompiledScene scene = CausticTest.scene(
                sky, CAMERA, "", new String[] {FLOOR, ring(metal(0.24)), ball(-0.7, -0.4, glass(0.2))});
        assertTrue(scene.physical.caustics.takesNarrow(0));
        assertSame(scene);
    }

    /** Rough ones, and lamps that are seen under a large angle, are found from the eye with less noise. */
    @ParameterizedTest
    @CsvSource({"0.24, 0.3, true", "0.26, 0.3, false", "0.1, 0.6, false"})
    void onlyPolishedSurfacesAndSmallLampsAreTaken(double roughness, double radius, boolean isTaken) {
        CompiledScene scene = scene(lamp(radius), FLOOR, ring(metal(roughness)));
        assertEquals(isTaken, scene.physical.hasCausticPass());
    }
}
