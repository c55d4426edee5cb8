package enlightenment.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import enlightenment.mesh.input.MeshSource;
import enlightenment.mesh.input.MtlFile;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Reads all files below the folder that {@code -Dmodels=FOLDER} names, whatever they hold: {@code mvn -Pmodels test -Dmodels=FOLDER}. Each may take
 * 5 seconds of CPU time and allocate 64 MB and 40 bytes for each of its own. What a thread allocates in all is more than what it holds at any time.
 */
@Tag("models")
class RealModelsTest {
    private static final Duration SOME_MINUTES = Duration.ofMinutes(10);
    private static final double SECONDS = 5;
    private static final long MUTATED = 10_000;
    private static final List<String> EXTENSIONS = List.of("ply", "obj", "stl", "serialized");
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private final Map<String, Integer> counts = new TreeMap<>();
    private List<Path> files = List.of();

    private interface Reading {
        void run() throws IOException;
    }

    @BeforeEach
    void findFiles() throws IOException {
        String folder = System.getProperty("models");
        if (folder == null) {
            System.out.println("RealModelsTest is skipped: -Dmodels=FOLDER names no folder of models");
        }
        assumeTrue(folder != null, "-Dmodels=FOLDER names no folder");
        try (Stream<Path> all = Files.walk(Path.of(folder))) {
            files = all.filter(Files::isRegularFile).sorted().toList();
        }
        assertTrue(files.stream().anyMatch(f -> EXTENSIONS.contains(extension(f))), folder + " holds no model");
    }

    private static String extension(Path file) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /** Reads within the limits; an IOException has to be one line that begins with the name. */
    private boolean isRead(String label, String name, long size, Reading reading) {
        long id = Thread.currentThread().getId();
        long allocated = THREADS.getThreadAllocatedBytes(id);
        long time = THREADS.getCurrentThreadCpuTime();
        String problem = null;
        try {
            reading.run();
        } catch (IOException e) {
            problem = e.getMessage();
        } catch (RuntimeException | Error e) {
            throw new AssertionError(label, e);
        }
        double seconds = (THREADS.getCurrentThreadCpuTime() - time) * 1e-9;
        long bytes = THREADS.getThreadAllocatedBytes(id) - allocated;
        assertTrue(seconds < SECONDS, () -> label + " took " + seconds + " s");
        assertTrue(bytes < 64_000_000 + 40 * size, () -> label + ", " + size + " bytes, allocated " + bytes);
        if (problem == null) {
            return true;
        }
        String line = problem;
        assertTrue(line.startsWith(name + ": ") && line.length() < name.length() + 400, () -> label + ": " + line);
        assertTrue(line.chars().noneMatch(c -> c < ' ' || c >= 127 && c < 160), () -> label + ": " + line);
        String kind = line.substring(name.length() + 2)
                .replaceAll("\".*\"", "\"...\"")
                .replaceAll("0x[0-9a-f]+|-?[0-9][-+.E0-9]*|NaN|-?Infinity", "N");
        counts.merge(name.substring(name.lastIndexOf('.') + 1) + ": " + kind, 1, Integer::sum);
        return false;
    }

    private void summarize(String title, int read) {
        System.out.println(title + ": " + read + " read, "
                + counts.values().stream().mapToInt(n -> n).sum() + " refused");
        counts.forEach((kind, n) -> System.out.printf("%7d  %s%n", n, kind));
    }

    @Test
    void eachModelIsReadOrRefusedWithinItsLimits() {
        assertTimeoutPreemptively(SOME_MINUTES, () -> {
            int read = 0;
            for (Path file : files) {
                String extension = extension(file);
                if (EXTENSIONS.contains(extension) || extension.equals("mtl")) {
                    List<MeshFiles.Part> parts = new ArrayList<>();
                    Reading reading = extension.equals("mtl")
                            ? () -> MtlFile.read(file)
                            : () -> parts.addAll(MeshFiles.read(file, MeshFiles.MAX_TRIANGLES));
                    if (isRead(file.toString(), file.toString(), Files.size(file), reading)) {
                        read++;
                        checkTriangles(file, extension, parts);
                    }
                }
            }
            summarize("Models", read);
            assertTrue(read > 0);
        });
    }

