package enlightenment.physical;

import enlightenment.material.Coated;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.IntStream;

/**
 * The rendering equation solved the slow way: paths go back from the eye until they happen to meet a light. No light is aimed at
 * (but for lights without extent, which nobody can meet, and their images in panes), nothing is known in closed form, no path is ended
 * before its fiftieth event, and nothing of the renderer is used but the description of the scene. So it makes the same picture only if
 * both are right.
 *
 * <p>Scenes have a size of about 1, and no surfaces that coincide.
 */
final class NaiveTracer {
    private static final int CHUNKS = 32;
    private static final int CERTAIN_EVENTS = 50;
    private static final double SURVIVAL = 0.9;
    private static final long STACK_BYTES = 1L << 28;

    /**
     * The same in scenes with media, where paths of hundreds of events matter: a share of survivors below the squared albedo would give
     * their mean no variance, and a sample's mean would be too small almost always.
     */
    private static final double SURVIVAL_IN_MEDIA = 0.995;

    /** What a path has come over so far. */
    private enum Sight {
        /** Nothing that turned it. */
        STRAIGHT,
        /** Mirrors and smooth glass. */
        MIRRORED,
        /** A surface that scatters light in many directions. */
        SCATTERED
    }

    /** A path's numbers and history. */
    private static final class Path {
        final SplittableRandom random;
        Sight sight = Sight.STRAIGHT;

        /** The only band that the path tells of, since a medium scattered it or let it pass; -1 before. */
        int band = -1;

        Path(SplittableRandom random) {
            this.random = random;
        }

        /** It meets a mirror, or a smooth boundary. */
        void mirrored() {
            sight = sight == Sight.STRAIGHT ? Sight.MIRRORED : sight;
        }
    }

    private final NaiveScene scene;
    private final NaivePoints points;

    private final double lateSurvival;

    /** Whether what the eye sees in mirrors and through glass that turns rays is black, but for what glows. */
    private final boolean leavesOutMirrored;

    /** Metals and coats of one colour have tables, which are made once. */
    private final Map<List<Object>, NaiveReflector> metals = new ConcurrentHashMap<>();

    private final Map<List<Double>, NaiveInterface> interfaces = new ConcurrentHashMap<>();

    NaiveTracer(Scene scene) {
        this(scene, false);
    }

    /** @param leavesOutMirrored whether what the eye sees in mirrors and through glass that turns rays is black, but for what glows */
    NaiveTracer(Scene scene, boolean leavesOutMirrored) {
        this.scene = new NaiveScene(scene);
        points = new NaivePoints(this.scene);
        this.leavesOutMirrored = leavesOutMirrored;
        lateSurvival = this.scene.hasMedia() ? SURVIVAL_IN_MEDIA : SURVIVAL;
    }

    /** Notes that the path comes to a surface that scatters light in many directions; returns whether that is left out. */
    private boolean isLeftOut(Path path) {
        boolean isMirrored = path.sight == Sight.MIRRORED;
        path.sight = Sight.SCATTERED;
        return leavesOutMirrored && isMirrored;
    }

    /**
     * Means of independent paths through a part of the picture.
     *
     * @return for each band, one mean per chunk of paths: independent numbers of one distribution
     */
    double[][] means(int left, int top, int right, int bottom, int paths, long seed) {
        List<Callable<double[]>> chunks = IntStream.range(0, CHUNKS)
                .mapToObj(k -> (Callable<double[]>) () -> chunk(
                        left, top, right, bottom, paths / CHUNKS, new Path(new SplittableRandom(seed + 1000L * k))))
                .toList();
        double[][] bands = new double[3][CHUNKS];
        List<double[]> means = inDeepThreads(chunks);
        for (int k = 0; k < CHUNKS; k++) {
            for (int band = 0; band < 3; band++) {
                bands[band][k] = means.get(k)[band];
            }
        }
        return bands;
    }

    /** Paths are recursive, and those in media may have thousands of events. */
    private static <T> List<T> inDeepThreads(List<Callable<T>> tasks) {
        ExecutorService threads = Executors.newFixedThreadPool(
                Runtime.getRuntime().availableProcessors(), task -> new Thread(null, task, "naive", STACK_BYTES));
        try {
            List<T> results = new ArrayList<>();
            for (Future<T> result : threads.invokeAll(tasks)) {
                results.add(result.get());
            }
            return results;
        } catch (InterruptedException | ExecutionException e) {
            throw new IllegalStateException(e);
        } finally {
            threads.shutdownNow();
        }
    }

