package enlightenment.packaged;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The completion script of the zip, asked as bash asks it, and the man page. */
@DisabledOnOs(OS.WINDOWS)
class ApplicationTextsIT {
    /** Completes the last of the words and shows what it found. */
    private static final String COMPLETE =
            """
            compopt() { :; }
            source "$1"
            shift
            COMP_WORDS=("$@")
            COMP_CWORD=$(($# - 1))
            COMP_LINE="$*"
            COMP_POINT=${#COMP_LINE}
            COMP_TYPE=9
            _complete_enlightenment enlightenment
            printf '%s\\n' "${COMPREPLY[@]}"
            """;

    @TempDir
    Path folder;

    private Path share;

    @BeforeEach
    void unpack() throws IOException {
        share = UnpackedZip.into(folder).resolve("share");
    }

    private TreeSet<String> complete(String... words) throws Exception {
        Object[] command = new Object[words.length + 6];
        command[0] = "bash";
        command[1] = "--norc";
        command[2] = "-c";
        command[3] = COMPLETE;
        command[4] = "complete";
        command[5] = share.resolve("bash-completion/completions/enlightenment");
        System.arraycopy(words, 0, command, 6, words.length);
        Packages.Run run = Packages.run(folder, Map.of(), command);
        assertEquals("", run.err());
        TreeSet<String> found = new TreeSet<>();
        run.out().lines().map(String::strip).filter(line -> !line.isEmpty()).forEach(found::add);
        return found;
    }

    @Test
    void commandsAreCompleted() throws Exception {
        assertEquals(new TreeSet<>(List.of("render", "render-store")), complete("enlightenment", "ren"));
        assertTrue(complete("enlightenment", "").containsAll(List.of("validate", "setup", "completion", "help")));
    }

    @Test
    void optionsAreCompleted() throws Exception {
        assertEquals(
                new TreeSet<>(List.of(
                        "--samples",
                        "--seed",
                        "--serve",
                        "--shadow-samples",
                        "--size",
                        "--stats",
                        "--store",
                        "--store-password-file",
                        "--store-rays",
                        "--store-samples",
                        "--store-user")),
                complete("enlightenment", "render", "--s"));
    }

    @Test
    void valuesOfClosedVocabulariesAreCompleted() throws Exception {
        assertEquals(
                List.of("auto", "bidirectional", "bidirectional-cluster", "cluster", "light", "metropolis", "raytrace"),
                List.copyOf(complete("enlightenment", "render", "--method", "")));
        assertEquals(List.of("cluster"), List.copyOf(complete("enlightenment", "render", "--method", "c")));
        assertEquals(
                List.of("linear", "normal", "zeta"),
                List.copyOf(complete("enlightenment", "render", "--proposal", "")));
        assertEquals(List.of("16", "32", "8"), List.copyOf(complete("enlightenment", "render", "--depth", "")));
        assertEquals(
                List.of("auto", "bar", "none", "plain"),
                List.copyOf(complete("enlightenment", "server", "--progress", "")));
    }

    @Test
    void filesAreCompletedWhereFilesAreMeant() throws Exception {
        Files.writeString(folder.resolve("tracery.json"), "");
        assertEquals(List.of("tracery.json"), List.copyOf(complete("enlightenment", "render", "-o", "trac")));
        assertEquals(List.of("tracery.json"), List.copyOf(complete("enlightenment", "validate", "trac")));
    }

    @Test
    void theManPageNamesEveryCommand() throws Exception {
        String page = Files.readString(share.resolve("man/man1/enlightenment.1"));
        assertTrue(page.startsWith(".TH ENLIGHTENMENT 1 \"\" \"Enlightenment " + Packages.VERSION + "\""));
        for (String command : complete("enlightenment", "").stream()
                .filter(word -> !word.startsWith("-"))
                .toList()) {
            assertTrue(page.contains("\n.SS enlightenment " + command.replace("-", "\\-")), command);
        }
    }
}
