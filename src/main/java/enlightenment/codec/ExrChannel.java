package enlightenment.codec;

import enlightenment.check.Check;
import java.util.List;

/**
 * A channel of an OpenEXR picture that is to be written.
 *
 * @param name printable ASCII characters, 1..{@value #LONGEST_NAME}; channels of a layer are called {@code layer.X}
 * @param isHalf whether numbers are rounded to 16 bits; otherwise they are floats
 */
public record ExrChannel(String name, boolean isHalf) {
    /** Longer names would need a flag that older readers do not know. */
    public static final int LONGEST_NAME = 31;

    public ExrChannel {
        Check.that(
                isName(name),
                "name",
                "must be 1 to " + LONGEST_NAME + " printable ASCII characters without spaces, not \"" + name + "\"");
    }

    static boolean isName(String name) {
        return !name.isEmpty() && name.length() <= LONGEST_NAME && name.chars().allMatch(c -> c > ' ' && c < 127);
    }

    /** Red, green and blue. */
    public static List<ExrChannel> rgb(boolean isHalf) {
        return List.of(new ExrChannel("R", isHalf), new ExrChannel("G", isHalf), new ExrChannel("B", isHalf));
    }

    ExrType type() {
        return isHalf ? ExrType.HALF : ExrType.FLOAT;
    }
}
