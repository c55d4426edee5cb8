package enlightenment.cli.input;

import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.importer.SceneImporter;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;

/** The source of a scene: a file, or standard input, whose textures are relative to the working folder. */
public final class SceneInput {
    private final Path file;
    private final ForeignOptions foreign;
    private final Terminal terminal;
    private final SceneReader.Frames scenes;

    /** The bytes of standard input, once it has been read. */
    private byte[] bytes;

    /** Whether the file is one of another program; null until the first call that needs it. */
    private Boolean isForeign;

    /** The imported scene, once it has been read. */
    private Scene imported;

    /** The frames of the imported scene, once one has been read. */
    private SceneReader.Frames importedFrames;

    public SceneInput(Path file, Terminal terminal) {
        this(file, new ForeignOptions(), terminal);
    }

    /** @param foreign the choices for a file of another program; one for a scene file is refused */
    public SceneInput(Path file, ForeignOptions foreign, Terminal terminal) {
        this.file = file;
        this.foreign = foreign;
        this.terminal = terminal;
        scenes = SceneReader.Frames.of(file);
    }

    /** The name of the input in messages. */
    public String name() {
        return StandardStreams.isNamed(file) ? StandardStreams.INPUT : file.toString();
    }

    /**
     * The scene at a frame, or as its own numbers say; may be read any number of times.
     *
     * @throws SceneException if it cannot be used
     */
    public Scene read(Optional<Integer> frame) {
        if (!isForeign()) {
            foreign.refuse(name());
        }
        if (StandardStreams.isNamed(file)) {
            OptionalInt at = frame.map(OptionalInt::of).orElse(OptionalInt.empty());
            return SceneReader.readBytes(bytes(), Path.of(""), StandardStreams.INPUT, at);
        }
        if (isForeign()) {
            return frame.isPresent() ? importedFrame(frame.get()) : imported();
        }
        return frame.isPresent() ? scenes.read(frame.get()) : scenes.read();
    }

    private boolean isForeign() {
        if (isForeign == null) {
            isForeign = !StandardStreams.isNamed(file) && SceneImporter.reads(file);
        }
        return isForeign;
    }

    /** The scene of another program's file, whose notes are shown once. */
    private Scene imported() {
        if (imported == null) {
            SceneImporter.Result result = ForeignScene.read(file, foreign.options());
            result.notes().forEach(note -> terminal.note(file + ": " + note));
            imported = result.scene();
        }
        return imported;
    }

    private Scene importedFrame(int frame) {
        if (importedFrames == null) {
            importedFrames = SceneReader.Frames.of(imported(), name());
        }
        return importedFrames.read(frame);
    }

    /** The exception with lines and columns of this input for problems that have none. */
    SceneException located(SceneException e) {
        if (isForeign()) {
            return e;
        }
        return StandardStreams.isNamed(file) ? SceneReader.located(e, bytes()) : SceneReader.located(e, file);
    }

    /** The size of the scene's text in bytes. */
    public long size() throws IOException {
        return StandardStreams.isNamed(file) ? bytes().length : Files.size(file);
    }

    private byte[] bytes() {
        if (bytes == null) {
            bytes = StandardStreams.readInput(terminal);
        }
        return bytes;
    }
}
