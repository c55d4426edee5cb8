package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.LightCone;
import enlightenment.compiled.PhysicalLight;
import enlightenment.compiled.PhysicalScene;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.Tracer;
import enlightenment.emitter.EmitterView;
import enlightenment.emitter.SphereEmitter;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/**
 * The light that reaches a vertex of a path straight from the lights, and the weight of light that the path runs into after it: what
 * both find is counted once.
 */
final class PathLight {
    private final PhysicalScene physical;
    private final PhysicalLight[] lights;
    private final RayCounters counters;
    private final PathFollower path;
    private final Hit hit;
    private final GlassTracer glass;
    private final Tracer tracer;
    private final LightCone cone = new LightCone();
    private final EmitterView view = new EmitterView(cone);
    private final Ray shadowRay = new Ray();

    /** Primitives that the vertex lies on; if there are more, the others are tested needlessly. The last is the light's own. */
    private final int[] starts = new int[9];

    private int startCount;

    /** The last vertex that scattered light other than into single directions, and its normal on the side that the path came from. */
    private double x;

    private double y;
    private double z;
    private double nx;
    private double ny;
    private double nz;

    /** Whether it is Lambertian. */
    private boolean isMatte;

    /** The density per solid angle with which the path left it. */
    private double pdf;

    /** What was gathered: radiance towards where the path came from; of a Lambertian surface, that of a white one. */
    double red;

    double green;
    double blue;

    PathLight(CompiledScene scene, RayCounters counters, PathFollower path) {
        physical = scene.physical;
        lights = physical.lights;
        this.counters = counters;
        this.path = path;
        hit = path.hit;
        glass = path.glass;
        tracer = path.tracer;
    }

    private void begin(boolean matte) {
        isMatte = matte;
        double facing = hit.side;
        x = hit.px;
        y = hit.py;
        z = hit.pz;
        nx = hit.nx * facing;
        ny = hit.ny * facing;
        nz = hit.nz * facing;
        red = 0;
        green = 0;
        blue = 0;
        findStarts();
    }

    /** Tells the density per solid angle of the direction in which the path leaves the vertex. */
    void left(double density) {
        pdf = density;
    }

    /** Gathers the light at the Lambertian surface that the path is at. */
    void gatherMatte(Sampler sampler, int address) {
        begin(true);
        for (int i = 0; i < lights.length; i++) {
            PhysicalLight l = lights[i];
            counters.lightSamples++;
            double e = irradiance(l, i, sampler, address);
            if (e > 0) {
                double f = e / Math.PI;
                red = Math.fma(f, l.r, red);
                green = Math.fma(f, l.g, green);
                blue = Math.fma(f, l.b, blue);
            }
        }
    }

    /** The irradiance, estimated, of a light of radiance 1 or of a point of intensity 1; the part of it that is not left to chance. */
    private double irradiance(PhysicalLight l, int index, Sampler sampler, int address) {
        aim(l, x, y, z);
        if (l.form instanceof SphereEmitter sphere) {
            return ofSphere(l, sphere, index, sampler, address);
        }
        if (l.isPoint) {
            double cosine = nx * cone.wx + ny * cone.wy + nz * cone.wz;
            l.form.sample(view, 0, 0);
            return cosine > 0 && isVisible(l) ? cosine / (cone.distance * cone.distance) : 0;
        }
        sampler.lightPoints(index, address, 1);
        l.form.sample(view, sampler.lightX(0), sampler.lightY(0));
        double cosine = nx * view.dx + ny * view.dy + nz * view.dz;
        if (!(cosine > 0) || !isLitBy(l) || !isVisible(l)) {
            return 0;
        }
        double density = l.form.pdf(view);
        return density > 0 ? cosine / density * weight(cosine / Math.PI, density) : 0;
    }

    private double ofSphere(PhysicalLight l, SphereEmitter sphere, int index, Sampler sampler, int address) {
        if (cone.inside) {
            return 0;
        }
        double mean = sphere.meanCosine(view, nx, ny, nz);
        if (mean == 0) {
            counters.lightSamplesWithoutRay++;
            return 0;
        }
        double angle = 2 * Math.PI * cone.oneMinusCosine;
        Tracer.Visibility visibility = visibility(l);
        boolean whole = mean == mean;
        if (visibility != Tracer.Visibility.UNKNOWN) {
            counters.lightSamplesWithoutRay++;
            if (visibility == Tracer.Visibility.NONE) {
                return 0;
            }
            if (whole) {
                return mean * angle;
            }
        }
        sampler.lightPoints(index, address, 1);
        if (whole) {
            sphere.prepareByCosine(view, nx, ny, nz);
            sphere.sampleByCosine(view, sampler.lightX(0), sampler.lightY(0));
            return isBlocked(l) ? 0 : mean * angle;
        }
        sphere.sample(view, sampler.lightX(0), sampler.lightY(0));
        double cosine = nx * view.dx + ny * view.dy + nz * view.dz;
        return cosine > 0 && (visibility == Tracer.Visibility.ALL || !isBlocked(l)) ? cosine * angle : 0;
    }

