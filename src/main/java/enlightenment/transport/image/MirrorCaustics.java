package enlightenment.transport.image;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.PathEvent;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathStrategy;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.PathVertex;
import enlightenment.transport.state.PowerHeuristic;
import enlightenment.world.CompiledScene;
import enlightenment.world.MirrorBalls;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;

/**
 * Light that reaches a vertex by one reflection at a spherical mirror. The caustic pass cannot sample it where the eye sees the vertex
 * itself in a mirror or through glass, and BSDF samples rarely do: the few that succeed are the brightest paths of all. This strategy
 * samples a direction within the mirror's image of the light, and combines it with BSDF sampling by the power heuristic: the result does
 * not depend on what the image is taken for.
 *
 * <p>A special case of specular manifold sampling (J. Hanika, M. Droske and L. Fascione, "Manifold next event estimation", 2015; T.
 * Zeltner, I. Georgiev and W. Jakob, "Specular manifold sampling", 2020), in which an image needs no derivatives.
 */
public final class MirrorCaustics implements PathStrategy {
    /** Value of {@link #sampledAt} for no vertex. */
    private static final int NONE = -3;

    private final PhysicalScene physical;
    private final MirrorBalls balls;
    private final PathFollower path;
    private final MirrorImage[] images;
    private final Ray shadow = new Ray();
    private final MirroredLight mirrored;
    private final double[] pair = new double[2];

    /** The number of surfaces that the path had left at the last vertex where images were sampled. */
    private int sampledAt = NONE;

    /** The estimate of this strategy: radiance towards the path's previous vertex. */
    private double red;

    private double green;
    private double blue;
    private double ultraviolet;

    private MirrorCaustics(CompiledScene scene, RayCounters counters, PathFollower path) {
        mirrored = new MirroredLight(scene, counters, path.tracer);
        this.path = path;
        physical = scene.physical;
        balls = scene.mirrorBalls;
        images = new MirrorImage[balls.pairs()];
        for (int k = 0; k < images.length; k++) {
            images[k] = new MirrorImage();
        }
    }

    /** Makes the strategy of one thread; null if the scene has no mirrors for it. */
    public static MirrorCaustics of(CompiledScene scene, RayCounters counters, PathFollower path) {
        return scene.mirrorBalls == null || scene.physical.hasMasks ? null : new MirrorCaustics(scene, counters, path);
    }

    /** Begins a path: no vertex was sampled. */
    public void begin() {
        sampledAt = NONE;
    }

    @Override
    public void direct(PathVertex vertex, PathState state, Sampler sampler, PathValue value) {
        sampledAt = NONE;
        if (!state.isSeenBySpecular()) {
            return;
        }
        red = 0;
        green = 0;
        blue = 0;
        ultraviolet = 0;
        // No images in a medium, whose absorption they ignore: BSDF samples find this light there.
        if (path.mayScatterTwice() && path.medium() == null) {
            sampledAt = path.surfaces;
            sample(vertex.bsdf, vertex.s, sampler, state.address);
        }
        value.addIndirect(red, green, blue, ultraviolet);
    }

    private void sample(Bsdf bsdf, Scattering s, Sampler sampler, int address) {
        sampler.pair(address, Sampler.Purpose.MIRROR, pair);
        for (int k = 0; k < images.length; k++) {
            MirrorImage image = images[k];
            if (aim(k)) {
                image.sample(pair[0], pair[1]);
                s.ix = image.dx;
                s.iy = image.dy;
                s.iz = image.dz;
                bsdf.evaluate(s);
                if ((s.valueR > 0 || s.valueG > 0 || s.valueB > 0) && meetsLight(k)) {
                    add(s, image.pdf, physical.lights[balls.light[k]]);
                }
            }
        }
    }

    private boolean aim(int k) {
        SpherePrimitive ball = balls.mirror[k];
        PhysicalLight l = physical.lights[balls.light[k]];
        Hit at = path.at.hit;
        return images[k].aim(ball, l, at.px, at.py, at.pz);
    }

    /** Whether the sampled direction leads to the mirror of pair k, and by reflection to its light. */
    private boolean meetsLight(int k) {
        path.poll.tick();
        Hit at = path.at.hit;
        MirrorImage image = images[k];
        shadow.set(at.px, at.py, at.pz, image.dx, image.dy, image.dz, 0).from(at, at.side);
        path.glass.startOnAll(shadow);
        return !path.glass.entersAtOnce() && mirrored.isMetBy(shadow, balls.id[k], balls.light[k]);
    }

    private void add(Scattering s, double density, PhysicalLight l) {
        double f = PowerHeuristic.weight(s.pdf, density) / density;
        red = Math.fma(f * s.valueR * mirrored.red, l.r, red);
        green = Math.fma(f * s.valueG * mirrored.green, l.g, green);
        blue = Math.fma(f * s.valueB * mirrored.blue, l.b, blue);
        ultraviolet = Math.fma(f * s.valueB * mirrored.blue, l.ultraviolet, ultraviolet);
    }

    @Override
    public double weightOfHit(PathState state, Ray ray, int light) {
        boolean isReflected =
                path.surfaces == sampledAt + 2 && state.mirror >= 0 && state.beforeLast() != PathEvent.SPECULAR;
        if (!isReflected) {
            return 1;
        }
        for (int k = 0; k < images.length; k++) {
            if (balls.id[k] == state.mirror && balls.light[k] == light) {
                MirrorImage image = images[k];
                return image.pdf > 0 && image.contains(state.dx, state.dy, state.dz)
                        ? PowerHeuristic.weight(image.pdf, state.pdf)
                        : 1;
            }
        }
        return 1;
    }
}
