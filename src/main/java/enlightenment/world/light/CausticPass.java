package enlightenment.world.light;

import enlightenment.emitter.IntensityProfile;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.surroundings.Sun;
import enlightenment.world.parts.CompiledPrimitives;
import enlightenment.world.parts.SceneBall;
import java.util.Arrays;

/**
 * What paths from lights start with that look for caustics: light that mirrors or smooth glass send to other surfaces. Those paths make
 * all of it that reaches the eye straight from such a surface, and paths from the eye leave it out. Of small lights the same holds for what
 * rough surfaces with narrow lobes send to surfaces with wide ones. Immutable.
 *
 * <p>A path begins with a pair of a light and a specular thing, which is chosen by an estimate of the power that goes from the one to the
 * other.
 */
public final class CausticPass {
    /** More balls than this are not worth telling apart: each path asks for all of them. */
    private static final int MOST_THINGS = 32;

    private static final int MOST_PAIRS = 1 << 20;

    private static final int[] NO_MEDIA = {};

    /** Of flat lights that a thing is seen from at an angle, the least cosine that is reckoned with. */
    private static final double LEAST_COSINE = 0.05;

    /** The least scattering events of a caustic: one at a mirror, one where it is seen. */
    private static final int LEAST_BOUNCES = 2;

    /** The lights. */
    public final PhysicalLight[] lights;

    /** The balls around the things. */
    public final double[] ballX;

    public final double[] ballY;
    public final double[] ballZ;
    public final double[] ballRadius;

    /** How many things there are. */
    public final int things;

    /** By light, then thing: the probability of the pair. */
    public final double[] probability;

    /** The sums of these. */
    private final double[] cumulative;

    private final double ofUltraviolet;

    /** The disks of suns, the lights after the last. */
    public final Sun[] suns;

    /** Centre and radius of a ball around all surfaces, which light of suns goes through. */
    public final Vec3 center;

    public final double radius;

    private double brightest;

    /** By light, then by sun: whether it is taken where a narrow lobe is the first to scatter its light. */
    private final boolean[] isSmall;

    private final boolean hasSmallLights;

    private final boolean[] isBeam;
    /** By light: whether light may come to things from its outside and from its inside. */
    private final boolean[] shinesOutside;

    private final boolean[] shinesInside;

    private CausticPass(
            PhysicalLight[] lights,
            Sun[] suns,
            double ofUltraviolet,
            SpecularThings balls,
            boolean[] isSmall,
            CompiledPrimitives compiled) {
        hasSmallLights = SmallLights.areThere(SmallLights.of(lights, suns, balls));
        this.lights = lights;
        this.isSmall = isSmall;
        this.suns = suns;
        this.ofUltraviolet = ofUltraviolet;
        SceneBall around = SceneBall.around(compiled.primitives());
        center = around.center();
        radius = around.radius();
        things = balls.count();
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
        int pairs = (n + suns.length) * things;
        probability = new double[pairs];
        cumulative = new double[pairs];
        for (int l = 0; l < n; l++) {
            prepare(l);
        }
        for (int i = 0; i < suns.length && brightest > 0; i++) {
            prepareSun(i);
        }
        for (int pair = 0; pair < probability.length; pair++) {
            if (!balls.isSharp[pair % things] && !isSmall[pair / things]) {
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
     * The pass of a scene; null if caustics need none: without mirrors and smooth glass, without lights that shine at them, and where
     * paths end before.
     *
     * @param ofUltraviolet how much of ultraviolet light is seen
     */
    public static CausticPass of(
            PhysicalLight[] lights, Sun[] suns, double ofUltraviolet, CompiledPrimitives compiled, int maxBounces) {
        int n = lights.length + suns.length;
        if (n == 0 || maxBounces < LEAST_BOUNCES) {
            return null;
        }
        int most = Math.max(Math.min(MOST_THINGS, MOST_PAIRS / n), 1);
        boolean[] isSmall = SmallLights.of(lights, suns, SpecularThings.of(compiled, most, false, true));
        SpecularThings balls = SpecularThings.of(compiled, most, true, SmallLights.areThere(isSmall));
        if (balls.count() == 0) {
            return null;
        }
        CausticPass pass = new CausticPass(lights, suns, ofUltraviolet, balls, isSmall, compiled);
        return pass.cumulative[pass.cumulative.length - 1] > 0 ? pass : null;
    }

    private void prepare(int l) {
        PhysicalLight light = lights[l];
        boolean isApart = true;
        for (int s = 0; s < things; s++) {
            isApart &= distance(light, s) > ballRadius[s] + light.ballRadius;
        }
        isBeam[l] = isApart && light.isBall;
        // What is outside of a solid is never met from its inside.
        shinesOutside[l] = light.shinesOutside;
        shinesInside[l] = light.shinesInside && !(isApart && light.surface.isSolid());
        for (int s = 0; s < things; s++) {
            probability[l * things + s] = brightest > 0 ? brightness(light) / brightest * reach(l, s) : 0;
        }
    }

    private void prepareSun(int i) {
        Sun sun = suns[i];
        int first = (lights.length + i) * things;
        for (int s = 0; s < things; s++) {
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

    /** About how much of a light of radiance 1 goes to a thing: the area seen from there times the solid angle seen from here. */
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
     * About how much of a point light with a profile goes to a thing: at most all of it, and 0 where its cone misses the ball of the thing.
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

    /** An upper bound of the cosine at a flat light, or what is taken for it; 0 where the thing is behind it. */
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

    /** Whether light is taken that a narrow lobe is the first to scatter; of suns, the lights after the last, too. */
    public boolean takesNarrow(int light) {
        return light < isSmall.length && isSmall[light];
    }

    /** Whether any is. */
    public boolean takesNarrow() {
        return SmallLights.areThere(isSmall);
    }

    /** The pair that a number chooses, 0..1: {@code light · things + thing}. */
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

    /** Whether a light is a ball apart from all things: then its rays are chosen by direction first. */
    public boolean isBeam(int light) {
        return isBeam[light];
    }

    /** Whether a light with extent shines from both sides of its surface to where things may be. */
    public boolean shinesBothWays(int light) {
        return shinesOutside[light] && shinesInside[light];
    }

    /** Whether it shines from its inside alone. */
    public boolean shinesInwards(int light) {
        return !shinesOutside[light];
    }

    /** The solids of glass that points of a light may lie in. */
    public int[] mediaAround(int light) {
        return light >= lights.length ? NO_MEDIA : lights[light].mediaAround();
    }

    /** Mean radiance, of a point radiant intensity, in the strongest band. */
    private static double strongest(PhysicalLight light) {
        return Math.max(light.meanR, Math.max(light.meanG, light.meanB));
    }
}
