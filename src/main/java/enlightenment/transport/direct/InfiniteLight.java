package enlightenment.transport.direct;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.surroundings.Sun;
import enlightenment.surroundings.Surroundings;
import enlightenment.transport.ray.Optics;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.PowerHeuristic;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/**
 * Next-event estimation of the surroundings: an environment map or a sky, and suns; with the MIS weight of such light that the path hits.
 * The map or sky is one light, each sun another: the first vertex samples all of them if there are at most {@value #ALL_AT_FIRST} suns,
 * later vertices sample one with probability proportional to its unoccluded irradiance. One per thread, and only for scenes with such
 * surroundings.
 */
public final class InfiniteLight {
    private static final int ALL_AT_FIRST = 4;

    private final Surroundings around;
    private final Sun[] suns;

    /** By sun: the probability that the last vertex sampled it, where it sampled one of the lights; and that of the map or sky. */
    private final double[] shares;

    private double shareOfSky;
    private final RayCounters counters;
    private final DistantRays rays;
    private final PathFollower path;

    /** The index of the first of these lights for random numbers of points on lights: after all other lights. */
    private final int firstIndex;

    private final double[] direction = new double[3];
    private final double[] rgb = new double[3];
    private final Scattering white = new Scattering();

    /** The normal of the last vertex with next-event estimation; (0, 0, 0) at a rough interface. */
    private double nx;

    private double ny;
    private double nz;

    /** Whether the last vertex sampled all lights, rather than one. */
    private boolean tookAll;

    /** Whether suns were left out at the last vertex, as the caustic pass covers them. */
    private boolean leavesSuns;

    /** The tint of transmitted light at a rough interface; null elsewhere. */
    private double[] through;

    /** The result of {@link #gather} or {@link #arrive}: radiance towards the path's previous vertex. */
    public double red;

    public double green;
    public double blue;

    private InfiniteLight(CompiledScene scene, RayCounters counters, PathFollower path) {
        around = scene.physical.surroundings;
        suns = around.suns.toArray(new Sun[0]);
        shares = new double[suns.length];
        firstIndex = scene.physical.lights.length + 1;
        this.counters = counters;
        this.path = path;
        rays = new DistantRays(scene, counters, path);
        white.red = 1;
        white.green = 1;
        white.blue = 1;
    }

    /** Makes the estimator of one thread; null if the scene has no such surroundings. */
    public static InfiniteLight of(CompiledScene scene, RayCounters counters, PathFollower path) {
        return scene.physical.surroundings == null ? null : new InfiniteLight(scene, counters, path);
    }

    /** Estimates the light that a white Lambertian surface at the current vertex would reflect. */
    void gatherMatte(Sampler sampler, int address, boolean isFirst) {
        white.nx = path.at.nx;
        white.ny = path.at.ny;
        white.nz = path.at.nz;
        gather(Lambert.INSTANCE, white, null, sampler, address, isFirst, false);
    }

    /**
     * Estimates direct light of the surroundings at the current vertex, on a surface or in a medium.
     *
     * @param tint of transmitted light, at a rough interface of two media: then both sides are lit; null elsewhere
     * @param isFirst whether the path came here from the eye by delta events only
     * @param leaves whether suns are left to the caustic pass
     */
    public void gather(
            Bsdf bsdf, Scattering s, double[] tint, Sampler sampler, int address, boolean isFirst, boolean leaves) {
        nx = tint == null ? path.at.nx : 0;
        ny = tint == null ? path.at.ny : 0;
        nz = tint == null ? path.at.nz : 0;
        through = tint;
        leavesSuns = leaves;
        tookAll = isFirst && suns.length <= ALL_AT_FIRST || suns.length == 0 || leavesSuns;
        red = 0;
        green = 0;
        blue = 0;
        int chosen = tookAll ? -1 : choose(sampler.unit(address, Sampler.Purpose.LIGHT));
        for (int i = 0; i < suns.length && !leavesSuns; i++) {
            if (tookAll || i == chosen) {
                Sun sun = suns[i];
                sampler.lightPoints(firstIndex + i, address, 1);
                sun.sample(sampler.lightX(0), sampler.lightY(0), direction);
                rgb[0] = sun.r;
                rgb[1] = sun.g;
                rgb[2] = sun.b;
                add(bsdf, s, probabilityOf(i) * sun.density());
            }
        }
        if (!around.isBlack() && (tookAll || chosen == suns.length)) {
            sampler.lightPoints(firstIndex + Math.max(suns.length, 1), address, 1);
            double density = around.sample(sampler.lightX(0), sampler.lightY(0), direction);
            around.radiance(direction[0], direction[1], direction[2], rgb);
            add(bsdf, s, probabilityOfSky() * density);
        }
    }

