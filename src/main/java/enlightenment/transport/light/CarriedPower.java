package enlightenment.transport.light;

import enlightenment.bsdf.Reradiation;
import enlightenment.transport.ray.PathSource;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.Throughput;
import java.util.Arrays;

/** How much the power counts that a path from a light carries from event to event. A mutable work object, one per thread. */
final class CarriedPower {
    /** The power itself. */
    final Throughput left = new Throughput();

    /** About how much visible light fluorescent surfaces make of ultraviolet; 0 if there is none. */
    private final double ofUltraviolet;

    /** What is faint. */
    private double faint;

    /** @param ofUltraviolet about how much visible light fluorescent surfaces make of ultraviolet; 0 if there is none */
    CarriedPower(double ofUltraviolet) {
        this.ofUltraviolet = ofUltraviolet;
    }

    /** A path begins at a source. */
    void begin(PathSource source) {
        left.begin(source.red, source.green, source.blue, source.ultraviolet);
        faint = PathValue.FAINT * most();
    }

    /** What counts of it, summed over bands. */
    double sum() {
        return left.sum() + ofUltraviolet * Math.abs(left.ultraviolet);
    }

    /** What counts of it in the blue band and beyond. */
    double blueAndBeyond() {
        return left.blue + ofUltraviolet * left.ultraviolet;
    }

    /** What counts of it, of the strongest band. */
    double most() {
        double most = left.most();
        return ofUltraviolet > 0 ? Math.max(most, ofUltraviolet * left.ultraviolet) : most;
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
        left.reradiate(by, surface);
        double after = most();
        double scale = after < before ? before / after : 1;
        if (!(after > 0) || !(scale < Double.POSITIVE_INFINITY)) {
            return false;
        }
        left.scale(scale);
        Arrays.fill(surface, 1 / scale);
        return true;
    }
}
