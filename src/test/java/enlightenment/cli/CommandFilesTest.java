package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.process.JavaProcess;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;

/** No command writes over what it reads, nor two files into one place, whatever the paths look like. */
class CommandFilesTest {
    /** Options that speak of files, but neither read nor write one of their own. */
    private static final Set<String> ABOUT_FILES = Set.of(
            "render --depth",
            "render --resume",
            "render-store --depth",
            "animate --depth",
            "animate --overwrite",
            "merge --depth",
            "server --depth",
            "render --preview",
            "render --part",
            "merge --partial",
            "trade --resume",
            "trade --evaluate",
            "view --save",
            "completion");

    /** Such options of all commands that read files of other programs. */
    private static final Set<String> OF_FOREIGN_FILES =
            Set.of("--camera", "--view", "--up", "--background", "--fps", "--animation", "--assets");

    /** What is read only, by commands that write nothing, or in a place where nothing is written but files that were not there; {@code view} writes into the scene itself, where asked to. */
    private static final Set<String> READ_ONLY = Set.of(
            "new NAME",
            "new --model",
            "validate SCENE",
            "inspect SCENE",
            "view SCENE",
            "store-info STORE",
            "store-info --store-password-file",
            "worker --token-file",
            "worker --tls-ca");

    private static final Pattern SPEAKS_OF_FILES = Pattern.compile("(?i)\\b(files?|folder|write|writes|written)\\b");

    @TempDir
    Path folder;

    private static String key(String command, ArgSpec arg) {
        return command + " "
                + (arg instanceof OptionSpec option && option.longestName() != null ? name(option) : arg.paramLabel());
    }

    private static String name(OptionSpec option) {
        return option.longestName().equals("--output") ? "-o" : option.longestName();
    }

    private static boolean mayBeAFile(ArgSpec arg) {
        Class<?>[] all = arg.auxiliaryTypes();
        return arg.type() == Path.class
                || arg.type() == java.io.File.class
                || all != null && Arrays.asList(all).contains(Path.class)
                || arg.paramLabel().matches(".*(FILE|DIR|PATH).*")
                || SPEAKS_OF_FILES.matcher(String.join(" ", arg.description())).find();
    }

    @Test
    void everyOptionThatMayNameAFileIsOneOfThoseTried() {
        PrintStream nowhere = new PrintStream(new ByteArrayOutputStream());
        Set<String> found = new TreeSet<>();
        for (String command : Commands.NAMES) {
            Subcommand made = Commands.create(command, new Terminal(nowhere, nowhere, new ShutdownSignal()));
            CommandLine line = new CommandLine(made);
            line.getCommandSpec().args().stream()
                    .filter(CommandFilesTest::mayBeAFile)
                    .forEach(arg -> found.add(key(command, arg)));
        }
        Set<String> known = new TreeSet<>(READ_ONLY);
        for (CommandLines line : CommandLines.values()) {
            Stream.concat(line.inputs.stream(), line.outputs.stream())
                    .filter(name -> !name.equals("texture"))
                    .forEach(name -> known.add(line.command() + " " + name));
        }
        found.removeAll(ABOUT_FILES);
        found.removeIf(key -> OF_FOREIGN_FILES.contains(key.substring(key.indexOf(' ') + 1)));
        assertEquals(known, found);
    }

    /** Makes all inputs, each in its own place or, if it is the victim, in a place that an output may have. */
    private Map<String, Path> inputs(CommandLines line, String victim, String name) throws IOException {
        Map<String, Path> files = new LinkedHashMap<>();
        for (String input : line.inputs) {
            String own = input.equals("--scenes") ? "fire-and-ice.json" : input.replace("-", "") + ".in";
            Path file = folder.resolve(input.equals(victim) && !input.equals("--scenes") ? name : own);
            CommandLines.make(input, file, folder);
            files.put(input, file);
        }
        return files;
    }

