package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.ExactPoint;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A ball that is much smaller than a unit in the last place of its distance gives what a point gives of the same power. */
class TinyLampsTest {
    private static final Rgb POWER = new Rgb(30, 20, 25);
    private static final Material CLEAR = new Glass(linear(1, 1, 1), 1, 1, 0, true);

    /** Above what the camera sees: a ball there would be seen, which a point never is. */
    private static final ExactPoint CENTER = at(0.2, 2.2, -0.5);

    /** A closed room with a ball in it, seen from within. */
    private static Scene.Builder room(int bounces) {
        return PhysicalScenes.view(8, 8)
                .shading(PhysicalScenes.atMost(bounces, 0))
                .object(new Box(at(-1.5, -0.5, -4), at(1.5, 2.5, 1.7)), PhysicalScenes.WHITE)
                .object(ball(-0.3, 0.4, 0.6, 0.35), PhysicalScenes.RED);
    }

    private static Scene.Builder behind(String what, int bounces) {
        Scene.Builder room = room(bounces);
        return switch (what) {
            case "pane" ->
                room.object(
                        TestScenes.rectangle(-1.4, 1.7, -1.8, -1.4, 1.75, 1.1, 1.4, 1.75, 1.1, 1.4, 1.7, -1.8),
                        new Glass(linear(0.9, 0.8, 0.7), 1.5, 1, 0, true));
            case "clear ball" -> room.object(ball(0.31, 2.13, -0.6, 0.35), CLEAR);
            case "filter" ->
                room.object(
                        ball(0.31, 2.13, -0.6, 0.35),
                        Glass.of(linear(1, 1, 1), 1).withAbsorption(new Rgb(0.8, 1.5, 2)));
            case "fog" ->
                room.object(
                        ball(0.31, 2.13, -0.6, 0.35),
                        new Material.Scattering(
                                new Medium.Coefficients(new Rgb(0.9, 0.6, 0.3), new Rgb(0.4, 0.2, 0.3), 0.2), 1, 0, 0));
            default -> throw new AssertionError(what);
        };
    }

    private static Light point() {
        return new Light.Point(CENTER, Rgb.WHITE, Emission.power(POWER));
    }

    private static Light lamp(double radius) {
        return new Light.Sphere(CENTER, radius, Rgb.WHITE, Emission.power(POWER));
    }

    private static double mean(Scene scene, BuiltInMethod method, int antialias) {
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(method)
                .withAntialias(antialias)
                .withThreads(1);
        return Rendered.mean(scene, settings);
    }

    /** Light that comes straight from the lamp has a closed form for each sample: radii change it by R/d. */
    @ParameterizedTest
    @ValueSource(strings = {"pane", "clear ball", "filter"})
    void straightLightIsThatOfAPoint(String what) {
        Scene expected = behind(what, 1).light(point()).build();
        double of = mean(expected, BuiltInMethod.RAYTRACE, 2);
        assertTrue(of > 0);
        for (double radius : new double[] {1e-8, 1e-16, 1e-30}) {
            Scene scene = behind(what, 1).light(lamp(radius)).build();
            assertEquals(1, mean(scene, BuiltInMethod.RAYTRACE, 2) / of, 1e-6, what + ", radius " + radius);
        }
    }

    /** With all bounces, within the noise of two pictures: some 1 % each. */
    @ParameterizedTest
    @CsvSource({
        "pane, RAYTRACE", "clear ball, RAYTRACE", "fog, RAYTRACE",
        "pane, BIDIRECTIONAL", "clear ball, BIDIRECTIONAL", "fog, BIDIRECTIONAL"
    })
    void allLightIsThatOfAPoint(String what, BuiltInMethod method) {
        double of = mean(behind(what, 4).light(point()).build(), method, 8);
        for (double radius : new double[] {1e-8, 1e-16, 1e-30}) {
            Scene scene = behind(what, 4).light(lamp(radius)).build();
            assertEquals(1, mean(scene, method, 8) / of, 0.06, what + ", radius " + radius);
        }
    }

    /** What stands between the pane and the lamp, as near as one likes, hides it. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-10})
    void whatIsBeforeTheLampHidesIt(double gap) {
        double y = 2.2 - gap;
        for (double radius : new double[] {1e-16, 1e-30}) {
            Scene scene = behind("pane", 1)
                    .object(TestScenes.rectangle(-9, y, -9, -9, y, 9, 9, y, 9, 9, y, -9), PhysicalScenes.WHITE)
                    .light(lamp(radius))
                    .build();
            // The camera is below, and so is all that it sees, but for that screen's lower side.
            assertEquals(0, mean(scene, BuiltInMethod.RAYTRACE, 2), "radius " + radius);
        }
    }
}
