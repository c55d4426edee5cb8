package enlightenment.scene;

import enlightenment.check.Check;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The methods of rendering: which samples are taken, and how they become pixels. This is the one list of them; the scene
 * format, the command line, reports, protocols and measurements take names, descriptions and settings from here.
 */
public enum Method {
    /** Evenly spaced camera rays, the same number of light samples at every hit. */
    RAYTRACE(
            "raytrace",
            "evenly spaced camera rays, a fixed number of light samples at every hit",
            Setting.SHADOW_SAMPLES),

    /** The paper's ray clusters: a survey allots samples to pixels and learns which light points to propose. */
    CLUSTER(
            "cluster",
            "a survey of the picture allots camera rays and light samples, and ray clusters propose light points",
            Setting.PROPOSAL);

    /** A setting that only some methods look at. */
    public enum Setting {
        /** {@link RenderSettings#shadowSamples}: light samples per hit and light. Other methods choose their number. */
        SHADOW_SAMPLES,

        /** {@link RenderSettings#proposal}: the family of distributions that light points are proposed from. */
        PROPOSAL
    }

    private final String word;
    private final String description;
    private final Set<Setting> settings;

    Method(String word, String description, Setting setting) {
        this.word = word;
        this.description = description;
        settings = Collections.unmodifiableSet(EnumSet.of(setting));
    }

    /** The name in scene files, on the command line and in reports. */
    public String word() {
        return word;
    }

    /** What it does, in one line without a full stop. */
    public String description() {
        return description;
    }

    /** Those of the settings which only some methods look at that have an influence on this one's pictures. */
    public Set<Setting> settings() {
        return settings;
    }

    /** Whether a setting has an influence on this method's pictures. */
    public boolean has(Setting setting) {
        return settings.contains(setting);
    }

    /** The names of all methods, in order. */
    public static List<String> words() {
        return Arrays.stream(values()).map(Method::word).toList();
    }

    /** The method with this name; empty if there is none. */
    public static Optional<Method> of(String word) {
        return Arrays.stream(values()).filter(m -> m.word.equals(word)).findFirst();
    }

    /**
     * The method with this name.
     *
     * @throws enlightenment.math.InvalidValueException if there is none
     */
    public static Method named(String word) {
        Optional<Method> method = of(word);
        Check.that(method.isPresent(), "method", "must be one of " + words() + ", not \"" + word + "\"");
        return method.orElseThrow();
    }

    /** The {@link #word}. */
    @Override
    public String toString() {
        return word;
    }
}
