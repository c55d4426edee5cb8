package enlightenment.scene;

import enlightenment.check.Check;
import java.util.Objects;

/**
 * The settings that a scene asks to be rendered with, unless the user says otherwise.
 *
 * @param method which samples are taken, {@link Method#RAYTRACE} unless given
 * @param antialias n for n × n positions per pixel, 1..256
 * @param chosen what the scene says of all other settings; not only of those of its own method
 */
public record RenderDefaults(Method method, int antialias, ChosenSettings chosen) {
    /** The largest n for n × n positions per pixel. */
    public static final int MAX_ANTIALIAS = 256;

    /** What a scene asks for that says nothing. */
    public static final RenderDefaults DEFAULT = new RenderDefaults(Method.RAYTRACE, 4, ChosenSettings.NONE);

    /**
     * Checks the ranges.
     *
     * @throws enlightenment.math.InvalidValueException if a number is out of its range
     */
    public RenderDefaults {
        Objects.requireNonNull(method, "method");
        Check.that(
                antialias >= 1 && antialias <= MAX_ANTIALIAS,
                "antialias",
                "must lie in 1.." + MAX_ANTIALIAS + ", not " + antialias);
        Objects.requireNonNull(chosen, "chosen");
    }
}
