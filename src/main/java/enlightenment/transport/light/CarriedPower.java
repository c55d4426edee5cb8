package enlightenment.transport.light;

import enlightenment.bsdf.Reradiation;
import enlightenment.transport.ray.PathSource;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.Throughput;
import java.util.Arrays;

/**
 * The power that a light path carries from event to event, with ultraviolet weighed by its visible effect. A mutable work object, one per
 * thread.
 */
final class CarriedPower {
    /** The power by band: the path's throughput. */
    final Throughput left = new Throughput();

    /** Roughly the visible light that fluorescent surfaces make of a unit of ultraviolet; 0 if the scene has none. */
    private final double ofUltraviolet;

    /** The power below which Russian roulette is due, in the strongest band. */
    private double faint;

    /**
     * @param ofUltraviolet roughly the visible light that fluorescent surfaces make of a unit of ultraviolet; 0 if the scene has none
     */
    CarriedPower(double ofUltraviolet) {
        this.ofUltraviolet = ofUltraviolet;
    }

    /** Begins a path with the power of a source. */
    void begin(PathSource source) {
        left.begin(source.red, source.green, source.blue, source.ultraviolet);
        faint = PathValue.FAINT * most();
    }

    /** The power summed over bands, ultraviolet weighed. */
    double sum() {
        return left.sum() + ofUltraviolet * Math.abs(left.ultraviolet);
    }

    /** The power of blue plus weighed ultraviolet. */
    double blueAndBeyond() {
        return left.blue + ofUltraviolet * left.ultraviolet;
    }

    /** The power of the strongest band, ultraviolet weighed. */
    double most() {
        double most = left.most();
        return ofUltraviolet > 0 ? Math.max(most, ofUltraviolet * left.ultraviolet) : most;
    }

    /** Whether power has fallen so far below its initial value that Russian roulette is due. */
    boolean isFaint() {
        return !(most() >= faint);
    }

    /**
     * Scatters the path at a fluorescent surface; the path goes on as at a grey one.
     *
     * @param surface its reflectance by band; receives the grey reflectance
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
