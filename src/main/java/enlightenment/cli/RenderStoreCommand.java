package enlightenment.cli;

import enlightenment.image.Image;
import enlightenment.image.PngOptions;
import enlightenment.picture.Rounding;
import enlightenment.render.RenderResult;
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
final class RenderStoreCommand extends Subcommand {
    @Mixin
    private StoreArgument argument = new StoreArgument();

    @Mixin
    private PictureOutput output = new PictureOutput();

    @Mixin
    private ViewOption view = new ViewOption();

    @Mixin
    private ReportOutput report = new ReportOutput();

    RenderStoreCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        output.check();
        view.check(output);
        CommandFiles files = new CommandFiles();
        argument.register(files);
        files.writes("-o", output.file());
        report.register(files);
        files.check();
        StorePicture picture;
        try (SampleStore store = argument.open()) {
            RenderRow render = argument.choose(store);
            picture = StorePicture.of(store, render);
        }
        picture.notes().forEach(terminal::say);
        RenderResult result = picture.result();
        if (result.shownPixels() == 0) {
            throw CliException.failed(
                    "nothing of the picture is in the store yet; " + output.name() + " was not written");
        }
        result = result.withRounding(Rounding.of(result.image(), output.writtenDepth()));
        Image shown = view.view(result.image(), terminal);
        output.write(shown, new PngOptions(output.depth(), picture.texts()), terminal);
        report.write(result, output, terminal);
        if (!result.complete()) {
            throw CliException.failed("missing: " + picture.missing() + " of " + picture.units()
                    + " units; they are black in " + output.name());
        }
        LightNotes.tell(result, shown, terminal::say);
        LightNotes.require(result);
        RequestedError.require(result);
        return ExitCode.DONE;
    }
}
