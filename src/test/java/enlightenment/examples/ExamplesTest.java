package enlightenment.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The programs of src/examples, compiled as a stranger would, and run at a small size without a display. */
@Timeout(600)
class ExamplesTest {
    private static final Path PROJECT = Path.of(System.getProperty("project.directory", "."));
    private static final Path SOURCES = PROJECT.resolve("src/examples/java");
    private static final int MOST_LINES = 120;

    @TempDir
    static Path classes;

    @TempDir
    Path folder;

    private static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.list(SOURCES)) {
            return files.filter(f -> f.toString().endsWith(".java")).sorted().toList();
        }
    }

    /** As a module, whose packages that are not exported cannot be seen. */
    @BeforeAll
    static void compile() throws IOException {
        List<String> arguments = new ArrayList<>(List.of(
                "--release",
                "17",
                "-Xlint:all",
                "-Werror",
                "--add-modules",
                "enlightenment",
                "--module-path",
                PROJECT.resolve("target/classes") + File.pathSeparator + jackson(),
                "-d",
                classes.toString()));
        sources().forEach(file -> arguments.add(file.toString()));
        StringWriter said = new StringWriter();
        PrintWriter writer = new PrintWriter(said, true);
        int code = ToolProvider.findFirst("javac").orElseThrow().run(writer, writer, arguments.toArray(String[]::new));
        assertEquals(0, code, said::toString);
    }

    private static String jackson() {
        return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .filter(entry -> Path.of(entry).getFileName().toString().startsWith("jackson-core-"))
                .findFirst()
                .orElseThrow();
    }

    /** Runs a program in this process; returns what it printed. */
    private static String run(String program, Object... arguments) throws Exception {
        String[] args = Arrays.stream(arguments).map(Object::toString).toArray(String[]::new);
        PrintStream before = System.out;
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        System.setOut(new PrintStream(said, true, StandardCharsets.UTF_8));
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {classes.toUri().toURL()})) {
            loader.loadClass(program).getMethod("main", String[].class).invoke(null, (Object) args);
        } finally {
            System.setOut(before);
        }
        return said.toString(StandardCharsets.UTF_8);
    }

    /** A square of 1 by 1 that faces the viewer, as a GLB. */
    private Path square() throws IOException {
        float[] corners = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
        String json = ("{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],"
                        + "'meshes':[{'primitives':[{'attributes':{'POSITION':0},'indices':1}]}],"
                        + "'accessors':[{'bufferView':0,'componentType':5126,'count':4,'type':'VEC3','min':[0,0,0],'max':[1,1,0]},"
                        + "{'bufferView':1,'componentType':5123,'count':6,'type':'SCALAR'}],"
                        + "'bufferViews':[{'buffer':0,'byteLength':48},{'buffer':0,'byteOffset':48,'byteLength':12}],"
                        + "'buffers':[{'byteLength':60}]}")
                .replace('\'', '"');
        byte[] text = (json + " ".repeat(-json.length() & 3)).getBytes(StandardCharsets.US_ASCII);
        ByteBuffer glb = ByteBuffer.allocate(12 + 8 + text.length + 8 + 60).order(ByteOrder.LITTLE_ENDIAN);
        glb.putInt(0x46546C67).putInt(2).putInt(glb.capacity());
        glb.putInt(text.length).putInt(0x4E4F534A).put(text);
        glb.putInt(60).putInt(0x004E4942);
        for (float f : corners) {
            glb.putFloat(f);
        }
        for (int i : new int[] {0, 1, 2, 0, 2, 3}) {
            glb.putShort((short) i);
        }
        return Files.write(folder.resolve("square.glb"), glb.array());
    }

    /** A shipped scene of 40 by 20 pixels. */
    private Path scene() throws IOException {
        String text = Files.readString(PROJECT.resolve("scenes/cone.json"));
        String small = text.replace("\"width\": 800, \"height\": 400", "\"width\": 40, \"height\": 20");
        assertTrue(!small.equals(text), "cone.json has another size");
        return Files.writeString(folder.resolve("small.json"), small);
    }

    private static int colors(Image image) {
        Set<Integer> colors = new HashSet<>();
        for (int argb : image.toArgb()) {
            colors.add(argb);
        }
        return colors.size();
    }

    @Test
    void aThumbnailHasTheSizeAskedForAndShowsSomething() throws Exception {
        Path picture = folder.resolve("thumbnail.png");
        run("Thumbnail", square(), picture, 32);
        Image image = ImageFiles.read(picture);
        assertEquals(32, image.width());
        assertEquals(32, image.height());
        assertTrue(colors(image) > 10);
    }

    @Test
    void aTurntableHasFramesThatDiffer() throws Exception {
        Path frames = folder.resolve("frames");
        run("Turntable", square(), frames, 2, 24);
        byte[] front = Files.readAllBytes(frames.resolve("000.png"));
        byte[] back = Files.readAllBytes(frames.resolve("001.png"));
        assertTrue(!Arrays.equals(front, back));
        assertTrue(Files.notExists(frames.resolve("002.png")));
    }

    @Test
    void aChartHasItsLargestBarWhereTheLargestNumberIs() throws Exception {
        Path picture = folder.resolve("chart.png");
        run("BarChart", picture, "48x30", 1, 9);
        Image large = ImageFiles.read(picture);
        run("BarChart", picture, "48x30", 9, 1);
        Image other = ImageFiles.read(picture);
        assertTrue(redness(large, 24, 48) > redness(large, 0, 24), "the marker is on the left");
        assertTrue(redness(other, 0, 24) > redness(other, 24, 48), "the marker is on the right");
    }

    /** How many pixels of some columns are red: the marker is, and nothing else. */
    private static int redness(Image image, int from, int to) {
        int red = 0;
        for (int y = 0; y < image.height(); y++) {
            for (int x = from; x < to; x++) {
                boolean isRed = image.component(x, y, 0) > 2 * image.component(x, y, 1)
                        && image.component(x, y, 1) < 1.5 * image.component(x, y, 2);
                red += isRed ? 1 : 0;
            }
        }
        return red;
    }

    @Test
    void theModelOfTheSwingProgramCountsToAHundred() throws Exception {
        assertEquals("100 %, complete: true", run("ProgressInSwing", scene()).strip());
    }

    @Test
    void twoWorkersMakeThePictureOfOneProcess() throws Exception {
        String said = run("ManyMachines", scene(), folder.resolve("picture.png"));
        assertEquals(
                2,
                said.lines().filter(line -> line.startsWith("a worker made ")).count(),
                said);
        assertTrue(said.contains("same bits: true"), said);
    }

    @Test
    void eachFitsOnTwoScreensAndIsListed() throws IOException {
        String page = Files.readString(PROJECT.resolve("docs/guide/java-examples.md"));
        assertEquals(5, sources().size());
        for (Path file : sources()) {
            int lines = Files.readAllLines(file).size();
            assertTrue(lines <= MOST_LINES, file + " has " + lines + " lines");
            assertTrue(page.contains("src/examples/java/" + file.getFileName()), file + " is not listed");
        }
    }
}
