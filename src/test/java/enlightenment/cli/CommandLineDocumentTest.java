package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.ImageFormat;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** docs/guide/cli.md lists the commands and options that there are. */
class CommandLineDocumentTest {
    private static final Path PAGE = Path.of("docs/guide/cli.md");

    /** The first cell of a row of a table. */
    private static final Pattern FIRST_CELL = Pattern.compile("(?m)^\\| (`-.*?) \\| ");

    private static final Pattern OPTION = Pattern.compile("`(--?[a-z][a-z-]*)[^`]*`");

    static String[] commands() {
        return Commands.NAMES;
    }

    private static CommandLine line(String command) {
        PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
        return new CommandLine(Commands.create(command, new Terminal(nowhere, nowhere, new ShutdownSignal())));
    }

    /** The text below the command's title, with its subsections. */
    private static String section(String command) throws IOException {
        String title = command.equals("merge") ? "render --part and merge" : command;
        Matcher m = Pattern.compile("(?ms)^## \\Q" + title + "\\E$(.*?)(?=^## |\\z)")
                .matcher(Files.readString(PAGE));
        assertTrue(m.find(), "docs/guide/cli.md has no section ## " + title);
        return m.group(1);
    }

    @ParameterizedTest
    @MethodSource("commands")
    void eachOptionOfACommandIsInTheTableOfItsSectionAndNoOther(String command) throws IOException {
        Set<String> known = new TreeSet<>();
        for (OptionSpec option : line(command).getCommandSpec().options()) {
            if (!option.hidden() && !option.usageHelp()) {
                known.addAll(Set.of(option.names()));
            }
        }
        Set<String> listed = new TreeSet<>();
        Matcher cell = FIRST_CELL.matcher(section(command));
        while (cell.find()) {
            Matcher name = OPTION.matcher(cell.group(1));
            while (name.find()) {
                assertTrue(listed.add(name.group(1)), name.group(1) + " is listed twice");
            }
        }
        assertEquals(known, listed);
    }

    @Test
    void compareTakesEveryFormatThereIs() throws IOException {
        String section = section("compare");
        for (ImageFormat format : ImageFormat.values()) {
            for (PositionalParamSpec picture : line("compare").getCommandSpec().positionalParameters()) {
                String described = String.join("", picture.description());
                assertTrue(
                        format.extensions().stream().anyMatch(e -> described.contains("." + e)),
                        format + " in " + described);
            }
            assertTrue(section.contains(format.name()), format + " in\n" + section);
        }
    }

    @Test
    void theSynopsisNamesEveryCommand() throws IOException {
        String synopsis = Files.readString(PAGE).split("```")[1];
        Set<String> named = synopsis.lines()
                .filter(l -> l.startsWith("enlightenment ") && !l.startsWith("enlightenment --"))
                .map(l -> l.split(" ")[1])
                .collect(Collectors.toCollection(TreeSet::new));
        Set<String> known = new TreeSet<>(Set.of(Commands.NAMES));
        known.addAll(Set.of("completion", "help"));
        assertEquals(known, named);
    }

    /** What the limits of an option are stands in the converter; the page must not say another. */
    @Test
    void limitsOnThePageAreThoseThatAreTold() throws IOException {
        Path scene = Path.of("scenes/fire-and-ice.json");
        Matcher row = Pattern.compile(
                        "(?m)^\\| `(--[a-z-]+) [A-Z]+` \\| .*?[ ,](\\d[\\d.]*\\.\\.\\d[\\d.]*\\d)\\b.*\\|$")
                .matcher(section("render"));
        int checked = 0;
        while (row.find()) {
            CliRun run = CliRun.of("render", scene, "-o", "none.png", row.group(1), "-1");
            assertEquals(2, run.code());
            assertTrue(run.err().startsWith("enlightenment: " + row.group(1) + " must be a "), run.err());
            assertTrue(run.err().contains(" in " + row.group(2) + ", not \"-1\""), run.err() + row.group());
            checked++;
        }
        assertTrue(checked >= 6, checked + " limits");
    }
}
