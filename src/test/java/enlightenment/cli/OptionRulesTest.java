package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.option.OptionRule;
import enlightenment.cli.option.OptionRules;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.serve.ServingOptions;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** Options that exclude or need each other: all that the tables of commands say is held, and stands in docs/guide/cli.md. */
class OptionRulesTest {
    private static final Pattern ROW =
            Pattern.compile("(?m)^\\| `([a-z-]+)` \\| (.*?) \\| (not with|only with) \\| (.*?) \\| .+ \\|$");

    /** What is typed before options, where there must be something. */
    private static final Map<String, List<String>> BEGINNINGS = Map.of(
            "render", List.of("missing.json", "-o", "none.film"),
            "animate", List.of("missing.json", "-o", "none/%d.png"),
            "server", List.of("missing.json", "-o", "none.png"),
            "worker", List.of("127.0.0.1:1"),
            "compare", List.of("missing.png", "none.png"),
            "trade", List.of("missing.json", "-o", "none"));

    /** Values of options that have one; those of files are not among them. */
    private static final Map<String, String> VALUES = Map.ofEntries(
            Map.entry("--depth", "16"),
            Map.entry("--format", "png"),
            Map.entry("--exposure", "1"),
            Map.entry("--aov", "depth"),
            Map.entry("--preview", "1"),
            Map.entry("--part", "1/2"),
            Map.entry("--error", "0.1"),
            Map.entry("--time", "1"),
            Map.entry("--device", "cpu"),
            Map.entry("--host", "127.0.0.1"),
            Map.entry("--port", "0"),
            Map.entry("--min-workers", "1"),
            Map.entry("--wait", "1"),
            Map.entry("--shares", "a=1"),
            Map.entry("--status-port", "0"),
            Map.entry("--local-threads", "1"),
            Map.entry("--audit", "0.5"),
            Map.entry("--tone", "clip"));

    private static final Set<String> FLAGS = Set.of(
            "--stats",
            "--serve",
            "--audit-required",
            "--window",
            "--resume",
            "--store-rays",
            "--store-samples",
            "--server",
            "--linear",
            "--evaluate");

    /** Two options of a command, and the rule that they break. */
    record Pair(String command, OptionRule rule, String option, String other) {
        @Override
        public String toString() {
            return command + " " + option + (rule.isNeed() ? " without " : " with ") + other;
        }
    }

    private static List<OptionRule> rules(String command) {
        PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
        return Commands.create(command, new Terminal(nowhere, nowhere, new ShutdownSignal()))
                .rules();
    }

    private static Stream<Pair> pairs(String command) {
        return rules(command).stream().flatMap(rule -> rule.options().stream()
                .flatMap(option -> rule.others().stream().map(other -> new Pair(command, rule, option, other))));
    }

    static Stream<Pair> pairs() {
        return Stream.of(Commands.NAMES).flatMap(OptionRulesTest::pairs);
    }

    /** The options, with what they need by all rules but one. */
    private static Set<String> withNeeds(String command, OptionRule but, Set<String> options) {
        Set<String> all = new LinkedHashSet<>(options);
        boolean isWhole = false;
        while (!isWhole) {
            isWhole = rules(command).stream()
                    .filter(r -> r.isNeed() && !r.equals(but))
                    .filter(r -> !Collections.disjoint(r.options(), all) && Collections.disjoint(r.others(), all))
                    .noneMatch(r -> all.add(r.others().get(0)));
        }
        return all;
    }

    private static CliRun run(String command, Set<String> options) {
        List<Object> words = new ArrayList<>(List.of(command));
        words.addAll(BEGINNINGS.get(command));
        for (String option : options) {
            words.add(option);
            if (!FLAGS.contains(option)) {
                words.add(VALUES.getOrDefault(option, "some.file"));
            }
        }
        return CliRun.of(words.toArray());
    }

