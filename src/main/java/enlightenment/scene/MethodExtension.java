package enlightenment.scene;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A rendering method that is no part of this program, found as a service ({@link java.util.ServiceLoader}). Scene files, command line and network
 * know it without any change here. Its word must differ from those of all others. A key of its settings may be that of another method's, if the
 * setting is equal in everything: a scene then says it once for both.
 *
 * <p>Stateless: its methods are called by several threads at once.
 */
public abstract non-sealed class MethodExtension implements Method {
    private final String word;
    private final String description;
    private final Kind kind;
    private final Set<Shading.Model> shadings;
    private final List<Method.Setting> settings;

    /**
     * Says what the method is.
     *
     * @param word as {@link Method#word}
     * @param description as {@link Method#description}
     * @param kind as {@link Method#kind}
     * @param shadings as {@link Method#shadings}
     * @param settings as {@link Method#settings}
     * @throws IllegalArgumentException if the word is none, nothing can be rendered, or a setting is called as one of
     *     {@link ChosenSettings.Common}
     */
    protected MethodExtension(
            String word, String description, Kind kind, Set<Shading.Model> shadings, List<Method.Setting> settings) {
        if (!word.matches("[a-z][a-z0-9-]*") || shadings.isEmpty()) {
            throw new IllegalArgumentException("a method needs a word of small letters, digits and hyphens, not \""
                    + word + "\", and a shading that it can render");
        }
        this.word = word;
        this.description = Objects.requireNonNull(description, "description");
        this.kind = Objects.requireNonNull(kind, "kind");
        this.shadings = Set.copyOf(shadings);
        this.settings = List.copyOf(settings);
        for (Method.Setting setting : settings) {
            if (ChosenSettings.Common.has(setting.key())) {
                throw new IllegalArgumentException("all methods have the setting " + setting.key());
            }
        }
    }

    @Override
    public final String word() {
        return word;
    }

    @Override
    public final String description() {
        return description;
    }

    @Override
    public final Kind kind() {
        return kind;
    }

    @Override
    public final Set<Shading.Model> shadings() {
        return shadings;
    }

    /** False, unless a subclass says otherwise: what follows light has to know what light may do. */
    @Override
    public boolean canRender(Shading.LightFeature feature) {
        return false;
    }

    @Override
    public final List<Method.Setting> settings() {
        return settings;
    }

    /** Empty: nothing is known here of surveys by others. */
    @Override
    public final Optional<Method> standIn() {
        return Optional.empty();
    }

    /** False: nothing is known here of clusters of others. */
    @Override
    public final boolean hasClusters() {
        return false;
    }

    /** The {@link #word}. */
    @Override
    public final String toString() {
        return word;
    }
}