    private double[] chunk(int left, int top, int right, int bottom, int paths, Path path) {
        double[] sum = new double[3];
        for (int i = 0; i < paths; i++) {
            double x = left + (right - left) * path.random.nextDouble();
            double y = top + (bottom - top) * path.random.nextDouble();
            Vec3[] ray = scene.ray(x / scene.width(), y / scene.height());
            path.sight = Sight.STRAIGHT;
            path.band = -1;
            add(sum, 1.0 / paths, radiance(ray[0], ray[1], 0, 0, path));
        }
        return sum;
    }

    private static void add(double[] sum, double factor, double[] value) {
        for (int band = 0; band < 3; band++) {
            sum[band] += factor * value[band];
        }
    }

    static double[] scaled(double[] value, double factor) {
        return new double[] {factor * value[0], factor * value[1], factor * value[2]};
    }

    /** What comes to a point against a direction, by one path. */
    private double[] radiance(Vec3 o, Vec3 d, int scattered, int events, Path path) {
        NaiveScene.Hit hit = scene.nearest(o, d);
        NaiveMedium medium = scene.fills(o.plus(d.times(hit == null ? 1e-6 : hit.distance() / 2)));
        if (medium.scatters()) {
            return fly(medium, hit, o, d, scattered, events, path);
        }
        double length = hit == null ? Double.POSITIVE_INFINITY : hit.distance();
        return arrive(hit, medium.transmittance(length), d, scattered, events, path);
    }

    /** What comes from what a ray meets, of which so much is left. */
    private double[] arrive(NaiveScene.Hit hit, double[] kept, Vec3 d, int scattered, int events, Path path) {
        if (hit == null) {
            return NaiveColors.product(kept, scene.background(d));
        }
        NaiveScene.Surface s = hit.surface();
        double[] emitted = hit.front() ? s.front() : s.back();
        if (s.material() == null) {
            return NaiveColors.product(kept, emitted);
        }
        double survival = events < CERTAIN_EVENTS ? 1 : lateSurvival;
        double[] sum = emitted.clone();
        if (survival == 1 || path.random.nextDouble() < survival) {
            add(sum, 1 / survival, scattered(hit, d, scattered, events + 1, path));
        }
        return NaiveColors.product(kept, sum);
    }

    /**
     * Flies through a medium as light of one band does, which the path keeps: what is left of it never grows. If one path told of all
     * bands, each collision would be worth more than 1 in the densest of them (and so would directions of another density than the phase
     * function's). After tens of collisions few paths would be worth nearly all, and a million of them would mostly miss these: of rough
     * jade they lost a quarter of the red light behind it, and their spread did not tell.
     */
    private double[] fly(NaiveMedium medium, NaiveScene.Hit hit, Vec3 o, Vec3 d, int scattered, int events, Path path) {
        double[] kept = new double[3];
        if (path.band < 0) {
            path.band = path.random.nextInt(3);
            kept[path.band] = 3;
        } else {
            kept[path.band] = 1;
        }
        double t = -Math.log(1 - path.random.nextDouble()) / medium.extinction()[path.band];
        if (!(t < (hit == null ? Double.POSITIVE_INFINITY : hit.distance()))) {
            return arrive(hit, kept, d, scattered, events, path);
        }
        kept[path.band] *= medium.albedo(path.band);
        return NaiveColors.product(kept, turned(medium, o.plus(d.times(t)), d, scattered, events + 1, path));
    }

    /** What comes to a point of a medium and is scattered there. */
    private double[] turned(NaiveMedium medium, Vec3 at, Vec3 d, int scattered, int events, Path path) {
        double[] sum = new double[3];
        if (scattered == scene.maxBounces || isLeftOut(path)) {
            return sum;
        }
        for (NaiveScene.Point p : scene.points) {
            Vec3 way = p.position().minus(at);
            double[] visible = points.visibility(at, way.normalized(), way.length());
            double share = medium.phase(d.dot(way.normalized())) / way.dot(way);
            add(sum, share, NaiveColors.product(visible, p.intensity()));
        }
        // By the albedo, what is left of the path stays the same.
        double survival = events < CERTAIN_EVENTS ? 1 : Math.min(medium.albedo(path.band), lateSurvival);
        if (survival == 1 || path.random.nextDouble() < survival) {
            add(sum, 1 / survival, radiance(at, medium.turned(d, path.random), scattered + 1, events, path));
        }
        return sum;
    }

