package enlightenment.color;

import enlightenment.check.Check;

/**
 * A display-referred colour: sRGB-encoded components, 0 (none) to 1 (as bright as the screen gets).
 *
 * <p>Classic shading works on these directly, as the paper does; nothing is decoded, so no gamma is applied twice.
 *
 * @param r red, encoded
 * @param g green, encoded
 * @param b blue, encoded
 */
public record DisplayRgb(double r, double g, double b) {
    public static final DisplayRgb BLACK = new DisplayRgb(0, 0, 0);
    public static final DisplayRgb WHITE = new DisplayRgb(1, 1, 1);

    public DisplayRgb {
        Check.range("r", r, 0, 1);
        Check.range("g", g, 0, 1);
        Check.range("b", b, 0, 1);
    }

    public static DisplayRgb of(double r, double g, double b) {
        return new DisplayRgb(r, g, b);
    }

    /** The colour with these 8-bit components, 0..255 each. */
    public static DisplayRgb ofBytes(int r, int g, int b) {
        return new DisplayRgb(r / 255.0, g / 255.0, b / 255.0);
    }
}
