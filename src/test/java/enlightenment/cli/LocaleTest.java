package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.process.JavaProcess;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Names with umlauts where the locale has none, as in cron, batch systems and containers. */
@Timeout(300)
class LocaleTest {
    private static final String HELP = " cannot be expressed in this locale (US-ASCII); LC_ALL=C.UTF-8 helps";

    /** So many bytes has an umlaut in UTF-8, and each is shown like this in ASCII. */
    private static final String UMLAUT = "??";

    @TempDir
    Path folder;

    private Path scene;

    @BeforeEach
    void fileNamesAreInUtf8HereAndInAsciiThere() throws Exception {
        assumeTrue("UTF-8".equals(System.getProperty("sun.jnu.encoding")), "names of files are not in UTF-8");
        scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        List<String> encoding = lines(folder, Encoding.class);
        assumeTrue(encoding.equals(List.of("US-ASCII")), "names of files are in " + encoding + " with LC_ALL=C");
    }

    /** Tells how names of files are encoded. */
    public static final class Encoding {
        private Encoding() {}

        public static void main(String[] args) {
            System.out.println(java.nio.charset.Charset.forName(System.getProperty("sun.jnu.encoding")));
        }
    }

    private List<String> lines(Path workingFolder, Class<?> main, Object... args) throws Exception {
        Path log = folder.resolve("log");
        ProcessBuilder builder = JavaProcess.of(main, args)
                .directory(workingFolder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(log.toFile());
        builder.environment().put("LC_ALL", "C");
        assertEquals(0, builder.start().waitFor());
        return new String(Files.readAllBytes(log), StandardCharsets.US_ASCII)
                .lines()
                .toList();
    }

    /** Runs commands, each an array, in one process; what they say is what is expected, each with an exit code of 2. */
    private void assertTold(Path workingFolder, Object[][] commands, String... expected) throws Exception {
        List<Object> args = new ArrayList<>();
        for (Object[] command : commands) {
            if (!args.isEmpty()) {
                args.add("|");
            }
            args.addAll(Arrays.asList(command));
        }
        List<String> all = new ArrayList<>();
        for (String line : expected) {
            all.add(line);
            all.add("2");
        }
        assertEquals(all, lines(workingFolder, LocaleProbe.class, args.toArray()));
    }

    private static String cannot(String what, String name) {
        return "enlightenment: " + what + " cannot be used: the name \"" + name + "\"" + HELP;
    }

    @Test
    void namesThatCannotBeExpressedAreToldByAllCommands() throws Exception {
        String text = Files.readString(scene)
                .replace(
                        "\"color\": \"#ffffff\" } }",
                        "\"color\": { \"texture\": \"t\" } } },\n\"textures\": { \"t\": { \"file\":\n \"\u00fc.png\" } }");
        Path textured = Files.writeString(folder.resolve("textured.json"), text);
        long line = text.substring(0, text.indexOf('\u00fc')).lines().count();
        assertTold(
                folder,
                new Object[][] {
                    {"validate", "\u00fc.json"},
                    {"render", scene, "-o", "\u00f6.png"},
                    {"render", scene, "-o", "o.png", "--report", "\u00f6.json"},
                    {"render", scene, "-o", "o.png", "--store", "\u00f6.db"},
                    {"compare", "\u00e4.png", "b.png"},
                    {"animate", scene, "-o", "\u00f6/%d.png"},
                    {"store-info", "jdbc:sqlite:\u00f6.db"},
                    {"validate", textured.getFileName()},
                },
                cannot("SCENE", UMLAUT + ".json"),
                cannot("--output", UMLAUT + ".png"),
                cannot("--report", UMLAUT + ".json"),
                "enlightenment: the name \"" + UMLAUT + ".db\"" + HELP,
                cannot("A", UMLAUT + ".png"),
                cannot("--output", UMLAUT + "/%d.png"),
                "enlightenment: the name \"" + UMLAUT + ".db\"" + HELP,
                "textured.json:" + line + ":2: /textures/t/file: the name \"?.png\"" + HELP);
    }

    @Test
    void aWorkingFolderThatCannotBeExpressedIsToldWhereNamesAreRelativeToIt() throws Exception {
        Path here = Files.createDirectory(folder.resolve("\u00e4"));
        Files.copy(scene, here.resolve("b.json"));
        String problem = "the working folder \"" + folder.toRealPath() + "/" + UMLAUT + "\"" + HELP;
        assertTold(
                here,
                new Object[][] {
                    {"render", "b.json", "-o", folder.resolve("o.png")},
                    {"render", scene, "-o", "o.png"},
                    {"animate", scene, "-o", "%d.png"},
                    {"render", scene, "-o", folder.resolve("o.png"), "--store", "s.db"},
                },
                "enlightenment: SCENE cannot be used: " + problem,
                "enlightenment: --output cannot be used: " + problem,
                "enlightenment: --output cannot be used: " + problem,
                "enlightenment: " + problem);
        assertEquals(List.of(scene + ": valid", "0"), lines(here, LocaleProbe.class, "validate", scene));
    }
}
