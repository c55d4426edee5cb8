package enlightenment.classic.shading;

import enlightenment.emitter.Emitter;
import enlightenment.emitter.EmitterView;
import enlightenment.emitter.RectangleEmitter;
import enlightenment.emitter.SphereEmitter;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.GlassTracer;
import enlightenment.transport.ray.PathFollower;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.light.LightCone;
import enlightenment.world.parts.RayCounters;

/**
 * The light that reaches a surface straight from the lights, by the paper's cosine rule.
 *
 * <p>If the whole light is above the horizon, the mean of cosθ itself has a closed form, and only the blocked fraction of it is
 * estimated, by light points sampled proportionally to cosθ: surfaces in full light and in the umbra are free of noise. If
 * nothing can occlude the light, no sample is needed at all.
 */
final class ClassicDirectLight {
    private final ClassicLight[] lights;
    private final RayCounters counters;
    private final PathFollower path;
    private final Hit hit;
    private final GlassTracer glass;
    private final Tracer tracer;
    private final PathReport report;
    private final LightCone cone = new LightCone();
    private final EmitterView view = new EmitterView(cone);
    /** The cone in which shadow rays lead to the light: from a smooth surface, not from its triangle. */
    private final LightCone shadowCone = new LightCone();

    /** The offset of a smooth surface from its triangle. */
    private final double[] bulge = new double[3];

    /** Whether shadow rays start there. */
    private boolean isBulging;

    private final Ray shadowRay = new Ray();

    /** Primitives that the shaded point lies on; if there are more, the others are tested needlessly. */
    private final int[] starts = new int[8];

    private final double ambient;
    private final double shadow;
    private int lightPoints;
    private LightGuide guide;

    /** The index of the light that is gathered; the light itself is that of the cone. */
    private int index;

    /** How much of the light becomes colour of the path, for the report: by component, and the same factor of all three. */
    private double weightR;

    private double weightG;
    private double weightB;
    private double weight;

    /** The normal on the viewer's side. */
    private double nx;

    private double ny;
    private double nz;

    /** The difference in mean cosine between all points of the light visible and all blocked. */
    private double contrast;

    /** The variance of the cosine among the light points. */
    private double cosineVariance;

    /** What was gathered, summed over the lights: their colours times (ambient + (1 − ambient) · mean). */
    double red;

    double green;
    double blue;

    ClassicDirectLight(
            CompiledScene scene, int lightPoints, RayCounters counters, PathFollower path, PathReport report) {
        lights = scene.lights;
        ambient = scene.classic.ambient();
        shadow = scene.classic.shadow();
        this.lightPoints = lightPoints;
        this.counters = counters;
        this.path = path;
        hit = path.at.hit;
        glass = path.glass;
        tracer = path.tracer;
        this.report = report;
    }

    /** Sets the number of points of each light. */
    void lightPoints(int count) {
        lightPoints = count;
    }

    void guide(LightGuide chooser) {
        guide = chooser;
    }

    /**
     * Sets for the report how much of the light that is gathered next becomes colour of the path.
     *
     * @param r how much of the red light; g and b likewise
     * @param share the same factor of all three
     */
    void weigh(double r, double g, double b, double share) {
        weightR = r;
        weightG = g;
        weightB = b;
        weight = share;
    }

    /**
     * Gathers the light of all lights at the surface that the path is at.
     *
     * @param receivesShadows whether occluded light points count less there
     */
    void gather(boolean receivesShadows, Sampler sampler) {
        nx = path.at.nx;
        ny = path.at.ny;
        nz = path.at.nz;
        double keeps = receivesShadows ? shadow : 1;
        isBulging = path.at.isSmooth() && hit.primitive.bulge(hit, bulge);
        double r = 0;
        double g = 0;
        double b = 0;
        for (int i = 0; i < lights.length; i++) {
            ClassicLight l = lights[i];
            index = i;
            double mean = meanCosine(l, keeps, sampler);
            double factor = Math.fma(1 - ambient, mean, ambient);
            if (report.isRead() && (contrast > 0 || cosineVariance > 0)) {
                addUncertainty(weightR * l.r, weightG * l.g, weightB * l.b, (1 - ambient) * weight / lights.length);
            }
            r += l.r * factor;
            g += l.g * factor;
            b += l.b * factor;
        }
        red = r;
        green = g;
        blue = b;
    }

