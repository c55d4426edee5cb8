package enlightenment.scene;

/**
 * The settings of {@link Method#RAYTRACE}.
 *
 * @param shadowSamples light samples per hit and light, 1..1,000,000
 */
public record RayTraceSettings(int shadowSamples) implements MethodSettings {
    /** {@link #shadowSamples}, 10 unless chosen. Methods that do not have it choose their number. */
    public static final MethodSetting.Whole SHADOW_SAMPLES =
            new MethodSetting.Whole("shadowSamples", 1, 1_000_000, 10, "light samples per hit and light");

    /**
     * Checks the range.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code shadowSamples}) if the number is out of it
     */
    public RayTraceSettings {
        SHADOW_SAMPLES.checked(shadowSamples);
    }

    /** What was chosen. */
    public static RayTraceSettings of(RenderSettings settings) {
        return new RayTraceSettings(settings.chosen().whole(SHADOW_SAMPLES));
    }

    @Override
    public Method method() {
        return Method.RAYTRACE;
    }

    @Override
    public Object value(MethodSetting setting) {
        return shadowSamples;
    }
}
