package enlightenment.scene;

/**
 * The settings of {@link Method#METROPOLIS}.
 *
 * @param largeSteps how many of a hundred proposals of a chain are new paths altogether, 1..100
 * @param mutations proposals of each chain, 1..1,000,000
 */
public record MetropolisSettings(int largeSteps, int mutations) implements MethodSettings {
    /** Side, in pixels, of the blocks of the picture that chains live in. */
    public static final int BLOCK_SIDE = 64;

    /** {@link #largeSteps}. */
    public static final MethodSetting.Whole LARGE_STEPS =
            new MethodSetting.Whole("largeSteps", 1, 100, 5, "new paths among a hundred proposals of a chain");

    /** {@link #mutations}. */
    public static final MethodSetting.Whole MUTATIONS =
            new MethodSetting.Whole("mutations", 1, 1_000_000, 250, "proposals of a chain");

    /**
     * Checks the ranges.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code largeSteps} or {@code mutations}) if a number is out of its own
     */
    public MetropolisSettings {
        LARGE_STEPS.checked(largeSteps);
        MUTATIONS.checked(mutations);
    }

    /** What was chosen. */
    public static MetropolisSettings of(RenderSettings settings) {
        ChosenSettings chosen = settings.chosen();
        return new MetropolisSettings(chosen.whole(LARGE_STEPS), chosen.whole(MUTATIONS));
    }

    /** How many blocks a render has: those of the whole picture that the part that is rendered has pixels in. */
    public static long blocks(RenderSettings settings) {
        RenderSettings.Crop c = settings.region();
        long across = (c.x() + c.width() - 1) / BLOCK_SIDE - c.x() / BLOCK_SIDE + 1;
        long down = (c.y() + c.height() - 1) / BLOCK_SIDE - c.y() / BLOCK_SIDE + 1;
        return across * down;
    }

    @Override
    public Method method() {
        return Method.METROPOLIS;
    }

    @Override
    public Object value(MethodSetting setting) {
        return setting == LARGE_STEPS ? largeSteps : mutations;
    }
}
