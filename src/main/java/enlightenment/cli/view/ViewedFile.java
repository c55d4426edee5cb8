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

/** The file that a view shows, read anew each time. */
final class ViewedFile implements SceneSource {
    private final Path file;
    private final ForeignOptions foreign;
    private final FrameOption frame;
    private final Terminal terminal;
    private final boolean isNative;

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
    public Scene read() {
        SceneInput input = new SceneInput(file, foreign, terminal);
        try {
            return frame.read(input);
        } catch (CliException e) {
            throw SceneException.of("", e.getMessage());
        } catch (InvalidValueException e) {
            throw SceneFailures.inFile(input, e);
        }
    }
}
