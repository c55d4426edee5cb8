package enlightenment.cli.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import enlightenment.cli.CliRun;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Bad numbers and degenerate things, from the file to the exit code (numerics, N39 and N40). */
class BadDocumentsTest {
    /** Stands in a row's text before the value that must be blamed; it is taken out of the document. */
    private static final String BLAME = "¤";

    private static final String SPHERE = "{ 'type': 'sphere', 'center': [0, 0, 0], 'radius': 1, 'material': 'white' }";
    private static final String IMAGE = "'image': { 'width': 8, 'height': 8 }";
    private static final String CAMERA = "'camera': { 'type': 'perspective', 'eye': [0, 0, -5], 'lookAt': [0, 0, 0],"
            + " 'up': [0, 1, 0], 'fieldOfView': 40 }";

    @TempDir
    Path folder;

    /**
     * One document.
     *
     * @param name what is wrong with it
     * @param image the part of that name, as all parts with ' for "
     * @param camera the camera
     * @param light the only light, or ""
     * @param object the fourth object
     * @param pointer the JSON pointer that the message must name
     * @param said what the message must say besides
     */
    record Row(
            String name, String image, String camera, String light, String object, String pointer, List<String> said) {
        @Override
        public String toString() {
            return name;
        }

        String marked() {
            return String.join(
                            "\n",
                            "{ " + image + ",",
                            "  " + camera + ",",
                            "  'materials': { 'white': { 'type': 'matte', 'color': '#ffffff' } },",
                            "  'lights': [ " + light + " ],",
                            "  'objects': [ " + SPHERE + ", " + SPHERE + ",",
                            "    " + SPHERE + ",",
                            "    " + object + " ] }",
                            "")
                    .replace('\'', '"');
        }

        String document() {
            return marked().replace(BLAME, "");
        }

        /** "line:column" of the value to blame. */
        String place() {
            String before = marked().substring(0, marked().indexOf(BLAME));
            int line = (int) before.chars().filter(c -> c == '\n').count() + 1;
            return line + ":" + (before.length() - before.lastIndexOf('\n'));
        }
    }

    private static Row object(String name, String object, String pointer, String... said) {
        return new Row(name, IMAGE, CAMERA, "", object, "/objects/3" + pointer, List.of(said));
    }

    private static Row radius(String text, String... said) {
        String object = "{ 'type': 'sphere', 'center': [0, 0, 0], 'radius': " + (text.contains(BLAME) ? "" : BLAME)
                + text + ", 'material': 'white' }";
        return object("radius " + text.replace(BLAME, ""), object, "/radius", said);
    }

    private static Row shape(String name, String shape, String pointer, String... said) {
        return object(
                name, (shape.contains(BLAME) ? "" : BLAME) + "{ " + shape + ", 'material': 'white' }", pointer, said);
    }

    private static Row light(String name, String light, String pointer, String... said) {
        return new Row(
                name,
                IMAGE,
                CAMERA,
                "{ " + light + ", 'color': '#ffffff' }",
                SPHERE,
                "/lights/0" + pointer,
                List.of(said));
    }

    private static Row camera(String name, String camera, String pointer, String... said) {
        return new Row(name, IMAGE, "'camera': " + camera, "", SPHERE, "/camera" + pointer, List.of(said));
    }

    private static Row image(String width, String height, String pointer, String... said) {
        String image = "'image': { 'width': " + width + ", 'height': " + height + " }";
        return new Row(
                (width + "x" + height).replace(BLAME, ""),
                image,
                CAMERA,
                "",
                SPHERE,
                "/image" + pointer,
                List.of(said));
    }

