package enlightenment.color;

import enlightenment.check.Check;
import java.util.Optional;

/**
 * A display-referred colour: sRGB-encoded components, 0 (none) to 1 (as bright as the screen gets).
 *
 * <p>Classic shading works on these directly, as the paper does: nothing is decoded or encoded again.
 *
 * @param r red, encoded, 0..1
 * @param g green, encoded, 0..1
 * @param b blue, encoded, 0..1
 */
public record DisplayRgb(double r, double g, double b) implements Color {
    /** All components 0. */
    public static final DisplayRgb BLACK = new DisplayRgb(0, 0, 0);

    /** All components 1. */
    public static final DisplayRgb WHITE = new DisplayRgb(1, 1, 1);

    /**
     * The colour with these components.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code r}, {@code g} or {@code b}) for a component outside 0..1 or NaN
     */
    public DisplayRgb {
        Check.range("r", r, 0, 1);
        Check.range("g", g, 0, 1);
        Check.range("b", b, 0, 1);
    }

    /** The colour with these components, 0..1 each; as the constructor. */
    public static DisplayRgb of(double r, double g, double b) {
        return new DisplayRgb(r, g, b);
    }

    /**
     * The colour with these 8-bit components, 0..255 each.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code r}, {@code g} or {@code b}) for a component outside 0..255
     */
    public static DisplayRgb ofBytes(int r, int g, int b) {
        return new DisplayRgb(r / 255.0, g / 255.0, b / 255.0);
    }

    /**
     * The colour of {@code #rrggbb} or {@code #rgb}, each digit of which stands for two; digits are hexadecimal, of any case.
     *
     * @return empty for any other text
     */
    public static Optional<DisplayRgb> ofHexadecimal(String text) {
        boolean isShort = text.length() == 4;
        if (!isShort && text.length() != 7 || text.charAt(0) != '#') {
            return Optional.empty();
        }
        int value = 0;
        // A loop, not a regular expression: there may be a colour for each of many lights.
        for (int i = 1; i < text.length(); i++) {
            char c = text.charAt(i);
            // Digits of other scripts are none.
            int digit = c < 128 ? Character.digit(c, 16) : -1;
            if (digit < 0) {
                return Optional.empty();
            }
            value = isShort ? value << 8 | 0x11 * digit : value << 4 | digit;
        }
        return Optional.of(ofBits(value));
    }

    /** The colour of the 24 bits 0xrrggbb. */
    public static DisplayRgb ofBits(int bits) {
        return ofBytes(bits >> 16 & 255, bits >> 8 & 255, bits & 255);
    }

    @Override
    public DisplayRgb display() {
        return this;
    }

    @Override
    public Rgb linear() {
        return Rgb.of(this);
    }
}
