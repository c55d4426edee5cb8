package enlightenment.shading;

import enlightenment.compiled.CompiledLight;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.compiled.Tracer;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SpherePrimitive;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * The paper's cosine shading: the colour seen along one camera ray.
 *
 * <p>With c the surface colour, cosθ (0..1) between the normal that faces the viewer and the direction to a light point,
 * and k the share of direct light that an occluded point keeps: colour = c · light · (ambient + (1 − ambient) · mean over
 * light points of (visible ? 1 : k) · cosθ), averaged over the lights. Mirrors and glass multiply their colour and are
 * followed; everything but a light occludes. See docs/classic-shading.md.
 *
 * <p>If the whole light is above the horizon, the mean of cosθ itself has a closed form, and only the blocked fraction of it is
 * estimated, by light points sampled proportionally to cosθ: surfaces in full light and in the umbra are free of noise. If
 * nothing can occlude the light, no sample is needed at all.
 *
 * <p>One per thread. {@code step} and {@code meanCosine} are longer than our methods usually are: the just-in-time compiler does
 * not inline a method of more than 325 bytes of code, and these two boundaries keep it from compiling the whole renderer once
 * at each level of calls (docs/benchmarks.md).
 */
public final class ClassicShader {
    /** A line meets a primitive at most this often: a torus is of the fourth degree. */
    private static final int MAX_CROSSINGS = 4;

    /** Cancellation is polled once per this many paths, surfaces and light points, taken together. */
    static final int POLL_INTERVAL = 1024;

    private final CompiledScene scene;
    private final RayCounters counters;
    private final Tracer tracer;
    private final GlassTracer glass;
    private final LightSampler sampler = new LightSampler();
    private final Hit hit = new Hit();
    private final Ray shadowRay = new Ray();
    private final double[] surface = new double[3];

    /** Primitives that the shaded point lies on; if there are more, the others are tested needlessly. */
    private final int[] starts = new int[8];

    private final int maxBounces;

    /** No line meets more surfaces: a path that passes more of them straight is caught in a loop by rounding, and ends. */
    private final int maxStraight;

    private final double ambient;
    private final double shadow;

    /** The primitive whose surface the ray is at. */
    private int id;

    private double throughputR;
    private double throughputG;
    private double throughputB;
    private double red;
    private double green;
    private double blue;

    /** Light points per hit and light. */
    private int lightPoints;

    private LightGuide guide;

    /** The difference in mean cosine between all light points visible and all blocked, in the last {@code meanCosine}. */
    private double contrast;

    /** Whether the last step was through glass that did not turn the ray. */
    private boolean passedStraight;

    private long pathKey;
    private int shadowRays;
    private int blockedShadowRays;
    private double visibilityContrast;
    private double colorVariance;

    /** The variance of the cosine among the light points of the last {@code meanCosine}. */
    private double cosineVariance;

    private BooleanSupplier cancelled = () -> false;
    private int untilPoll = POLL_INTERVAL;

    private LightObserver observer;
    private int observedLight;
    private int observedBounce;

    /**
     * A shader for one thread.
     *
     * @param scene what is seen
     * @param lightPoints the number of points of each light at each hit
     * @param counters what this thread counts
     */
    public ClassicShader(CompiledScene scene, int lightPoints, RayCounters counters) {
        this.scene = scene;
        this.counters = counters;
        this.lightPoints = lightPoints;
        tracer = new Tracer(scene, counters);
        glass = new GlassTracer(scene, counters);
        maxBounces = scene.shading.maxBounces();
        maxStraight = MAX_CROSSINGS * scene.primitives.length;
        ambient = scene.shading.ambient();
        shadow = scene.shading.shadow();
    }

    /** Sets the tile of the camera rays to come: (x0..x1, y0..y1), 0..1 from the picture's upper left corner. */
    public void beginTile(double x0, double y0, double x1, double y1) {
        tracer.beginTile(x0, y0, x1, y1);
    }

    /** Whether it is known that all camera rays of the tile see the background. */
    public boolean seesNothing() {
        return tracer.seesNothing();
    }

    /** Sets the number of points of each light at each hit. */
    public void lightPoints(int count) {
        lightPoints = count;
    }

    /** Says that only colours are asked for, not what shadow rays told: the cheapest way to the same colours is taken. */
    public void onlyColors() {
        tracer.leaveVisibilityOpen();
    }

    /** Sets the guide that samples lights that may be partly occluded; null for low-discrepancy samples. */
    public void guide(LightGuide chooser) {
        guide = chooser;
    }

