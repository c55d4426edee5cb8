package enlightenment.transport.state;

import enlightenment.world.light.PhysicalLight;

/** Direct lighting at a vertex of a path, by band, and the deterministic part of it. Mutable, one per thread. */
public final class GatheredLight {
    private final boolean hasUltraviolet;

    /** Red, green and blue, with the deterministic part included. */
    public double red;

    public double green;
    public double blue;

    /** Ultraviolet, which surfaces reflect as blue; 0 if nothing in the scene shows it. */
    public double ultraviolet;

    /** The part that depends on no random number, by band; included in the sums above. */
    double certainRed;

    double certainGreen;
    double certainBlue;
    double certainUltraviolet;

    /** What was noted of the lights, a digit to base three each: 0 for hidden, 1 for visible without a random number, 2 for random. */
    public long views;

    /** @param hasUltraviolet whether anything in the scene gives and shows ultraviolet */
    public GatheredLight(boolean hasUltraviolet) {
        this.hasUltraviolet = hasUltraviolet;
    }

    /** Begins a new vertex: nothing arrives, no light was noted. */
    public void clear() {
        red = 0;
        green = 0;
        blue = 0;
        certainRed = 0;
        certainGreen = 0;
        certainBlue = 0;
        ultraviolet = 0;
        certainUltraviolet = 0;
        views = 0;
    }

    /** Sets the light, without a deterministic part. */
    public void set(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
    }

    /** Adds light in the visible bands. */
    public void add(double r, double g, double b) {
        red += r;
        green += g;
        blue += b;
    }

    /** Adds the radiance or intensity of a source times a factor for each band; ultraviolet takes the factor of blue. */
    public void add(PhysicalLight l, double r, double g, double b) {
        red = Math.fma(r, l.r, red);
        green = Math.fma(g, l.g, green);
        blue = Math.fma(b, l.b, blue);
        if (hasUltraviolet) {
            ultraviolet = Math.fma(b, l.ultraviolet, ultraviolet);
        }
    }

    /** Declares this multiple of a light's radiance or intensity, which was added before, to be deterministic. */
    public void addCertain(PhysicalLight l, double factor) {
        certainRed = Math.fma(factor, l.r, certainRed);
        certainGreen = Math.fma(factor, l.g, certainGreen);
        certainBlue = Math.fma(factor, l.b, certainBlue);
        certainUltraviolet = Math.fma(factor, l.ultraviolet, certainUltraviolet);
    }

    /**
     * Appends a light to {@link #views}.
     *
     * @param isByChance whether its contribution depends on a random number
     * @param isSeen whether it contributed anything
     */
    public void note(boolean isByChance, boolean isSeen) {
        views = 3 * views + (isByChance ? 2 : isSeen ? 1 : 0);
    }
}
