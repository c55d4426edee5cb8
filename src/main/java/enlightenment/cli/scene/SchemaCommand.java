package enlightenment.cli.scene;

import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.scene.json.SceneReader;
import picocli.CommandLine.Command;

/** {@code enlightenment schema}: prints the JSON Schema of the scene format. */
@Command(
        name = "schema",
        description = "Prints the JSON Schema of scene files, for editors that complete and check them.")
public final class SchemaCommand extends Subcommand {
    public SchemaCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() {
        String text = SceneReader.schema();
        terminal.out().print(text.endsWith("\n") ? text : text + "\n");
        return ExitCode.DONE;
    }
}