    /** Sets the observer of shadow rays, or null. */
    public void observer(LightObserver watcher) {
        observer = watcher;
    }

    /**
     * Lets {@link #shade} end in the middle of a path: it throws a {@link CancellationException} soon after this becomes true,
     * however long the path is.
     */
    public void stopWhen(BooleanSupplier condition) {
        cancelled = condition;
    }

    private void tick() {
        if (--untilPoll <= 0) {
            poll();
        }
    }

    private void poll() {
        untilPoll = POLL_INTERVAL;
        if (cancelled.getAsBoolean()) {
            throw new CancellationException();
        }
    }

    /** A hash of the surfaces of the last path, in order: if it is equal for neighbouring rays, no edge lies between them. */
    public long pathKey() {
        return pathKey;
    }

    /** The number of shadow rays of the last path. */
    public int shadowRays() {
        return shadowRays;
    }

    /** The number of them that were blocked. */
    public int blockedShadowRays() {
        return blockedShadowRays;
    }

    /**
     * What the shadow rays of the last path decide: the squared difference in colour between all light points visible and all
     * blocked, as the mean of the three components, summed over the lights and surfaces concerned.
     */
    public double visibilityContrast() {
        return visibilityContrast;
    }

    /**
     * The variance of the colour with a single light point that is due to the cosine, where the cosine has no closed form;
     * summed as {@link #visibilityContrast}.
     */
    public double colorVariance() {
        return colorVariance;
    }

    /**
     * Computes the colour seen along a camera ray.
     *
     * @param ray the camera ray; the path overwrites it
     * @param address the sample that it belongs to
     * @param out receives red, green and blue, display-referred
     * @throws CancellationException once the condition of {@link #stopWhen} holds
     */
    public void shade(Ray ray, SampleAddress address, double[] out) {
        red = 0;
        green = 0;
        blue = 0;
        throughputR = 1;
        throughputG = 1;
        throughputB = 1;
        pathKey = 0;
        shadowRays = 0;
        blockedShadowRays = 0;
        visibilityContrast = 0;
        colorVariance = 0;
        counters.cameraRays++;
        glass.begin(ray);
        int surfaces = 0;
        int bounces = 0;
        int straight = 0;
        passedStraight = false;
        tick();
        // Surfaces that do not turn the ray are no bounces, so cutting a scene into more pieces changes nothing.
        while (step(ray, address, surfaces)) {
            surfaces++;
            if (!passedStraight) {
                bounces++;
                straight = 0;
            } else if (++straight > maxStraight) {
                break;
            }
            passedStraight = false;
            if (bounces > maxBounces) {
                break;
            }
            tick();
        }
        out[0] = red;
        out[1] = green;
        out[2] = blue;
    }

    /** Follows the ray to the next surface; returns whether the path continues. */
    private boolean step(Ray ray, SampleAddress address, int bounce) {
        id = glass.takeNext(hit);
        if (id < 0) {
            if (!(bounce == 0 ? tracer.traceCamera(ray, hit) : tracer.trace(ray, hit))) {
                add(
                        scene.shading.background().r(),
                        scene.shading.background().g(),
                        scene.shading.background().b());
                return false;
            }
            if (tracer.light != null) {
                pathKey = Hash.mix(pathKey + 1);
                add(tracer.light.r, tracer.light.g, tracer.light.b);
                return false;
            }
            id = tracer.id;
        }
        pathKey = Hash.mix(pathKey - 1 - id - ((long) hit.face << 32));
        if (glass.arrive(ray, id, hit)) {
            crossGlass(ray, address, bounce);
        } else {
            id = glass.id;
            SurfaceMaterial material = scene.material(id, hit.face);
            if (material.isTextured()) {
                counters.textureLookups += material.hasImage() ? 1 : 0;
                hit.primitive.textureCoordinates(hit);
                material.color(hit.u, hit.v, hit.primitive instanceof SpherePrimitive, surface);
            } else {
                material.color(surface);
            }
            if (material.kind == SurfaceMaterial.Kind.MATTE) {
                shadeSurface(material, address, bounce, 1);
                return false;
            }
            filter(1);
            counters.mirrorRays++;
            Optics.reflect(ray, hit);
            glass.settle(ray, id, hit);
            glass.reflectFromAll(ray);
        }
        return throughputR > 0 || throughputG > 0 || throughputB > 0;
    }

