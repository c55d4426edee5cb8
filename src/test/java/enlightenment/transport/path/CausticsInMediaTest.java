package enlightenment.transport.path;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.world.CompiledScene;
import org.junit.jupiter.api.Test;

/** Shafts of light: what mirrors and glass send into fog, and fog to the eye. */
class CausticsInMediaTest {
    private static final double SCATTERING = 0.3;

    /** Beyond this side of the box, in its middle, there is no fog. */
    private static final double HALF = 4;

    private static final int STEPS = 400;
    private static final int PLACES = 24;

    private static final String POINT =
            "{ \"type\": \"point\", \"position\": [0, 0, 0], \"color\": \"#ffffff\", \"intensity\": 2 }";
    private static final String FOG =
            """
            { "type": "box", "min": [-4, -4, -4], "max": [4, 4, 4],
              "material": { "type": "scattering", "scatteringCoefficient": 0.3, "absorptionCoefficient": 0 } }
            """;
    private static final String MIRROR =
            """
            { "type": "rectangle", "corners": [[-4, -1, -4], [-4, -1, 4], [4, -1, 4], [4, -1, -4]],
              "material": { "type": "mirror", "color": { "linear": [1, 1, 1] } } }
            """;

    /**
     * Single scattering of the light of the point's image in the mirror, along a ray from inside of the fog to its far side.
     *
     * @param x where the ray starts
     * @param dx its direction, and so on; it goes 1 along z
     */
    private static double ofImage(double x, double y, double z, double dx, double dy) {
        double length = Math.sqrt(dx * dx + dy * dy + 1);
        double step = (HALF - z) / STEPS;
        double sum = 0;
        for (int k = 0; k < STEPS; k++) {
            double s = (k + 0.5) * step;
            double px = x + s * dx;
            double py = y + s * dy + 2;
            double pz = z + s;
            double dd = px * px + py * py + pz * pz;
            sum += Math.exp(-SCATTERING * (s * length + Math.sqrt(dd))) / dd;
        }
        return 2 * SCATTERING / (4 * Math.PI) * sum * step * length;
    }

    /** By eight pictures of the pass, whose paths may have two events only: the mirror's, and one in the fog. */
    private static void assertMean(String camera, double expected) {
        CompiledScene scene = CausticTest.scene(CausticTest.TWO_EVENTS, camera, POINT, new String[] {FOG, MIRROR});
        CausticTest.Mean found = CausticTest.Mean.of(scene, 1 << 17);
        assertTrue(found.error() < 0.05 * expected, found + ", expected " + expected);
        assertTrue(Math.abs(found.value() - expected) < 4 * found.error(), found + ", not " + expected);
    }

    @Test
    void aMirrorLightsFogAsTheImageOfAPointLightDoes() {
        double expected = 0;
        for (int k = 0; k < PLACES * PLACES; k++) {
            double x = 0.1 + 0.8 * (k % PLACES + 0.5) / PLACES;
            double y = -0.9 + 0.8 * (k / PLACES + 0.5) / PLACES;
            expected += ofImage(x, y, -3.9, 0, 0) / PLACES / PLACES;
        }
        assertMean(
                """
                "camera": { "type": "orthographic", "eye": [0.5, -0.5, -3.9], "lookAt": [0.5, -0.5, 0], "up": [0, 1, 0], "height": 0.8 },
                """,
                expected);
    }

    /** What is scattered near the eye counts by the inverse square of its distance. */
    @Test
    void anEyeInTheFogSeesTheSame() {
        double tangent = Math.tan(Math.toRadians(10));
        double expected = 0;
        for (int k = 0; k < PLACES * PLACES; k++) {
            double dx = tangent * (2 * (k % PLACES + 0.5) / PLACES - 1);
            double dy = tangent * (2 * (k / PLACES + 0.5) / PLACES - 1);
            expected += ofImage(0.5, 0.5, -3, dx, dy) / PLACES / PLACES;
        }
        assertMean(
                """
                "camera": { "type": "perspective", "eye": [0.5, 0.5, -3], "lookAt": [0.5, 0.5, 0], "up": [0, 1, 0], "fieldOfView": 20 },
                """,
                expected);
    }

    /** All ways over fog and surfaces, with milk that refracts, whose inside is left to paths from the eye. */
    @Test
    void theyAreWhatPathsFromTheEyeFindByChance() {
        String camera =
                """
                "camera": { "type": "perspective", "eye": [0, 3, -4], "lookAt": [0, 0.5, 0], "up": [0, 1, 0], "fieldOfView": 40 },
                """;
        String lamp =
                "{ \"type\": \"sphere\", \"center\": [-1.2, 2, 0.4], \"radius\": 0.7, \"color\": \"#ffffff\", \"radiance\": [3, 2, 1] }";
        String fog = FOG.replace("0.3", "[0.2, 0.1, 0.4]")
                .replace("\"absorptionCoefficient\": 0", "\"absorptionCoefficient\": 0.05");
        String ball =
                """
                { "type": "sphere", "center": [0.6, 0.7, 0.3], "radius": 0.6,
                  "material": { "type": "mirror", "color": { "linear": [0.9, 0.8, 0.7] } } }
                """;
        String milk =
                """
                { "type": "sphere", "center": [-0.7, 0.6, -0.3], "radius": 0.5,
                  "material": { "type": "scattering", "scatteringCoefficient": 4, "absorptionCoefficient": 0.1, "indexOfRefraction": 1.3 } }
                """;
        String floor =
                """
                { "type": "rectangle", "corners": [[-3, 0, -3], [-3, 0, 3], [3, 0, 3], [3, 0, -3]],
                  "material": { "type": "matte", "color": { "linear": [0.6, 0.5, 0.4] } } }
                """;
        CausticTest.assertSame(CausticTest.scene("", camera, lamp, new String[] {fog, ball, milk, floor}), 256, 16_384);
    }
}
