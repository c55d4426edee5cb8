package enlightenment.transport.emission;

import enlightenment.emitter.AreaLight;
import enlightenment.emitter.IntensityProfile;
import enlightenment.frame.BallCone;
import enlightenment.primitive.EndFaces;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Warp;
import enlightenment.surroundings.Sun;
import enlightenment.transport.ray.PathSource;
import enlightenment.world.light.CausticPass;
import enlightenment.world.light.PhysicalLight;

/**
 * Samples the first rays of light paths for caustics, aimed at specular casters: mirrors and smooth glass. Given a light and a caster, the
 * direction is uniform over the cone around the caster's bounding ball; where that covers much of the view, it is distributed as the light
 * emits, by the cosine. Cones may overlap: the density of a direction is the sum over all casters of its light.
 *
 * <p>A sphere light apart from all casters is sampled as a beam: a direction in the cone around its centre that holds all lines from it to
 * the caster's ball, and a point of the disk across it. Then the cosine at the light causes no variance.
 */
public final class CausticSource extends PathSource {
    /** Directions are sampled as the light emits if the caster's ball covers more than this solid angle, in steradians. */
    private static final double WIDE = 1;

    private final CausticPass pass;
    private final BallCone cone = new BallCone();
    private final double[] direction = new double[3];

    public CausticSource(CausticPass pass) {
        this.pass = pass;
    }

    @Override
    protected int[] media() {
        return pass.mediaAround(light);
    }

    @Override
    protected EndFaces faces() {
        return light >= pass.lights.length ? null : pass.lights[light].lyingOn();
    }

    /** Uses one number for the pair of light and caster, two for the point on the light, two for the direction, one for the side. */
    @Override
    public boolean emit(double[] numbers, Ray ray) {
        int pair = pass.choose(numbers[0]);
        light = pair / pass.casters;
        int caster = pair % pass.casters;
        if (light >= pass.lights.length) {
            return fromSun(caster, numbers, ray);
        }
        PhysicalLight l = pass.lights[light];
        double weight;
        if (l.isPoint) {
            weight = fromPoint(l, caster, numbers, ray);
        } else if (pass.isBeam(light)) {
            weight = asBeam(l, caster, numbers, ray);
        } else {
            weight = fromSurface(l, caster, numbers, ray);
        }
        red = weight * l.r;
        green = weight * l.g;
        blue = weight * l.b;
        ultraviolet = weight * l.ultraviolet;
        weighByProfile(l);
        weighByTexture(l, ray.ox, ray.oy, ray.oz);
        return weight > 0 && weight < Double.POSITIVE_INFINITY;
    }

    /** Samples a direction of a sun's disk, and a point of the disk across it that the caster's ball fills. */
    private boolean fromSun(int caster, double[] numbers, Ray ray) {
        Sun sun = pass.suns[light - pass.lights.length];
        sun.sample(numbers[3], numbers[4], direction);
        dx = -direction[0];
        dy = -direction[1];
        dz = -direction[2];
        Warp.toDisk(numbers[1], numbers[2], disk);
        basis.around(dx, dy, dz);
        double a = pass.ballRadius[caster] * disk[0];
        double b = pass.ballRadius[caster] * disk[1];
        double x = Math.fma(a, basis.ax, Math.fma(b, basis.bx, pass.ballX[caster]));
        double y = Math.fma(a, basis.ay, Math.fma(b, basis.by, pass.ballY[caster]));
        double z = Math.fma(a, basis.az, Math.fma(b, basis.bz, pass.ballZ[caster]));
        double density = 0;
        for (int s = 0; s < pass.casters; s++) {
            if (s == caster || probability(s) > 0 && passes(s, x, y, z)) {
                density += probability(s) / (Math.PI * pass.ballRadius[s] * pass.ballRadius[s]);
            }
        }
        // The ray starts before all surfaces.
        double ahead =
                pass.radius + (x - pass.center.x()) * dx + (y - pass.center.y()) * dy + (z - pass.center.z()) * dz;
        ray.set(x - ahead * dx, y - ahead * dy, z - ahead * dz, dx, dy, dz, 0);
        double weight = sun.solidAngle / density;
        red = weight * sun.r;
        green = weight * sun.g;
        blue = weight * sun.b;
        ultraviolet = 0;
        return weight > 0 && weight < Double.POSITIVE_INFINITY;
    }

    /** Whether a ray through this point meets the bounding ball of caster s. */
    private boolean passes(int s, double x, double y, double z) {
        double ex = x - pass.ballX[s];
        double ey = y - pass.ballY[s];
        double ez = z - pass.ballZ[s];
        double along = ex * dx + ey * dy + ez * dz;
        double r = pass.ballRadius[s];
        return ex * ex + ey * ey + ez * ez - along * along <= r * r;
    }

