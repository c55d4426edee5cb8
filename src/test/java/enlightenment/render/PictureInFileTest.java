package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.ImageFormat;
import enlightenment.math.InvalidValueException;
import enlightenment.physical.InvarianceScenes;
import enlightenment.picture.Exposure;
import enlightenment.process.JavaProcess;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.work.PictureMemory;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Pictures whose pixels are kept in a file while they are rendered, against those in memory. */
class PictureInFileTest {
    private static final Scene FIRE = TestScenes.whiteFireAndIce().build();
    private static final Scene CAUSTICS = InvarianceScenes.byRadiance();
    private static final Scene ROOM = SceneReader.read(Path.of("scenes/cornell-box.json"));

    /** No picture is small enough for memory. */
    private static final long NOTHING = 0;

    /** Of the process that stops a large picture. */
    private static final int HEAP_MIB = 64;

    private static final int LARGE_WIDTH = 3000;
    private static final int LARGE_HEIGHT = 2000;

    @TempDir
    private Path folder;

    /** What is rendered. */
    record Kind(String name, Scene scene, RenderSettings settings) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static RenderSettings of(Scene scene, Method method, double samples) {
        return RenderSettings.of(scene)
                .withMethod(method)
                .withSize(45, 37)
                .withThreads(2)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
    }

    static Stream<Kind> kinds() {
        RenderSettings fire = of(FIRE, BuiltInMethod.RAYTRACE, 4).with(new BuiltInMethod.RayTraceSettings(2));
        RenderSettings room = of(ROOM, BuiltInMethod.RAYTRACE, 8);
        RenderSettings.Crop crop = new RenderSettings.Crop(11, 5, 21, 30);
        return Stream.of(
                new Kind("classic", FIRE, fire),
                new Kind("classic, one sample", FIRE, of(FIRE, BuiltInMethod.RAYTRACE, 1)),
                new Kind("classic, crop", FIRE, fire.withCrop(crop)),
                new Kind("classic, tiles of 7", FIRE, fire.withTileSize(7)),
                new Kind("cluster", FIRE, of(FIRE, BuiltInMethod.CLUSTER, 9)),
                new Kind("physical", ROOM, room),
                new Kind("physical, one sample", ROOM, of(ROOM, BuiltInMethod.RAYTRACE, 1)),
                new Kind("physical, two samples", ROOM, of(ROOM, BuiltInMethod.RAYTRACE, 2)),
                new Kind("physical, crop, tiles of 5", ROOM, room.withCrop(crop).withTileSize(5)),
                new Kind("light", ROOM, of(ROOM, BuiltInMethod.LIGHT, 1)),
                new Kind("light, two samples", ROOM, of(ROOM, BuiltInMethod.LIGHT, 2)),
                new Kind(
                        "light, three samples, crop",
                        ROOM,
                        of(ROOM, BuiltInMethod.LIGHT, 3).withCrop(crop)),
                new Kind("bidirectional", ROOM, of(ROOM, BuiltInMethod.BIDIRECTIONAL, 8)),
                new Kind("caustics, one sample", CAUSTICS, of(CAUSTICS, BuiltInMethod.RAYTRACE, 1)),
                new Kind(
                        "caustics, tiles of 5",
                        CAUSTICS,
                        of(CAUSTICS, BuiltInMethod.RAYTRACE, 16).withTileSize(5)),
                new Kind("metropolis", ROOM, of(ROOM, BuiltInMethod.METROPOLIS, 16)));
    }

