package enlightenment.render;

import enlightenment.scene.RenderSettings;
import enlightenment.work.Phases;
import enlightenment.work.Stopwatch;
import enlightenment.world.CompiledScene;
import java.util.Optional;

/**
 * The method of a render, chosen by the program where the settings leave that to it ({@link enlightenment.scene.Method#AUTO}): what
 * {@link Renderer#choose} gives. A render that is requested with it ({@link RenderRequest#withChoice}) neither chooses nor prepares the
 * scene again. Immutable; keeps the scene in memory.
 */
public final class MethodChoice {
    private final RenderSettings settings;
    private final Optional<String> reason;
    private final CompiledScene compiled;
    private final Phases phases;
    private final Stopwatch time;

    /**
     * @param compiled the scene, or null if it was not needed
     * @param phases what was done so far
     * @param time since the choice began
     */
    MethodChoice(
            RenderSettings settings, Optional<String> reason, CompiledScene compiled, Phases phases, Stopwatch time) {
        this.settings = settings;
        this.reason = reason;
        this.compiled = compiled;
        this.phases = phases;
        this.time = time;
    }

    /** The settings with a method that renders. */
    public RenderSettings settings() {
        return settings;
    }

    /** Why that method, as a sentence without a full stop; empty if the settings named it. */
    public Optional<String> reason() {
        return reason;
    }

    /**
     * This choice for another render of its scene, which is not prepared again. Its time is counted from now.
     *
     * @param other settings that differ in samples, seed, threads and crop alone; their method is not looked at
     * @throws IllegalArgumentException if their size is another one
     */
    public MethodChoice with(RenderSettings other) {
        if (other.width() != settings.width() || other.height() != settings.height()) {
            throw new IllegalArgumentException("prepared for " + settings.width() + "x" + settings.height()
                    + " pixels, not for " + other.width() + "x" + other.height());
        }
        RenderSettings chosen = other.method() == settings.method() ? other : other.withMethod(settings.method());
        return new MethodChoice(chosen, Optional.empty(), compiled, new Phases(), Stopwatch.started());
    }

    Optional<CompiledScene> compiled() {
        return Optional.ofNullable(compiled);
    }

    Phases phases() {
        return phases.copy();
    }

    Stopwatch time() {
        return time;
    }
}