    /** Samples a sun by a number in [0, 1), or the map or sky, whose index is after the last sun; stores the probabilities. */
    private int choose(double number) {
        boolean isInterface = nx == 0 && ny == 0 && nz == 0;
        double all = 0;
        for (int i = 0; i < suns.length; i++) {
            Sun sun = suns[i];
            double cosine = isInterface ? 1 : nx * sun.x + ny * sun.y + nz * sun.z + sun.sine;
            shares[i] = (sun.r + sun.g + sun.b) * sun.irradiance(Math.max(Math.min(cosine, 1), 0));
            all += shares[i];
        }
        all += around.irradiance(nx, ny, nz);
        int chosen = suns.length;
        double below = 0;
        for (int i = 0; i < suns.length; i++) {
            shares[i] = all > 0 ? shares[i] / all : 0;
            below += shares[i];
            chosen = chosen == suns.length && number < below ? i : chosen;
        }
        shareOfSky = 1 - below;
        return chosen;
    }

    private double probabilityOf(int sun) {
        return tookAll ? 1 : shares[sun];
    }

    private double probabilityOfSky() {
        return tookAll ? 1 : shareOfSky;
    }

    private void add(Bsdf bsdf, Scattering s, double density) {
        counters.lightSamples++;
        s.ix = direction[0];
        s.iy = direction[1];
        s.iz = direction[2];
        if (!(density > 0) || !bsdf.transmits() && !(s.ix * s.nx + s.iy * s.ny + s.iz * s.nz > 0)) {
            return;
        }
        bsdf.evaluate(s);
        boolean passes = through != null && Optics.turn(s, through);
        if ((s.valueR > 0 || s.valueG > 0 || s.valueB > 0)
                && rays.escapes(direction[0], direction[1], direction[2], through != null, passes)) {
            double f = PowerHeuristic.weight(s.pdf, density) / density;
            if (through != null && path.glass.wavelength != null) {
                path.glass.wavelength.color(s);
            }
            red = Math.fma(f * s.valueR * rays.rgb[0], rgb[0], red);
            green = Math.fma(f * s.valueG * rays.rgb[1], rgb[1], green);
            blue = Math.fma(f * s.valueB * rays.rgb[2], rgb[2], blue);
        }
    }

    /**
     * Computes the radiance of the surroundings along a ray that leaves the scene, times its MIS weight.
     *
     * @param pdf the density per solid angle of the path's last BSDF sample, if light was sampled at its vertex; else 0
     * @param countsSuns whether the disks of suns count if light was not sampled
     */
    public void arrive(Ray ray, double pdf, boolean countsSuns) {
        boolean isWeighted = pdf > 0;
        double scale = 1 / Math.sqrt(ray.dd);
        double dx = ray.dx * scale;
        double dy = ray.dy * scale;
        double dz = ray.dz * scale;
        around.radiance(dx, dy, dz, rgb);
        double weight = 1;
        if (isWeighted && !around.isBlack()) {
            weight = PowerHeuristic.weight(probabilityOfSky() * around.density(dx, dy, dz), pdf);
        }
        red = weight * rgb[0];
        green = weight * rgb[1];
        blue = weight * rgb[2];
        for (int i = 0; i < suns.length; i++) {
            Sun sun = suns[i];
            if (sun.contains(dx, dy, dz)) {
                double ofSun = countsSuns ? 1 : 0;
                if (isWeighted) {
                    ofSun = leavesSuns ? 0 : PowerHeuristic.weight(probabilityOf(i) * sun.density(), pdf);
                }
                red = Math.fma(ofSun, sun.r, red);
                green = Math.fma(ofSun, sun.g, green);
                blue = Math.fma(ofSun, sun.b, blue);
            }
        }
    }
}