    static Stream<Row> badNumbers() {
        String finite = "must be a finite number, not ";
        String holds = "must be a number that a double can hold";
        return Stream.of(
                radius("NaN", finite + "NaN"),
                radius("Infinity", finite + "Infinity"),
                radius("-Infinity", finite + "-Infinity"),
                radius("1e999", holds, "not 1e999"),
                radius("-1e309", holds, "not -1e309"),
                radius("1e-400", "must be 0 or a number that a double can hold", "not 1e-400"),
                radius("1e-324", "must be 0 or a number that a double can hold", "not 1e-324"),
                radius("1e1000000000", holds, "not 1e1000000000"),
                radius("1e-1000000000", holds, "not 1e-1000000000"),
                radius("1e99999999999999999999", holds, "not 1e99999999999999999999"),
                radius("null", "must be a number, not null"),
                radius("'1'", "must be a number, not", "\"1\""),
                radius("'NaN'", "must be a number, not", "\"NaN\""),
                radius("true", "must be a number, not true"),
                radius("[1]", "must be a number, not an array"),
                radius("{}", "must be a number, not an object"),
                radius("1" + "0".repeat(2300), "has 2301 digits"),
                object(
                        "radius missing",
                        "¤{ 'type': 'sphere', 'center': [0, 0, 0], 'material': 'white' }",
                        "/radius",
                        "missing"),
                object(
                        "center of an infinite coordinate",
                        "{ 'type': 'sphere', 'center': [0, ¤1e400, 0], 'radius': 1, 'material': 'white' }",
                        "/center/1",
                        "not 1e400"),
                object(
                        "center of a coordinate without end",
                        "{ 'type': 'sphere', 'center': [0, 0, ¤1e1000000000], 'radius': 1, 'material': 'white' }",
                        "/center/2",
                        "not 1e1000000000"),
                object(
                        "center of two coordinates",
                        "{ 'type': 'sphere', 'center': ¤[0, 0], 'radius': 1, 'material': 'white' }",
                        "/center",
                        "must be a position [x, y, z]"),
                camera(
                        "field of view NaN",
                        "{ 'type': 'perspective', 'eye': [0, 0, -5], 'lookAt': [0, 0, 0], 'up': [0, 1, 0],"
                                + " 'fieldOfView': ¤NaN }",
                        "/fieldOfView",
                        finite + "NaN"),
                light(
                        "light radius 1e999",
                        "'type': 'sphere', 'center': [0, 3, 0], 'radius': ¤1e999",
                        "/radius",
                        holds));
    }

    static Stream<Row> notNumbers() {
        return Stream.of(
                radius("1d", "\"1d\" is not a number"),
                radius("0x1p3", "\"0x1p3\" is not a number"),
                radius("+1", "\"+1\" is not a number"),
                radius(".5", "\".5\" is not a number"),
                radius("1.", "\"1.\" is not a number"),
                radius("01", "\"01\" is not a number"),
                radius("1e", "\"1e\" is not a number"),
                radius("nan", "\"nan\" needs double quotes"));
    }

