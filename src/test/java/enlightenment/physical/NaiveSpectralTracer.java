package enlightenment.physical;

import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/**
 * As {@link NaiveTracer}, one wavelength at a time: a path begins with the wavelength that is seen, and where a fluorescent surface may
 * have changed it, with a wavelength that was absorbed there. No matrix, and no bands but those in which a scene says how much light there
 * is and what surfaces reflect. Knows matte, fluorescent, mirroring and glass surfaces, and lights with extent by their radiance.
 */
final class NaiveSpectralTracer {
    private static final int CHUNKS = 32;
    private static final int CERTAIN_EVENTS = 20;
    private static final double SURVIVAL = 0.8;

    /** Red, green, blue, ultraviolet, in nanometres. */
    private static final double[] LOW = {580, 490, 400, 300};

    private static final double[] HIGH = {780, 580, 490, 400};

    private final NaiveScene scene;
    private final boolean leavesOutMirrored;

    /** By surface: what it emits in ultraviolet. */
    private final List<Double> ultraviolet = new ArrayList<>();

    /** @param leavesOutMirrored whether surfaces that the eye sees in mirrors and through glass are black */
    NaiveSpectralTracer(Scene scene, boolean leavesOutMirrored) {
        this.scene = new NaiveScene(scene);
        this.leavesOutMirrored = leavesOutMirrored;
        for (Light light : scene.lights()) {
            ultraviolet.add(light.ultraviolet());
        }
        for (SceneObject object : scene.objects()) {
            ultraviolet.add(object.material().ultraviolet());
        }
    }

    /** As {@link NaiveTracer#means}. */
    double[][] means(int left, int top, int right, int bottom, int paths, long seed) {
        double[][] bands = new double[3][CHUNKS];
        IntStream.range(0, CHUNKS).parallel().forEach(k -> {
            SplittableRandom random = new SplittableRandom(seed + 1000L * k);
            for (int i = 0; i < 3 * paths / CHUNKS; i++) {
                double x = left + (right - left) * random.nextDouble();
                double y = top + (bottom - top) * random.nextDouble();
                Vec3[] ray = scene.ray(x / scene.width(), y / scene.height());
                int band = i % 3;
                double wavelength = random.nextDouble(LOW[band], HIGH[band]);
                // Of what comes in the band, per nanometre.
                double seen = radiance(ray[0], ray[1], wavelength, 0, 0, random);
                bands[band][k] += seen * (HIGH[band] - LOW[band]) / (paths / CHUNKS);
            }
        });
        return bands;
    }

    private static int band(double wavelength) {
        int band = 0;
        while (wavelength < LOW[band]) {
            band++;
        }
        return band;
    }

    /** Of three numbers that of a wavelength: surfaces reflect ultraviolet as blue. */
    private static double at(double wavelength, double[] rgb) {
        return rgb[Math.min(band(wavelength), 2)];
    }

    /** @param sight 0 at the eye, 1 after mirrors and glass, 2 after a surface that scatters light */
    private double radiance(Vec3 o, Vec3 d, double wavelength, int sight, int events, SplittableRandom random) {
        NaiveScene.Hit hit = scene.nearest(o, d);
        int band = band(wavelength);
        if (hit == null) {
            return band < 3 ? scene.background(d)[band] / (HIGH[band] - LOW[band]) : 0;
        }
        NaiveScene.Surface s = hit.surface();
        double[] visible = hit.front() ? s.front() : s.back();
        boolean shines = s.material() != null || hit.front() || s.isSolid() || visible[0] > 0;
        double emitted = band < 3 ? visible[band] : shines ? ultraviolet.get(scene.surfaces.indexOf(s)) : 0;
        double sum = emitted / (HIGH[band] - LOW[band]);
        if (s.material() == null) {
            return sum;
        }
        double survival = events < CERTAIN_EVENTS ? 1 : SURVIVAL;
        if (random.nextDouble() < survival) {
            sum += scattered(hit, d, wavelength, sight, events + 1, random) / survival;
        }
        return sum;
    }

    private double scattered(
            NaiveScene.Hit hit, Vec3 d, double wavelength, int sight, int events, SplittableRandom random) {
        Material material = hit.surface().material();
        Vec3 n = hit.normal();
        int mirrored = Math.max(sight, 1);
        double color =
                at(wavelength, NaiveColors.of(material.color(), hit.surface().shape(), hit.point()));
        Vec3 reflected = d.minus(n.times(2 * d.dot(n)));
        if (material instanceof Material.Mirror) {
            return color * radiance(hit.point(), reflected, wavelength, mirrored, events, random);
        }
        if (material instanceof Glass g) {
            double from = hit.front() ? 1 : g.indexOfRefraction();
            double to = hit.front() ? g.indexOfRefraction() : 1;
            double cosine = Math.min(1, -d.dot(n));
            if (random.nextDouble() < NaiveFresnel.dielectric(cosine, from, to)) {
                return radiance(hit.point(), reflected, wavelength, mirrored, events, random);
            }
            Vec3 on = d.times(from / to)
                    .plus(n.times(from / to * cosine - NaiveFresnel.refracted(cosine, from, to)))
                    .normalized();
            double expansion = from * from / (to * to);
            return expansion * color * radiance(hit.point(), on, wavelength, mirrored, events, random);
        }
        if (leavesOutMirrored && sight == 1) {
            return 0;
        }
        Vec3 on = cosine(n, random);
        if (!(material instanceof Material.Fluorescent dye)) {
            return color * radiance(hit.point(), on, wavelength, 2, events, random);
        }
        if (random.nextBoolean()) {
            return 2 * color * radiance(hit.point(), on, wavelength, 2, events, random);
        }
        double low = dye.absorption().low();
        double high = dye.absorption().high();
        double absorbed = low + (high - low) * random.nextDouble();
        double first = Math.max(dye.emission().low(), absorbed);
        double last = dye.emission().high();
        if (wavelength < first || wavelength > last) {
            return 0;
        }
        double share =
                1 - at(absorbed, NaiveColors.of(material.color(), hit.surface().shape(), hit.point()));
        double weight = 2 * (high - low) * share * dye.yield() * (absorbed / wavelength) / (last - first);
        return weight * radiance(hit.point(), on, absorbed, 2, events, random);
    }

    private static Vec3 cosine(Vec3 n, SplittableRandom random) {
        double angle = 2 * Math.PI * random.nextDouble();
        double r2 = random.nextDouble();
        Vec3 x = (Math.abs(n.x()) < 0.6 ? Vec3.X : Vec3.Y).cross(n).normalized();
        Vec3 y = n.cross(x);
        double r = Math.sqrt(r2);
        return x.times(r * Math.cos(angle)).plus(y.times(r * Math.sin(angle))).plus(n.times(Math.sqrt(1 - r2)));
    }
}
