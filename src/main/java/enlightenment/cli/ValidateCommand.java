package enlightenment.cli;

import enlightenment.math.Check.InvalidValueException;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code enlightenment validate}: finds all problems of scenes without rendering them. */
@Command(name = "validate", description = "Finds all problems of scenes without rendering them.")
final class ValidateCommand extends Subcommand {
    @Parameters(arity = "1..*", paramLabel = "SCENE", description = "the scene files")
    private List<Path> sceneFiles;

    ValidateCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() {
        int code = CliException.DONE;
        for (Path file : sceneFiles) {
            try {
                validate(file);
                terminal.show(file + ": valid");
            } catch (SceneException e) {
                new Failures(terminal).problems(e);
                code = CliException.WRONG_INPUT;
            }
        }
        return code;
    }

    /** Reads the scene and puts it together, which also looks at its textures. */
    private static void validate(Path file) {
        Scene scene = SceneReader.read(file);
        try {
            Renderer.inspect(scene, RenderSettings.of(scene));
        } catch (InvalidValueException e) {
            throw Failures.inFile(file.toString(), e);
        } catch (SceneException e) {
            throw Failures.inFile(file.toString(), e);
        }
    }
}
