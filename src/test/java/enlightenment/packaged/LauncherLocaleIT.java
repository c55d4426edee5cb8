package enlightenment.packaged;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The locale that the launcher starts Java in: its letters are those of UTF-8 where they would be ASCII's, and nothing else changes. */
@DisabledOnOs(OS.WINDOWS)
class LauncherLocaleIT {
    /** Instead of Java: tells its locale. */
    private static final String JAVA =
            """
            #!/bin/sh
            if [ "$1" = -XshowSettings:properties ]; then
                echo "    java.version = 17.0.1" >&2
                exit 0
            fi
            echo "${LC_ALL-unset} ${LC_CTYPE-unset} ${LANG-unset}"
            """;

    /** As in glibc's systems: C, Turkish in two encodings and, where it is installed, C.UTF-8. */
    private static final String LOCALE =
            """
            #!/bin/sh
            case ${LC_ALL:-${LC_CTYPE:-${LANG:-C}}}:INSTALLED in
                C:* | POSIX:*) echo ANSI_X3.4-1968 ;;
                C.UTF-8:yes | tr_TR.UTF-8:*) echo UTF-8 ;;
                tr_TR:*) echo ISO-8859-9 ;;
                *)
                    echo "locale: Cannot set LC_CTYPE to default locale: No such file or directory" >&2
                    echo "locale: Cannot set LC_ALL to default locale: No such file or directory" >&2
                    echo ANSI_X3.4-1968
                    ;;
            esac
            """;

    @TempDir
    static Path common;

    private static Path launcher;

    @TempDir
    Path folder;

    @BeforeAll
    static void unpack() throws IOException {
        launcher = UnpackedZip.into(common).resolve("bin/enlightenment");
    }

    private static void script(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        assertTrue(Files.writeString(file, text).toFile().setExecutable(true));
    }

    @ParameterizedTest
    @CsvSource({
        // Before, and whether there is C.UTF-8 or even locale(1); after.
        "'','','',            yes,     unset C.UTF-8 unset",
        "C,'','',             yes,     C.UTF-8 unset unset",
        "POSIX,'',tr_TR,      yes,     C.UTF-8 unset tr_TR",
        "'',C,tr_TR.UTF-8,    yes,     unset C.UTF-8 tr_TR.UTF-8",
        "'','',POSIX,         yes,     unset C.UTF-8 POSIX",
        "'','',tr_TR.UTF-8,   yes,     unset unset tr_TR.UTF-8",
        "'','',tr_TR,         yes,     unset unset tr_TR",
        "tr_TR.UTF-8,C,C,     yes,     tr_TR.UTF-8 C C",
        "C.UTF-8,'','',       yes,     C.UTF-8 unset unset",
        "'','',de_DE.UTF-8,   yes,     C.UTF-8 unset de_DE.UTF-8",
        "'',UTF-8,'',         yes,     C.UTF-8 UTF-8 unset",
        "C,'','',             no,      C unset unset",
        "'','',de_DE.UTF-8,   no,      unset unset de_DE.UTF-8",
        "'','','',            missing, unset C.UTF-8 unset",
        "C,'','',             missing, C.UTF-8 unset unset",
        "'','',tr_TR,         missing, unset unset tr_TR",
    })
    void onlyTheLettersOfALocaleChangeAndOnlyWhereTheyAreAscii(
            String all, String letters, String language, String installed, String after) throws Exception {
        script(folder.resolve("java/bin/java"), JAVA);
        Path tools = Files.createDirectories(folder.resolve("tools"));
        for (String tool : List.of("readlink", "cksum", "ls", "sed", "mkdir")) {
            Path place = Stream.of("/bin", "/usr/bin")
                    .map(bin -> Path.of(bin, tool))
                    .filter(Files::isExecutable)
                    .findFirst()
                    .orElseThrow();
            script(tools.resolve(tool), "#!/bin/sh\nexec " + place + " \"$@\"\n");
        }
        if (!installed.equals("missing")) {
            script(tools.resolve("locale"), LOCALE.replace("INSTALLED", installed));
        }
        Map<String, String> environment =
                new HashMap<>(Map.of("JAVA_HOME", folder.resolve("java").toString(), "PATH", tools.toString()));
        environment.putAll(Map.of("LC_ALL", all, "LC_CTYPE", letters, "LANG", language));
        Packages.Run run = Packages.run(folder, environment, launcher, "help");
        assertEquals(after + "\n", run.out(), run::toString);
        assertEquals("", run.err());
    }

    @Test
    void namesWithUmlautsWorkInALocaleWithoutThem() throws Exception {
        assumeTrue("UTF-8".equals(System.getProperty("sun.jnu.encoding")), "names of files are not in UTF-8");
        Map<String, String> environment = Map.of("JAVA_HOME", System.getProperty("java.home"), "LC_ALL", "C");
        try {
            Packages.Run locales = Packages.run(folder, Map.of("LC_ALL", "C.UTF-8"), "locale", "charmap");
            assumeTrue(locales.out().equals("UTF-8\n"), "there is no C.UTF-8");
        } catch (IOException e) {
            assumeTrue(false, "there is no locale(1)");
        }
        Path home = UnpackedZip.into(Files.createDirectory(folder.resolve("\u00e4 p p")));
        Path here = Files.createDirectory(folder.resolve("\u00f6"));
        Files.copy(Packages.SCENE, here.resolve("\u00fc.json"));
        Packages.Run run = Packages.run(
                here,
                environment,
                home.resolve("bin/enlightenment"),
                "render",
                "\u00fc.json",
                "--size",
                "8x8",
                "-o",
                "\u00e4.png",
                "--progress",
                "none");
        assertEquals(0, run.code(), run::toString);
        assertTrue(Files.size(here.resolve("\u00e4.png")) > 0);
    }
}