    private double[] scattered(NaiveScene.Hit hit, Vec3 d, int scattered, int events, Path path) {
        Material material = hit.surface().material();
        if (hit.surface().isGlass()) {
            Glass boundary = NaiveMedium.boundary(material);
            Glass g = boundary.withRoughness(NaiveAmount.at(boundary.roughness(), hit));
            if (path.random.nextDouble() < g.transparency()) {
                return throughGlass(g, hit, d, scattered, events, path);
            }
            material = boundary.opaque().orElse(Material.Matte.of(boundary.color()));
        }
        if (scattered == scene.maxBounces) {
            return new double[3];
        }
        if (material instanceof Material.Mirror) {
            double[] seen = mirrored(hit, shadingNormal(hit, d), d, scattered, events, path);
            return NaiveColors.product(color(material, hit), seen);
        }
        NaiveReflector reflector = reflector(material, hit);
        if (reflector instanceof NaiveCoat coat && coat.isSmooth()) {
            Vec3 n = shadingNormal(hit, d);
            double reflectance = coat.fresnel(Math.min(1, -d.dot(n)));
            if (path.random.nextDouble() < reflectance) {
                return mirrored(hit, n, d, scattered, events, path);
            }
        }
        if (reflector instanceof NaivePrincipled principled && principled.hasMirror()) {
            Vec3 n = shadingNormal(hit, d);
            double cosine = Math.min(1, -d.dot(n));
            double[] seen = path.random.nextBoolean()
                    ? NaiveColors.product(principled.mirrored(cosine), mirrored(hit, n, d, scattered, events, path))
                    : reflected(reflector, hit, d, scattered + 1, events, path);
            return scaled(seen, 2);
        }
        return reflected(reflector, hit, d, scattered + 1, events, path);
    }

    static double[] color(NaiveScene.Hit hit) {
        return color(hit.surface().material(), hit);
    }

    private static double[] color(Material material, NaiveScene.Hit hit) {
        return NaiveColors.of(material.color(), hit.surface().shape(), hit.point());
    }

    private NaiveReflector reflector(Material material, NaiveScene.Hit hit) {
        if (material instanceof Glossy g) {
            double[] color = color(material, hit);
            Glossy here = g.withRoughness(NaiveAmount.at(g.roughness(), hit));
            List<Object> key = List.of(here, color[0], color[1], color[2]);
            return metals.computeIfAbsent(key, any -> new NaiveReflector.Facets(color, here));
        }
        if (material instanceof Coated c) {
            double[] color = color(material, hit);
            Coated here = c.withRoughness(NaiveAmount.at(c.roughness(), hit));
            List<Object> key = List.of(here, color[0], color[1], color[2]);
            return metals.computeIfAbsent(key, any -> new NaiveCoat(color, here));
        }
        if (material instanceof Principled p) {
            double[] color = color(material, hit);
            Principled here = p.withRoughness(NaiveAmount.at(p.roughness(), hit))
                    .withMetallic(NaiveAmount.at(p.metallic(), hit))
                    .withClearcoat(p.clearcoat()
                            .withRoughness(NaiveAmount.at(p.clearcoat().roughness(), hit)));
            List<Object> key = List.of(here, color[0], color[1], color[2]);
            return metals.computeIfAbsent(key, any -> new NaivePrincipled(color, here));
        }
        double roughness = ((Material.Matte) material).roughness();
        double[] color = color(material, hit);
        return roughness > 0 ? new NaiveReflector.Rough(color, roughness) : new NaiveReflector.Lambert(color);
    }

