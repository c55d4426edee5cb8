package enlightenment.color;

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
        if (!(r >= 0 && r <= 1 && g >= 0 && g <= 1 && b >= 0 && b <= 1)) {
            throw new IllegalArgumentException(
                    "colour components must lie in 0..1, not (" + r + ", " + g + ", " + b + ")");
        }
    }

    public static DisplayRgb of(double r, double g, double b) {
        return new DisplayRgb(r, g, b);
    }

    /** The colour with these 8-bit components, 0..255 each. */
    public static DisplayRgb ofBytes(int r, int g, int b) {
        return new DisplayRgb(r / 255.0, g / 255.0, b / 255.0);
    }
}
