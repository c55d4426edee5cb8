package enlightenment.cli.render;

import enlightenment.checkpoint.Checkpoint;
import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.terminal.Terminal;
import enlightenment.job.Build;
import enlightenment.job.RenderIdentity;
import enlightenment.job.SceneDocument;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Option;

/** The options that say where a render keeps what it has done, so that it can be stopped at any time and go on. */
final class KeepOptions {
    @Option(
            names = "--checkpoint",
            paramLabel = "FILE",
            description = "keep what is done in this file, so that the render can be stopped at any time and go on")
    private Path checkpoint;

    @Option(
            names = "--resume",
            description = "go on from the file of --checkpoint: with the same picture, or more samples of it")
    private boolean resume;

    KeepOptions() {}

    /** The hint for a render that was stopped, in words that end a sentence; empty if nothing is kept. */
    String hint() {
        return checkpoint == null ? "" : "; what is done is kept: --resume goes on with it";
    }

    /** Adds the files that are read and written. */
    void register(CommandFiles files) {
        files.writes("--checkpoint", checkpoint);
    }

    /** Opens the checkpoint, if there is to be one. */
    Optional<Checkpoint> open(Scene scene, RenderSettings settings, Terminal terminal) throws IOException {
        if (checkpoint == null) {
            return Optional.empty();
        }
        boolean exists = Files.exists(checkpoint);
        RenderIdentity render = RenderIdentity.of(SceneDocument.of(scene).hash(), settings, Build.number());
        Checkpoint opened = Checkpoint.open(checkpoint, render, resume);
        opened.damage().forEach(line -> terminal.say("checkpoint " + checkpoint + ": " + line));
        if (resume && opened.results() == 0) {
            terminal.say("checkpoint " + checkpoint + ": "
                    + (exists ? "it holds nothing yet" : "there is no such file yet") + ", the render begins anew");
        }
        return Optional.of(opened);
    }
}
