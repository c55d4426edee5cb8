package enlightenment.render;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Objects;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * What is wanted of a render. Only scene and settings have an influence on the picture.
 *
 * @param scene what to render
 * @param settings how
 * @param progress hears how it gets on: called from several threads, one at a time
 * @param cancelled asked from several threads at once; once true, the render ends with what it has. An interrupt of the
 *     thread that renders is the same wish
 * @param auxiliary what to tell of each pixel beside its colour
 * @param progressive whether coarse passes over the whole picture come first, so that from then on there is always a whole
 *     picture to show; they take about a seventh more time
 * @param clusters whether to tell of the ray clusters
 */
public record RenderRequest(
        Scene scene,
        RenderSettings settings,
        RenderProgress progress,
        BooleanSupplier cancelled,
        Set<Auxiliary> auxiliary,
        boolean progressive,
        boolean clusters) {

    public RenderRequest {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(progress, "progress");
        Objects.requireNonNull(cancelled, "cancelled");
        EnumSet<Auxiliary> copy = EnumSet.noneOf(Auxiliary.class);
        copy.addAll(auxiliary);
        auxiliary = Collections.unmodifiableSet(copy);
    }

    /** Just the picture. */
    public static RenderRequest of(Scene scene, RenderSettings settings) {
        return new RenderRequest(scene, settings, RenderProgress.NONE, () -> false, Set.of(), false, false);
    }

    public RenderRequest withProgress(RenderProgress value) {
        return new RenderRequest(scene, settings, value, cancelled, auxiliary, progressive, clusters);
    }

    public RenderRequest withCancelled(BooleanSupplier value) {
        return new RenderRequest(scene, settings, progress, value, auxiliary, progressive, clusters);
    }

    public RenderRequest withAuxiliary(Set<Auxiliary> value) {
        return new RenderRequest(scene, settings, progress, cancelled, value, progressive, clusters);
    }

    public RenderRequest withClusters(boolean value) {
        return new RenderRequest(scene, settings, progress, cancelled, auxiliary, progressive, value);
    }

    public RenderRequest withProgressive(boolean value) {
        return new RenderRequest(scene, settings, progress, cancelled, auxiliary, value, clusters);
    }
}
