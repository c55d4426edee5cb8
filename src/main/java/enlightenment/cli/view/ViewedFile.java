package enlightenment.cli.view;

import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.FrameOption;
import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.Terminal;
import enlightenment.importer.SceneImporter;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.view.SceneSource;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;

/** The file that a view shows, read anew each time. */
final class ViewedFile implements SceneSource {
    private final Path file;
    private final ForeignOptions foreign;
    private final FrameOption frame;
    private final Terminal terminal;
    private final boolean isNative;

    /** The file as it was last read; null before. */
    private SceneInput input;

    ViewedFile(Path file, ForeignOptions foreign, FrameOption frame, Terminal terminal) {
        this.file = file;
        this.foreign = foreign;
        this.frame = frame;
        this.terminal = terminal;
        isNative = !SceneImporter.reads(file);
        if (isNative) {
            foreign.refuse(file.toString());
        }
    }

    @Override
    public Path file() {
        return file;
    }

    @Override
    public boolean isNative() {
        return isNative;
    }

    @Override
    public SceneException located(SceneException e) {
        return SceneFailures.inFile(new SceneInput(file, foreign, terminal), e);
    }

    @Override
    public OptionalInt frame() {
        return frame.number() == null ? OptionalInt.empty() : OptionalInt.of(frame.number());
    }

    @Override
    public synchronized Scene read() {
        input = new SceneInput(file, foreign, terminal);
        return located(() -> frame.read(input));
    }

    @Override
    public synchronized Scene read(int number) {
        return located(() -> input.read(Optional.of(number)));
    }

    private Scene located(Supplier<Scene> reading) {
        try {
            return reading.get();
        } catch (CliException e) {
            throw SceneException.of("", e.getMessage());
        } catch (InvalidValueException e) {
            throw SceneFailures.inFile(input, e);
        }
    }
}
