package enlightenment.transport.light;

import enlightenment.bsdf.Reradiation;
import enlightenment.transport.ray.PathSource;
import enlightenment.transport.state.PathValue;
import java.util.Arrays;

/** The power that a path of light carries from event to event, by band. A mutable work object, one per thread. */
final class CarriedPower {
    double red;
    double green;
    double blue;

    /** That of ultraviolet, which surfaces reflect as blue, and glass lets pass as blue. */
    private double ultraviolet;

    /** About how much visible light fluorescent surfaces make of ultraviolet; 0 if there is none. */
    private final double ofUltraviolet;

    private final double[] bands = new double[Reradiation.BANDS];

    /** What is faint. */
    private double faint;

    /** @param ofUltraviolet about how much visible light fluorescent surfaces make of ultraviolet; 0 if there is none */
    CarriedPower(double ofUltraviolet) {
        this.ofUltraviolet = ofUltraviolet;
    }

    /** A path begins at a source. */
    void begin(PathSource source) {
        red = source.red;
        green = source.green;
        blue = source.blue;
        ultraviolet = source.ultraviolet;
        faint = PathValue.FAINT * most();
    }

    void filter(double r, double g, double b) {
        red *= r;
        green *= g;
        blue *= b;
        ultraviolet *= b;
    }

    /** The path has survived what it survives with this probability. */
    void survive(double probability) {
        red /= probability;
        green /= probability;
        blue /= probability;
        ultraviolet /= probability;
    }

    /** What counts of it, summed over bands. */
    double sum() {
        return Math.abs(red) + Math.abs(green) + Math.abs(blue) + ofUltraviolet * Math.abs(ultraviolet);
    }

    /** What counts of it in the blue band and beyond. */
    double blueAndBeyond() {
        return blue + ofUltraviolet * ultraviolet;
    }

    /** What counts of it, of the strongest band. */
    double most() {
        // Bands of a single wavelength may be negative.
        double most = Math.max(Math.abs(red), Math.max(Math.abs(green), Math.abs(blue)));
        return ofUltraviolet > 0 ? Math.max(most, ofUltraviolet * ultraviolet) : most;
    }

    /** Whether it is so little beside what the path began with that roulette is due. */
    boolean isFaint() {
        return !(most() >= faint);
    }

    /**
     * A fluorescent surface changes the light; the path goes on as from a grey surface.
     *
     * @param surface the reflectance by band; becomes the grey one
     * @return whether any light is left
     */
    boolean reradiate(Reradiation by, double[] surface) {
        double before = most();
        bands[0] = red;
        bands[1] = green;
        bands[2] = blue;
        bands[Reradiation.ULTRAVIOLET] = ultraviolet;
        by.scatter(surface, bands);
        red = bands[0];
        green = bands[1];
        blue = bands[2];
        ultraviolet = bands[Reradiation.ULTRAVIOLET];
        double after = most();
        double scale = after < before ? before / after : 1;
        if (!(after > 0) || !(scale < Double.POSITIVE_INFINITY)) {
            return false;
        }
        filter(scale, scale, scale);
        Arrays.fill(surface, 1 / scale);
        return true;
    }
}
