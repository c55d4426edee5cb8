package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.option.WordOption;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.scene.Method;
import java.io.File;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** The shell completes the values of options, not only their names. */
class CompletionTest {
    static String[] commands() {
        return Commands.NAMES;
    }

    private static List<OptionSpec> options(String command) {
        PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
        Terminal terminal = new Terminal(nowhere, nowhere, new ShutdownSignal());
        return new CommandLine(Commands.create(command, terminal))
                .getCommandSpec()
                .options();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "render  | --method   | METHODS",
                "render  | --proposal | normal zeta linear",
                "render  | --progress | auto bar plain none",
                "render  | --depth    | 8 16 32",
                "render  | --format   | png jpg pfm exr",
                "render  | --aov      | error samples depth normal position object albedo direct indirect",
                "trade   | --methods  | METHODS"
            })
    void wordsAreCompleted(String command, String option, String known) {
        String words = known.equals("METHODS") ? String.join(" ", Method.words(Method.selectable())) : known;
        OptionSpec spec = options(command).stream()
                .filter(o -> o.longestName().equals(option))
                .findFirst()
                .orElseThrow();
        List<String> candidates = new ArrayList<>();
        spec.completionCandidates().forEach(candidates::add);
        assertEquals(List.of(words.split(" ")), candidates);
        assertTrue(CliRun.of("completion").out().contains("(\"" + words.replace(" ", "\" \"") + "\")"), option);
    }

    /** An option whose converter knows words completes these words. */
    @ParameterizedTest
    @MethodSource("commands")
    void noVocabularyIsForgotten(String command) {
        for (OptionSpec option : options(command)) {
            if (option.converters().length > 0 && option.converters()[0] instanceof WordOption<?> words) {
                assertNotNull(option.completionCandidates(), option.longestName());
                List<String> candidates = new ArrayList<>();
                option.completionCandidates().forEach(candidates::add);
                List<String> known = new ArrayList<>();
                words.forEach(known::add);
                assertEquals(known, candidates, option.longestName());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("commands")
    void filesAreCompletedAsFiles(String command) {
        for (OptionSpec option : options(command)) {
            if (List.of("FILE", "DIR", "OUT.png").contains(option.paramLabel())) {
                assertTrue(option.type() == Path.class || option.type() == File.class, option.longestName());
            }
        }
    }

    @Test
    void theScriptAsksBashForFiles() {
        assertTrue(CliRun.of("completion").out().contains("compgen -f"));
    }
}
