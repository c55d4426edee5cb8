package enlightenment.shading;

/**
 * What the last path of a {@link PathTracer} consists of: linear, by band. The first vertex is the first surface that scatters other than
 * into single directions, seen straight or by way of mirrors and glass.
 */
public final class PathParts {
    /** The share of light that the surface at the first vertex reflects, its colour; 0 if there is none. */
    public double albedoR;

    public double albedoG;
    public double albedoB;

    /** What the path saw of things that glow, and light that came to the first vertex straight from lights. */
    public double directR;

    public double directG;
    public double directB;

    PathParts() {}

    void clear() {
        albedoR = 0;
        albedoG = 0;
        albedoB = 0;
        directR = 0;
        directG = 0;
        directB = 0;
    }

    void albedo(double[] rgb) {
        albedoR = rgb[0];
        albedoG = rgb[1];
        albedoB = rgb[2];
    }

    void direct(double r, double g, double b) {
        directR = r;
        directG = g;
        directB = b;
    }
}
