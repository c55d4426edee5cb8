package enlightenment.scene;

import enlightenment.check.Check;
import java.util.Objects;

/**
 * The settings that a scene asks to be rendered with, unless the user says otherwise.
 *
 * @param method which samples are taken, {@link Method#RAYTRACE} unless given
 * @param antialias n for n × n positions per pixel, 1..256
 * @param shadowSamples light samples per hit and light, 1..1,000,000
 * @param seed what all random numbers are derived from
 */
public record RenderDefaults(Method method, int antialias, int shadowSamples, long seed) {
    /** The largest n for n × n positions per pixel. */
    public static final int MAX_ANTIALIAS = 256;

    /** The largest number of light samples per hit and light. */
    public static final int MAX_SHADOW_SAMPLES = 1_000_000;

    /** What a scene asks for that says nothing. */
    public static final RenderDefaults DEFAULT = new RenderDefaults(Method.RAYTRACE, 4, 10, 0);

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
        Check.that(
                shadowSamples >= 1 && shadowSamples <= MAX_SHADOW_SAMPLES,
                "shadowSamples",
                "must lie in 1.." + MAX_SHADOW_SAMPLES + ", not " + shadowSamples);
    }
}
