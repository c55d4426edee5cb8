package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.process.JavaProcess;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.work.PictureMemory;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.net.ServerSocket;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures that take more than all of the memory of the commands that make them, against those made in memory. */
class LargePictureTest {
    private static final int HEAP_MIB = 64;
    private static final String FIRE = "scenes/fire-and-ice.json";
    private static final String ROOM = "scenes/cornell-box.json";

    /** Pictures and frames that were made in memory, by the command that made them. */
    private static final Map<List<String>, List<byte[]>> IN_MEMORY = new HashMap<>();

    @TempDir
    private Path folder;

    private static String output(Process process, int code) throws IOException, InterruptedException {
        String output = new String(process.getInputStream().readAllBytes());
        process.waitFor();
        assertEquals(code, process.exitValue(), output);
        return output;
    }

    /** Starts a command in little memory. */
    private static Process start(Object... args) throws IOException {
        ProcessBuilder builder = JavaProcess.of(Main.class, (Object[]) CliRun.quiet(CliRun.texts(args)));
        builder.command().replaceAll(o -> o.startsWith("-Xmx") ? "-Xmx" + HEAP_MIB + "m" : o);
        return builder.redirectErrorStream(true).start();
    }

    private static String run(Object... args) throws IOException, InterruptedException {
        return output(start(args), 0);
    }

    /** The picture made in memory, which is more than the others have. */
    private byte[] inMemory(String scene, String size) throws IOException {
        return inMemory(scene, size, PictureMemory.Films.TILES);
    }

    private byte[] inMemory(String scene, String size, PictureMemory.Films films, Object... more) throws IOException {
        Scene read = SceneReader.read(Path.of(scene));
        String[] sides = size.split("x");
        RenderSettings settings =
                RenderSettings.of(read).withSize(Integer.parseInt(sides[0]), Integer.parseInt(sides[1]));
        long bytes = PictureMemory.of(read, settings, films, 0).bytes();
        assertTrue(bytes > (long) HEAP_MIB << 20, bytes + " bytes would fit");
        List<String> asked = Stream.concat(Stream.of("render", scene, "--size", size, "--samples", 1), Stream.of(more))
                .map(Object::toString)
                .toList();
        return made(asked, "whole.png", "whole.png").get(0);
    }

    /** The files that a command writes in this process; each command runs once. */
    private List<byte[]> made(List<String> command, String output, String... files) throws IOException {
        if (!IN_MEMORY.containsKey(command)) {
            Stream<Object> rest = Stream.of("-o", folder.resolve(output), "--progress", "none");
            CliRun run = CliRun.of(Stream.concat(command.stream(), rest).toArray());
            assertEquals(0, run.code(), run.err());
            List<byte[]> contents = new ArrayList<>();
            for (String file : files) {
                contents.add(Files.readAllBytes(folder.resolve(file)));
            }
            IN_MEMORY.put(command, contents);
        }
        return IN_MEMORY.get(command);
    }

    @ParameterizedTest
    @CsvSource({FIRE + ", 1500x1000", ROOM + ", 900x720"})
    void partsAreMadeAndMergedInLittleMemory(String scene, String size) throws Exception {
        byte[] expected = inMemory(scene, size);
        List<Object> merge = new ArrayList<>(List.of("merge", "-o", folder.resolve("merged.png")));
        for (int part = 1; part <= 2; part++) {
            Path file = folder.resolve(part + ".film");
            run("render", scene, "-o", file, "--part", part + "/2", "--size", size, "--samples", 1);
            merge.add(file);
        }
        run(merge.toArray());
        assertArrayEquals(expected, Files.readAllBytes(folder.resolve("merged.png")));
    }

