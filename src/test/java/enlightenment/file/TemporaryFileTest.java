package enlightenment.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.UserPrincipal;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(600)
class TemporaryFileTest {
    @TempDir
    Path folder;

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void whatAKilledProcessLeftIsRemovedAndWhatALivingOneWritesIsNot() throws Exception {
        Path target = folder.resolve("picture.png");
        Process living = Holder.start("write", target);
        Process killed = Holder.start("write", target);
        try {
            assertEquals(2, names().size());
            TemporaryFile.clean(folder);
            assertEquals(2, names().size(), "both are alive");
            killed.destroyForcibly().waitFor();
            assertEquals(2, names().size(), "a killed process cannot tidy up");
            TemporaryFile.clean(folder);
            assertEquals(1, names().size(), "one is alive");
            assertTrue(names().get(0).contains("-" + living.pid() + "-"), names().toString());
        } finally {
            living.destroyForcibly().waitFor();
            killed.destroyForcibly().waitFor();
        }
        assertFalse(Files.exists(target));
        TemporaryFile.clean(folder);
        assertEquals(List.of(), names());
    }

    @Test
    void ourOwnFilesInUseStayAndThoseOfAFormerProcessOfOurNumberGo() throws IOException {
        try (TemporaryFile own = TemporaryFile.in(folder)) {
            Path inner = Files.writeString(own.folder().resolve("inner"), "x");
            TemporaryFile.clean(folder);
            assertTrue(Files.exists(inner));
            assertEquals(2, names().size());
            Path former = folder.resolve(names().get(0).replaceFirst("-[0-9a-f]+\\.tmp$", "-0.tmp"));
            Files.writeString(former, "of the process that had our number before the machine was started again");
            TemporaryFile.clean(folder);
            assertFalse(Files.exists(former));
            assertEquals(2, names().size());
        }
        assertEquals(List.of(), names());
    }

    @Test
    void whatAnotherMachineWritesGoesWhenItIsOldAndNobodyHasItLocked() throws Exception {
        String other = HostTag.HASH.equals("1") ? "2" : "1";
        Path young = Files.writeString(folder.resolve(".enlightenment-" + other + "-12-ab.tmp"), "x");
        Path old = Files.writeString(folder.resolve(".enlightenment-" + other + "-12-cd.tmp"), "x");
        Path locked = Files.writeString(folder.resolve(".enlightenment-" + other + "-12-ef.tmp"), "x");
        FileTime longAgo = FileTime.from(Instant.now().minus(Duration.ofDays(2)));
        Process holder = Holder.start("lock", locked);
        try {
            Files.setLastModifiedTime(old, longAgo);
            Files.setLastModifiedTime(locked, longAgo);
            TemporaryFile.clean(folder);
            assertTrue(Files.exists(young));
            assertFalse(Files.exists(old));
            assertTrue(Files.exists(locked));
        } finally {
            holder.destroyForcibly().waitFor();
        }
        TemporaryFile.clean(folder);
        assertFalse(Files.exists(locked));
    }

    @Test
    void whatIsNotOursStays() throws IOException {
        for (String name : List.of(".enlightenment-notes.tmp", ".enlightenment-1-2-3.tmp.png", "enlightenment.tmp")) {
            Files.writeString(folder.resolve(name), "x");
        }
        Path precious = Files.writeString(folder.resolve("precious"), "x");
        long pid = ProcessHandle.current().pid();
        Path link = folder.resolve(".enlightenment-" + HostTag.HASH + "-" + pid + "-1.tmp");
        Files.createSymbolicLink(link, precious);
        Files.createDirectory(folder.resolve(".enlightenment-" + HostTag.HASH + "-" + pid + "-2.tmp"));
        List<String> before = names();
        TemporaryFile.clean(folder);
        assertEquals(before, names());
        TemporaryFile.clean(folder.resolve("missing"));
    }

    @Test
    void whatAnotherUserOwnsStays() throws IOException {
        long pid = ProcessHandle.current().pid();
        Path theirs = folder.resolve(".enlightenment-" + HostTag.HASH + "-" + pid + "-1.tmp");
        Files.writeString(theirs, "x");
        UserPrincipal ours = Files.getOwner(theirs);
        try {
            Files.setOwner(
                    theirs,
                    folder.getFileSystem().getUserPrincipalLookupService().lookupPrincipalByName("nobody"));
            assumeFalse(ours.equals(Files.getOwner(theirs)), "we are nobody");
        } catch (IOException | UnsupportedOperationException e) {
            assumeTrue(false, "only the superuser can try this");
        }
        TemporaryFile.clean(folder);
        assertEquals(1, names().size());
    }

    @Test
    void theFirstFileThatIsWrittenToAFolderCleansIt() throws IOException {
        long pid = ProcessHandle.current().pid();
        Files.writeString(folder.resolve(".enlightenment-" + HostTag.HASH + "-" + pid + "-1.tmp"), "half");
        WholeFile.write(folder.resolve("a"), "whole");
        assertEquals(List.of("a"), names());
    }
}