    private static boolean names(String message, String option) {
        return Pattern.compile(option + "(?![a-z-])").matcher(message).find();
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void whatDoesNotGoTogetherIsRefusedWithBothNames(Pair pair) {
        Set<String> wrong = pair.rule.isNeed() ? Set.of(pair.option) : Set.of(pair.option, pair.other);
        Set<String> given = withNeeds(pair.command, pair.rule, wrong);
        CliRun run = run(pair.command, given);
        assertEquals(2, run.code(), run.err());
        assertEquals(1, run.errLines().size(), run.err());
        assertTrue(names(run.err(), pair.other), run.err());
        // What it needs itself may be of the same rule.
        assertTrue(
                pair.rule.options().stream().filter(given::contains).anyMatch(option -> names(run.err(), option)),
                run.err());
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void anOptionWithWhatItNeedsBreaksNoRule(Pair pair) {
        for (String option : List.of(pair.option, pair.other)) {
            Set<String> given = withNeeds(pair.command, null, Set.of(option));
            for (OptionRule rule : rules(pair.command)) {
                assertTrue(rule.broken(given).isEmpty(), given + ": " + rule.message());
            }
        }
    }

    @Test
    void theDepthOfAPartIsThatOfThePictureThatIsToMeetAnError() {
        for (OptionRule rule : OptionRules.RENDER) {
            assertTrue(rule.broken(Set.of("--part", "--depth", "--error")).isEmpty(), rule.message());
        }
        CliRun run = run("render", Set.of("--part", "--depth", "--error"));
        assertTrue(run.err().contains("missing.json"), run.err());
    }

    @Test
    void aFlagThatIsSwitchedOffIsNotGiven() {
        CliRun run = CliRun.of("render", "missing.json", "-o", "none.png", "--store-rays=false", "--resume=false");
        assertTrue(run.err().contains("missing.json"), run.err());
    }

    @Test
    void allOptionsOfAServerAreForAnimateWithServerOnly() {
        Set<String> serving = CommandSpec.forAnnotatedObject(new ServingOptions())
                .optionsMap()
                .keySet();
        Set<String> held = pairs("animate")
                .filter(p -> p.rule.isNeed() && p.other.equals("--server"))
                .map(Pair::option)
                .collect(Collectors.toSet());
        assertEquals(serving, held);
    }

    /** A rule about an option that is called otherwise would never be broken. */
    @Test
    void rulesNameOptionsOfTheirCommandsByTheirLongestNames() {
        for (String command : Commands.NAMES) {
            PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
            Subcommand made = Commands.create(command, new Terminal(nowhere, nowhere, new ShutdownSignal()));
            Set<String> names = new CommandLine(made)
                    .getCommandSpec().options().stream()
                            .map(o -> o.longestName())
                            .collect(Collectors.toSet());
            for (OptionRule rule : made.rules()) {
                assertTrue(names.containsAll(rule.options()), command + ": " + rule);
                assertTrue(names.containsAll(rule.others()), command + ": " + rule);
                assertTrue(rule.excuse().isEmpty() || names.contains(rule.excuse()), command + ": " + rule);
            }
        }
    }

    private static String cell(List<String> options) {
        return options.stream().map(o -> "`" + o + "`").collect(Collectors.joining(", "));
    }

    @Test
    void thePageListsTheRulesAndNoOthers() throws IOException {
        Set<String> held = new TreeSet<>();
        for (String command : Commands.NAMES) {
            for (OptionRule rule : rules(command)) {
                held.add(String.join(
                        " | ",
                        command,
                        cell(rule.options()) + (rule.excuse().isEmpty() ? "" : ", but for `" + rule.excuse() + "`"),
                        rule.isNeed() ? "only with" : "not with",
                        cell(rule.others())));
            }
        }
        Set<String> listed = new TreeSet<>();
        Matcher row = ROW.matcher(Files.readString(Path.of("docs/guide/cli.md")));
        while (row.find()) {
            listed.add(String.join(" | ", row.group(1), row.group(2), row.group(3), row.group(4)));
        }
        assertEquals(held, listed);
    }
}
