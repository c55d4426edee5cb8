package enlightenment.world.light;

import enlightenment.surroundings.Sun;
import java.util.Arrays;

/**
 * Decides which lights are so small, as seen from surfaces with narrow lobes, that paths from the eye seldom find their caustics: light
 * paths sample these. Caustics of other lights are found from the eye, with less variance.
 */
final class SmallLights {
    /**
     * The largest solid angle of a small light, in steradians: a 63rd of a hemisphere. Fitted (docs/notes/caustics.md): beyond it light
     * paths help little or not at all.
     */
    private static final double SMALL = 0.1;

    private SmallLights() {}

    /**
     * By light, then by sun: whether it is small. All suns are small, or none, since next-event estimation leaves out all or none.
     *
     * @param narrow the surfaces with narrow lobes
     */
    static boolean[] of(PhysicalLight[] lights, Sun[] suns, SpecularCasters narrow) {
        boolean[] small = new boolean[lights.length + suns.length];
        for (int l = 0; l < lights.length; l++) {
            for (int s = 0; s < narrow.count(); s++) {
                small[l] |= isSmall(lights[l], narrow, s);
            }
        }
        boolean areSmall = narrow.count() > 0 && Arrays.stream(suns).allMatch(sun -> sun.solidAngle < SMALL);
        Arrays.fill(small, lights.length, small.length, areSmall);
        return small;
    }

    private static boolean isSmall(PhysicalLight light, SpecularCasters narrow, int s) {
        double x = narrow.x[s] - light.ballX;
        double y = narrow.y[s] - light.ballY;
        double z = narrow.z[s] - light.ballZ;
        double radius = light.isPoint ? 0 : light.ballRadius;
        return Math.PI * radius * radius < SMALL * (x * x + y * y + z * z);
    }

    static boolean any(boolean[] small) {
        for (boolean isSmall : small) {
            if (isSmall) {
                return true;
            }
        }
        return false;
    }
}
