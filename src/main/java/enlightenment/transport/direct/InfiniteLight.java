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
 * The light that reaches a vertex of a path from a picture of all directions, or from a sky and its sun; and the weight of such light that
 * the path runs into after it. Picture or sky and the sun are two lights: the first vertex takes both, later ones choose one by what falls
 * there if nothing hides any. One per thread, and only for scenes with such surroundings.
 */
public final class InfiniteLight {
    private final Surroundings around;
    private final Sun sun;
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

    /** Whether it took light from sun and sky, rather than from one that was chosen. */
    private boolean tookBoth;

    /** Whether the sun is left out, as paths from there find its light. */
    private boolean leavesSun;

    /** The tint of what passes, at a rough border; null elsewhere. */
    private double[] through;

    /** What was gathered, or came to the path's end. */
    public double red;

    public double green;
    public double blue;

    private InfiniteLight(CompiledScene scene, RayCounters counters, PathFollower path) {
        around = scene.physical.surroundings;
        sun = around.sun;
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
     * @param leaves whether the sun is left to the pass of caustics
     */
    public void gather(
            Bsdf bsdf, Scattering s, double[] tint, Sampler sampler, int address, boolean isFirst, boolean leaves) {
        nx = tint == null ? path.at.nx : 0;
        ny = tint == null ? path.at.ny : 0;
        nz = tint == null ? path.at.nz : 0;
        through = tint;
        leavesSun = leaves;
        tookBoth = isFirst || sun == null || leavesSun;
        red = 0;
        green = 0;
        blue = 0;
        boolean toSun = sun != null && !leavesSun;
        boolean toSky = !around.isBlack();
        if (!tookBoth) {
            toSun = sampler.unit(address, Sampler.Purpose.LIGHT) < sunShare();
            toSky &= !toSun;
        }
        if (toSun) {
            sampler.lightPoints(firstIndex, address, 1);
            sun.sample(sampler.lightX(0), sampler.lightY(0), direction);
            rgb[0] = sun.r;
            rgb[1] = sun.g;
            rgb[2] = sun.b;
            add(bsdf, s, probabilityOfSun() * sun.density());
        }
        if (toSky) {
            sampler.lightPoints(firstIndex + 1, address, 1);
            double density = around.sample(sampler.lightX(0), sampler.lightY(0), direction);
            around.radiance(direction[0], direction[1], direction[2], rgb);
            add(bsdf, s, probabilityOfSky() * density);
        }
    }

    /** The probability that the vertex chooses the sun, where it chooses. */
    private double sunShare() {
        boolean isBorder = nx == 0 && ny == 0 && nz == 0;
        double cosine = isBorder ? 1 : nx * sun.x + ny * sun.y + nz * sun.z + sun.sine;
        double ofSun = (sun.r + sun.g + sun.b) * sun.irradiance(Math.max(Math.min(cosine, 1), 0));
        double all = ofSun + around.irradiance(nx, ny, nz);
        return all > 0 ? ofSun / all : 0;
    }

    private double probabilityOfSun() {
        return tookBoth ? 1 : sunShare();
    }

    private double probabilityOfSky() {
        return tookBoth ? 1 : 1 - sunShare();
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
     * @param countsSun whether the sun's disk counts if light was not gathered
     */
    public void arrive(Ray ray, double pdf, boolean countsSun) {
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
        if (sun != null && sun.contains(dx, dy, dz)) {
            double ofSun = countsSun ? 1 : 0;
            if (isWeighted) {
                ofSun = leavesSun ? 0 : PowerHeuristic.weight(probabilityOfSun() * sun.density(), pdf);
            }
            red = Math.fma(ofSun, sun.r, red);
            green = Math.fma(ofSun, sun.g, green);
            blue = Math.fma(ofSun, sun.b, blue);
        }
    }
}
