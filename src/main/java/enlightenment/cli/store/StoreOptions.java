package enlightenment.cli.store;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.picture.PictureText;
import enlightenment.cli.setting.SettingsLine;
import enlightenment.cli.terminal.Terminal;
import enlightenment.job.Build;
import enlightenment.job.RenderIdentity;
import enlightenment.job.SceneDocument;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneWriter;
import enlightenment.store.RenderRow;
import enlightenment.store.StoreArchive;
import enlightenment.store.StoreException;
import enlightenment.store.StoredSamples;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options that say in which store a render is kept. */
public final class StoreOptions {
    @Option(
            names = "--store",
            paramLabel = "STORE",
            description =
                    "keep what is done in this store, and go on from it: a SQLite file, or the JDBC URL of a database")
    private String store;

    @Mixin
    private StoreAccess access = new StoreAccess();

    public StoreOptions() {}

    /** Fails if the store's name is none. */
    public void check() {
        if (store != null) {
            StoreAccess.address(store);
        }
    }

    /** Adds the files that are read and written. */
    public void register(CommandFiles files) throws IOException {
        if (store != null) {
            access.register(files);
            StoreAccess.writes(StoreAccess.address(store), files);
        }
    }

    /**
     * Opens the store, if there is to be one. A disk that is full already costs the store, not the picture, as one that becomes full does.
     *
     * @param frame the frame that was asked for, or null
     */
    public Optional<RenderResult.Archive> open(
            Scene scene, RenderSettings settings, Integer frame, StoredSamples samples, Terminal terminal)
            throws IOException {
        if (store == null) {
            return Optional.empty();
        }
        SceneDocument document = SceneDocument.of(scene);
        RenderIdentity render = RenderIdentity.of(document.hash(), settings, Build.number());
        RenderRow row = RenderRow.now(
                render.id().toString(),
                scene.name(),
                render.settings(),
                render.build(),
                settings.width(),
                settings.height());
        StoreArchive.Render what = new StoreArchive.Render(
                row,
                SceneWriter.toJson(scene.withoutAnimation().withInstants(List.of()), Path::toString)
                        .getBytes(StandardCharsets.UTF_8),
                planned -> PictureText.of(scene, SettingsLine.replayable(settings, planned, frame)),
                samples);
        try {
            return Optional.of(StoreArchive.open(StoreAccess.address(store), access.login(), what));
        } catch (StoreException e) {
            if (!e.isOutOfSpace()) {
                throw e;
            }
            terminal.say("store " + e.getMessage() + "; it is not used, the render goes on without");
            return Optional.empty();
        }
    }
}
