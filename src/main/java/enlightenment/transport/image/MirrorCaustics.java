package enlightenment.transport.image;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.PowerHeuristic;
import enlightenment.world.CompiledScene;
import enlightenment.world.MirrorBalls;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;

/**
 * The light that reaches a vertex of a path by one reflection at a mirror that is a sphere. Light paths of the caustic pass cannot make
 * it where the vertex itself is seen in a mirror or through glass, and directions that the vertex's surface chooses seldom find it: those
 * of the few that do are the brightest paths of all. Here a direction is chosen in the mirror's image of the light, and both ways are
 * weighted by the power heuristic, as with direct light: the sum is the same whatever the image is taken for.
 *
 * <p>A special case of specular manifold sampling (J. Hanika, M. Droske and L. Fascione, "Manifold next event estimation", 2015;
 * T. Zeltner, I. Georgiev and W. Jakob, "Specular manifold sampling", 2020), in which an image needs no derivatives.
 */
public final class MirrorCaustics {
    /** The last event says nothing about a mirror's image. */
    private static final int NONE = 0;

    /** The path has left a vertex of which images are known. */
    private static final int LEFT = 1;

    /** And a mirror after it. */
    private static final int REFLECTED = 2;

    private final PhysicalScene physical;
    private final MirrorBalls balls;
    private final PathFollower path;
    private final MirrorImage[] images;
    private final Ray ray = new Ray();
    private final MirroredLight mirrored;
    private final double[] pair = new double[2];

    private int state;
    private boolean found;
    private int mirror;

    /** The direction in which the path left the vertex, and its density. */
    private double dx;

    private double dy;
    private double dz;
    private double pdf;

    /** What was gathered: radiance towards where the path came from. */
    public double red;

    public double green;
    public double blue;
    public double ultraviolet;

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

    /** What gathers for a thread; null if the scene has no mirrors for it. */
    public static MirrorCaustics of(CompiledScene scene, RayCounters counters, PathFollower path) {
        return scene.mirrorBalls == null ? null : new MirrorCaustics(scene, counters, path);
    }

    /** Forgets what the path has left behind. */
    public void begin() {
        state = NONE;
        found = false;
    }

    /**
     * Gathers the light at the surface that the path is at.
     *
     * @param s the surface, with its colour
     */
    public void gather(Bsdf bsdf, Scattering s, Sampler sampler, int address) {
        begin();
        red = 0;
        green = 0;
        blue = 0;
        ultraviolet = 0;
        // In a medium absorption counts as well: left to chance.
        if (!path.mayScatterTwice() || path.medium() != null) {
            return;
        }
        found = true;
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
        Hit at = path.hit;
        return images[k].aim(ball, l, at.px, at.py, at.pz);
    }

    /** Whether the direction sampled leads to the mirror of the pair, and from there to the light. */
    private boolean meetsLight(int k) {
        path.poll.tick();
        Hit at = path.hit;
        MirrorImage image = images[k];
        ray.set(at.px, at.py, at.pz, image.dx, image.dy, image.dz, 0).from(at.primitive, at.side);
        path.glass.startOnAll(ray);
        return !path.glass.entersAtOnce() && mirrored.isMetBy(ray, balls.id[k], balls.light[k]);
    }

    private void add(Scattering s, double density, PhysicalLight l) {
        double f = PowerHeuristic.weight(s.pdf, density) / density;
        red = Math.fma(f * s.valueR * mirrored.red, l.r, red);
        green = Math.fma(f * s.valueG * mirrored.green, l.g, green);
        blue = Math.fma(f * s.valueB * mirrored.blue, l.b, blue);
        ultraviolet = Math.fma(f * s.valueB * mirrored.blue, l.ultraviolet, ultraviolet);
    }

    /** Tells the direction in which the path leaves the vertex that was gathered at, and its density per solid angle. */
    public void left(Scattering s) {
        state = found && !s.delta ? LEFT : NONE;
        found = false;
        dx = s.ix;
        dy = s.iy;
        dz = s.iz;
        pdf = s.pdf;
    }

    /** Tells that a mirror reflected the path. */
    public void reflected(int id) {
        state = state == LEFT ? REFLECTED : NONE;
        mirror = id;
    }

    /** The weight of what the surface that the path is at emits. */
    public double weight() {
        if (state != REFLECTED) {
            return 1;
        }
        int light = physical.lightOf(path.id, path.hit.face);
        for (int k = 0; k < images.length; k++) {
            if (balls.id[k] == mirror && balls.light[k] == light) {
                MirrorImage image = images[k];
                return image.pdf > 0 && image.contains(dx, dy, dz) ? PowerHeuristic.weight(image.pdf, pdf) : 1;
            }
        }
        return 1;
    }
}
