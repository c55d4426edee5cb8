package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class ForeignFormatTest {
    private static Optional<ForeignFormat> of(String name, String content) {
        byte[] bytes = content.getBytes(StandardCharsets.ISO_8859_1);
        return ForeignFormat.of(name, bytes, bytes.length);
    }

    /** Beginnings as the programs write them. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    PLY        | 'ply\\nformat ascii 1.0\\n'
                    PLY        | 'ply\\r\\nformat binary_little_endian 1.0\\r\\n'
                    STL        | 'solid cube\\n  facet normal 0 0 1\\n'
                    STL        | 'solid\\nendsolid\\n'
                    GLTF       | 'glTF\\002\\000\\000\\000'
                    GLTF       | '{"asset":{"generator":"Khronos glTF Blender I/O","version":"2.0"},"scene":0}'
                    GLTF       | '{ "scenes": [{}], "nodes": [], "asset": { "version": "2.0" } }'
                    FBX        | 'Kaydara FBX Binary  \\000'
                    FBX        | '; FBX 7.4.0 project file\\n'
                    BLENDER    | 'BLENDER-v402'
                    SERIALIZED | '\\034\\004\\004\\000x'
                    USD        | '#usda 1.0\\n('
                    USD        | 'PXR-USDC'
                    COLLADA    | '<?xml version="1.0"?>\\n<COLLADA xmlns="x" version="1.4.1">'
                    MITSUBA    | '<scene version="3.0.0">'
                    MITSUBA    | '<?xml version="1.0"?>\\n<!-- a box -->\\n<scene type="x" version="0.6.0">'
                    XML        | '<?xml version="1.0"?>\\n<note/>'
                    NFF        | 'v\\nfrom 0 0 1\\nat 0 0 0\\n'
                    NFF        | '# balls\\nv \\nfrom 0 0 1\\n'
                    OBJ        | '# Blender 4.2\\nmtllib a.mtl\\no Cube\\nv 1.0 -1.0 1e-3\\n'
                    OBJ        | 'v 0 0 0\\nv 1 0 0\\n'
                    PBRT       | '# killeroo\\nLookAt 3 4 1.5  .5 .5 0  0 0 1\\n'
                    PBRT       | 'Film "rgb" "string filename" "a.exr"\\n'
                    POV_RAY    | '// a ball\\n#include "colors.inc"\\n'
                    POV_RAY    | '/* a\\nball */ camera { location <0, 1, 2> }'
                    """)
    void whatAFileIsShowsItsContentWhateverItsName(ForeignFormat format, String escaped) {
        String content = escaped.translateEscapes();
        assertEquals(Optional.of(format), of("scene.json", content));
        assertEquals(Optional.of(format), of("", "\u00ef\u00bb\u00bf" + content), "after a byte order mark");
    }

    @Test
    void aBinaryStlFileIsAsLongAsItsTrianglesWant() {
        byte[] file = ByteBuffer.allocate(84 + 2 * 50)
                .order(ByteOrder.LITTLE_ENDIAN)
                .put("{ solid".getBytes(StandardCharsets.US_ASCII))
                .putInt(80, 2)
                .array();
        assertEquals(Optional.of(ForeignFormat.STL), ForeignFormat.of("a.json", file, file.length));
        assertEquals(Optional.empty(), ForeignFormat.of("a.json", file, file.length + 1));
        assertEquals(Optional.empty(), ForeignFormat.of("", new byte[84], 84));
    }

    @ParameterizedTest
    @CsvSource({
        "OBJ, model.obj",
        "PLY, model.PLY",
        "STL, model.stl",
        "GLTF, model.glb",
        "GLTF, model.gltf",
        "XML, scene.xml",
        "PBRT, scene.pbrt",
        "BLENDER, a.b.blend",
        "POV_RAY, scene.pov",
        "SERIALIZED, mesh.serialized",
        "FBX, model.fbx",
        "USD, model.usd",
        "USD, model.usdz",
        "COLLADA, model.dae",
        "NFF, balls.nff"
    })
    void theExtensionDecidesWhereTheContentDoesNot(ForeignFormat format, String name) {
        assertEquals(Optional.of(format), of(name, "\u0028\u00b5/compressed"));
        assertEquals(Optional.empty(), of(name, " { \"image\": {} }"), "meant as a scene");
        assertEquals(Optional.empty(), of(name, ""), "empty");
    }

    @Test
    void whatIsNeitherKnownByContentNorByNameIsNot() {
        for (String content :
                List.of("", "{", "[1]", "\"v 1 2 3\"", "hello", "plywood", "// {", "v is a letter", "solid")) {
            for (String name : List.of("", "obj", "scene.json", "a.obj.json")) {
                assertEquals(Optional.empty(), of(name, content), content);
            }
        }
    }

    @Test
    void noShippedSceneIsTakenForOne() throws IOException {
        try (Stream<Path> scenes = Files.walk(Path.of("scenes"))) {
            for (Path scene : scenes.filter(f -> f.toString().endsWith(".json")).toList()) {
                byte[] bytes = Files.readAllBytes(scene);
                assertEquals(Optional.empty(), ForeignFormat.of("a.obj.gltf.json", bytes, bytes.length), scene + "");
            }
        }
    }

    /** Long files of one kind of line must not exhaust the stack. */
    @Test
    void aLongStartOfBlanksOrCommentsIsLookedThrough() {
        for (String part : List.of(" ", "\n", "# a\n", "// a\n", "/* a */", "/*" + "*".repeat(9), "o a\n", "<", "{")) {
            String content = part.repeat(ForeignFormat.START / part.length());
            assertEquals(Optional.empty(), of("scene.json", content), part);
        }
    }

    @ParameterizedTest
    @EnumSource
    void eachSaysInOneLineWhatCanBeDone(ForeignFormat format) {
        String said = format.refusal();
        assertEquals(1, said.lines().count());
        assertEquals(
                true, said.contains("docs/guide/scene-format.md") || said.contains("'enlightenment convert"), said);
    }
}
