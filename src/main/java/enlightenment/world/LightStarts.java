package enlightenment.world;

import enlightenment.emitter.IntensityProfile;
import enlightenment.math.Vec3;
import enlightenment.primitive.Primitive;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.SceneBall;
import java.util.Arrays;

/**
 * The emission sampling of light paths: the lights of a scene, and its surroundings as a last one that shines through the scene's
 * bounding sphere. One of them is sampled proportionally to its power, then a point and a direction. Immutable.
 */
public final class LightStarts {
    private static final int[] NO_MEDIA = {};

    private final PhysicalScene physical;

    /** The lights. */
    public final PhysicalLight[] lights;

    /** The index of the surroundings. */
    public final int background;

    /** Centre and radius of the scene's bounding sphere, in the frame: light paths from the surroundings pass through it. */
    public final Vec3 center;

    public final double radius;

    /** By light: the probability of being sampled. */
    private final double[] probability;

    /** Cumulative sums of {@link #probability}. */
    private final double[] cumulative;

    private final boolean[] shinesBothWays;

    /**
     * @param physical the lights and surroundings of the scene
     * @param primitives all surfaces of the scene
     * @param withBackground whether paths may begin in the surroundings
     */
    LightStarts(PhysicalScene physical, Primitive[] primitives, boolean withBackground) {
        this.physical = physical;
        lights = physical.lights;
        int n = lights.length;
        background = n;
        SceneBall ball = SceneBall.around(primitives);
        center = ball.center();
        radius = ball.radius();
        shinesBothWays = new boolean[n];
        probability = new double[n + 1];
        cumulative = new double[n + 1];
        double brightest = withBackground ? background() : 0;
        for (PhysicalLight light : lights) {
            brightest = Math.max(brightest, brightness(light));
        }
        double sum = 0;
        for (int l = 0; l <= n && brightest > 0; l++) {
            if (l < n) {
                shinesBothWays[l] = lights[l].shinesOutside && lights[l].shinesInside;
                probability[l] = brightness(lights[l]) / brightest * reach(l);
            } else if (withBackground) {
                probability[l] = background() / brightest * reach(l);
            }
            sum += probability[l];
            cumulative[l] = sum;
        }
        for (int l = 0; l <= n && sum > 0; l++) {
            probability[l] /= sum;
            cumulative[l] /= sum;
        }
    }

    /** The mean radiance of the surroundings, over all directions and the visible bands. */
    private double background() {
        if (physical.surroundings != null) {
            return physical.surroundings.power() / (12 * Math.PI);
        }
        return mean(physical.backgroundR, physical.backgroundG, physical.backgroundB);
    }

    private double brightness(PhysicalLight light) {
        double visible = mean(light.meanR, light.meanG, light.meanB);
        return physical.hasUltraviolet
                ? Math.fma(physical.visibleOfUltraviolet / 3, light.meanUltraviolet, visible)
                : visible;
    }

    private static double mean(double r, double g, double b) {
        return r / 3 + g / 3 + b / 3;
    }

    /** The power of a light of radiance or intensity 1: the integral over its points and directions. */
    private double reach(int l) {
        if (l == background) {
            return 4 * Math.PI * Math.PI * radius * radius;
        }
        if (lights[l].isPoint) {
            return lights[l].profile == null ? 4 * Math.PI : lights[l].profile.solidAngle();
        }
        return (shinesBothWays[l] ? 2 : 1) * Math.PI * lights[l].form.area();
    }

    /** Samples a light by a number in 0..1; -1 if the scene has no light. */
    public int choose(double number) {
        if (!(cumulative[background] > 0)) {
            return -1;
        }
        int at = Arrays.binarySearch(cumulative, number);
        int light = at < 0 ? -at - 1 : at + 1;
        while (light <= background && probability[light] == 0) {
            light++;
        }
        return light <= background ? light : last();
    }

    private int last() {
        int light = background;
        while (probability[light] == 0) {
            light--;
        }
        return light;
    }

    /** The probability with which {@link #choose} returns this light. */
    public double probability(int light) {
        return probability[light];
    }

    /** Whether paths leave a light with extent from both sides of its surface. */
    public boolean shinesBothWays(int light) {
        return shinesBothWays[light];
    }

    /** Whether light paths leave a light with extent on its inside only. */
    public boolean shinesInwards(int light) {
        return !lights[light].shinesOutside;
    }

    /**
     * The density, per area of the light in the frame, of the points that paths start at, given the light; for the surroundings per area
     * perpendicular to the direction, on the disk of the bounding sphere; 1 for a point light (discrete measure).
     */
    public double pointDensity(int light) {
        if (light == background) {
            return 1 / (Math.PI * radius * radius);
        }
        return lights[light].isPoint ? 1 : 1 / lights[light].form.area();
    }

    /**
     * The density, per solid angle, of the direction in which paths leave a point of a light with extent; of surroundings only if they are
     * constant.
     *
     * @param cosine between that direction and the normal on the side of emission; without influence for surroundings
     */
    public double directionDensity(int light, double cosine) {
        if (light == background) {
            return 1 / (4 * Math.PI);
        }
        return cosine > 0 ? cosine / (shinesBothWays[light] ? 2 * Math.PI : Math.PI) : 0;
    }

    /** The density, per solid angle, of the direction (unit vector) in which paths leave a point light. */
    public double directionDensity(int light, double dx, double dy, double dz) {
        IntensityProfile profile = lights[light].profile;
        return profile == null ? 1 / (4 * Math.PI) : profile.density(dx, dy, dz);
    }

    /** The ids of solids of glass that points of the light may lie in. */
    public int[] mediaAround(int light) {
        return light == background ? NO_MEDIA : lights[light].mediaAround();
    }
}