    private void crossGlass(Ray ray, SampleAddress address, int bounce) {
        boolean through = glass.cross(ray, hit);
        passedStraight = glass.passedStraight();
        pathKey += through ? 1 : 0;
        for (int k = 0; k < glass.surfaces(); k++) {
            if (glass.filters(k, through)) {
                id = glass.surface(k);
                hit.set(glass.hitOf(k));
                SurfaceMaterial material = scene.material(id, hit.face);
                lookUpColor(material);
                if (material.transparency < 1) {
                    shadeSurface(material, address, bounce, 1 - material.transparency);
                }
                if (through) {
                    filter(material.transparency);
                } else {
                    scaleThroughput(material.transparency);
                }
            }
        }
    }

    private void add(double r, double g, double b) {
        red = Math.fma(throughputR, r, red);
        green = Math.fma(throughputG, g, green);
        blue = Math.fma(throughputB, b, blue);
    }

    private void filter(double share) {
        throughputR *= surface[0] * share;
        throughputG *= surface[1] * share;
        throughputB *= surface[2] * share;
    }

    private void scaleThroughput(double share) {
        throughputR *= share;
        throughputG *= share;
        throughputB *= share;
    }

    private void lookUpColor(SurfaceMaterial material) {
        if (!material.isTextured()) {
            material.color(surface);
            return;
        }
        if (material.hasImage()) {
            counters.textureLookups++;
        }
        hit.primitive.textureCoordinates(hit);
        material.color(hit.u, hit.v, hit.primitive instanceof SpherePrimitive, surface);
    }

    /** Adds the light that the surface itself reflects, times a share. */
    private void shadeSurface(SurfaceMaterial material, SampleAddress address, int bounce, double share) {
        CompiledLight[] lights = scene.lights;
        if (lights.length == 0) {
            double factor = ambient * share;
            add(surface[0] * factor, surface[1] * factor, surface[2] * factor);
            return;
        }
        double facing = hit.side;
        double nx = hit.nx * facing;
        double ny = hit.ny * facing;
        double nz = hit.nz * facing;
        double keeps = material.receivesShadows ? shadow : 1;
        double r = 0;
        double g = 0;
        double b = 0;
        for (int i = 0; i < lights.length; i++) {
            CompiledLight light = lights[i];
            double mean = meanCosine(light, i, nx, ny, nz, keeps, address, bounce);
            double factor = Math.fma(1 - ambient, mean, ambient);
            if (contrast > 0 || cosineVariance > 0) {
                addUncertainty(light, (1 - ambient) * share / lights.length);
            }
            r += light.r * factor;
            g += light.g * factor;
            b += light.b * factor;
        }
        // Divided last: n white lights on white give exactly white, whatever n is.
        double n = lights.length;
        add(surface[0] * (r * share) / n, surface[1] * (g * share) / n, surface[2] * (b * share) / n);
    }

    private void addUncertainty(CompiledLight light, double factor) {
        double r = throughputR * surface[0] * light.r;
        double g = throughputG * surface[1] * light.g;
        double b = throughputB * surface[2] * light.b;
        double square = factor * factor * (r * r + g * g + b * b) / 3;
        visibilityContrast += square * contrast * contrast;
        colorVariance += square * cosineVariance;
    }

    /** The mean over light points of (visible ? 1 : keeps) · cosθ at the hit. */
    private double meanCosine(
            CompiledLight light,
            int index,
            double nx,
            double ny,
            double nz,
            double keeps,
            SampleAddress address,
            int bounce) {
        contrast = 0;
        cosineVariance = 0;
        sampler.aim(light, hit.px, hit.py, hit.pz);
        int count = sampler.isPoint() ? 1 : lightPoints;
        counters.lightSamples += count;
        if (sampler.isBelow(nx, ny, nz)) {
            counters.lightSamplesWithoutRay += count;
            return 0;
        }
        double unshadowed = sampler.meanCosine(nx, ny, nz);
        boolean known = unshadowed == unshadowed;
        Tracer.Visibility visibility = keeps < 1 ? visibility() : Tracer.Visibility.ALL;
        boolean rays = visibility == Tracer.Visibility.UNKNOWN;
        double factor = visibility == Tracer.Visibility.NONE ? keeps : 1;
        if (!rays) {
            counters.lightSamplesWithoutRay += count;
            if (known && observer == null) {
                return factor * unshadowed;
            }
        }
        long seed = address.lightSeed(index, bounce);
        int first = address.firstLightPoint(seed, count);
        if (observer != null) {
            observedLight = index;
            observedBounce = bounce;
            if (known && !rays) {
                observeCertain(nx, ny, nz, first, seed, factor < 1);
                return factor * unshadowed;
            }
        }
        if (known) {
            contrast = (1 - keeps) * unshadowed;
            sampler.prepareByCosine(nx, ny, nz);
            boolean guided = guide != null && !sampler.isPoint() && guide.begin(id, index, bounce);
            double blocked = guided ? guidedShare(first, count, seed) : blockedShare(first, count, seed);
            if (blocked == 1 && keeps > 0 && tracer.isHidden()) {
                return keeps * unshadowed;
            }
            return Math.fma(-contrast, blocked, unshadowed);
        }
        return sampledCosine(nx, ny, nz, first, count, seed, rays ? keeps : factor, rays);
    }

