package enlightenment.transport.state;

import enlightenment.bsdf.Reradiation;

/**
 * The throughput β of a path or a subpath, from the eye or from a light: the product of the weights of its events, by band. Bands of a path
 * with a single wavelength may be negative. Mutable, one per thread.
 */
public final class Throughput {
    public double red;
    public double green;
    public double blue;

    /** The throughput of ultraviolet, which surfaces reflect, and glass transmits, as blue. */
    public double ultraviolet;

    private final double[] bands = new double[Reradiation.BANDS];

    /** Sets red, green, blue and ultraviolet. */
    public void begin(double r, double g, double b, double u) {
        red = r;
        green = g;
        blue = b;
        ultraviolet = u;
    }

    /** Multiplies by the weight of an event; ultraviolet takes that of blue. */
    public void filter(double r, double g, double b) {
        red *= r;
        green *= g;
        blue *= b;
        ultraviolet *= b;
    }

    /** Multiplies all bands by a factor. */
    public void scale(double factor) {
        filter(factor, factor, factor);
    }

    /** The largest absolute value of the visible bands. */
    public double most() {
        return Math.max(Math.abs(red), Math.max(Math.abs(green), Math.abs(blue)));
    }

    /** The sum of the absolute values of the visible bands. */
    public double sum() {
        return Math.abs(red) + Math.abs(green) + Math.abs(blue);
    }

    /** Whether any band, ultraviolet included, is positive. */
    public boolean isLit() {
        return red > 0 || green > 0 || blue > 0 || ultraviolet > 0;
    }

    /**
     * Multiplies by the reradiation of a fluorescent surface, in the direction of light: from bands that it absorbs to bands that it emits.
     *
     * @param color its reflectance by band
     */
    public void reradiate(Reradiation by, double[] color) {
        bands[0] = red;
        bands[1] = green;
        bands[2] = blue;
        bands[Reradiation.ULTRAVIOLET] = ultraviolet;
        by.scatter(color, bands);
        begin(bands[0], bands[1], bands[2], bands[Reradiation.ULTRAVIOLET]);
    }
}
