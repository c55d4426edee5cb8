package enlightenment.cli;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.WholeFile;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import picocli.AutoComplete;
import picocli.CommandLine;

/**
 * Writes the man page and the completion script of the application's zip. The build runs it, so that both agree with picocli's model of the
 * commands.
 */
public final class ApplicationTexts {
    private ApplicationTexts() {}

    /**
     * Writes the files.
     *
     * @param args the folder that gets {@code share/man/man1/enlightenment.1} and
     *     {@code share/bash-completion/completions/enlightenment}, and the version
     */
    public static void main(String[] args) throws IOException {
        Path share = Path.of(args[0]).resolve("share");
        CommandLine tree = tree();
        write(share.resolve("man").resolve("man1").resolve("enlightenment.1"), ManPage.of(tree, args[1]));
        write(
                share.resolve("bash-completion").resolve("completions").resolve("enlightenment"),
                AutoComplete.bash("enlightenment", tree));
    }

    /** The command tree without input and with its output discarded. */
    static CommandLine tree() {
        PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
        return Commands.tree(new Terminal(InputStream.nullInputStream(), nowhere, nowhere, new ShutdownSignal()));
    }

    private static void write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        WholeFile.write(file, text);
    }
}
