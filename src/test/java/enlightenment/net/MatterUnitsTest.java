package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.net.parts.RenderParts;
import enlightenment.physical.MatterScenes;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Media, dyes, dispersion, pictures and skies: threads, tiles, crops, parts and workers make the same bytes, in every method. */
@Timeout(600)
class MatterUnitsTest {
    @TempDir
    static Path images;

    private static Map<String, Scene> scenes;

    @TempDir
    Path folder;

    @BeforeAll
    static void makeScenes() {
        scenes = MatterScenes.all(images);
    }

    static Stream<String> names() {
        return MatterScenes.NAMES.stream();
    }

    static Stream<Arguments> all() {
        return names().flatMap(name -> Stream.of(BuiltInMethod.values())
                .filter(method -> Method.supports(method, scenes.get(name)))
                .map(method -> Arguments.of(name, method)));
    }

    private static RenderSettings settings(Scene scene, BuiltInMethod method) {
        return RenderSettings.of(scene)
                .withMethod(method)
                .withAntialias(2)
                .withThreads(1)
                .withTileSize(9);
    }

    private static float[] picture(Scene scene, RenderSettings settings) {
        return Renderer.render(scene, settings).toArray();
    }

    @ParameterizedTest
    @MethodSource("all")
    void threadsTilesCropsPartsAndOtherEnginesMakeTheSame(String name, BuiltInMethod method) throws Exception {
        Scene scene = scenes.get(name);
        RenderSettings settings = settings(scene, method);
        Image whole = Renderer.render(scene, settings);
        float[] expected = whole.toArray();
        assertArrayEquals(expected, picture(scene, settings.withThreads(3).withTileSize(16)));
        Crop crop = new Crop(7, 5, 9, 6);
        Image part = Renderer.render(scene, settings.withCrop(crop));
        for (int i = 0; i < crop.width() * crop.height() * 3; i++) {
            int x = i / 3 % crop.width();
            int y = i / 3 / crop.width();
            assertEquals(whole.component(crop.x() + x, crop.y() + y, i % 3), part.component(x, y, i % 3));
        }
        assertArrayEquals(expected, byParts(scene, settings));
        assertArrayEquals(expected, byContents(scene, settings));
    }

    private float[] byParts(Scene scene, RenderSettings settings) throws Exception {
        List<Path> files = new ArrayList<>();
        for (int part = 1; part <= 2; part++) {
            Path file = folder.resolve(part + ".film");
            assertTrue(RenderParts.render(RenderRequest.of(scene, settings), part, 2, n -> Map.of(), file));
            files.add(file);
        }
        RenderParts.Merged all = RenderParts.merge(files, Optional.empty());
        assertEquals(List.of(), all.missing());
        return all.result().image().toArray();
    }

    /** What a worker does: it knows the job's contents, and no file. */
    private static float[] byContents(Scene scene, RenderSettings settings) throws Exception {
        try (EngineJob job = EngineJob.start(scene, settings, null, text -> {}, () -> false)) {
            IntFunction<byte[]> maker = EngineJob.makers(job.contents()).get();
            for (int unit : job.missing()) {
                job.put(unit, maker.apply(unit), "one");
            }
            return job.result().image().toArray();
        }
    }

    @ParameterizedTest
    @MethodSource("names")
    void aServerWithTwoWorkersMakesTheSame(String name) throws Exception {
        Scene scene = scenes.get(name);
        RenderSettings settings = settings(scene, BuiltInMethod.RAYTRACE);
        try (Farm farm = new Farm(scene, settings, Farm.options().awaitWorkers(2, Farm.TIMEOUT_SECONDS)).begin()) {
            farm.join(Farm.worker(1));
            farm.join(Farm.worker(1));
            assertArrayEquals(picture(scene, settings), farm.result().image().toArray());
        }
    }

    /** The parts of light add up to the picture; albedo is a share of light, and of dyes more than one at most. */
    @ParameterizedTest
    @MethodSource("names")
    void directAndIndirectLightAreThePictureAndAlbedoIsAShare(String name) {
        Scene scene = scenes.get(name);
        RenderSettings settings = settings(scene, BuiltInMethod.RAYTRACE);
        EnumSet<RenderResult.Auxiliary> kinds = EnumSet.of(
                RenderResult.Auxiliary.DIRECT, RenderResult.Auxiliary.INDIRECT, RenderResult.Auxiliary.ALBEDO);
        RenderResult result = Renderer.render(RenderRequest.of(scene, settings).withAuxiliary(kinds));
        float[] whole = result.image().toArray();
        float[] direct = result.auxiliary().get(RenderResult.Auxiliary.DIRECT).toArray();
        float[] indirect =
                result.auxiliary().get(RenderResult.Auxiliary.INDIRECT).toArray();
        float[] albedo = result.auxiliary().get(RenderResult.Auxiliary.ALBEDO).toArray();
        double most = 0;
        for (int i = 0; i < whole.length; i++) {
            double sum = (double) direct[i] + indirect[i];
            assertEquals(whole[i], sum, 1e-6 * (Math.abs(direct[i]) + Math.abs(indirect[i])));
            assertTrue(albedo[i] >= 0 && albedo[i] < 2, "albedo " + albedo[i]);
            most = Math.max(most, albedo[i]);
        }
        assertTrue(most > 0.2, "albedo " + most);
    }
}
