package enlightenment.shading;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.PhysicalLight;
import enlightenment.compiled.RayCounters;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.sampling.SobolSampler;
import java.util.function.BooleanSupplier;

/** The paths from small lights that come into media behind borders which refract, of all that begin at a moment of a scene. */
final class EnteringPaths {
    /** Paths that are sought, and that are tried at most. */
    private static final int SOUGHT = 1 << 9;

    private static final int TRIED = 1 << 16;

    final CompiledScene scene;
    private final BidirectionalTracer tracer;
    private final SobolSampler sampler = new SobolSampler();

    /** The numbers of those that were found, of all that were tried. */
    private final int[] entering = new int[SOUGHT];

    private int found;
    private int tried;
    private int connections;

    /**
     * Seeks them.
     *
     * @param mayEnter whether any are known to come in; if not, none is sought
     * @param cancelled asked now and then, by {@link #connectNext} as well
     * @throws java.util.concurrent.CancellationException soon after that has become true
     */
    EnteringPaths(CompiledScene scene, long seed, boolean mayEnter, BooleanSupplier cancelled) {
        this.scene = scene;
        tracer = new BidirectionalTracer(scene, new RayCounters(scene.kindNames.size()));
        tracer.stopWhen(cancelled);
        tracer.beginTile(0, 0, 1, 1);
        sampler.pixel(seed, 0, 0);
        while (mayEnter && tried < TRIED && found < SOUGHT) {
            sampler.sample(tried);
            if (enters()) {
                entering[found++] = tried;
            }
            tried++;
        }
    }

    /** Whether mirrors and smooth glass send a path into such a medium, from a light that paths from the eye hardly find. */
    private boolean enters() {
        LightSubpath path = tracer.light();
        boolean goes = path.begin(sampler);
        while (goes) {
            switch (path.next(sampler)) {
                case MEDIUM:
                    return !path.seesLamps() && isRare(path.source.light, path.path.hit);
                case SURFACE:
                    goes = path.bsdf.isDelta() && path.mayScatter() && path.leave(sampler);
                    break;
                case PASSED:
                    break;
                default:
                    goes = false;
                    break;
            }
        }
        return false;
    }

    private boolean isRare(int light, Hit seenFrom) {
        PhysicalLight from = scene.lightStarts(false).lights[light];
        return MediumBeams.group(from, seenFrom.px, seenFrom.py, seenFrom.pz) >= 0;
    }

    /** How many of those that begin come in. */
    double probability() {
        return found == 0 ? 0 : (double) found / tried;
    }

    int tried() {
        return tried;
    }

    /**
     * Connects the next of them, of which there are some, to the path of a camera ray.
     *
     * @param color receives what that brings
     */
    void connectNext(Ray ray, Sampler ofEye, double[] color) {
        sampler.sample(entering[connections++ % found]);
        tracer.connect(ray, ofEye, sampler, color);
    }
}
