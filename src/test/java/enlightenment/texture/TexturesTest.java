package enlightenment.texture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The pictures in textures/, as docs/notes/textures.md describes them. */
class TexturesTest {
    private static final Path ROOT = Path.of(System.getProperty("project.directory", "."));
    private static final Path TEXTURES = ROOT.resolve("textures");
    private static final Map<String, String> SIZES = new TreeMap<>(Map.ofEntries(
            Map.entry("brushed.png", "256 x 256"),
            Map.entry("cloth.png", "256 x 256"),
            Map.entry("dial.png", "768 x 768"),
            Map.entry("earth.png", "1024 x 512"),
            Map.entry("fire.png", "1024 x 512"),
            Map.entry("floor.png", "512 x 512"),
            Map.entry("hammered.png", "256 x 256"),
            Map.entry("ice.png", "1024 x 512"),
            Map.entry("leaf-shape.png", "256 x 256"),
            Map.entry("leaf.png", "256 x 256"),
            Map.entry("leather.png", "256 x 256"),
            Map.entry("oak.png", "512 x 512"),
            Map.entry("slate.png", "256 x 256"),
            Map.entry("orientation.png", "512 x 512"),
            Map.entry("sky.png", "512 x 512"),
            Map.entry("stone.png", "512 x 512"),
            Map.entry("wall-back.png", "512 x 512"),
            Map.entry("wall-left.png", "512 x 512"),
            Map.entry("wall-right.png", "512 x 512"),
            Map.entry("waves.png", "512 x 512"),
            Map.entry("wood.png", "512 x 512")));

    @Test
    void allTexturesDecodeAndHaveTheDocumentedSizes() throws IOException {
        Map<String, String> found = new TreeMap<>();
        long bytes = 0;
        try (Stream<Path> files = Files.list(TEXTURES)) {
            for (Path file : files.filter(f -> f.toString().endsWith(".png")).collect(Collectors.toList())) {
                ImageTexture image = ImageTexture.read(file);
                found.put(file.getFileName().toString(), image.width() + " x " + image.height());
                bytes += Files.size(file);
            }
        }
        assertEquals(SIZES, found);
        assertTrue(bytes < 3_000_000, "textures take " + bytes + " bytes");
        String documentation = Files.readString(ROOT.resolve("docs/notes/textures.md"));
        SIZES.forEach((name, size) -> assertTrue(
                documentation.contains("`" + name + "` | " + size.replace("x", "×")), name + " is not documented"));
    }

    @Test
    void spheresHaveNoSeamAndNoPinch() throws IOException {
        for (String name : new String[] {"ice.png", "fire.png", "earth.png"}) {
            Image image = ImageFiles.read(TEXTURES.resolve(name));
            double within = 0;
            double across = 0;
            for (int y = 0; y < 512; y++) {
                for (int c = 0; c < 3; c++) {
                    within += Math.abs(image.component(512 + 20, y, c) - image.component(512 + 21, y, c));
                    across += Math.abs(image.component(1023, y, c) - image.component(0, y, c));
                }
            }
            assertTrue(across < 2 * within + 5, name + ": " + across + " across the seam, " + within + " within");
            for (int x = 1; x < 1024; x++) {
                assertEquals(image.component(0, 0, 0), image.component(x, 0, 0), 0.15, name + " at the pole");
            }
        }
    }

    @Tag("full")
    @Test
    void theGeneratorPaintsTheSamePixelsAgain(@TempDir Path folder) throws Exception {
        Path java = Path.of(System.getProperty("java.home"), "bin", "java");
        Path generator = TEXTURES.resolve("generate/Textures.java");
        Process process = new ProcessBuilder(java.toString(), generator.toString(), folder.toString())
                .inheritIO()
                .start();
        assertEquals(0, process.waitFor());
        List<String> painted;
        try (Stream<Path> files = Files.list(folder)) {
            painted = files.map(f -> f.getFileName().toString()).sorted().toList();
        }
        assertEquals(9, painted.size(), painted::toString);
        for (String name : painted) {
            assertArrayEquals(
                    ImageFiles.read(TEXTURES.resolve(name)).toArgb(),
                    ImageFiles.read(folder.resolve(name)).toArgb(),
                    name);
        }
    }
}
