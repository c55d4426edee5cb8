package enlightenment.method;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.camera.Camera;
import enlightenment.film.FilmTile;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;

/** A method asks nothing of a shader but what {@link Shader} says. */
class ReplacedShaderTest {
    private static final int SIZE = 8;

    private final Scene scene = Scene.builder()
            .size(SIZE, SIZE)
            .camera(new Camera.Orthographic(ExactPoint.of(0, 0, -1), ExactPoint.ORIGIN, Vec3.Y, 2))
            .build();
    private final RenderSettings settings = RenderSettings.of(scene);
    private final CompiledScene compiled = SceneCompiler.compile(scene, settings);

    /** Shows where rays start and one of their numbers. */
    private static final class Places implements Shader {
        private BooleanSupplier cancelled = () -> false;
        private double right;
        private double bottom;
        private int shaded;

        @Override
        public void beginTile(double x0, double y0, double x1, double y1) {
            right = x1;
            bottom = y1;
        }

        @Override
        public boolean seesNothing() {
            return false;
        }

        @Override
        public void stopWhen(BooleanSupplier condition) {
            cancelled = condition;
        }

        @Override
        public void shade(Ray ray, Sampler sampler, double[] out) {
            if (cancelled.getAsBoolean()) {
                throw new CancellationException();
            }
            shaded++;
            double[] pair = new double[2];
            sampler.pair(0, Sampler.Purpose.DIRECTION, pair);
            out[0] = ray.ox;
            out[1] = ray.oy;
            out[2] = pair[0] < 0.25 ? 1 : 0;
        }
    }

    @Test
    void itsColoursBecomePixels() {
        Places places = new Places();
        RayTraceMethod method = new RayTraceMethod(compiled, settings, places, 16);
        FilmTile tile = new FilmTile(0, 0, SIZE, SIZE / 2);
        method.render(tile);
        assertEquals(SIZE * SIZE / 2 * 16, places.shaded);
        assertEquals(1, places.right);
        assertEquals(0.5, places.bottom);
        double pixel = 2.0 / SIZE;
        for (int x = 1; x < SIZE; x++) {
            // Stratified in each pixel: a mean is its middle to an eighth of it.
            assertEquals(pixel, Math.abs(tile.mean(x, 0, 0) - tile.mean(x - 1, 0, 0)), pixel / 4);
            assertEquals(tile.mean(0, 0, 1), tile.mean(x, 0, 1), pixel / 4);
            assertEquals(0.25, tile.mean(x, 0, 2), "4 of 16 numbers");
        }
    }

    @Test
    void itIsToldWhenToStop() {
        RayTraceMethod method = new RayTraceMethod(compiled, settings, new Places(), 1);
        method.stopWhen(() -> true);
        assertThrows(CancellationException.class, () -> method.render(new FilmTile(0, 0, 1, 1)));
    }
}
