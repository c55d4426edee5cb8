package enlightenment.plan;

import enlightenment.scene.RenderSettings;

/** Numbers of samples per pixel as they are planned: possible ones, short enough to be read from a log and given again. */
final class Tidy {
    private static final double FEWEST_DIGITS = 100;
    private static final double TOO_MANY_DIGITS = 1000;

    private Tidy() {}

    /** The number with three digits that is nearest to this one, within what a budget may be; 1 for what is no number. */
    static double of(double samples) {
        // In this order NaN becomes 1.
        double possible = samples > 1 ? Math.min(samples, RenderSettings.Budget.MAX_SAMPLES) : 1;
        double unit = 1;
        while (possible / unit >= TOO_MANY_DIGITS) {
            unit *= 10;
        }
        double parts = 1;
        while (possible * parts < FEWEST_DIGITS) {
            parts *= 10;
        }
        // Powers of ten below one are not exact: their inverse is.
        return Math.min(Math.rint(possible / unit * parts) * unit / parts, RenderSettings.Budget.MAX_SAMPLES);
    }
}
