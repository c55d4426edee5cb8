package enlightenment.world.light;

import enlightenment.bsdf.Bsdf;
import enlightenment.emitter.IntensityProfile;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.surroundings.Sun;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.SceneBall;
import java.util.Arrays;

/**
 * The pairs of lights and specular casters that light paths for caustics start from: light that mirrors or smooth glass send to other
 * surfaces. Light paths sample all of it that such a surface scatters directly to the eye, and paths from the eye leave it out. For small
 * lights the same holds for light that narrow lobes of rough surfaces send to wide ones. Immutable.
 *
 * <p>A path begins with a pair of light and caster, sampled by an estimate of the power that goes from one to the other.
 */
public final class CausticPass {
    /** The largest number of bounding balls of casters: each path tests all of them. */
    private static final int MOST_THINGS = 32;

    private static final int MOST_PAIRS = 1 << 20;

    private static final int[] NO_MEDIA = {};

    /** The least cosine assumed at a flat light from which a caster is seen at a grazing angle. */
    private static final double LEAST_COSINE = 0.05;

    /** The least number of scattering events of a caustic: one at a mirror, one where it is seen. */
    private static final int LEAST_BOUNCES = 2;

    /** The lights. */
    public final PhysicalLight[] lights;

    /** The bounding balls of the casters, in the frame. */
    public final double[] ballX;

    public final double[] ballY;
    public final double[] ballZ;
    public final double[] ballRadius;

    /** The number of casters. */
    public final int casters;

    /** By light, then caster: the probability of the pair. */
    public final double[] probability;

    /** Cumulative sums of {@link #probability}. */
    private final double[] cumulative;

    private final double ofUltraviolet;

    /** The disks of suns; their indices as lights follow the others. */
    public final Sun[] suns;

    /** Centre and radius of the scene's bounding ball, which paths from suns pass through. */
    public final Vec3 center;

    public final double radius;

    private double brightest;

    /** By light, then by sun: whether it is small, so that narrow lobes count as casters of its caustics. */
    private final boolean[] isSmall;

    /** Whether any light is small. */
    private final boolean takesNarrow;

    private final boolean hasSmallLights;

    private final boolean[] isBeam;
    /** By light: whether light may go to casters from its outside and from its inside. */
    private final boolean[] shinesOutside;

    private final boolean[] shinesInside;

    private CausticPass(
            PhysicalLight[] lights,
            Sun[] suns,
            double ofUltraviolet,
            SpecularCasters balls,
            boolean[] isSmall,
            CompiledPrimitives compiled) {
        hasSmallLights = SmallLights.any(SmallLights.of(lights, suns, balls));
        this.lights = lights;
        this.isSmall = isSmall;
        takesNarrow = SmallLights.any(isSmall);
        this.suns = suns;
        this.ofUltraviolet = ofUltraviolet;
        SceneBall around = SceneBall.around(compiled.primitives());
        center = around.center();
        radius = around.radius();
        casters = balls.count();
        ballX = balls.x;
        ballY = balls.y;
        ballZ = balls.z;
        ballRadius = balls.radius;
        int n = lights.length;
        for (PhysicalLight light : lights) {
            brightest = Math.max(brightest, brightness(light));
        }
        for (Sun sun : suns) {
            brightest = Math.max(brightest, sun.max());
        }
        isBeam = new boolean[n];
        shinesOutside = new boolean[n];
        shinesInside = new boolean[n];
        int pairs = (n + suns.length) * casters;
        probability = new double[pairs];
        cumulative = new double[pairs];
        for (int l = 0; l < n; l++) {
            prepare(l);
        }
        for (int i = 0; i < suns.length && brightest > 0; i++) {
            prepareSun(i);
        }
        for (int pair = 0; pair < probability.length; pair++) {
            if (!balls.isSharp[pair % casters] && !isSmall[pair / casters]) {
                probability[pair] = 0;
            }
        }
        double sum = 0;
        for (int pair = 0; pair < probability.length; pair++) {
            sum += probability[pair];
            cumulative[pair] = sum;
        }
        for (int pair = 0; pair < probability.length && sum > 0; pair++) {
            probability[pair] /= sum;
            cumulative[pair] /= sum;
        }
    }

    /** Whether a light is so small, as seen from a mirror or glass, that paths from the eye seldom find its caustics. */
    public boolean hasSmallLights() {
        return hasSmallLights;
    }

    /**
     * The pass of a scene; null if it needs none: without mirrors and smooth glass, without lights that reach them, and where paths end
     * before.
     *
     * @param ofUltraviolet visible effect of a unit of ultraviolet
     */
    public static CausticPass of(
            PhysicalLight[] lights, Sun[] suns, double ofUltraviolet, CompiledPrimitives compiled, int maxBounces) {
        int n = lights.length + suns.length;
        if (n == 0 || maxBounces < LEAST_BOUNCES) {
            return null;
        }
        int most = Math.max(Math.min(MOST_THINGS, MOST_PAIRS / n), 1);
        boolean[] isSmall = SmallLights.of(lights, suns, SpecularCasters.of(compiled, most, false, true));
        SpecularCasters balls = SpecularCasters.of(compiled, most, true, SmallLights.any(isSmall));
        if (balls.count() == 0) {
            return null;
        }
        CausticPass pass = new CausticPass(lights, suns, ofUltraviolet, balls, isSmall, compiled);
        return pass.cumulative[pass.cumulative.length - 1] > 0 ? pass : null;
    }