    private void addUncertainty(double r, double g, double b, double factor) {
        double square = factor * factor * (r * r + g * g + b * b) / 3;
        report.visibilityContrast += square * contrast * contrast;
        report.colorVariance += square * cosineVariance;
    }

    /** The mean over light points of (visible ? 1 : keeps) · cosθ at the hit. */
    private double meanCosine(ClassicLight light, double keeps, Sampler sampler) {
        contrast = 0;
        cosineVariance = 0;
        Emitter emitter = light.emitter;
        cone.aim(light, hit.px, hit.py, hit.pz);
        view.aim();
        int count = light.isDelta ? 1 : lightPoints;
        counters.lightSamples += count;
        double unshadowed = meanCosine(emitter);
        if (unshadowed == 0) {
            counters.lightSamplesWithoutRay += count;
            return 0;
        }
        boolean known = unshadowed == unshadowed;
        Tracer.Visibility visibility = keeps < 1 ? visibility(count) : Tracer.Visibility.ALL;
        boolean rays = visibility == Tracer.Visibility.UNKNOWN;
        double factor = visibility == Tracer.Visibility.NONE ? keeps : 1;
        if (!rays) {
            counters.lightSamplesWithoutRay += count;
            if (known && !report.keepsRays()) {
                return factor * unshadowed;
            }
        }
        sampler.lightPoints(index, path.surfaces, count);
        if (!known) {
            return sampledCosine(emitter, sampler, count, rays ? keeps : factor, rays);
        }
        emitter.prepareByCosine(view, nx, ny, nz);
        if (!rays) {
            emitter.sampleByCosine(view, sampler.lightX(0), sampler.lightY(0));
            keepRay(factor < 1);
            return factor * unshadowed;
        }
        contrast = (1 - keeps) * unshadowed;
        boolean guided = guide != null && !light.isDelta && guide.begin(path.at.id, index, path.surfaces);
        double blocked = guided ? guidedShare(emitter, sampler, count) : blockedShare(emitter, sampler, count);
        if (blocked == 1) {
            // To the last bit what is known without rays of a light that is hidden.
            return keeps * unshadowed;
        }
        return Math.fma(-contrast, blocked, unshadowed);
    }

    // Where a scene has lights of all forms, asking for the common ones first lets the just-in-time compiler inline
    // them.

    private double meanCosine(Emitter emitter) {
        if (emitter instanceof SphereEmitter sphere) {
            return sphere.meanCosine(view, nx, ny, nz);
        }
        return emitter instanceof RectangleEmitter rectangle
                ? rectangle.meanCosine(view, nx, ny, nz)
                : emitter.meanCosine(view, nx, ny, nz);
    }

    private void sample(Emitter emitter, double u, double v) {
        if (emitter instanceof RectangleEmitter rectangle) {
            rectangle.sample(view, u, v);
        } else if (emitter instanceof SphereEmitter sphere) {
            sphere.sample(view, u, v);
        } else {
            emitter.sample(view, u, v);
        }
    }

    private void sampleByCosine(Emitter emitter, double u, double v) {
        if (emitter instanceof SphereEmitter sphere) {
            sphere.sampleByCosine(view, u, v);
        } else {
            emitter.sampleByCosine(view, u, v);
        }
    }

    /** {@link #meanCosine(ClassicLight, double, Sampler)} without a closed form: the mean over light points. */
    private double sampledCosine(Emitter emitter, Sampler sampler, int count, double blockedFactor, boolean rays) {
        double sum = 0;
        double cosines = 0;
        double squares = 0;
        for (int j = 0; j < count; j++) {
            sample(emitter, sampler.lightX(j), sampler.lightY(j));
            path.poll.tick();
            double cosine = nx * view.dx + ny * view.dy + nz * view.dz;
            if (cosine > 0) {
                sum += !rays || isBlocked() ? blockedFactor * cosine : cosine;
                if (!rays && report.keepsRays()) {
                    keepRay(blockedFactor < 1);
                }
                cosines += cosine;
                squares += cosine * cosine;
            }
        }
        contrast = rays ? (1 - blockedFactor) * cosines / count : 0;
        cosineVariance = count < 2 ? 0 : Math.max(squares - cosines * cosines / count, 0) / (count - 1);
        return sum / count;
    }

