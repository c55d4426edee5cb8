package enlightenment.cli.store;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What SQLite keeps beside the file of a store is as little written over as the store, by whatever name that is given. */
class StoreFilesTest {
    @TempDir
    Path folder;

    private Path scene;
    private Path password;

    /** All that the store can be called. */
    private final List<String> names = new ArrayList<>();

    @BeforeEach
    void makeInputs() throws IOException {
        scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        password = Files.writeString(folder.resolve("password"), "secret\n");
        Path store = folder.resolve("s.db");
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
        Path link = Files.createSymbolicLink(elsewhere.resolve("link.db"), store);
        names.addAll(List.of(store.toString(), link.toString()));
        names.addAll(List.of("jdbc:sqlite:" + store, "JDBC:SQLite:" + store, "jdbc:sqlite:" + link + "?cache=shared"));
    }

    private long count() throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.count();
        }
    }

    private void assertRefused(String words, Object... args) throws IOException {
        long before = count();
        CliRun run = CliRun.of(args);
        String told = List.of(args) + ": " + run.err();
        assertEquals(2, run.code(), told);
        assertTrue(run.err().contains(words), told);
        assertEquals(1, run.errLines().size(), told);
        assertEquals(before, count(), told);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-wal", "-shm", "-journal"})
    void noOutputLiesWhereAStoreIsToBe(String suffix) throws IOException {
        Path file = folder.resolve("s.db" + suffix);
        Path picture = folder.resolve("p.png");
        for (String name : names) {
            for (String option : List.of("--report", "--checkpoint")) {
                String same = " would write the same file, ";
                assertRefused(same, "render", scene, "-o", picture, "--store", name, option, file);
                assertRefused(same, "server", scene, "-o", picture, "--port", 0, "--store", name, option, file);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-wal", "-shm", "-journal"})
    void noStoreIsMadeAroundAnInput(String suffix) throws IOException {
        Path input = Files.copy(scene, folder.resolve("s.db" + suffix));
        for (String name : names) {
            assertRefused(
                    "--store would write over the scene, ",
                    "render",
                    input,
                    "-o",
                    folder.resolve("p.png"),
                    "--store",
                    name);
        }
        assertEquals(Files.readString(scene), Files.readString(input));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-wal", "-shm", "-journal"})
    void whatIsMadeFromAStoreDoesNotReplaceIt(String suffix) throws IOException {
        Path file = Files.writeString(folder.resolve("s.db" + suffix), "precious");
        Path picture = Files.createSymbolicLink(folder.resolve("p.png"), file.getFileName());
        String over =
                suffix.isEmpty() ? " would write over the store, " : " would write over what lies beside the store, ";
        for (String name : names) {
            assertRefused("-o" + over, "render-store", name, "-o", picture);
            assertRefused("--report" + over, "render-store", name, "-o", folder.resolve("q.png"), "--report", file);
            assertRefused("--csv" + over, "store-export", name, "--csv", file);
        }
        assertEquals("precious", Files.readString(file));
    }

    @Test
    void aCheckpointAndAStoreLieSideBySide() {
        Path picture = folder.resolve("p.png");
        Path checkpoint = folder.resolve("s.ck");
        CliRun run = CliRun.of(
                "render",
                scene,
                "-o",
                picture,
                "--store",
                names.get(1),
                "--store-password-file",
                password,
                "--checkpoint",
                checkpoint);
        assertEquals(0, run.code(), run.err());
        assertTrue(Files.isRegularFile(picture) && Files.isRegularFile(checkpoint));
        assertTrue(Files.isRegularFile(folder.resolve("s.db")));
    }
}
