package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.surroundings.Sun;
import enlightenment.surroundings.Surroundings;

/**
 * The light that reaches a vertex of a path from a picture of all directions, or from a sky and its sun; and the weight of such light that
 * the path runs into after it. Picture or sky and the sun are two lights: the first vertex takes both, later ones choose one by what falls
 * there if nothing hides any. One per thread, and only for scenes with such surroundings.
 */
final class InfiniteLight {
    private final Surroundings around;
    private final Sun sun;
    private final RayCounters counters;
    private final DistantRays rays;
    private final PathFollower path;
    private final PathValue value;

    /** Numbers of points of lights are asked for by the indices after those of all other lights. */
    private final int firstIndex;

    private final double[] direction = new double[3];
    private final double[] rgb = new double[3];

    /** The normal of the last vertex that scattered light other than into single directions; (0, 0, 0) at a rough border. */
    private double nx;

    private double ny;
    private double nz;

    /** Whether it took light from sun and sky, rather than from one that was chosen. */
    private boolean tookBoth;

    /** The tint of what passes, at a rough border; null elsewhere. */
    private double[] through;

    private InfiniteLight(CompiledScene scene, RayCounters counters, PathFollower path, PathValue value) {
        this.value = value;
        around = scene.physical.surroundings;
        sun = around.sun;
        firstIndex = scene.physical.lights.length + 1;
        this.counters = counters;
        this.path = path;
        rays = new DistantRays(scene, counters, path);
    }

    /** What gathers for a thread and adds it to the value of its path; null if the scene has no such surroundings. */
    static InfiniteLight of(CompiledScene scene, RayCounters counters, PathFollower path, PathValue value) {
        return scene.physical.surroundings == null ? null : new InfiniteLight(scene, counters, path, value);
    }

    /**
     * Gathers the light at the surface that the path is at.
     *
     * @param isFirst whether the path came here from the eye by delta events only
     */
    void gather(Bsdf bsdf, Scattering s, Sampler sampler, int address, boolean isFirst) {
        double facing = path.hit.side;
        begin(facing * path.hit.nx, facing * path.hit.ny, facing * path.hit.nz, isFirst);
        through = null;
        gather(bsdf, s, sampler, address);
    }

    /**
     * Gathers the light on both sides of the rough border of two media that the path is at.
     *
     * @param tint of what passes, by band
     */
    void gatherAtBorder(Bsdf bsdf, Scattering s, double[] tint, Sampler sampler, int address, boolean isFirst) {
        begin(0, 0, 0, isFirst);
        through = tint;
        gather(bsdf, s, sampler, address);
    }

    private void begin(double x, double y, double z, boolean isFirst) {
        nx = x;
        ny = y;
        nz = z;
        tookBoth = isFirst || sun == null;
    }

    private void gather(Bsdf bsdf, Scattering s, Sampler sampler, int address) {
        boolean toSun = sun != null;
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
        if (!(density > 0) || through == null && !(s.ix * s.nx + s.iy * s.ny + s.iz * s.nz > 0)) {
            return;
        }
        bsdf.evaluate(s);
        boolean passes = through != null && Optics.turn(s, through);
        if ((s.valueR > 0 || s.valueG > 0 || s.valueB > 0)
                && rays.escapes(direction[0], direction[1], direction[2], through != null, passes)) {
            double f = PowerHeuristic.weight(s.pdf, density) / density;
            value.add(
                    f * s.valueR * rays.rgb[0] * rgb[0],
                    f * s.valueG * rays.rgb[1] * rgb[1],
                    f * s.valueB * rays.rgb[2] * rgb[2]);
        }
    }

    /**
     * What comes to the path from where its ray leads to, beyond everything.
     *
     * @param pdf the density per solid angle with which the path left its last vertex, if light was gathered there; else 0
     * @param sunWeight of the sun's disk if light was not gathered
     */
    void arrive(Ray ray, double pdf, double sunWeight) {
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
        double r = weight * rgb[0];
        double g = weight * rgb[1];
        double b = weight * rgb[2];
        if (sun != null && sun.contains(dx, dy, dz)) {
            double ofSun = isWeighted ? PowerHeuristic.weight(probabilityOfSun() * sun.density(), pdf) : sunWeight;
            r = Math.fma(ofSun, sun.r, r);
            g = Math.fma(ofSun, sun.g, g);
            b = Math.fma(ofSun, sun.b, b);
        }
        value.add(r, g, b);
        value.addCertain(r, g, b, 0);
    }
}
