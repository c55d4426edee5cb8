package enlightenment.transport.emission;

import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Warp;
import enlightenment.surroundings.Sun;
import enlightenment.surroundings.Surroundings;
import enlightenment.transport.ray.PathSource;
import enlightenment.world.LightStarts;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;

/**
 * Samples the first rays of light paths in proportion to emission: a light by its power, a point on it by area, a direction by the cosine;
 * for the surroundings, a direction, uniformly or by radiance, and a point of the disk across it that the scene's bounding ball fills. So
 * all paths carry about the same power. The densities are kept for MIS weights.
 */
public final class LightSource extends PathSource {
    private final LightStarts starts;
    private final PhysicalScene physical;

    /** The probability with which this light was sampled. */
    public double probability;

    /** The density of the point, per area of the light; of the surroundings, per area across the ray; 1 for a point light. */
    public double pointDensity;

    /** The density of the direction, per solid angle. */
    public double directionDensity;

    /** The cosine at the light, on the side that the path leaves on; 1 where it has no surface. */
    public double cosine;

    private final double[] direction = new double[3];
    private final double[] radiance = new double[3];
    private boolean isInside;

    /**
     * @param starts the distribution of lights of the same scene
     */
    public LightSource(LightStarts starts, PhysicalScene physical) {
        this.starts = starts;
        this.physical = physical;
    }

    /** The cosine with the outside normal of the light: negative if the path leaves on the inside. */
    public double cosineOutside() {
        return isInside ? -cosine : cosine;
    }

    /** Whether the light is a point, which no path can hit. */
    public boolean isPoint() {
        return !isBackground() && starts.lights[light].isPoint;
    }

    /** Whether the sampled light is the surroundings. */
    boolean isBackground() {
        return light == starts.background;
    }

    @Override
    protected int[] media() {
        return starts.mediaAround(light);
    }

    @Override
    protected EndFaces faces() {
        return isBackground() ? null : starts.lights[light].lyingOn();
    }

    @Override
    public boolean emit(double[] numbers, Ray ray) {
        light = starts.choose(numbers[0]);
        if (light < 0) {
            return false;
        }
        probability = starts.probability(light);
        pointDensity = starts.pointDensity(light);
        cosine = 1;
        boolean goes = true;
        if (isBackground()) {
            if (physical.surroundings == null) {
                toSphere(numbers);
                across(numbers, ray);
                weigh(physical.backgroundR, physical.backgroundG, physical.backgroundB, 0);
            } else {
                fromSurroundings(physical.surroundings, numbers);
                across(numbers, ray);
            }
        } else {
            PhysicalLight l = starts.lights[light];
            if (l.isPoint) {
                fromPoint(l, numbers, ray);
            } else {
                goes = fromSurface(l, numbers, ray);
                weigh(l.r, l.g, l.b, l.ultraviolet);
                weighByTexture(l, point.x, point.y, point.z);
            }
        }
        return goes && directionDensity > 0 && (red > 0 || green > 0 || blue > 0 || ultraviolet > 0);
    }

    private void weigh(double r, double g, double b, double u) {
        directionDensity = starts.directionDensity(light, cosine);
        weighEvenly(r, g, b, u);
    }

    private void weighEvenly(double r, double g, double b, double u) {
        double weight = cosine / (probability * pointDensity * directionDensity);
        red = weight * r;
        green = weight * g;
        blue = weight * b;
        ultraviolet = weight * u;
    }

    private void fromPoint(PhysicalLight l, double[] numbers, Ray ray) {
        if (l.profile == null) {
            toSphere(numbers);
        } else {
            l.profile.sample(numbers[4], numbers[5], direction);
            dx = direction[0];
            dy = direction[1];
            dz = direction[2];
        }
        directionDensity = starts.directionDensity(light, dx, dy, dz);
        weighEvenly(l.r, l.g, l.b, l.ultraviolet);
        weighByProfile(l);
        ray.set(l.x, l.y, l.z, dx, dy, dz, 0);
        l.lyingOn().startOn(ray, Ray.OUTSIDE, 0, 0, 0, probe);
    }

    /** Samples a direction uniformly over the sphere. */
    private void toSphere(double[] numbers) {
        Warp.toDisk(numbers[4], numbers[5], disk);
        double spread = 2 * Math.sqrt(Math.max(1 - disk[2], 0));
        direct(0, 0, 1, disk[0] * spread, disk[1] * spread, 1 - 2 * disk[2]);
    }

    /** Samples a sun, or the map or sky, by power, and a direction from it; sets the throughput. */
    private void fromSurroundings(Surroundings around, double[] numbers) {
        Sun chosen = null;
        double below = 0;
        for (Sun sun : around.suns) {
            boolean isNext = numbers[1] >= below;
            below += around.share(sun);
            chosen = isNext && sun.power() > 0 ? sun : chosen;
        }
        // Where there are only suns, the sum of their probabilities may fall below 1 by rounding.
        if (chosen != null && (numbers[1] < below || around.isBlack())) {
            chosen.sample(numbers[4], numbers[5], direction);
            directionDensity = around.share(chosen) * chosen.density();
            weighEvenly(chosen.r, chosen.g, chosen.b, 0);
        } else {
            directionDensity = (1 - below) * around.sample(numbers[4], numbers[5], direction);
            around.radiance(direction[0], direction[1], direction[2], radiance);
            weighEvenly(radiance[0], radiance[1], radiance[2], 0);
        }
        dx = -direction[0];
        dy = -direction[1];
        dz = -direction[2];
    }

    /** Samples the ray's origin on the disk across its direction that the scene's bounding ball fills. */
    private void across(double[] numbers, Ray ray) {
        Warp.toDisk(numbers[2], numbers[3], disk);
        basis.around(dx, dy, dz);
        double r = starts.radius;
        ray.set(
                starts.center.x() + r * Math.fma(disk[0], basis.ax, Math.fma(disk[1], basis.bx, -dx)),
                starts.center.y() + r * Math.fma(disk[0], basis.ay, Math.fma(disk[1], basis.by, -dy)),
                starts.center.z() + r * Math.fma(disk[0], basis.az, Math.fma(disk[1], basis.bz, -dz)),
                dx,
                dy,
                dz,
                0);
    }

    /** Samples point and direction on a light with a surface; returns false where another surface covers it. */
    private boolean fromSurface(PhysicalLight l, double[] numbers, Ray ray) {
        l.form.samplePoint(numbers[2], numbers[3], point);
        Warp.toDisk(numbers[4], numbers[5], disk);
        boolean isInside = starts.shinesBothWays(light) ? numbers[1] < 0.5 : starts.shinesInwards(light);
        int side = isInside ? Ray.INSIDE : Ray.OUTSIDE;
        direct(
                side * point.nx,
                side * point.ny,
                side * point.nz,
                disk[0],
                disk[1],
                Math.sqrt(Math.max(1 - disk[2], 0)));
        cosine = side * (dx * point.nx + dy * point.ny + dz * point.nz);
        this.isInside = isInside;
        return leave(l, side, ray);
    }
}
