package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A solid of glass that stands on a surface: light crosses their common face in both directions, as if a hair of air were between. */
class GlassOnFloorTest {
    private static final int SIDE = 8;

    private static Material glass(double roughness) {
        return new Glass(linear(1, 1, 1), 1.5, 1, 0, true).withRoughness(roughness);
    }

    private static double mean(BuiltInMethod method, double reflectance, double gap, double roughness) {
        return mean(
                method,
                PhysicalScenes.view(SIDE, SIDE)
                        .camera(new Camera.Perspective(at(0, 6, -0.5), at(0, 0, 0), Vec3.Z, 12))
                        .shading(PhysicalScenes.atMost(100, 1))
                        .object(
                                TestScenes.rectangle(-6, -gap, -6, -6, -gap, 6, 6, -gap, 6, 6, -gap, -6),
                                matte(reflectance, reflectance, reflectance))
                        .object(new Box(at(-1, 0, -1), at(1, 1, 1)), glass(roughness))
                        .build());
    }

    /** A cylinder on a disk that is aligned with no axis: which of the two is met first is up to rounding. */
    private static double tilted(BuiltInMethod method, double reflectance, double gap, double roughness) {
        Vec3 n = new Vec3(0.3, 1, 0.2);
        Vec3 up = n.normalized();
        Vec3 foot = new Vec3(0.1, 0.2, 0.3);
        return mean(
                method,
                PhysicalScenes.view(SIDE, SIDE)
                        .camera(new Camera.Perspective(at(foot.plus(up.times(6))), at(foot), Vec3.Z, 14))
                        .shading(PhysicalScenes.atMost(100, 1))
                        .object(
                                new Disk(at(foot.minus(up.times(gap))), n, 5),
                                matte(reflectance, reflectance, reflectance))
                        .object(new Cylinder(at(foot), at(foot.plus(up)), 0.9, true), glass(roughness))
                        .build());
    }

    private static double mean(BuiltInMethod method, Scene scene) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method).withAntialias(16);
        return Rendered.mean(scene, settings);
    }

    /** Nothing absorbs, and the surroundings are the same everywhere: all is as bright as they. What roulette adds is below a percent. */
    @ParameterizedTest
    @CsvSource({"RAYTRACE", "CLUSTER", "BIDIRECTIONAL"})
    void aWhiteFurnaceShowsNothing(BuiltInMethod method) {
        assertEquals(1, mean(method, 1, 0, 0), 0.02);
    }

    /** Sixteen thousand paths, of about the mean of the surroundings each. */
    @ParameterizedTest
    @CsvSource({"RAYTRACE, 0", "RAYTRACE, 0.5", "BIDIRECTIONAL, 0", "CLUSTER, 0.5"})
    void contactIsTheLimitOfAThinGap(BuiltInMethod method, double roughness) {
        assertEquals(mean(method, 0.7, 1e-6, roughness), mean(method, 0.7, 0, roughness), 0.015);
    }

    /** Where rounding puts the interface behind the surface, light that the glass reflects must come back to the surface all the same. */
    @ParameterizedTest
    @CsvSource({"RAYTRACE, 0", "RAYTRACE, 0.5", "BIDIRECTIONAL, 0", "BIDIRECTIONAL, 0.5", "CLUSTER, 0"})
    void contactIsTheLimitOfAThinGapWhateverRoundingPutsFirst(BuiltInMethod method, double roughness) {
        assertEquals(tilted(method, 0.7, 1e-6, roughness), tilted(method, 0.7, 0, roughness), 0.008);
    }
}