    /** The same without a closed form: the mean over light points. */
    private double sampledCosine(
            double nx, double ny, double nz, int first, int count, long seed, double blockedFactor, boolean rays) {
        double sum = 0;
        double cosines = 0;
        double squares = 0;
        for (int j = 0; j < count; j++) {
            sampler.sample(Sobol.x(first + j, seed), Sobol.y(first + j, seed));
            tick();
            double cosine = nx * sampler.dx + ny * sampler.dy + nz * sampler.dz;
            if (cosine > 0) {
                sum += !rays || isBlocked() ? blockedFactor * cosine : cosine;
                if (observer != null && !rays) {
                    observe(blockedFactor < 1);
                }
                cosines += cosine;
                squares += cosine * cosine;
            }
        }
        contrast = rays ? (1 - blockedFactor) * cosines / count : 0;
        cosineVariance = count < 2 ? 0 : Math.max(squares - cosines * cosines / count, 0) / (count - 1);
        return sum / count;
    }

    /** Shows the observer one light point whose visibility is known without a ray. */
    private void observeCertain(double nx, double ny, double nz, int first, long seed, boolean blocked) {
        sampler.prepareByCosine(nx, ny, nz);
        sampler.sampleByCosine(Sobol.x(first, seed), Sobol.y(first, seed));
        observe(blocked);
    }

    private void observe(boolean blocked) {
        observer.ray(
                id, observedLight, observedBounce, hit, sampler.dx, sampler.dy, sampler.dz, sampler.length, blocked);
    }

    /** The fraction of light points that are blocked, sampled proportionally to their cosine. */
    private double blockedShare(int first, int count, long seed) {
        int blocked = 0;
        for (int j = 0; j < count; j++) {
            sampler.sampleByCosine(Sobol.x(first + j, seed), Sobol.y(first + j, seed));
            blocked += isBlocked() ? 1 : 0;
        }
        return (double) blocked / count;
    }

    /** The same with light points that the guide samples, by importance sampling weights. */
    private double guidedShare(int first, int count, long seed) {
        double sum = 0;
        for (int j = 0; j < count; j++) {
            double weight = guide.propose(Sobol.x(first + j, seed), Sobol.y(first + j, seed));
            if (weight > 0) {
                sampler.sampleDisk(guide.p(), guide.q());
                boolean blocked = isBlocked();
                guide.tell(blocked);
                sum += blocked == guide.wantsBlocked() ? weight : 0;
            }
        }
        double share = sum / count;
        return guide.wantsBlocked() ? share : 1 - share;
    }

    private Tracer.Visibility visibility() {
        int count = 0;
        if (neverReturnsTo(hit)) {
            starts[count++] = id;
        }
        // Nor does it meet the coincident surfaces again.
        for (int k = 0; k < glass.surfaces() && count < starts.length; k++) {
            if (glass.surface(k) != id && neverReturnsTo(glass.hitOf(k))) {
                starts[count++] = glass.surface(k);
            }
        }
        return tracer.prepareShadows(sampler.cone, starts, count, sampler.isPoint() ? 1 : lightPoints);
    }

    /** Whether a ray that leaves the surface on the viewer's side cannot meet it again. */
    private static boolean neverReturnsTo(Hit place) {
        Primitive p = place.primitive;
        return p.isFlat() || p.isConvex() && place.side == Ray.OUTSIDE;
    }

    private boolean isBlocked() {
        tick();
        sampler.ray(shadowRay, hit.px, hit.py, hit.pz);
        shadowRay.from(hit.primitive, hit.side);
        if (glass.surfaces() > 1) {
            glass.startOnAll(shadowRay);
        }
        boolean blocked = tracer.occluded(shadowRay, sampler.length, sampler.light());
        shadowRays++;
        blockedShadowRays += blocked ? 1 : 0;
        if (observer != null) {
            observe(blocked);
        }
        return blocked;
    }
}
