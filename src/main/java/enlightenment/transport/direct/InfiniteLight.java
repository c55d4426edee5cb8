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
 * The light that reaches a vertex of a path from a picture of all directions or a sky, and from suns; and the weight of such light that
 * the path runs into after it. Picture or sky is one light, each sun another: the first vertex samples all of them if there are at most
 * {@value #ALL_AT_FIRST} suns, later ones choose one by what falls there if nothing hides any. One per thread, and only for scenes with
 * such surroundings.
 */
public final class InfiniteLight {
    private static final int ALL_AT_FIRST = 4;

    private final Surroundings around;
    private final Sun[] suns;

    /** By sun: the probability that the last vertex chose it, if it chose; and that of the rest. */
    private final double[] shares;

    private double shareOfSky;
    private final RayCounters counters;
    private final DistantRays rays;
    private final PathFollower path;

    /** Numbers of points of lights are asked for by the indices after those of all other lights. */
    private final int firstIndex;

    private final double[] direction = new double[3];
    private final double[] rgb = new double[3];
    private final Scattering white = new Scattering();

    /** The normal of the last vertex that scattered light other than into single directions; (0, 0, 0) at a rough border. */
    private double nx;

    private double ny;
    private double nz;

    /** Whether it took light from suns and sky, rather than from one that was chosen. */
    private boolean tookAll;

    /** Whether suns are left out, as paths from there find their light. */
    private boolean leavesSuns;

    /** The tint of what passes, at a rough border; null elsewhere. */
    private double[] through;

    /** What was gathered, or came to the path's end. */
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

    /** What gathers for a thread; null if the scene has no such surroundings. */
    public static InfiniteLight of(CompiledScene scene, RayCounters counters, PathFollower path) {
        return scene.physical.surroundings == null ? null : new InfiniteLight(scene, counters, path);
    }

    /** Gathers the light at a white Lambertian surface in the place of the one that the path is at. */
    void gatherMatte(Sampler sampler, int address, boolean isFirst) {
        white.nx = path.at.nx;
        white.ny = path.at.ny;
        white.nz = path.at.nz;
        gather(Lambert.INSTANCE, white, null, sampler, address, isFirst, false);
    }

    /**
     * Gathers the light at the surface that the path is at, or the point of a medium.
     *
     * @param tint of what passes, at a rough border of two media: then light is gathered on both sides; null elsewhere
     * @param isFirst whether the path came here from the eye by delta events only
     * @param leaves whether suns are left to the pass of caustics
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

    /** The sun that a number in [0, 1) chooses at the vertex, or the rest, which is after the last; keeps the probabilities. */
    private int choose(double number) {
        boolean isBorder = nx == 0 && ny == 0 && nz == 0;
        double all = 0;
        for (int i = 0; i < suns.length; i++) {
            Sun sun = suns[i];
            double cosine = isBorder ? 1 : nx * sun.x + ny * sun.y + nz * sun.z + sun.sine;
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
     * What comes to the path from where its ray leads to, beyond everything.
     *
     * @param pdf the density per solid angle with which the path left its last vertex, if light was gathered there; else 0
     * @param countsSuns whether the disks of suns count if light was not gathered
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
