package enlightenment.classic.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.classic.shading.ClassicShader;
import enlightenment.color.DisplayRgb;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.method.Block;
import enlightenment.render.TestScenes;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import org.junit.jupiter.api.Test;

/** What evenly spaced rays see, and what that says about the pixels between them. */
class SurveyTest {
    private static final Shading.Classic FULL = new Shading.Classic(1, 1, DisplayRgb.BLACK, 10);

    /** A camera whose picture is the square -1..1 of the plane z = 0, seen from z = -1 along the axis. */
    private static Scene.Builder flat(int side) {
        return Scene.builder()
                .size(side, side)
                .camera(new Camera.Orthographic(ExactPoint.of(0, 0, -1), ExactPoint.of(0, 0, 0), Vec3.Y, 2));
    }

    private static Survey survey(Scene scene, Block block) {
        RenderSettings settings = RenderSettings.of(scene);
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        ClassicShader shader = new ClassicShader(compiled, 1, new RayCounters(compiled.kindNames.size()));
        shader.beginTile(
                block.x() / (double) scene.width(),
                block.y() / (double) scene.height(),
                (block.x() + block.width()) / (double) scene.width(),
                (block.y() + block.height()) / (double) scene.height());
        Survey survey = new Survey(compiled, settings, shader, null);
        survey.take(block);
        return survey;
    }

    private static SampleDemand needs(Survey survey, Block block) {
        SampleDemand needs = new SampleDemand();
        needs.of(survey, block);
        return needs;
    }

    @Test
    void neighbouringBlocksSeeTheSameAtTheirBorder() {
        Scene scene = TestScenes.whiteFireAndIce().size(40, 24).build();
        for (int y = 0; y < 24; y += 8) {
            for (int x = 0; x < 32; x += 8) {
                Survey left = survey(scene, new Block(x, y, 8, 8));
                Survey right = survey(scene, new Block(x + 8, y, 8, 8));
                for (int j = 0; j <= 8; j++) {
                    int a = left.node(8, j);
                    int b = right.node(0, j);
                    for (int c = 0; c < 3; c++) {
                        assertEquals(
                                left.rgb[3 * a + c], right.rgb[3 * b + c], "column " + (x + 8) + ", row " + (y + j));
                    }
                    assertEquals(left.keys[a], right.keys[b]);
                }
            }
        }
    }

    @Test
    void everyCornerIsLookedThroughOnce() {
        Scene scene = flat(16).shading(FULL)
                .object(TestScenes.rectangle(-2, -2, 0, -2, 2, 0, 2, 2, 0, 2, -2, 0), TestScenes.matte(0.3, 0.6, 0.9))
                .build();
        assertEquals(81, survey(scene, new Block(8, 8, 8, 8)).rays());
        assertEquals(12, survey(scene, new Block(8, 8, 3, 2)).rays());
        assertEquals(4, survey(scene, new Block(0, 0, 1, 1)).rays());
    }

    @Test
    void whereNothingComesNearOneLookIsEnough() {
        Scene scene = flat(16).shading(FULL).build();
        Block block = new Block(8, 8, 8, 8);
        Survey survey = survey(scene, block);
        assertEquals(1, survey.rays());
        SampleDemand needs = needs(survey, block);
        for (int k = 0; k < 64; k++) {
            assertEquals(0, needs.film[k] + needs.edge[k] + needs.light[k]);
        }
        for (int k = 0; k < 3 * 81; k++) {
            assertEquals(survey.rgb[k % 3], survey.rgb[k]);
        }
    }

    @Test
    void aFlatColourNeedsNextToNothing() {
        Scene scene = flat(8).shading(FULL)
                .object(TestScenes.rectangle(-2, -2, 0, -2, 2, 0, 2, 2, 0, 2, -2, 0), TestScenes.matte(0.3, 0.6, 0.9))
                .build();
        Block block = new Block(0, 0, 8, 8);
        Survey survey = survey(scene, block);
        SampleDemand needs = needs(survey, block);
        for (int k = 0; k < 64; k++) {
            assertEquals(0, needs.film[k]);
            assertEquals(0, needs.light[k]);
            assertTrue(needs.edge[k] > 0 && needs.edge[k] < 1e-7, "what is unseen");
        }
        assertTrue(needs.lightIsSettled);
        assertFalse(survey.hasDoubtfulLight());
        assertEquals(0, survey.rareShare());
    }

