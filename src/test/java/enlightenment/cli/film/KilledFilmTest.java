package enlightenment.cli.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.cli.CliRun;
import enlightenment.cli.Processes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** A film as a process of its own, alone and as a server in turns, which is killed as {@code kill -9} does, again and again. */
@Timeout(600)
class KilledFilmTest {
    private static final int FRAMES = 40;
    private static final String ANIMATION =
            """
            , "animation": { "frames": FRAMES, "framesPerSecond": 25,
              "tracks": [{ "target": "/objects/0/radius", "keys": { "0": 1, "39": 2 } }] }}
            """
                    .replace("FRAMES", Integer.toString(FRAMES));

    @TempDir
    Path folder;

    @RegisterExtension
    final Processes processes = new Processes();

    private Path frames;
    private Path film;

    private Path scene() throws IOException {
        Path file = CliRun.scene(folder, "\"width\": 48, \"height\": 36");
        String text = Files.readString(file);
        return Files.writeString(file, text.substring(0, text.lastIndexOf('}')) + ANIMATION);
    }

    private Processes.Running start(Path scene, boolean isServer) throws IOException {
        List<Object> args = new ArrayList<>(List.of("animate", scene, "-o", frames.resolve("f-%02d.png")));
        args.addAll(List.of("--antialias", 6, "--video", film));
        if (isServer) {
            args.addAll(List.of("--server", "--port", 0, "--local-threads", 2));
        }
        return processes.start(folder, args.toArray());
    }

    /** Names and contents of what lies there. */
    private static Map<String, byte[]> contents(Path folder) throws IOException {
        Map<String, byte[]> all = new TreeMap<>();
        if (Files.exists(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : files.toList()) {
                    all.put(file.getFileName().toString(), Files.readAllBytes(file));
                }
            }
        }
        return all;
    }

    private int frameCount() throws IOException {
        String[] names = frames.toFile().list((dir, name) -> name.endsWith(".png"));
        return names == null ? 0 : names.length;
    }

    private void check(int kills, long seed) throws Exception {
        Path scene = scene();
        frames = folder.resolve("plain");
        Path plainFilm = folder.resolve("plain.apng");
        CliRun run =
                CliRun.of("animate", scene, "-o", frames.resolve("f-%02d.png"), "--antialias", 6, "--video", plainFilm);
        assertEquals(0, run.code(), run.err());
        Map<String, byte[]> plain = contents(frames);
        assertEquals(FRAMES, plain.size());
        frames = folder.resolve("killed");
        film = folder.resolve("killed.apng");
        Random random = new Random(seed);
        List<Integer> kept = new ArrayList<>();
        for (int k = 0; k < kills; k++) {
            int there = frameCount();
            // Somewhere in the next frames, all of which have their turn, and the first time before there is one.
            int most = FRAMES * (k + 1) / (kills + 2);
            int count = k == 0 ? 0 : Math.min(there + random.nextInt(Math.max(most - there, 1)), FRAMES);
            int nanosMore = random.nextInt(k == 0 ? 1_500_000_000 : 30_000_000);
            Processes.Running running = start(scene, k % 2 == 1);
            long end = System.nanoTime() + (k == 0 ? nanosMore : 0);
            // The first one dies while it starts, or with its first frame where that comes soon.
            boolean isKilled = k == 0
                    ? running.killOnce(() -> frameCount() > 0 || System.nanoTime() - end >= 0, 0)
                    : running.killOnce(() -> frameCount() >= count, nanosMore);
            if (!isKilled) {
                break;
            }
            kept.add(frameCount());
            for (Map.Entry<String, byte[]> e : contents(frames).entrySet()) {
                if (e.getKey().endsWith(".png")) {
                    assertArrayEquals(plain.get(e.getKey()), e.getValue(), e.getKey() + " after " + kept + " frames");
                }
            }
        }
        assertTrue(kept.size() >= kills - 1, "killed after " + kept + " frames");
        start(scene, kills % 2 == 1).ended(0);
        Map<String, byte[]> result = contents(frames);
        assertEquals(plain.keySet(), result.keySet(), "files after kills at " + kept + " frames");
        for (String name : plain.keySet()) {
            assertArrayEquals(plain.get(name), result.get(name), name + " after kills at " + kept + " frames");
        }
        assertArrayEquals(Files.readAllBytes(plainFilm), Files.readAllBytes(film));
    }

    @Test
    void killedTwiceItMakesTheSameFiles() throws Exception {
        check(2, 1);
    }

    @Test
    @Tag("full")
    void killedAtTwentyRandomMomentsInARowItMakesTheSameFiles() throws Exception {
        check(20, 2);
    }
}
