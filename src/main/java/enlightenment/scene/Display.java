package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.color.DisplayCurve;
import java.util.Objects;

/**
 * How the linear light of physical shading becomes a picture for a screen: light times 2^exposure goes through the tone curve, then
 * through sRGB's transfer curve. Files of linear light do not ask for it, and classic shading, whose colours are those of a
 * screen, has no use for it.
 *
 * @param exposure in stops, -{@link #MAX_EXPOSURE}..{@link #MAX_EXPOSURE}: one more doubles the light
 * @param tone how light becomes 0..1
 */
public record Display(double exposure, DisplayCurve.Tone tone) {
    /** The largest exposure, and with a minus the smallest one. */
    public static final double MAX_EXPOSURE = 1000;

    /** No change of exposure, light cut at 1. */
    public static final Display DEFAULT = new Display(0, DisplayCurve.Tone.CLIP);

    /**
     * Checks the range.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code exposure}) if the exposure is out of it
     */
    public Display {
        Check.range("exposure", exposure, -MAX_EXPOSURE, MAX_EXPOSURE);
        Objects.requireNonNull(tone, "tone");
    }
}