    /** Gathers the light at the surface that the path is at, whatever its lobes. */
    void gather(Bsdf bsdf, Scattering s, Sampler sampler, int address) {
        begin(false);
        for (int i = 0; i < lights.length; i++) {
            PhysicalLight l = lights[i];
            counters.lightSamples++;
            aim(l, x, y, z);
            if (cone.inside && !l.isPoint) {
                continue;
            }
            sampler.lightPoints(i, address, 1);
            l.form.sample(view, sampler.lightX(0), sampler.lightY(0));
            s.ix = view.dx;
            s.iy = view.dy;
            s.iz = view.dz;
            bsdf.evaluate(s);
            if (!(s.valueR > 0 || s.valueG > 0 || s.valueB > 0) || !isLitBy(l) || !isVisible(l)) {
                continue;
            }
            double density = l.isPoint ? cone.distance * cone.distance : l.form.pdf(view);
            if (density > 0) {
                double f = (l.isPoint ? 1 : weight(bsdf.pdf(s), density)) / density;
                red = Math.fma(f * s.valueR, l.r, red);
                green = Math.fma(f * s.valueG, l.g, green);
                blue = Math.fma(f * s.valueB, l.b, blue);
            }
        }
    }

    /** The weight of what the light emits that the path runs into after it left the vertex. */
    double weight(Ray ray) {
        PhysicalLight l = lights[physical.lightOf(path.id, hit.face)];
        aim(l, x, y, z);
        if (cone.inside && l.form instanceof SphereEmitter) {
            return 1;
        }
        if (isMatte && l.form instanceof SphereEmitter) {
            return 0;
        }
        double scale = 1 / Math.sqrt(ray.dd);
        return weight(l.form.pdf(view, ray.dx * scale, ray.dy * scale, ray.dz * scale), pdf);
    }

    /** The power heuristic of one density against another (Veach and Guibas 1995), with the ratio formed first: no square overflows. */
    private static double weight(double other, double own) {
        double ratio = other / own;
        return 1 / (1 + ratio * ratio);
    }

    private void aim(PhysicalLight l, double px, double py, double pz) {
        cone.aim(l, px, py, pz);
        view.aim();
    }

    /** Whether the vertex is on a side that the light shines to. */
    private boolean isLitBy(PhysicalLight l) {
        return l.isTwoSided || l.facing(x, y, z) > 0;
    }

    private boolean isVisible(PhysicalLight l) {
        Tracer.Visibility visibility = visibility(l);
        if (visibility != Tracer.Visibility.UNKNOWN) {
            counters.lightSamplesWithoutRay++;
            return visibility == Tracer.Visibility.ALL;
        }
        return !isBlocked(l);
    }

    private void findStarts() {
        int count = 0;
        if (neverReturnsTo(hit)) {
            starts[count++] = path.id;
        }
        for (int k = 0; k < glass.surfaces() && count < starts.length - 1; k++) {
            if (glass.surface(k) != path.id && neverReturnsTo(glass.hitOf(k))) {
                starts[count++] = glass.surface(k);
            }
        }
        startCount = count;
    }

    private Tracer.Visibility visibility(PhysicalLight l) {
        int count = startCount;
        if (l.hidesNothingOfItself) {
            starts[count++] = l.id;
        }
        return tracer.prepareShadows(cone, starts, count, 1);
    }

    /** Whether a ray that leaves the surface on the viewer's side cannot meet it again. */
    private static boolean neverReturnsTo(Hit place) {
        Primitive p = place.primitive;
        return p.isFlat() || p.isConvex() && place.side == Ray.OUTSIDE;
    }

    private boolean isBlocked(PhysicalLight l) {
        path.poll.tick();
        shadowRay.set(x, y, z, view.dx, view.dy, view.dz, 0);
        shadowRay.from(hit.primitive, hit.side);
        if (glass.surfaces() > 1) {
            glass.startOnAll(shadowRay);
        }
        return tracer.occluded(shadowRay, view.length, l);
    }
}