    private Map<String, String> content() throws IOException {
        Map<String, String> all = new TreeMap<>();
        try (Stream<Path> files = Files.walk(folder)) {
            files.filter(Files::isRegularFile).forEach(f -> {
                try {
                    all.put(folder.relativize(f).toString(), Arrays.toString(Files.readAllBytes(f)));
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            });
        }
        return all;
    }

    private void assertRefused(CommandLines line, Map<String, Path> files, String what, String... words)
            throws IOException {
        Object[] args = line.args(files, folder).toArray();
        Map<String, String> before = content();
        CliRun run = CliRun.of(args);
        String told = what + ": " + Arrays.toString(args) + ": " + run.err();
        assertEquals(2, run.code(), told);
        for (String word : words) {
            assertTrue(run.err().contains(word), told);
        }
        assertEquals(1, run.errLines().size(), told);
        assertEquals(before, content(), told);
    }

    private void empty() throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(java.util.Comparator.reverseOrder()).toList()) {
                if (!file.equals(folder)) {
                    Files.delete(file);
                }
            }
        }
    }

    /** All that leads to a file: other spellings, a linked folder, symbolic links (to links), a hard link. */
    private List<Path> names(Path file, String extension) throws IOException {
        Files.createDirectory(folder.resolve("sub"));
        Path linked = Files.createSymbolicLink(folder.resolve("linked"), folder);
        Path soft = Files.createSymbolicLink(folder.resolve("soft" + extension), file.getFileName());
        Path twice = Files.createSymbolicLink(folder.resolve("twice" + extension), soft.toAbsolutePath());
        Path hard = Files.createLink(folder.resolve("hard" + extension), file);
        List<Path> links = List.of(soft, twice, hard, linked.resolve(soft.getFileName()));
        Path name = file.getFileName();
        List<Path> spelled = List.of(
                file,
                folder.resolve("sub/../" + name),
                linked.resolve(name),
                Path.of("").toAbsolutePath().relativize(file.toAbsolutePath()));
        return name.toString().endsWith(extension)
                ? Stream.concat(spelled.stream(), links.stream()).toList()
                : links;
    }

    @ParameterizedTest
    @EnumSource(names = "TRADE", mode = EnumSource.Mode.EXCLUDE)
    void noOutputWritesOverAnInput(CommandLines line) throws IOException {
        checkNoOutputOverAnInput(line, false);
    }

    @ParameterizedTest
    @Tag("full")
    @EnumSource(names = {"RENDER", "RENDER_KEPT", "ANIMATE", "ANIMATE_SERVER", "SERVER"})
    void noOutputOfManyWritesOverAnInputByAnyName(CommandLines line) throws IOException {
        checkNoOutputOverAnInput(line, true);
    }

    /** Of the names of a file all, or of a command with many files a few at a time, in turn, so that each has several turns. */
    private static List<Path> some(List<Path> names, CommandLines line, boolean all, int turn) {
        if (all || !line.hasMany()) {
            return names;
        }
        int n = names.size();
        return Stream.of(2 * turn, 2 * turn + 1)
                .map(i -> names.get(i % n))
                .distinct()
                .toList();
    }

    private void checkNoOutputOverAnInput(CommandLines line, boolean all) throws IOException {
        int turn = 0;
        for (String output : line.outputs) {
            for (String victim : line.inputs) {
                if (output.equals("--tls") && victim.startsWith("--tls")) {
                    continue; // Never given together.
                }
                empty();
                Map<String, Path> inputs = inputs(line, victim, "victim" + line.extension(output));
                List<Path> names = names(inputs.get(victim), line.extension(output));
                for (Path name : some(names, line, all, turn++)) {
                    Map<String, Path> files = new LinkedHashMap<>(inputs);
                    files.put(output, name);
                    assertRefused(line, files, output + " onto " + victim, output + " ", " would write over ");
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource(names = "TRADE", mode = EnumSource.Mode.EXCLUDE)
    void noTwoOutputsAreOneFile(CommandLines line) throws IOException {
        checkNoTwoOutputsAreOne(line, false);
    }

    @ParameterizedTest
    @Tag("full")
    @EnumSource(names = {"RENDER", "RENDER_KEPT", "ANIMATE", "ANIMATE_SERVER", "SERVER"})
    void noTwoOutputsOfManyAreOneFileByAnyName(CommandLines line) throws IOException {
        checkNoTwoOutputsAreOne(line, true);
    }

    private void checkNoTwoOutputsAreOne(CommandLines line, boolean all) throws IOException {
        int turn = 0;
        for (String first : line.outputs) {
            for (String second : line.outputs) {
                if (first.equals(second) || Set.of(first, second).equals(Set.of("-o", "--aov"))) {
                    continue; // The picture and what lies beside it have different names by their making.
                }
                for (boolean exists : new boolean[] {false, true}) {
                    empty();
                    Map<String, Path> inputs = inputs(line, "", "");
                    Path file = folder.resolve("one" + line.extension(first));
                    if (exists) {
                        Files.writeString(file, "precious");
                    }
                    List<Path> names =
                            exists ? names(file, line.extension(second)) : newNames(file, line.extension(second));
                    for (Path name : some(names, line, all, turn++)) {
                        Map<String, Path> files = new LinkedHashMap<>(inputs);
                        files.put(first, file);
                        files.put(second, name);
                        assertRefused(
                                line, files, first + " and " + second, first, second, " would write the same file");
                    }
                }
            }
        }
    }

    /** The same for a file that is not there yet: links may lead to it all the same. */
    private List<Path> newNames(Path file, String extension) throws IOException {
        Files.createDirectory(folder.resolve("sub"));
        Path linked = Files.createSymbolicLink(folder.resolve("linked"), folder);
        Path soft = Files.createSymbolicLink(folder.resolve("soft" + extension), file.getFileName());
        Path twice = Files.createSymbolicLink(folder.resolve("twice" + extension), soft.toAbsolutePath());
        List<Path> links = List.of(soft, twice, linked.resolve(soft.getFileName()));
        Path name = file.getFileName();
        List<Path> spelled = List.of(file, folder.resolve("sub/../" + name), linked.resolve(name));
        return name.toString().endsWith(extension)
                ? Stream.concat(spelled.stream(), links.stream()).toList()
                : links;
    }

    @Test
    void aTradeWritesOverNoInputUnderAnyOfItsNames() throws IOException {
        CommandLines line = CommandLines.TRADE;
        for (String name : List.of("trade.csv", "settings.txt", "index.html", "reference.pfm", "reference-2.pfm")) {
            for (String victim : line.inputs) {
                empty();
                Map<String, Path> files = inputs(line, victim, name);
                files.put("-o", folder);
                assertRefused(line, files, "-o onto " + victim, "-o would write over ", name);
                Path other = Files.createDirectory(folder.resolve("other"));
                Files.createLink(other.resolve(name), files.get(victim));
                files.put("-o", other);
                assertRefused(line, files, "-o onto a link of " + victim, "-o would write over ", name);
            }
        }
    }

    @Test
    void theInputBesideTheOutputsIsNoneOfThem() throws IOException {
        Map<String, Path> files = inputs(CommandLines.RENDER, "", "");
        files.put("-o", folder.resolve("p.png"));
        files.put("--report", folder.resolve("r.json"));
        files.put("--dump-clusters", folder.resolve("c.json"));
        CliRun run = CliRun.of(CommandLines.RENDER.args(files, folder).toArray());
        assertEquals(0, run.code(), run.err());
    }

    @Test
    void namesThatDifferInCaseOnlyAreTwoFilesWhereTheFileSystemSaysSo() throws IOException {
        Path lower = Files.createFile(folder.resolve("probe"));
        assumeTrue(!Files.exists(folder.resolve("PROBE")), "a file system that tells capital letters from others");
        Files.delete(lower);
        Map<String, Path> files = inputs(CommandLines.RENDER, "", "");
        files.put("-o", folder.resolve("x.png"));
        files.put("--report", folder.resolve("X.png"));
        CliRun run = CliRun.of(CommandLines.RENDER.args(files, folder).toArray());
        assertEquals(0, run.code(), run.err());
        assertTrue(Files.exists(folder.resolve("X.png")) && Files.exists(folder.resolve("x.png")));
    }

    @Test
    void aLinkToNowhereIsToldBeforeTheWork() throws IOException {
        Map<String, Path> files = inputs(CommandLines.RENDER, "", "");
        Path missing = folder.toRealPath().resolve("missing");
        Path link = Files.createSymbolicLink(folder.resolve("o.png"), missing.resolve("p.png"));
        files.put("-o", link);
        CliRun run = CliRun.of(CommandLines.RENDER.args(files, folder).toArray());
        String reason = ": cannot be written: it is a link to where nothing can be written, " + missing;
        assertEquals(new CliRun(1, "", "enlightenment: " + link + reason + "\n"), run);
    }

    @Test
    @Timeout(600)
    void whatAKilledRenderLeftIsGoneWhenTheNextOneStarts() throws Exception {
        Map<String, Path> files = inputs(CommandLines.RENDER, "", "");
        Path out = Files.createDirectory(folder.resolve("out"));
        files.put("-o", out.resolve("p.png"));
        Object[] args = CommandLines.RENDER.args(files, folder).toArray();
        Process killed = JavaProcess.of(HeldRender.class, out.resolve("p.png"))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try {
            assertEquals('r', killed.getInputStream().read());
            assertEquals(1, left(out).size());
            killed.destroyForcibly().waitFor();
        } finally {
            killed.destroyForcibly();
        }
        assertEquals(1, left(out).size());
        // A start is enough, whatever becomes of it: this one is told to stop before it begins.
        ShutdownSignal stop = new ShutdownSignal();
        stop.request();
        assertEquals(1, CliRun.of(stop, args).code());
        assertEquals(List.of(), left(out));
    }

    private static List<Path> left(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toList();
        }
    }

    @Test
    void aDeviceMayBeWrittenToTwice() throws IOException {
        Path nothing = Path.of("/dev/null");
        assumeTrue(Files.exists(nothing));
        Map<String, Path> files = inputs(CommandLines.RENDER, "", "");
        files.put("-o", Files.createSymbolicLink(folder.resolve("o.png"), nothing));
        files.put("--report", nothing);
        CliRun run = CliRun.of(CommandLines.RENDER.args(files, folder).toArray());
        assertEquals(0, run.code(), run.err());
    }
}
