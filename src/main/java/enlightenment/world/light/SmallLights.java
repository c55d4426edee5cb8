package enlightenment.world.light;

import enlightenment.surroundings.Sun;
import java.util.Arrays;

/**
 * Which lights are so small, as surfaces with narrow lobes see them, that paths from the eye seldom find what these make of them: those
 * caustics are the business of paths from these lights. Others are found from the eye, with less noise.
 */
final class SmallLights {
    /** Steradians, a 63rd of a hemisphere. Fitted (docs/notes/caustics.md): beyond it paths from the light bring little or nothing. */
    private static final double SMALL = 0.1;

    private SmallLights() {}

    /**
     * Which they are, by light, then by sun: all suns are small, or none, since next-event estimation leaves out all or none.
     *
     * @param narrow what has narrow lobes
     */
    static boolean[] of(PhysicalLight[] lights, Sun[] suns, SpecularThings narrow) {
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

    private static boolean isSmall(PhysicalLight light, SpecularThings narrow, int s) {
        double x = narrow.x[s] - light.ballX;
        double y = narrow.y[s] - light.ballY;
        double z = narrow.z[s] - light.ballZ;
        double radius = light.isPoint ? 0 : light.ballRadius;
        return Math.PI * radius * radius < SMALL * (x * x + y * y + z * z);
    }

    static boolean areThere(boolean[] small) {
        for (boolean isSmall : small) {
            if (isSmall) {
                return true;
            }
        }
        return false;
    }
}
