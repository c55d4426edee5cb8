package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.docs.GuidePages;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

/**
 * Commands of the guide: what stands in its blocks of shell is taken by the command line as it is, and what reads files that come with
 * the program, or that were made further up on the page, is run, as a picture of a few pixels and samples.
 */
class GuideCommandsTest {
    private static final Pattern PROGRAM =
            Pattern.compile("^(?:enlightenment|java -jar target/enlightenment\\.jar) +(.*)$");

    /** Wait for somebody, measure for minutes, or write outside of the folder that they are called in. */
    private static final Set<String> NOT_RUN = Set.of("view", "server", "worker", "trade", "bench", "setup");

    /** Names of files that commands write. */
    private static final Pattern FILE =
            Pattern.compile("[\\w./%-]+\\.(?:png|jpg|exr|pfm|json|gif|apng|mp4|csv|db|ck|film)");

    /** What is asked for in the guide, and what a test has time for. */
    private static final Map<String, String> SMALL =
            Map.of("--samples", "1", "--error", "0.4", "--time", "0.2", "--frames", "0-1", "--max-rmse", "1");

    @TempDir
    Path folder;

    static List<Path> pages() throws IOException {
        return GuidePages.all();
    }

    /** The words of the commands of a page, without the program's name. */
    private static List<List<String>> commands(Path page) throws IOException {
        List<List<String>> commands = new ArrayList<>();
        for (String block : GuidePages.blocks(page, "sh")) {
            for (String line : block.replaceAll("\\\\\n\\s*", "").lines().toList()) {
                Matcher m = PROGRAM.matcher(line.replaceFirst("\\s+#.*", "").replaceFirst("\\s*(?:&&|>|<|\\|).*", ""));
                if (m.matches()) {
                    commands.add(List.of(m.group(1).strip().split(" +")));
                }
            }
        }
        return commands;
    }

    @ParameterizedTest
    @MethodSource("pages")
    void everyCommandIsOneThatTheProgramTakes(Path page) throws IOException {
        PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
        CommandLine line = Commands.tree(new Terminal(nowhere, nowhere, new ShutdownSignal()));
        for (List<String> command : commands(page)) {
            try {
                line.parseArgs(command.toArray(String[]::new));
            } catch (CommandLine.ParameterException e) {
                throw new AssertionError(page + ": " + String.join(" ", command) + ": " + e.getMessage(), e);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void everyCommandWhoseFilesAreThereDoesWhatItShould(Path page) throws IOException {
        for (List<String> command : commands(page)) {
            if (isRun(command)) {
                List<String> small = small(command);
                CliRun run = CliRun.of(small.toArray());
                assertEquals(0, run.code(), page + ": " + String.join(" ", small) + "\n" + run.err());
            }
        }
    }

    /** Few commands would be a sign that the pattern finds them no more, and few runs that their files are not recognized. */
    @Test
    void mostCommandsOfTheGuideAreRun() throws IOException {
        int all = 0;
        int run = 0;
        for (Path page : GuidePages.all()) {
            Set<String> made = new HashSet<>();
            for (List<String> command : commands(page)) {
                all++;
                boolean lacksAFile = NOT_RUN.contains(command.get(0))
                        || inputs(command).stream().anyMatch(f -> !Files.exists(Path.of(f)) && !made.contains(f));
                made.addAll(
                        command.stream().filter(w -> FILE.matcher(w).matches()).toList());
                made.add(command.size() > 1 ? command.get(1) + ".json" : "");
                run += lacksAFile ? 0 : 1;
            }
        }
        assertTrue(all > 80, all + " commands");
        assertTrue(run > 40, run + " of " + all + " commands are run");
    }

    /** The files that a command reads: what follows its name, up to the first option. */
    private static List<String> inputs(List<String> command) {
        if (Set.of("new", "schema", "completion", "help", "--version").contains(command.get(0))) {
            return command.contains("--model") ? List.of(command.get(command.indexOf("--model") + 1)) : List.of();
        }
        List<String> inputs =
                command.stream().skip(1).takeWhile(w -> !w.startsWith("-")).toList();
        return command.get(0).equals("convert") ? inputs.subList(0, 1) : inputs;
    }

    private boolean isRun(List<String> command) {
        return !NOT_RUN.contains(command.get(0))
                && inputs(command).stream().allMatch(f -> Files.exists(place(f)))
                && command.stream().noneMatch(w -> w.equals("--window") || w.endsWith(".mp4"));
    }

    /** A file that comes with the program stays where it is, any other is one of the test's folder. */
    private Path place(String file) {
        Path shipped = Path.of(file);
        return Files.exists(shipped) ? shipped : folder.resolve(file);
    }

    private List<String> small(List<String> command) throws IOException {
        List<String> words = new ArrayList<>();
        for (int i = 0; i < command.size(); i++) {
            String word = command.get(i);
            String before = i == 0 ? "" : command.get(i - 1);
            if (before.equals("--size")) {
                words.add("24x16");
            } else if (before.equals("--crop")) {
                words.add("0,0,12,16");
            } else if (SMALL.containsKey(before)) {
                words.add(SMALL.get(before));
            } else if (FILE.matcher(word).matches() || command.get(0).equals("new") && i == 1) {
                Path file = place(word);
                Files.createDirectories(file.toAbsolutePath().getParent());
                words.add(file.toString());
            } else {
                words.add(word);
            }
        }
        return withBudget(words);
    }

    private static List<String> withBudget(List<String> words) {
        if (Set.of("render", "animate").contains(words.get(0))) {
            if (!words.contains("--size")) {
                words.addAll(List.of("--size", "24x16"));
            }
            if (words.stream().noneMatch(Set.of("--samples", "--error", "--time", "--antialias")::contains)) {
                words.addAll(List.of("--samples", "1"));
            }
            if (words.get(0).equals("animate") && !words.contains("--frames")) {
                words.addAll(List.of("--frames", "0-1"));
            }
        }
        return words;
    }
}
