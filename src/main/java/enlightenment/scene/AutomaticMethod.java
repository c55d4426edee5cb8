package enlightenment.scene;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The choice of a method by the program. It renders nothing itself: before a render is planned, one of {@link BuiltInMethod} takes
 * its place, so that plans, reports, checkpoints and workers see that one.
 */
enum AutomaticMethod implements Method {
    /** {@link Method#AUTO}. */
    AUTO;

    @Override
    public String word() {
        return "auto";
    }

    @Override
    public String description() {
        return "the program chooses: small pictures by each method show which has the least error for its cost";
    }

    @Override
    public Kind kind() {
        return Kind.TILES;
    }

    @Override
    public Set<Shading.Model> shadings() {
        return Set.of(Shading.Model.values());
    }

    /** True: what a method cannot render is not chosen. */
    @Override
    public boolean canRender(Shading.LightFeature feature) {
        return true;
    }

    /** The settings of all methods that may be chosen. */
    @Override
    public List<Method.Setting> settings() {
        return Method.settings(BuiltInMethod.ALL).stream()
                .filter(setting -> !ChosenSettings.Common.has(setting.key()))
                .toList();
    }

    @Override
    public Optional<Method> standIn() {
        return Optional.empty();
    }

    @Override
    public boolean hasClusters() {
        return false;
    }

    /** The {@link #word}. */
    @Override
    public String toString() {
        return word();
    }
}