    private static List<byte[]> files(Image image) throws IOException {
        List<byte[]> all = new ArrayList<>();
        for (ImageFormat format : List.of(ImageFormat.PNG, ImageFormat.PFM, ImageFormat.EXR, ImageFormat.JPEG)) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            ImageFiles.write(image, out, format, new ImageFiles.PngOptions(8, Map.of("Title", "t")));
            all.add(out.toByteArray());
        }
        ByteArrayOutputStream deep = new ByteArrayOutputStream();
        ImageFiles.toPng(image, deep, new ImageFiles.PngOptions(16, Map.of()));
        all.add(deep.toByteArray());
        ByteArrayOutputStream shown = new ByteArrayOutputStream();
        ImageFiles.toExr(image.toDisplay(), shown, ImageFiles.ExrOptions.DEFAULT);
        all.add(shown.toByteArray());
        return all;
    }

    private static void assertSame(RenderResult expected, RenderResult actual) throws IOException {
        assertTrue(actual.complete());
        List<byte[]> inMemory = files(expected.image());
        List<byte[]> inFile = files(actual.image());
        for (int i = 0; i < inMemory.size(); i++) {
            assertArrayEquals(inMemory.get(i), inFile.get(i), "file " + i);
        }
        assertArrayEquals(expected.image().toArray(), actual.image().toArray());
        assertEquals(expected.report().sampling(), actual.report().sampling());
        assertEquals(expected.report().pixels(), actual.report().pixels());
        assertEquals(Exposure.meanDisplayed(expected.image()), Exposure.meanDisplayed(actual.image()));
        assertEquals(Exposure.automatic(expected.image()), Exposure.automatic(actual.image()));
    }

    private RenderRequest inFile(Kind kind) {
        return RenderRequest.of(kind.scene, kind.settings)
                .withScratch(new RenderRequest.ScratchFolder(folder, NOTHING));
    }

    private static boolean isEmpty(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.findAny().isEmpty();
        }
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void theBytesAreThoseOfThePictureInMemory(Kind kind) throws IOException {
        assertSame(Renderer.render(RenderRequest.of(kind.scene, kind.settings)), Renderer.render(inFile(kind)));
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void aStoppedRenderGoesOnInAFile(Kind kind) throws IOException {
        MemoryArchive archive = new MemoryArchive();
        RenderRequest request = inFile(kind).withArchives(List.of(archive));
        RenderResult part = Renderer.render(request.withCancelled(() -> archive.given >= 2));
        assertFalse(part.complete());
        assertSame(Renderer.render(RenderRequest.of(kind.scene, kind.settings)), Renderer.render(request));
    }

    /** Tiles alone would fit in memory, not with the sums of paths from lights: what watchers see must be of neither half. */
    @Test
    void aWatchedPictureWhosePathsFromLightsDoNotFitIsMadeInAFile() throws IOException {
        RenderSettings settings = of(CAUSTICS, BuiltInMethod.RAYTRACE, 16);
        long tiles = PictureMemory.of(CAUSTICS, settings, PictureMemory.Films.TILES, 0)
                .bytes();
        AtomicInteger seen = new AtomicInteger();
        RenderRequest request = RenderRequest.of(CAUSTICS, settings)
                .withScratch(new RenderRequest.ScratchFolder(folder, tiles + 1))
                .withWatched(true)
                .withProgress((done, total, soFar) -> seen.addAndGet(soFar.get().width()));
        assertSame(Renderer.render(RenderRequest.of(CAUSTICS, settings)), Renderer.render(request));
        assertTrue(seen.get() > 0);
    }

    /**
     * Nothing is allocated per pixel for a picture that was stopped before it was planned: three floats per pixel would be more than the
     * memory of the process.
     */
    @Test
    void aLargePictureThatIsStoppedWhileItIsPlannedTakesNoMemory() throws IOException, InterruptedException {
        long image = 3L * Float.BYTES * LARGE_WIDTH * LARGE_HEIGHT;
        assertTrue(image > (long) HEAP_MIB << 20, image + " bytes would fit");
        ProcessBuilder builder = JavaProcess.of(PictureInFileTest.class, folder).redirectErrorStream(true);
        builder.command().replaceAll(o -> o.startsWith("-Xmx") ? "-Xmx" + HEAP_MIB + "m" : o);
        Process process = builder.start();
        String output = new String(process.getInputStream().readAllBytes());
        assertEquals(0, process.waitFor(), output);
        assertTrue(output.contains("complete: false, shown pixels: 0"), output);
    }

    /** Stops a large picture while it is planned. */
    public static void main(String[] args) {
        RenderSettings settings = of(ROOM, BuiltInMethod.RAYTRACE, 1)
                .withSize(LARGE_WIDTH, LARGE_HEIGHT)
                .withBudget(RenderSettings.Budget.NONE.withError(0.001));
        AtomicInteger asked = new AtomicInteger();
        RenderResult stopped = Renderer.render(RenderRequest.of(ROOM, settings)
                .withScratch(new RenderRequest.ScratchFolder(Path.of(args[0]), NOTHING))
                .withCancelled(() -> asked.incrementAndGet() > 20));
        System.out.println("complete: " + stopped.complete() + ", shown pixels: " + stopped.shownPixels());
    }

    @Test
    void samplesThatAreKeptAreGoneOnFrom() throws IOException {
        RenderSettings few = of(ROOM, BuiltInMethod.RAYTRACE, 4);
        RenderSettings many = of(ROOM, BuiltInMethod.RAYTRACE, 16);
        RenderRequest request = inFile(new Kind("", ROOM, few)).withArchives(List.of(new MemoryArchive()));
        assertTrue(Renderer.render(request).complete());
        RenderResult more = Renderer.render(request.withSettings(many));
        assertSame(Renderer.render(RenderRequest.of(ROOM, many)), more);
    }

    @Test
    void roundsOfAnErrorAreThoseOfAPictureInMemory() throws IOException {
        RenderSettings settings =
                of(FIRE, BuiltInMethod.RAYTRACE, 1).withBudget(RenderSettings.Budget.NONE.withError(0.02));
        Kind kind = new Kind("", FIRE, settings);
        assertSame(Renderer.render(RenderRequest.of(FIRE, settings)), Renderer.render(inFile(kind)));
    }

    @Test
    void noFileIsLeftNorSeen() throws IOException {
        Kind kind = kinds().findFirst().orElseThrow();
        AtomicInteger seen = new AtomicInteger();
        RenderRequest request = inFile(kind).withCancelled(() -> {
            try {
                seen.addAndGet(isEmpty(folder) ? 0 : 1);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            return false;
        });
        Image image = Renderer.render(request).image();
        assertTrue(isEmpty(folder));
        // Where the system can remove a file that is open, it has no name from the beginning.
        if (!System.getProperty("os.name").startsWith("Windows")) {
            assertEquals(0, seen.get());
        }
        assertEquals(45, image.width());
    }

    @Test
    void whatNeedsThePictureInMemorySaysSo() {
        RenderSettings huge = of(ROOM, BuiltInMethod.RAYTRACE, 1).withSize(60_000, 60_000);
        InvalidValueException e = assertThrows(
                InvalidValueException.class,
                () -> Renderer.render(inFile(new Kind("", ROOM, huge)).withProgressive(true)));
        assertEquals("size", e.key());
        assertTrue(e.problem().contains("a preview needs all of it in memory"), e.problem());
        assertTrue(e.problem().matches(".*for about \\d+x\\d+ pixels.*"), e.problem());
    }

    @Test
    void aFolderThatIsNotThereIsToldOf() {
        Kind kind = kinds().findFirst().orElseThrow();
        RenderRequest request = RenderRequest.of(kind.scene, kind.settings)
                .withScratch(new RenderRequest.ScratchFolder(folder.resolve("none"), NOTHING));
        UncheckedIOException e = assertThrows(UncheckedIOException.class, () -> Renderer.render(request));
        assertTrue(e.getCause().getMessage().contains("none"), e.getMessage());
    }
}