    private double fromPoint(PhysicalLight l, int caster, double[] numbers, Ray ray) {
        aim(caster, 0, l.x, l.y, l.z);
        if (isWideFor(l.profile)) {
            l.profile.sample(numbers[3], numbers[4], direction);
            dx = direction[0];
            dy = direction[1];
            dz = direction[2];
        } else {
            toCone(numbers);
        }
        double density = 0;
        for (int s = 0; s < pass.casters; s++) {
            if (probability(s) > 0) {
                aim(s, 0, l.x, l.y, l.z);
                boolean asEmitted = isWideFor(l.profile);
                density += probability(s) * (asEmitted ? l.profile.density(dx, dy, dz) : densityInCone(s == caster));
            }
        }
        ray.set(l.x, l.y, l.z, dx, dy, dz, 0);
        l.lyingOn().startOn(ray, Ray.OUTSIDE, 0, 0, 0, probe);
        return 1 / density;
    }

    private double asBeam(PhysicalLight l, int caster, double[] numbers, Ray ray) {
        aim(caster, l.radius, l.x, l.y, l.z);
        toCone(numbers);
        double density = 0;
        for (int s = 0; s < pass.casters; s++) {
            density += probability(s) * coneDensity(s, caster, l.radius, l.x, l.y, l.z);
        }
        Warp.toDisk(numbers[1], numbers[2], disk);
        basis.around(dx, dy, dz);
        double a = l.radius * disk[0];
        double b = l.radius * disk[1];
        double c = l.radius * Math.sqrt(Math.max(1 - disk[2], 0));
        ray.set(
                l.x + a * basis.ax + b * basis.bx + c * dx,
                l.y + a * basis.ay + b * basis.by + c * dy,
                l.z + a * basis.az + b * basis.bz + c * dz,
                dx,
                dy,
                dz,
                0);
        ray.from(l.surface, Ray.OUTSIDE);
        l.lyingOn().startOn(ray, Ray.OUTSIDE, 0, 0, 0, probe);
        return Math.PI * l.radius * l.radius / density;
    }

    private double fromSurface(PhysicalLight l, int caster, double[] numbers, Ray ray) {
        AreaLight area = l.form;
        area.samplePoint(numbers[1], numbers[2], point);
        boolean both = pass.shinesBothWays(light);
        int only = pass.shinesInwards(light) ? Ray.INSIDE : Ray.OUTSIDE;
        aim(caster, 0, point.x, point.y, point.z);
        if (isWide()) {
            byCosine(numbers, both && numbers[5] < 0.5 ? Ray.INSIDE : only);
        } else {
            toCone(numbers);
        }
        double cosine = dx * point.nx + dy * point.ny + dz * point.nz;
        if (both ? cosine == 0 : !(only * cosine > 0)) {
            return 0;
        }
        double emission = Math.abs(cosine) / (both ? 2 * Math.PI : Math.PI);
        double density = 0;
        for (int s = 0; s < pass.casters; s++) {
            if (probability(s) > 0) {
                aim(s, 0, point.x, point.y, point.z);
                density += probability(s) * (isWide() ? emission : densityInCone(s == caster));
            }
        }
        int side = cosine > 0 ? Ray.OUTSIDE : Ray.INSIDE;
        return leave(l, side, ray) ? area.area() * Math.abs(cosine) / density : 0;
    }

    private double probability(int caster) {
        return pass.probability[light * pass.casters + caster];
    }

    /** Sets the cone from a point around the bounding ball of caster s, whose radius is widened. */
    private void aim(int s, double wider, double x, double y, double z) {
        cone.set(pass.ballX[s], pass.ballY[s], pass.ballZ[s], pass.ballRadius[s] + wider, x, y, z);
    }

    private boolean isWide() {
        return cone.inside || 2 * Math.PI * cone.oneMinusCosine() > WIDE;
    }

    /** Whether the light's profile emits into a smaller solid angle than the cone: then directions are sampled by the profile. */
    private boolean isWideFor(IntensityProfile profile) {
        return profile != null && (cone.inside || 2 * Math.PI * cone.oneMinusCosine() > profile.solidAngle());
    }

    /** Samples a direction uniformly over the cone, or over the sphere from inside the ball. */
    private void toCone(double[] numbers) {
        Warp.toDisk(numbers[3], numbers[4], disk);
        double height = cone.inside ? 2 : cone.oneMinusCosine();
        double spread = Math.sqrt(height * (2 - disk[2] * height));
        if (cone.inside) {
            direct(0, 0, 1, disk[0] * spread, disk[1] * spread, 1 - disk[2] * height);
        } else {
            direct(cone.wx, cone.wy, cone.wz, disk[0] * spread, disk[1] * spread, 1 - disk[2] * height);
        }
    }

    private void byCosine(double[] numbers, int side) {
        Warp.toDisk(numbers[3], numbers[4], disk);
        double up = Math.sqrt(Math.max(1 - disk[2], 0));
        direct(point.nx, point.ny, point.nz, disk[0], disk[1], side * up);
    }

    private double coneDensity(int s, int chosen, double wider, double x, double y, double z) {
        aim(s, wider, x, y, z);
        return densityInCone(s == chosen);
    }

    /** The density per solid angle of the direction by a cone; isIn for the cone that it was sampled in, which rounding must not deny. */
    private double densityInCone(boolean isIn) {
        if (cone.inside) {
            return 1 / (4 * Math.PI);
        }
        boolean in = isIn || dx * cone.wx + dy * cone.wy + dz * cone.wz >= cone.cosine;
        return in ? 1 / (2 * Math.PI * cone.oneMinusCosine()) : 0;
    }
}
