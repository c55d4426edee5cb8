package enlightenment.transport.state;

import enlightenment.world.light.PhysicalLight;

/**
 * What arrives from lights at a vertex of a path, and how much of it is no matter of chance. Mutable, one per thread.
 */
public final class GatheredLight {
    private final boolean hasUltraviolet;

    /** All of it. */
    public double red;

    public double green;
    public double blue;

    /** The same of ultraviolet, which surfaces reflect as blue; 0 if nothing in the scene shows it. */
    public double ultraviolet;

    /** The part that no random number has a part in. */
    double certainRed;

    double certainGreen;
    double certainBlue;
    double certainUltraviolet;

    /** What is known of the lights: a digit to base three for each, hidden, in full view, or a matter of chance. */
    public long views;

    /** @param hasUltraviolet whether anything in the scene gives and shows ultraviolet */
    public GatheredLight(boolean hasUltraviolet) {
        this.hasUltraviolet = hasUltraviolet;
    }

    /** Forgets everything. */
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

    /** Makes it this much light, of which nothing is known. */
    public void set(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
    }

    /** Adds light. */
    public void add(double r, double g, double b) {
        red += r;
        green += g;
        blue += b;
    }

    /** Adds light: the radiance or intensity of a source, times these; of ultraviolet as much as of blue. */
    public void add(PhysicalLight l, double r, double g, double b) {
        red = Math.fma(r, l.r, red);
        green = Math.fma(g, l.g, green);
        blue = Math.fma(b, l.b, blue);
        if (hasUltraviolet) {
            ultraviolet = Math.fma(b, l.ultraviolet, ultraviolet);
        }
    }

    /** Says that so much of a light's radiance or intensity, which was added, is certain. */
    public void addCertain(PhysicalLight l, double factor) {
        certainRed = Math.fma(factor, l.r, certainRed);
        certainGreen = Math.fma(factor, l.g, certainGreen);
        certainBlue = Math.fma(factor, l.b, certainBlue);
        certainUltraviolet = Math.fma(factor, l.ultraviolet, certainUltraviolet);
    }

    /** Notes what is known of the next light: whether a random number has a part in what it gave, and whether it gave anything. */
    public void note(boolean isByChance, boolean isSeen) {
        views = 3 * views + (isByChance ? 2 : isSeen ? 1 : 0);
    }
}