    static Stream<Row> degenerateShapes() {
        String positive = "must be a number greater than 0, not ";
        String line = "lie in one line";
        return Stream.of(
                radius("0", positive + "0.0"),
                radius("-0.0", positive + "-0.0"),
                radius("-1", positive + "-1.0"),
                shape(
                        "cylinder of no length",
                        "'type': 'cylinder', 'base': [1, 2, 3], 'top': ¤[1.0, 20e-1, 3], 'radius': 1",
                        "/top",
                        "must differ from \"base\""),
                shape(
                        "cylinder of radius 0",
                        "'type': 'cylinder', 'base': [1, 2, 3], 'top': [1, 2, 4], 'radius': ¤0",
                        "/radius",
                        positive),
                shape(
                        "cone of no height",
                        "'type': 'cone', 'base': [1, 2, 3], 'apex': ¤[1, 2, 3], 'radius': 1",
                        "/apex",
                        "must differ from \"base\""),
                shape(
                        "cone of a negative top",
                        "'type': 'cone', 'base': [0, 0, 0], 'apex': [0, 1, 0], 'radius': 1, 'topRadius': ¤-1e-300",
                        "/topRadius",
                        "must be a number of at least 0"),
                shape(
                        "torus without tube",
                        "'type': 'torus', 'center': [0, 0, 0], 'axis': [0, 1, 0], 'majorRadius': 1, 'minorRadius': ¤0",
                        "/minorRadius",
                        positive),
                shape(
                        "torus that is all tube",
                        "'type': 'torus', 'center': [0, 0, 0], 'axis': [0, 1, 0], 'majorRadius': 1,"
                                + " 'minorRadius': ¤1.0000000000000002",
                        "/minorRadius",
                        "must be at most \"majorRadius\"",
                        "1.0000000000000002"),
                shape(
                        "torus without axis",
                        "'type': 'torus', 'center': [0, 0, 0], 'axis': ¤[0, 0, 0], 'majorRadius': 1, 'minorRadius': 0.1",
                        "/axis",
                        "direction other than (0, 0, 0)"),
                shape(
                        "disk of radius 0",
                        "'type': 'disk', 'center': [0, 0, 0], 'normal': [0, 1, 0], 'radius': ¤0",
                        "/radius",
                        positive),
                shape("cube of radius 0", "'type': 'cube', 'center': [0, 0, 0], 'radius': ¤0", "/radius", positive),
                shape(
                        "box of no height",
                        "'type': 'box', 'min': [0, 1, 0], 'max': [1, ¤1, 1]",
                        "/max/1",
                        "must be greater than the same coordinate of \"min\""),
                shape(
                        "rectangle of coincident corners",
                        "'type': 'rectangle', 'corners': ¤[[0, 0, 0], [0, 0, 0], [1, 0, 0], [1, 0, 0]]",
                        "/corners",
                        line),
                shape(
                        "rectangle of one point",
                        "'type': 'rectangle', 'corners': ¤[[1, 1, 1], [1, 1, 1], [1, 1, 1], [1, 1, 1]]",
                        "/corners",
                        line),
                shape(
                        "rectangle in one line",
                        "'type': 'rectangle', 'corners': ¤[[0, 0, 0], [1, 1, 1], [3, 3, 3], [2, 2, 2]]",
                        "/corners",
                        line),
                shape(
                        "fourth corner off the plane",
                        "'type': 'rectangle', 'corners': [[0, 0, 0], [0, 4, 0], ¤[4, 4, 4e-6], [4, 0, 0]]",
                        "/corners/2",
                        "must close the parallelogram",
                        "1.0E-6 of the longer edge"),
                shape(
                        "fourth corner off the parallelogram",
                        "'type': 'rectangle', 'corners': [[0, 0, 0], [0, 4, 0], ¤[4.000005, 4, 0], [4, 0, 0]]",
                        "/corners/2",
                        "must close the parallelogram"),
                shape(
                        "triangle in one line",
                        "'type': 'triangle', 'vertices': ¤[[0, 0, 0], [1, 2, 3], [2, 4, 6]]",
                        "/vertices",
                        line),
                shape(
                        "triangle of coincident vertices",
                        "'type': 'triangle', 'vertices': ¤[[0, 0, 0], [1, 2, 3], [1, 2, 3]]",
                        "/vertices",
                        line));
    }

