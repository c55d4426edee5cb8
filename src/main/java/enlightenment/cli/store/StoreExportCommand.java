package enlightenment.cli.store;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import enlightenment.store.RenderRow;
import enlightenment.store.SampleRows;
import enlightenment.store.SampleStore;
import enlightenment.store.StoreException;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code enlightenment store-export}: unpacks the samples of a render for queries by other programs. */
@Command(
        name = "store-export",
        description = "Unpacks the samples of a render that is in a store, into a file or a table.",
        sortOptions = false)
public final class StoreExportCommand extends Subcommand {
    @Mixin
    private StoreArgument argument = new StoreArgument();

    @Option(names = "--csv", paramLabel = "FILE", description = "write them to this file, a line each")
    private Path csv;

    @Option(names = "--rows", description = "put them into the table \"sample\" of the store, a row each")
    private boolean rows;

    public StoreExportCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        if (rows == (csv != null)) {
            throw CliException.wrongUsage("either --csv FILE or --rows says where the samples go");
        }
        CommandFiles files = new CommandFiles();
        argument.register(files);
        files.writes("--csv", csv);
        files.check();
        try (SampleStore store = rows ? argument.openToUnpack() : argument.open()) {
            RenderRow render = argument.choose(store);
            SampleRows samples = SampleRows.of(store, render);
            long count = rows ? samples.fillTable() : write(samples);
            terminal.say(count + " samples of render " + SampleStore.shortId(render) + ", pass " + samples.pass()
                    + ", unpacked");
            long without = samples.unitsWithout();
            if (without > 0) {
                terminal.say(without + " units were kept without them and are left out");
            }
            if (samples.damaged() > 0) {
                throw CliException.failed(samples.damaged() + " blocks of samples are damaged and were left out");
            }
        }
        return ExitCode.DONE;
    }

    private long write(SampleRows samples) throws IOException {
        long[] count = new long[1];
        try {
            WholeFile.write(csv, out -> {
                Writer writer = new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8));
                try {
                    count[0] = samples.writeCsv(writer);
                } catch (StoreException e) {
                    // Past the writing of the file, which has not failed.
                    throw new UncheckedIOException(e);
                }
                writer.flush();
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        return count[0];
    }
}