    /** The fraction of light points that are blocked, sampled proportionally to their cosine. */
    private double blockedShare(Emitter emitter, Sampler sampler, int count) {
        int blocked = 0;
        for (int j = 0; j < count; j++) {
            sampleByCosine(emitter, sampler.lightX(j), sampler.lightY(j));
            blocked += isBlocked() ? 1 : 0;
        }
        return (double) blocked / count;
    }

    /** {@link #blockedShare} estimated with light points that the guide proposes, by their importance weights. */
    private double guidedShare(Emitter emitter, Sampler sampler, int count) {
        double sum = 0;
        for (int j = 0; j < count; j++) {
            double weight = guide.propose(sampler.lightX(j), sampler.lightY(j));
            if (weight > 0) {
                double p = guide.p();
                double q = guide.q();
                emitter.sampleDisk(view, p, q);
                boolean blocked = isBlocked();
                report.guided.add(path.at.id, index, path.surfaces, blocked);
                report.guided.set(PathReport.P, p, q, weight);
                sum += blocked == guide.wantsBlocked() ? weight : 0;
            }
        }
        double share = sum / count;
        return guide.wantsBlocked() ? share : 1 - share;
    }

    /** The visibility of {@code points} light points as far as it is known without a ray. */
    private Tracer.Visibility visibility(int points) {
        int count = 0;
        if (neverReturnsTo(hit)) {
            starts[count++] = path.at.id;
        }
        // Nor does it meet the coincident surfaces again.
        for (int k = 0; k < glass.surfaces() && count < starts.length; k++) {
            if (glass.surface(k) != path.at.id && neverReturnsTo(glass.hitOf(k))) {
                starts[count++] = glass.surface(k);
            }
        }
        if (isBulging) {
            shadowCone.aim(cone.light(), hit.px + bulge[0], hit.py + bulge[1], hit.pz + bulge[2]);
        }
        return tracer.prepareShadows(isBulging ? shadowCone : cone, starts, count, points);
    }

    /** Whether a ray that leaves the surface on the viewer's side cannot meet it again. */
    private static boolean neverReturnsTo(Hit place) {
        Primitive p = place.primitive;
        return p.isFlat() || p.isConvex() && place.side == Ray.OUTSIDE;
    }

    private boolean isBlocked() {
        path.poll.tick();
        double length = view.length;
        if (isBulging) {
            // To the same point of the light; lengths are in units of the way to it.
            shadowRay.set(
                    hit.px + bulge[0],
                    hit.py + bulge[1],
                    hit.pz + bulge[2],
                    Math.fma(view.dx, length, -bulge[0]),
                    Math.fma(view.dy, length, -bulge[1]),
                    Math.fma(view.dz, length, -bulge[2]),
                    0);
            length = 1;
        } else {
            shadowRay.set(hit.px, hit.py, hit.pz, view.dx, view.dy, view.dz, 0);
        }
        shadowRay.from(hit, hit.side);
        if (glass.surfaces() > 1) {
            glass.startOnAll(shadowRay);
        }
        boolean blocked = tracer.occluded(shadowRay, length, cone.light());
        if (report.isRead()) {
            report.shadowRays++;
            report.blockedShadowRays += blocked ? 1 : 0;
            if (report.keepsRays()) {
                keepRay(blocked);
            }
        }
        return blocked;
    }

    private void keepRay(boolean blocked) {
        report.rays.add(path.at.id, index, path.surfaces, blocked);
        report.rays.set(PathReport.SURFACE_POINT, hit.px, hit.py, hit.pz);
        report.rays.set(
                PathReport.LIGHT_POINT,
                Math.fma(view.dx, view.length, hit.px),
                Math.fma(view.dy, view.length, hit.py),
                Math.fma(view.dz, view.length, hit.pz));
    }
}