    static Stream<Row> degenerateLightsAndViews() {
        String window = "{ 'type': 'window', 'eye': %s, 'lowerLeft': %s, 'upperLeft': %s, 'upperRight': %s,"
                + " 'lowerRight': %s }";
        return Stream.of(
                light("light of radius 0", "'type': 'sphere', 'center': [0, 3, 0], 'radius': ¤0", "/radius", "not 0.0"),
                light(
                        "light of radius -1",
                        "'type': 'sphere', 'center': [0, 3, 0], 'radius': ¤-1",
                        "/radius",
                        "not -1.0"),
                light(
                        "light of zero area",
                        "'type': 'rectangle', 'corners': ¤[[0, 3, 0], [0, 3, 1], [0, 3, 3], [0, 3, 2]]",
                        "/corners",
                        "must span an area"),
                light(
                        "light of an open corner",
                        "'type': 'rectangle', 'corners': [[0, 3, 0], [0, 3, 1], ¤[1, 3, 2], [1, 3, 0]]",
                        "/corners/2",
                        "must close the parallelogram"),
                camera(
                        "eye in the window",
                        window.formatted(
                                "¤[0.1, 0.7, 0.66]", "[0, 0, 0]", "[0, 1, 1]", "[1, 1.2, 0.8]", "[1, 0.2, -0.2]"),
                        "/eye",
                        "must not lie in the window's plane"),
                camera(
                        "eye on the window's corner",
                        window.formatted("¤[0, 0, 0]", "[0, 0, 0]", "[0, 1, 0]", "[1, 1, 0]", "[1, 0, 0]"),
                        "/eye",
                        "must not lie in the window's plane"),
                camera(
                        "window in one line",
                        BLAME + window.formatted("[0, 0, -3]", "[0, 0, 0]", "[1, 0, 0]", "[3, 0, 0]", "[2, 0, 0]"),
                        "",
                        "lie in one line"),
                camera(
                        "window of one point",
                        BLAME + window.formatted("[0, 0, -3]", "[0, 0, 0]", "[0, 0, 0]", "[0, 0, 0]", "[0, 0, 0]"),
                        "",
                        "lie in one line"),
                camera(
                        "window that does not close",
                        window.formatted("[0, 0, -3]", "[0, 0, 0]", "[0, 1, 0]", "¤[1, 1.1, 0]", "[1, 0, 0]"),
                        "/upperRight",
                        "must close the parallelogram"),
                camera(
                        "view from the point it looks at",
                        "{ 'type': 'perspective', 'eye': [1, 2, 3], 'lookAt': ¤[1, 2, 3], 'up': [0, 1, 0],"
                                + " 'fieldOfView': 40 }",
                        "/lookAt",
                        "differ"),
                camera(
                        "view along up",
                        "{ 'type': 'perspective', 'eye': [0, 0, 0], 'lookAt': [0, 2, 0], 'up': ¤[0, -1, 0],"
                                + " 'fieldOfView': 40 }",
                        "/up",
                        "line of sight"),
                camera(
                        "flat angle of view",
                        "{ 'type': 'perspective', 'eye': [0, 0, 0], 'lookAt': [0, 0, 2], 'up': [0, 1, 0],"
                                + " 'fieldOfView': ¤180 }",
                        "/fieldOfView",
                        "between 0 and 180 degrees, not 180.0"),
                camera(
                        "drawing of no height",
                        "{ 'type': 'isometric', 'lookAt': [0, 0, 0], 'height': ¤0 }",
                        "/height",
                        "greater than 0, not 0.0"));
    }

    static Stream<Row> impossibleSizes() {
        String sides = "must be a whole number in 1..65536, not ";
        return Stream.of(
                image("¤0", "8", "/width", sides + "0"),
                image("8", "¤0", "/height", sides + "0"),
                image("¤-1", "8", "/width", sides + "-1"),
                image("8", "¤-1", "/height", sides + "-1"),
                image("¤1.5", "8", "/width", sides + "1.5"),
                image("8", "¤65537", "/height", sides + "65537"),
                image("¤4294967297", "8", "/width", sides + "4294967297"),
                image("¤1e300", "8", "/width", sides + "1e300"),
                image("¤'8'", "8", "/width", sides.substring(0, sides.length() - 1), "\"8\""));
    }

    /** Reading a document takes less than two million; neither a picture nor anything else that is too large is begun. */
    private static final long MOST_BYTES = 1 << 24;

    /** The first run of a process loads classes; what that takes is not the document's. */
    @BeforeAll
    static void warmUp(@TempDir Path folder) throws IOException {
        CliRun.of("render", CliRun.badScene(folder), "-o", folder.resolve("x.png"));
    }

