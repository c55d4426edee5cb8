package enlightenment.cli.store;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.picture.ResultPicture;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.store.RenderRow;
import enlightenment.store.SampleStore;
import enlightenment.store.StorePicture;
import java.io.IOException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code enlightenment render-store}: makes the picture of a render that is in a store. */
@Command(
        name = "render-store",
        description = "Makes the picture of a render that is in a store, be it finished or not.",
        sortOptions = false)
public final class RenderStoreCommand extends Subcommand {
    @Mixin
    private StoreArgument argument = new StoreArgument();

    @Mixin
    private ResultPicture output = new ResultPicture();

    public RenderStoreCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        CommandFiles files = new CommandFiles();
        argument.register(files);
        output.check(files);
        StorePicture picture;
        try (SampleStore store = argument.open()) {
            RenderRow render = argument.choose(store);
            picture = StorePicture.of(store, render, output.scratch());
        }
        picture.notes().forEach(terminal::say);
        if (picture.result().shownPixels() == 0) {
            throw CliException.failed(
                    "nothing of the picture is in the store yet; " + output.name() + " was not written");
        }
        String missing = picture.result().complete()
                ? ""
                : "missing: " + picture.missing() + " of " + picture.units() + " units; they are black in "
                        + output.name();
        output.write(picture.result(), picture.texts(), missing, terminal);
        return ExitCode.DONE;
    }
}