    private double[] reflected(
            NaiveReflector reflector, NaiveScene.Hit hit, Vec3 d, int scattered, int events, Path path) {
        if (isLeftOut(path)) {
            return new double[3];
        }
        Vec3 n = shadingNormal(hit, d);
        Vec3[] axes = axes(n);
        Vec3 out = local(axes, d.negated());
        double[] sum = new double[3];
        points.add(hit.point(), axes, reflector, out, scattered < scene.maxBounces, sum);
        Vec3 in = reflector.sample(out, path.random);
        if (in == null || in.z() <= 0) {
            return sum;
        }
        double density = reflector.density(out, in);
        Vec3 on = axes[0].times(in.x()).plus(axes[1].times(in.y())).plus(axes[2].times(in.z()));
        double soft = softened(hit, n, on);
        if (soft == 0) {
            return sum;
        }
        double[] arriving = scaled(radiance(hit.point(), on, scattered, events, path), soft);
        for (int band = 0; band < 3; band++) {
            sum[band] += reflector.value(band, out, in) * in.z() / density * arriving[band];
        }
        return sum;
    }

    private double[] throughGlass(Glass glass, NaiveScene.Hit hit, Vec3 d, int scattered, int events, Path path) {
        Vec3 n = glass.smoothRefraction() && hit.surface().isSolid() ? interpolated(hit) : hit.normal();
        double cosine = Math.min(1, -d.dot(n));
        NaiveScene.Surface before = scene.medium(hit, 1);
        double from = NaiveScene.index(before);
        if (!hit.surface().isSolid()) {
            boolean reflects = path.random.nextDouble() < NaiveFresnel.pane(cosine, from, glass.indexOfRefraction());
            return reflects
                    ? mirrored(hit, hit.normal(), d, scattered, events, path)
                    : NaiveColors.product(color(hit), radiance(hit.point(), d, scattered, events, path));
        }
        NaiveScene.Surface after = scene.medium(hit, -1);
        double to = NaiveScene.index(after);
        if (before == after || from == to) {
            double[] through = radiance(hit.point(), d, scattered, events, path);
            return before == after ? through : NaiveColors.product(color(hit), through);
        }
        if (!glass.roughness().isZero()) {
            return throughFacets(glass, hit, d, from, to, scattered, events, path);
        }
        if (cosine <= 0) {
            return new double[3];
        }
        if (path.random.nextDouble() < NaiveFresnel.dielectric(cosine, from, to)) {
            return mirrored(hit, n, d, scattered, events, path);
        }
        return refracted(hit, n, d, from, to, scattered, events, path);
    }

    /** On the side of the triangle's own that the path is on, wherever that is of it. */
    private static Vec3 interpolated(NaiveScene.Hit hit) {
        return hit.surface().shape().shadingNormal(hit.point()).times(hit.front() ? 1 : -1);
    }

    private double[] mirrored(NaiveScene.Hit hit, Vec3 facet, Vec3 d, int scattered, int events, Path path) {
        path.mirrored();
        Vec3 on = d.minus(facet.times(2 * d.dot(facet)));
        double soft = hit.surface().isGlass() ? 1 : softened(hit, facet, on);
        return scattered == scene.maxBounces || on.dot(hit.normal()) <= 0
                ? new double[3]
                : scaled(radiance(hit.point(), on, scattered + 1, events, path), soft);
    }

    /** On the side of the eye: where it turns away from that, its mirror image in the plane across the view. */
    private static Vec3 shadingNormal(NaiveScene.Hit hit, Vec3 d) {
        Vec3 n = interpolated(hit);
        return n.dot(d) > 0 ? n.minus(d.times(2 * n.dot(d))) : n;
    }

    /** Chiang, Li and Burley, "Taming the shadow terminator", 2019; 0 for light from behind the triangle. */
    private static double softened(NaiveScene.Hit hit, Vec3 n, Vec3 light) {
        double straight = hit.normal().dot(light);
        if (straight <= 0) {
            return 0;
        }
        double g = Math.min(1, straight / (n.dot(light) * Math.abs(n.dot(hit.normal()))));
        return -g * g * g + g * g + g;
    }

    /** Radiance on the two sides of a boundary is in the ratio of the squares of the indices. */
    private double[] refracted(
            NaiveScene.Hit hit, Vec3 facet, Vec3 d, double from, double to, int scattered, int events, Path path) {
        path.mirrored();
        double cosine = -d.dot(facet);
        double beyond = NaiveFresnel.refracted(Math.min(1, cosine), from, to);
        Vec3 on = d.times(from / to)
                .plus(facet.times(from / to * cosine - beyond))
                .normalized();
        if (scattered == scene.maxBounces || on.dot(hit.normal()) >= 0) {
            return new double[3];
        }
        double[] arriving = radiance(hit.point(), on, scattered + 1, events, path);
        return scaled(NaiveColors.product(color(hit), arriving), from * from / (to * to));
    }