    @ParameterizedTest
    @MethodSource({"badNumbers", "notNumbers", "degenerateShapes", "degenerateLightsAndViews", "impossibleSizes"})
    void whatCannotBeRenderedIsRefusedWithItsPlaceAndReason(Row row) throws IOException {
        Path scene = Files.writeString(folder.resolve("scene.json"), row.document());
        Path picture = folder.resolve("picture.png");
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long begin = thread.getCurrentThreadAllocatedBytes();
        CliRun run = CliRun.of("render", scene, "-o", picture, "--progress", "none");
        long bytes = thread.getCurrentThreadAllocatedBytes() - begin;
        assertEquals(2, run.code(), run.err());
        assertEquals(1, run.errLines().size(), run.err());
        String start = scene + ":" + row.place() + ": " + row.pointer() + ": ";
        assertTrue(run.err().startsWith(start), () -> run.err() + "does not begin with\n" + start);
        for (String part : row.said()) {
            assertTrue(run.err().contains(part), () -> run.err() + "does not say\n" + part);
        }
        assertEquals("", run.out());
        assertFalse(Files.exists(picture));
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(List.of(scene), files.toList());
        }
        assertTrue(bytes < MOST_BYTES, bytes + " bytes");
    }

    static Stream<Row> acceptable() {
        return Stream.of(
                shape(
                        "fourth corner almost there",
                        "'type': 'rectangle', 'corners':"
                                + " [[0, 0, 0], [0, 4, 0], [4.000000002, 4, 3e-9], [4, 0, 0]]",
                        ""),
                shape(
                        "fourth corner rounded as a double",
                        "'type': 'rectangle', 'corners':"
                                + " [[0.1, 0.2, 0.3], [0.1, 0.5, 0.3], [0.8, 0.7, 0.6], [0.8, 0.4, 0.6]]",
                        ""),
                shape(
                        "horn torus",
                        "'type': 'torus', 'center': [0, 0, 0], 'axis': [0, 1, 0], 'majorRadius': 1,"
                                + " 'minorRadius': 1",
                        ""),
                shape("smallest ball", "'type': 'sphere', 'center': [0, 0, 0], 'radius': 4.9e-324", ""),
                shape("long exponent of zero", "'type': 'sphere', 'center': [0e400, 0e-400, -0.0], 'radius': 1", ""),
                light(
                        "light that almost closes",
                        "'type': 'rectangle', 'corners':" + " [[0, 3, 0], [0, 3, 1], [1, 3, 1.000000001], [1, 3, 0]]",
                        ""),
                image("1", "1", ""),
                image("1", "4096", ""),
                image("4096", "1", ""),
                image("16384", "2", ""));
    }

    @ParameterizedTest
    @MethodSource("acceptable")
    void whatIsUnusualButSoundIsRendered(Row row) throws IOException {
        Path scene = Files.writeString(folder.resolve("scene.json"), row.document());
        Path picture = folder.resolve("picture.pfm");
        CliRun run = CliRun.of("render", scene, "-o", picture, "--progress", "none", "--antialias", 1);
        assertEquals(new CliRun(0, "", ""), run);
        assertTrue(Files.size(picture) > 12);
    }

    @ParameterizedTest
    @CsvSource({"cylinder, top", "cone, apex"})
    void endsThatNoDoubleTellsApartMakeAWafer(String type, String key) throws IOException {
        String object = "{ 'type': '" + type + "', 'base': [1, 1, 1], '" + key
                + "': [1, 1, 1.00000000000000000001], 'radius': 1, 'material': 'white' }";
        Path scene = Files.writeString(
                folder.resolve("scene.json"), object(type, object, "").document());
        Path picture = folder.resolve("picture.png");
        assertEquals(
                new CliRun(0, "", ""),
                CliRun.of("render", scene, "-o", picture, "--progress", "none", "--antialias", 1));
        assertTrue(Files.exists(picture));
    }

    @Test
    void aPictureBeyondTheMemoryIsRefusedWithItsBytes() throws IOException {
        Path scene = Files.writeString(
                folder.resolve("scene.json"), image("65536", "65536", "").document());
        Path picture = folder.resolve("picture.png");
        // Without a preview the pixels may be in a file. Film, picture and error take 52 bytes, the coarse picture
        // takes 12.
        CliRun run = CliRun.of("render", scene, "-o", picture, "--preview");
        assertEquals(2, run.code());
        String start =
                scene + ":1:12: /image: a picture of 65536x65536 pixels needs 274877906944 bytes of memory; at most ";
        assertTrue(run.err().startsWith(start), run.err());
        assertTrue(run.err().contains("; a preview needs all of it in memory"), run.err());
        assertFalse(Files.exists(picture));
    }
}
