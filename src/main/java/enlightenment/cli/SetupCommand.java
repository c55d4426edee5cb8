package enlightenment.cli;

import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.file.TemporaryFile;
import enlightenment.file.WholeFile;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Command;

/**
 * {@code enlightenment setup}: makes the class-data archive that Java starts from. It holds the classes that commands load, parsed
 * and verified, so that they need not be read from the jar each time. For Java 25 and newer the launcher names an ahead-of-time
 * cache (JEP 483, JEP 514), in which these classes are linked, too.
 */
@Command(
        name = "setup",
        description = "Makes the archive of classes that lets commands start faster on this computer; "
                + "with Java 21 or newer the first render makes a simpler one by itself.")
final class SetupCommand extends Subcommand {
    /** The name of the archive that the launcher reads. */
    static final String ARCHIVE = "enlightenment.archive";

    /** The extension of an ahead-of-time cache. */
    private static final String CACHE_SUFFIX = ".aot";

    private static final double MEBI = 1 << 20;

    SetupCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        String place = System.getProperty(ARCHIVE);
        if (place == null || place.isEmpty()) {
            throw CliException.failed("nothing to set up: only the launcher, bin/enlightenment, starts from an archive,"
                    + " and it needs a place in the user's cache for it");
        }
        Path archive = Path.of(place);
        Files.createDirectories(archive.toAbsolutePath().getParent());
        try (TemporaryFile temporary = TemporaryFile.in(archive.toAbsolutePath().getParent())) {
            Path made = temporary.folder().resolve("archive");
            train(
                    place.endsWith(CACHE_SUFFIX) ? "-XX:AOTCacheOutput=" : "-XX:ArchiveClassesAtExit=",
                    made,
                    temporary.folder());
            WholeFile.write(archive, out -> {
                try (InputStream in = Files.newInputStream(made)) {
                    in.transferTo(out);
                }
            });
        }
        // Some versions of Java crash on an archive that was cut short; the launcher compares.
        WholeFile.write(Path.of(place + ".size"), Files.size(archive) + "\n");
        terminal.show(String.format(
                Locale.ROOT, "%s: %.1f MiB; commands start from it from now on", archive, Files.size(archive) / MEBI));
        return ExitCode.DONE;
    }

    /** Runs typical commands in a Java of their own, which writes what it has loaded when it ends, by this option. */
    private static void train(String option, Path archive, Path folder) throws IOException {
        Path java = Path.of(System.getProperty("java.home"), "bin", "java");
        Process training = new ProcessBuilder(List.of(
                        java.toString(),
                        option + archive,
                        // Before version 21 Java archives that a method waits for the compiler, and a process that
                        // starts from such an archive never compiles it (JDK-8306460). So no method may wait. From 25
                        // on a cache would hold profiles of methods (JEP 515), by which short renders compile more, not
                        // less.
                        "-Xint",
                        // Warnings about classes that cannot be archived are of no use here.
                        "-Xlog:disable",
                        "-Xlog:all=error:stderr",
                        "-cp",
                        System.getProperty("java.class.path"),
                        ArchiveTraining.class.getName(),
                        folder.toString()))
                .redirectErrorStream(true)
                .start();
        training.getOutputStream().close();
        String said = new String(training.getInputStream().readAllBytes(), Charset.defaultCharset());
        int code = waitFor(training);
        if (code != 0 || !Files.exists(archive)) {
            throw CliException.failed("this Java makes no archive of classes (exit code " + code + ")"
                    + said.lines()
                            .filter(line -> line.contains("[error]"))
                            .findFirst()
                            .or(() ->
                                    said.lines().filter(line -> !line.isBlank()).findFirst())
                            .map(line -> ": " + line.strip())
                            .orElse(""));
        }
    }

    private static int waitFor(Process training) throws IOException {
        try {
            return training.waitFor();
        } catch (InterruptedException e) {
            training.destroy();
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("setup was interrupted");
        }
    }
}