    /** Rough glass: by single scattering with the weight of Walter's equation 41, or what that loses. */
    private double[] throughFacets(
            Glass glass, NaiveScene.Hit hit, Vec3 d, double from, double to, int scattered, int events, Path path) {
        if (isLeftOut(path)) {
            return new double[3];
        }
        double alpha = NaiveAmount.squared(glass.roughness());
        NaiveFacets facets = new NaiveFacets(alpha);
        Vec3[] axes = axes(hit.normal());
        Vec3 out = local(axes, d.negated());
        double share = 1;
        if (glass.multipleScattering()) {
            NaiveInterface boundary = boundary(alpha, from, to);
            // By halves each event of single scattering would be worth twice as much: see fly.
            double lost = Math.min(0.9, Math.max(0.01, boundary.lost(out.z())));
            if (path.random.nextDouble() < lost) {
                return throughInterface(boundary, lost, hit, axes, out.z(), from / to, scattered, events, path);
            }
            share = 1 - lost;
        }
        Vec3 m = facets.sample(path.random);
        double cosine = out.dot(m);
        if (cosine <= 0) {
            return new double[3];
        }
        Vec3 facet = axes[0].times(m.x()).plus(axes[1].times(m.y())).plus(axes[2].times(m.z()));
        boolean reflects = path.random.nextDouble() < NaiveFresnel.dielectric(cosine, from, to);
        double beyond = NaiveFresnel.refracted(Math.min(1, cosine), from, to);
        Vec3 in = reflects
                ? m.times(2 * cosine).minus(out)
                : m.times(from / to * cosine - beyond).minus(out.times(from / to));
        if (reflects != in.z() > 0) {
            return new double[3];
        }
        double weight = facets.visible(out, in.z() > 0 ? in : in.negated()) * cosine / (out.z() * m.z());
        return scaled(
                reflects
                        ? mirrored(hit, facet, d, scattered, events, path)
                        : refracted(hit, facet, d, from, to, scattered, events, path),
                weight / share);
    }

    /** What single scattering loses; that it is asked for has this probability. */
    private double[] throughInterface(
            NaiveInterface boundary,
            double probability,
            NaiveScene.Hit hit,
            Vec3[] axes,
            double out,
            double eta,
            int scattered,
            int events,
            Path path) {
        boolean through = path.random.nextDouble() < boundary.through();
        double side = through ? boundary.through() : 1 - boundary.through();
        Vec3 in = NaiveReflector.byCosine(path.random);
        double weight = Math.PI * boundary.value(out, in.z(), through) / (probability * side);
        double[] arriving = amongFacets(hit, axes, through ? mirror(in) : in, scattered, events, path);
        return through
                ? scaled(NaiveColors.product(color(hit), arriving), weight * eta * eta)
                : scaled(arriving, weight);
    }

    private static Vec3 mirror(Vec3 v) {
        return new Vec3(v.x(), v.y(), -v.z());
    }

    private double[] amongFacets(NaiveScene.Hit hit, Vec3[] axes, Vec3 in, int scattered, int events, Path path) {
        path.mirrored();
        Vec3 on = axes[0].times(in.x()).plus(axes[1].times(in.y())).plus(axes[2].times(in.z()));
        return scattered == scene.maxBounces ? new double[3] : radiance(hit.point(), on, scattered + 1, events, path);
    }

    private NaiveInterface boundary(double alpha, double from, double to) {
        return interfaces.computeIfAbsent(List.of(alpha, from, to), any -> new NaiveInterface(alpha, from, to));
    }

    static Vec3 local(Vec3[] axes, Vec3 v) {
        return new Vec3(axes[0].dot(v), axes[1].dot(v), axes[2].dot(v));
    }

    private static Vec3[] axes(Vec3 z) {
        Vec3 x = (Math.abs(z.x()) < 0.6 ? Vec3.X : Vec3.Y).cross(z).normalized();
        return new Vec3[] {x, z.cross(x), z};
    }
}
