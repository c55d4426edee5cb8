package enlightenment.method.cluster;

import enlightenment.method.Block;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.world.CompiledScene;

/**
 * The deterministic part of paths through the corners of a block's pixels, with the surfaces that they hit
 * ({@link PathIntegrator#certain}). Paths end at their first random decision, so that a corner costs a fraction of a path.
 *
 * <p>The result of a corner is a pure function of the scene and the corner; objects that move while the shutter is open are seen at the
 * time of the frame.
 */
final class PhysicalSurvey extends Corners {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final PathIntegrator tracer;
    private final Ray ray = new Ray();
    private final SobolSampler sampler = new SobolSampler();
    private final double[] color = new double[3];
    private int rays;
    private boolean empty;

    PhysicalSurvey(CompiledScene scene, RenderSettings settings, PathIntegrator tracer, int blockSide) {
        super(blockSide);
        this.scene = scene;
        this.settings = settings;
        this.tracer = tracer;
    }

    /** Traces a path through each corner of the pixels of a block. */
    void take(Block block) {
        empty = scene.instants.length == 0 && tracer.seesNothing();
        if (empty) {
            // The background is the same everywhere, so one corner serves for all.
            look(block, 0, 0);
            for (int k = 1; k < nodes; k++) {
                System.arraycopy(rgb, 0, rgb, 3 * k, 3);
                keys[k] = keys[0];
            }
            rays = 1;
            return;
        }
        for (int j = 0; j <= block.height(); j++) {
            for (int i = 0; i <= block.width(); i++) {
                look(block, i, j);
            }
        }
        rays = (block.width() + 1) * (block.height() + 1);
    }

    private void look(Block block, int i, int j) {
        int column = block.x() + i;
        int row = block.y() + j;
        // The deterministic part does not use random numbers, but paths ask for them.
        sampler.pixel(Hash.mix(settings.seed()), column, row);
        sampler.sample(0);
        scene.camera.ray((double) column / settings.width(), (double) row / settings.height(), ray);
        tracer.glimpse(ray, sampler);
        int k = node(i, j);
        keys[k] = tracer.certain(color);
        System.arraycopy(color, 0, rgb, 3 * k, 3);
    }

    /** Whether the block is known to show only background. */
    boolean isEmpty() {
        return empty;
    }

    /** The number of rays traced. */
    int rays() {
        return rays;
    }
}