    /** Compares the number of triangles with that of a plain count of words, where there is one. */
    private static void checkTriangles(Path file, String extension, List<MeshFiles.Part> parts) throws IOException {
        long expected =
                switch (extension) {
                    case "obj" -> triangles(file, "f");
                    case "stl" -> stlTriangles(file);
                    default -> -1;
                };
        long found = parts.stream()
                .mapToLong(p -> p.mesh().triangles() + p.mesh().dropped())
                .sum();
        // Of an OBJ file's materials without any area nothing is left, not even the count.
        boolean isOfMany = extension.equals("obj") && parts.size() > 1;
        boolean isEqual = expected < 0 || found == expected || isOfMany && found < expected;
        assertTrue(isEqual, () -> file + " has " + expected + " triangles, of which " + found + " were found");
    }

    private static long stlTriangles(Path file) throws IOException {
        byte[] all = Files.readAllBytes(file);
        boolean isText = new String(all, StandardCharsets.ISO_8859_1).matches("(?s)\\s*solid.*facet.*");
        return isText ? triangles(file, "vertex") / 3 : (all.length - 84) / 50;
    }

    /** By the words of lines that begin with a word: for f those behind the second, else the lines. */
    private static long triangles(Path file, String first) throws IOException {
        String text = Files.readString(file, StandardCharsets.ISO_8859_1).replaceAll("\\\\\r?\n", " ");
        return text.lines()
                .map(line -> line.replaceAll("#.*", "").strip().split("\\s+"))
                .filter(words -> words[0].equals(first))
                .mapToLong(words -> first.equals("f") ? words.length - 3 : 1)
                .sum();
    }

    @Test
    void anyFileIsReadOrRefusedByTheNameOfEachFormat() {
        assertTimeoutPreemptively(SOME_MINUTES, () -> {
            int read = 0;
            for (Path file : files) {
                byte[] content = Files.readAllBytes(file);
                for (String extension : EXTENSIONS) {
                    String name = "a." + extension;
                    read += isRead(
                                    file + " as " + extension,
                                    name,
                                    content.length,
                                    () -> MeshFiles.read(content, name, MeshFiles.MAX_TRIANGLES))
                            ? 1
                            : 0;
                }
                MeshSource source = MeshSource.of(content, "a.mtl");
                isRead(file + " as mtl", "a.mtl", content.length, () -> MtlFile.read(source));
            }
            summarize("Files by the name of each format", read);
        });
    }

    @Test
    void mutatedModelsAreReadOrRefused() throws IOException {
        List<Path> small = files.stream()
                .filter(f -> EXTENSIONS.contains(extension(f)) && f.toFile().length() > 0)
                .filter(f -> f.toFile().length() < 200_000)
                .toList();
        assumeTrue(!small.isEmpty(), "no models of at most 200 kB");
        assertTimeoutPreemptively(SOME_MINUTES, () -> {
            Random random = new Random(22);
            int read = 0;
            for (int i = 0; i < MUTATED; i++) {
                Path file = small.get(random.nextInt(small.size()));
                byte[] content = MutatedFiles.mutated(Files.readAllBytes(file), random);
                String name = "a." + extension(file);
                read += isRead(
                                file + ", mutation " + i,
                                name,
                                content.length,
                                () -> MeshFiles.read(content, name, MeshFiles.MAX_TRIANGLES))
                        ? 1
                        : 0;
            }
            summarize("Mutated models", read);
            assertEquals(
                    MUTATED, read + counts.values().stream().mapToInt(n -> n).sum());
        });
    }
}