    private void prepare(int l) {
        PhysicalLight light = lights[l];
        boolean isApart = true;
        for (int s = 0; s < casters; s++) {
            isApart &= distance(light, s) > ballRadius[s] + light.ballRadius;
        }
        isBeam[l] = isApart && light.isBall;
        // Light that a solid emits on its inside reaches no caster outside of it.
        shinesOutside[l] = light.shinesOutside;
        shinesInside[l] = light.shinesInside && !(isApart && light.surface.isSolid());
        for (int s = 0; s < casters; s++) {
            probability[l * casters + s] = brightest > 0 ? brightness(light) / brightest * reach(l, s) : 0;
        }
    }

    private void prepareSun(int i) {
        Sun sun = suns[i];
        int first = (lights.length + i) * casters;
        for (int s = 0; s < casters; s++) {
            probability[first + s] = sun.max() / brightest * sun.solidAngle * Math.PI * ballRadius[s] * ballRadius[s];
        }
    }

    private double brightness(PhysicalLight light) {
        double visible = strongest(light);
        return ofUltraviolet > 0 ? Math.max(visible, ofUltraviolet * light.meanUltraviolet) : visible;
    }

    private double distance(PhysicalLight light, int s) {
        return new Vec3(ballX[s] - light.ballX, ballY[s] - light.ballY, ballZ[s] - light.ballZ).length();
    }

    /** Roughly the power that a light of radiance 1 sends to a caster: the projected area of the light times the caster's solid angle. */
    private double reach(int l, int s) {
        PhysicalLight light = lights[l];
        if (!shinesOutside[l] && !shinesInside[l]) {
            return 0;
        }
        double wide = ballRadius[s] + (light.isPoint ? 0 : light.ballRadius);
        double d = distance(light, s);
        double sine = wide / d;
        double angle =
                d > wide ? 2 * Math.PI * sine * sine / (1 + Math.sqrt((d - wide) * (d + wide)) / d) : 4 * Math.PI;
        if (light.isPoint) {
            return light.profile == null ? angle : angle(light.profile, l, s, d, angle);
        }
        if (isBeam[l]) {
            return Math.PI * light.radius * light.radius * angle;
        }
        return light.form.area() * cosine(l, s, d) * Math.min(angle, Math.PI);
    }

    /**
     * Roughly the power that a point light with a profile sends to a caster: at most all of it, and 0 where its cone misses the caster's
     * ball.
     *
     * @param d the distance of the ball's centre
     * @param angle the solid angle of the ball
     */
    private double angle(IntensityProfile profile, int l, int s, double d, double angle) {
        double r = ballRadius[s];
        if (d > r) {
            Vec3 way = new Vec3(ballX[s] - lights[l].ballX, ballY[s] - lights[l].ballY, ballZ[s] - lights[l].ballZ)
                    .normalized();
            Vec3 axis = profile.axis();
            double between = 2
                    * StrictMath.atan2(way.minus(axis).length(), way.plus(axis).length());
            double ofBall = StrictMath.atan2(r, Math.sqrt((d - r) * (d + r)));
            if (between > (profile.coneAngle() + ofBall) * (1 + Scale.gamma(64))) {
                return 0;
            }
        }
        return Math.min(angle, profile.solidAngle());
    }

    /** An upper bound of the cosine at a flat light, at least {@link #LEAST_COSINE}; 0 where the caster is behind it. */
    private double cosine(int l, int s, double d) {
        PhysicalLight light = lights[l];
        Vec3 n = light.form.flatNormal();
        double height =
                n.x() * (ballX[s] - light.ballX) + n.y() * (ballY[s] - light.ballY) + n.z() * (ballZ[s] - light.ballZ);
        boolean isFlat = n.maxAbs() > 0;
        double front = shinesBothWays(l) || !isFlat ? Math.abs(height) : height;
        if (isFlat && front < -ballRadius[s]) {
            return 0;
        }
        return isFlat ? Math.min(Math.max((front + ballRadius[s]) / d, LEAST_COSINE), 1) : 1;
    }

    /** Whether a light is small, so that narrow lobes count as casters of its caustics; suns follow the last light. */
    public boolean takesNarrow(int light) {
        return light < isSmall.length && isSmall[light];
    }

    /** Whether any light is small. */
    public boolean takesNarrow() {
        return takesNarrow;
    }

    /** Whether light of small lights that this BSDF reflects is sampled by the pass. */
    public boolean takesNarrow(Bsdf bsdf) {
        return takesNarrow && bsdf.isNarrow();
    }

    /** Samples a pair by a number in 0..1: {@code light · casters + caster}. */
    public int choose(double number) {
        int at = Arrays.binarySearch(cumulative, number);
        int pair = at < 0 ? -at - 1 : at + 1;
        while (pair < cumulative.length && probability[pair] == 0) {
            pair++;
        }
        return pair < cumulative.length ? pair : last();
    }

    private int last() {
        int pair = cumulative.length - 1;
        while (probability[pair] == 0) {
            pair--;
        }
        return pair;
    }

    /** Whether a light is a ball apart from all casters: then its rays are sampled by direction first. */
    public boolean isBeam(int light) {
        return isBeam[light];
    }

    /** Whether a light with extent sends light to casters from both sides of its surface. */
    public boolean shinesBothWays(int light) {
        return shinesOutside[light] && shinesInside[light];
    }

    /** Whether a light with extent sends light to casters from its inside only. */
    public boolean shinesInwards(int light) {
        return !shinesOutside[light];
    }

    /** The ids of solids of glass that points of the light may lie in. */
    public int[] mediaAround(int light) {
        return light >= lights.length ? NO_MEDIA : lights[light].mediaAround();
    }

    /** Mean radiance in the strongest band; of a point light radiant intensity. */
    private static double strongest(PhysicalLight light) {
        return Math.max(light.meanR, Math.max(light.meanG, light.meanB));
    }
}