    @Test
    void pathsFromLightsAreAddedInLittleMemory() throws Exception {
        String size = "560x420";
        byte[] expected = inMemory(ROOM, size, PictureMemory.Films.BOTH, "--method", "bidirectional");
        Path made = folder.resolve("made.png");
        Path part = folder.resolve("1.film");
        Path merged = folder.resolve("merged.png");
        Object[] picture = {"--size", size, "--samples", 1, "--method", "bidirectional"};
        run(Stream.concat(Stream.of("render", ROOM, "-o", made), Stream.of(picture))
                .toArray());
        assertArrayEquals(expected, Files.readAllBytes(made));
        run(Stream.concat(Stream.of("render", ROOM, "-o", part, "--part", "1/1"), Stream.of(picture))
                .toArray());
        run("merge", part, "-o", merged);
        assertArrayEquals(expected, Files.readAllBytes(merged));
    }

    @ParameterizedTest
    @CsvSource({FIRE + ", 1500x1000", ROOM + ", 900x720"})
    void aServerAndItsWorkerMakeThemInLittleMemory(String scene, String size) throws Exception {
        byte[] expected = inMemory(scene, size);
        Path served = folder.resolve("served.png");
        int port;
        try (ServerSocket free = new ServerSocket(0)) {
            port = free.getLocalPort();
        }
        Process server = start(
                "server", scene, "-o", served, "--size", size, "--samples", 1, "--port", port, "--local-threads", 0);
        Process worker = start("worker", "127.0.0.1:" + port);
        try {
            output(server, 0);
            output(worker, 0);
        } finally {
            server.destroyForcibly();
            worker.destroyForcibly();
        }
        assertArrayEquals(expected, Files.readAllBytes(served));
    }

    @ParameterizedTest
    @CsvSource({"'', 1500x1000", "--server --port 0, 1500x1000", "--server --port 0, 900x680"})
    void framesAreMadeInLittleMemory(String more, String size) throws Exception {
        Path pattern = folder.resolve("f-%d.png");
        List<String> command = List.of(
                "animate", "scenes/fire-and-ice-tween.json", "--frames", "3-4", "--size", size, "--samples", "1");
        List<byte[]> expected = made(command, "m-%d.png", "m-3.png", "m-4.png");
        List<Object> words = new ArrayList<>(command);
        words.addAll(List.of("-o", pattern));
        words.addAll(more.isEmpty() ? List.of() : List.of(more.split(" ")));
        run(words.toArray());
        for (int k = 0; k < 2; k++) {
            assertArrayEquals(expected.get(k), Files.readAllBytes(folder.resolve("f-" + (3 + k) + ".png")));
        }
    }

    @Test
    void whoLooksSeesSomeOfTheColumnsAndRows() throws Exception {
        byte[] expected = inMemory(FIRE, "1500x1000");
        Path made = folder.resolve("made.png");
        Process process = start("render", FIRE, "-o", made, "--size", "1500x1000", "--samples", 1, "--serve");
        try (BufferedReader said = process.inputReader()) {
            String line = said.readLine();
            while (!line.contains("http:")) {
                line = said.readLine();
            }
            URL url = new URL(line.substring(line.indexOf("http:")) + "picture.png");
            BufferedImage seen = null;
            while (seen == null && process.isAlive()) {
                try (InputStream in = url.openStream()) {
                    seen = ImageIO.read(in);
                } catch (FileNotFoundException e) {
                    // There is no picture yet.
                    process.waitFor(10, TimeUnit.MILLISECONDS);
                }
            }
            assertEquals(500, seen.getWidth());
            assertEquals(334, seen.getHeight());
            String rest = said.lines().collect(Collectors.joining("\n"));
            assertEquals(0, process.waitFor(), rest);
        } finally {
            process.destroyForcibly();
        }
        assertArrayEquals(expected, Files.readAllBytes(made));
    }

    @Test
    void whatNeedsThePictureInMemoryIsRefusedByName() throws Exception {
        String said =
                output(start("render", ROOM, "-o", folder.resolve("p.png"), "--preview", "--size", "4000x3000"), 2);
        assertTrue(said.contains("a preview needs all of it in memory"), said);
    }
}