    /** Corners as if a colour a + b x + c y had been seen: no scene is needed for that. */
    @Test
    void aLinearRampNeedsNothing() {
        Block block = new Block(0, 0, 8, 8);
        Survey survey = survey(flat(8).build(), block);
        for (int k = 0; k < 81; k++) {
            for (int c = 0; c < 3; c++) {
                // Multiples of 1/64: no rounding.
                survey.rgb[3 * k + c] = (5 + k % 9 * (c + 1) - k / 9 * 2) / 64.0;
            }
        }
        SampleDemand needs = needs(survey, block);
        for (int k = 0; k < 64; k++) {
            assertEquals(0, needs.film[k]);
        }
    }

    @Test
    void aBentRampNeedsSomethingEverywhere() {
        Block block = new Block(0, 0, 8, 8);
        Survey survey = survey(flat(8).build(), block);
        for (int k = 0; k < 81; k++) {
            double bend = k % 9 * (k % 9) / 64.0;
            survey.rgb[3 * k] = survey.rgb[3 * k + 1] = survey.rgb[3 * k + 2] = bend;
        }
        SampleDemand needs = needs(survey, block);
        // Second differences are 2/64 everywhere: 0.1 + 0.003 of their squares.
        for (int k = 0; k < 64; k++) {
            assertEquals(0.103 / 1024, needs.film[k], 1e-12);
        }
    }

    @Test
    void anEdgeNeedsAShareOfTheVarianceOfItsCorners() {
        // Dark up to the middle of the fourth column, bright beyond: two surfaces.
        double edge = -1 + 3.5 / 4;
        Scene scene = flat(8).shading(FULL)
                .object(TestScenes.rectangle(-2, -2, 0, -2, 2, 0, edge, 2, 0, edge, -2, 0), TestScenes.matte(0, 0, 0))
                .object(TestScenes.rectangle(edge, -2, 0, edge, 2, 0, 2, 2, 0, 2, -2, 0), TestScenes.matte(1, 1, 1))
                .build();
        Block block = new Block(0, 0, 8, 8);
        SampleDemand needs = needs(survey(scene, block), block);
        double most = 0;
        double least = 1;
        for (int j = 0; j < 8; j++) {
            int at = 8 * j;
            for (int i = 0; i < 8; i++) {
                most = Math.max(most, needs.edge[at + i]);
                least = Math.min(least, needs.film[at + i] + needs.edge[at + i]);
            }
            int brightest = 0;
            for (int i = 1; i < 8; i++) {
                brightest = needs.edge[at + i] > needs.edge[at + brightest] ? i : brightest;
            }
            assertTrue(brightest == 3 || brightest == 4, "column " + brightest);
        }
        // Two corners 0 and two 1: variance 1/4, of which an edge counts twice; besides the share of the
        // block: 0.003 of second differences that are 1 at two or three of nine corners.
        assertEquals(0.5, most, 0.002);
        assertEquals(0.003 * 2.5 / 9, least, 0.003 / 9);
    }

    @Test
    void partlyHiddenLightIsInDoubtAndItsVarianceIsThatOfACoin() {
        // A ball light above a floor, half of it behind a screen's edge.
        Scene scene = Scene.builder()
                .size(8, 8)
                .camera(new Camera.Orthographic(ExactPoint.of(0, 3, 0), ExactPoint.of(0, 0, 0), Vec3.Z, 0.25))
                .shading(new Shading.Classic(0, 0, DisplayRgb.BLACK, 10))
                .object(TestScenes.rectangle(-9, 0, -9, -9, 0, 9, 9, 0, 9, 9, 0, -9), TestScenes.matte(1, 1, 1))
                .object(TestScenes.rectangle(0, 5, -9, 0, 5, 9, 9, 5, 9, 9, 5, -9), TestScenes.matte(1, 1, 1))
                .light(new Light.Sphere(ExactPoint.of(0, 10, 0), 1, DisplayRgb.WHITE))
                .build();
        Block block = new Block(0, 0, 8, 8);
        Survey survey = survey(scene, block);
        assertTrue(survey.hasDoubtfulLight());
        assertEquals(0.5, survey.rareShare(), 0.1);
        // Seen against not seen is (mean cosine)² ≈ 1, half of the points hidden: p (1 − p) = 1/4 at the block's
        // middle.
        assertEquals(0.25, needs(survey, block).light[27], 0.03);
    }
}
