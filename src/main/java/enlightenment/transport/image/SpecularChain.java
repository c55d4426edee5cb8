package enlightenment.transport.image;

import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.Shader;
import enlightenment.transport.state.PathValue;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;

/**
 * Follows paths from the eye that mirrors and smooth glass alone turn, by choices between reflection and transmission that are made before:
 * a chain of them is a number, in binary a 1 and a digit for each surface, 0 where it reflects, 1 where it is passed. What chance would
 * choose with some probability is worth so much less. A mutable work object, one per thread.
 */
final class SpecularChain {
    /** The chain of no events. */
    static final long STRAIGHT = 1;

    /** Of more events than there is room for: no chain. */
    static final long NONE = 0;

    private static final long LARGEST = 1L << 62;

    /** Chooses transmission wherever there is any: chance is less than 1. */
    private static final double LAST = Math.nextDown(1.0);

    private final CompiledScene scene;
    private final PathFollower path;
    private final PathValue value = new PathValue();
    private final MirroredLight panesOf;
    private final Scattering border = new Scattering();
    private final double[] weight = new double[3];
    private final double[] pair = new double[2];

    /** How many panes the path has passed, if it has done nothing else. */
    private int panes;

    /** What the path has come to after the chain's last event. */
    private PathFollower.Event event;

    /** What is left along the last path, by band, of radiance where it has ended. */
    double red;

    double green;
    double blue;

    SpecularChain(CompiledScene scene, RayCounters counters) {
        this.scene = scene;
        path = new PathFollower(scene, counters, scene.physical.maxBounces);
        panesOf = new MirroredLight(scene, counters, path.tracer);
    }

    /** A chain with one more event; none if there is none before. */
    static long and(long chain, boolean isTransmitted) {
        return chain == NONE || chain >= LARGEST ? NONE : chain << 1 | (isTransmitted ? 1 : 0);
    }

    /** How many events a chain has; -1 of no chain. */
    static int length(long chain) {
        return Long.SIZE - 1 - Long.numberOfLeadingZeros(chain);
    }

    /** Sets the tile of the camera rays to come, as {@link Shader#beginTile}. */
    void beginTile(double x0, double y0, double x1, double y1) {
        path.tracer.beginTile(x0, y0, x1, y1);
    }

    /**
     * Follows a camera ray, which becomes the ray after the chain's last event, to what it meets then, if anything.
     *
     * @return whether all of the events happen, and something is left
     */
    boolean follow(Ray ray, long chain) {
        path.beginAgain(ray);
        value.begin(path.glass.indexOfRefraction());
        panes = 0;
        arrive(ray);
        for (int k = length(chain) - 1; k >= 0; k--) {
            if (event == PathFollower.Event.NOTHING || !leave(ray, (chain >> k & 1) != 0)) {
                return false;
            }
            arrive(ray);
        }
        red = value.throughputR * value.compression();
        green = value.throughputG * value.compression();
        blue = value.throughputB * value.compression();
        return red + green + blue > 0;
    }

    private void arrive(Ray ray) {
        SurfaceMaterial medium = scene.physical.hasAbsorption ? path.medium() : null;
        event = path.next(ray);
        if (medium != null && medium.absorbs) {
            value.absorb(medium, distance(ray));
        }
    }

    /** How far the ray went to what it met last; infinite if that is nothing. */
    double distance(Ray ray) {
        return event == PathFollower.Event.NOTHING ? Double.MAX_VALUE : path.distance(ray);
    }

    private boolean leave(Ray ray, boolean isTransmitted) {
        return (event == PathFollower.Event.GLASS ? cross(ray, isTransmitted) : !isTransmitted && reflect(ray))
                && path.goesOn();
    }

    private boolean reflect(Ray ray) {
        SurfaceMaterial material = path.material();
        if (!reflects(material) || !path.mayScatter()) {
            return false;
        }
        path.color(material, weight);
        boolean goes = path.scatter(ray, material, weight, 0, 0, 0);
        value.filter(weight[0], weight[1], weight[2]);
        return goes;
    }

    private static boolean reflects(SurfaceMaterial material) {
        return material.isDelta && !material.isBlack;
    }

    private boolean cross(Ray ray, boolean isTransmitted) {
        if (scene.physical.hasPartialGlass && path.glass.opaque(0) >= 0
                || scene.physical.hasRoughGlass && path.roughBorder(ray, border) != null) {
            return false;
        }
        path.glass.choose(isTransmitted ? LAST : 0, pair);
        if (path.cross(ray) != isTransmitted) {
            return false;
        }
        double share = path.glass.clear(1) * path.glass.weight() * path.glass.probability();
        Arrays.fill(weight, share);
        if (isTransmitted) {
            path.filter(weight);
            if (panes == path.surfaces && path.glass.passedStraight() && panesOf.isPane(path.id, path.hit.face)) {
                panes++;
            }
        }
        value.enter(path.glass.indexOfRefraction());
        value.filter(weight[0], weight[1], weight[2]);
        return true;
    }

    /** Whether the last path has come to glass, or to a mirror, so that a longer chain may go on. */
    boolean goesOn(boolean isTransmitted) {
        return event == PathFollower.Event.GLASS
                || event == PathFollower.Event.SURFACE && !isTransmitted && reflects(path.material());
    }

    /** Whether the last path, of this chain, is neither straight nor reflected just once: those are other images. */
    boolean isOwn(long chain) {
        return path.surfaces != panes && chain != and(STRAIGHT, false);
    }

    /** Whether the last path has come to a light, by its index, where that glows. */
    boolean isAt(int light) {
        return event == PathFollower.Event.SURFACE
                && scene.physical.lightOf(path.id, path.hit.face) == light
                && path.material().glowsTo(path.hit.side);
    }

    /** Whether the last path has come to a primitive. */
    boolean isAtPrimitive(int id) {
        return event != PathFollower.Event.NOTHING && path.id == id;
    }

    /** How many scattering events the last path had. */
    int bounces() {
        return path.bounces();
    }
}
