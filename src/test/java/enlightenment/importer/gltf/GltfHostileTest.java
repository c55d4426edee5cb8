package enlightenment.importer.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.importer.SceneImporter;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Broken and malicious glTF files are refused by one clear line. */
class GltfHostileTest {
    @TempDir
    Path folder;

    private static GltfFile square() {
        GltfFile file = new GltfFile();
        file.square("");
        file.add("nodes", "{'mesh':0}");
        return file;
    }

    private String problem(byte[] content, String name) throws IOException {
        Path file = Files.write(folder.resolve(name), content);
        SceneException e =
                assertThrows(SceneException.class, () -> SceneImporter.read(file, SceneImporter.Options.DEFAULT));
        assertEquals(1, e.problems().size());
        return e.problems().get(0).message();
    }

    private String problem(String json) throws IOException {
        return problem(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8), "model.gltf");
    }

    private String problem(GltfFile file) throws IOException {
        return problem(file.glb(), "model.glb");
    }

    private static void assertSays(String expected, String said) {
        assertTrue(said.contains(expected), said);
    }

    @Test
    void filesOfOtherKindsAreRefused() throws IOException {
        assertSays("is empty", problem(new byte[0], "model.glb"));
        assertSays("is no JSON text", problem("hello"));
        assertSays("must be an object", problem("[1]"));
        assertSays("asset/version", problem("{}"));
        assertSays("must be 2.0, not \"1.0\"", problem("{'asset':{'version':'1.0'}}"));
        assertSays("nothing to be seen", problem("{'asset':{'version':'2.0'}}"));
    }

    @Test
    void cutFilesAreRefusedWhereverTheyEnd() throws IOException {
        byte[] glb = square().glb();
        for (int length = 4; length < glb.length; length += 7) {
            String said = problem(Arrays.copyOf(glb, length), "model.glb");
            assertSays("is incomplete", said);
        }
    }

    @Test
    void wrongLengthsOfChunksAndBuffersAreRefused() throws IOException {
        byte[] glb = square().glb();
        ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN).putInt(12, -1);
        assertSays("chunk 0: is incomplete: it says 4294967295 bytes", problem(glb, "model.glb"));
        assertSays(
                "bufferViews/0: reaches beyond its buffer",
                problem(square().withDataUri().replaceFirst("\"byteLength\":48", "\"byteLength\":4800")));
        assertSays(
                "buffers/0: says 100000 bytes",
                problem(square().withDataUri()
                        .replaceFirst("\"byteLength\":\\d+,\"uri", "\"byteLength\":100000,\"uri")));
    }

    @Test
    void hugeCountsTakeNoMemory() throws IOException {
        String text = square().withDataUri();
        String huge = text.replaceFirst("\"count\":4", "\"count\":2000000000");
        assertFalse(text.equals(huge));
        assertSays("accessors/0: has 2000000000 elements", problem(huge));
        GltfFile sparse = new GltfFile();
        sparse.add("accessors", "{'type':'VEC3','componentType':5126,'count':2000000000}");
        sparse.add("meshes", "{'primitives':[{'attributes':{'POSITION':0}}]}");
        sparse.add("nodes", "{'mesh':0}");
        assertSays("accessors/0: has 2000000000 elements", problem(sparse));
    }

    @Test
    void accessorsAndIndicesStayInside() throws IOException {
        GltfFile file = new GltfFile();
        int p = file.floats("VEC3", 3, GltfFile.SQUARE);
        int i = file.indices(0, 1, 9);
        file.add("meshes", "{'primitives':[{'attributes':{'POSITION':" + p + "},'indices':" + i + "}]}");
        file.add("nodes", "{'mesh':0}");
        assertSays("meshes/0/primitives/0: index 2 is 9, and there are 4 vertices", problem(file));
        String text = square().withDataUri();
        assertSays("reaches beyond its bufferView", problem(text.replaceFirst("\"count\":4", "\"count\":5")));
        assertSays("nodes/0/mesh: is 7, and there are 1", problem(text.replace("\"mesh\":0", "\"mesh\":7")));
    }

    @Test
    void circlesOfNodesAreRefused() throws IOException {
        GltfFile file = square().with("'scene':0");
        file.add("nodes", "{'children':[2]}");
        file.add("nodes", "{'children':[1]}");
        file.add("scenes", "{'nodes':[0,1]}");
        assertSays("nodes/1: is in the scene twice", problem(file));
        GltfFile self = square();
        self.add("nodes", "{'children':[1]}");
        self.add("scenes", "{'nodes':[1]}");
        assertSays("nodes/1: is in the scene twice", problem(self));
    }

    @Test
    void nodesMayBeNestedAsDeepAsTheyLike() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        int depth = 50_000;
        for (int i = 0; i < depth; i++) {
            file.add("nodes", "{'children':[" + (i + 1) + "]}");
        }
        file.add("nodes", "{'mesh':0}");
        assertEquals("model", file.read(folder).scene().name());
    }

    @Test
    void whatIsCompressedIsRefusedByName() throws IOException {
        for (String name :
                new String[] {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_basisu"}) {
            assertSays(
                    "the file needs \"" + name + "\"", problem(square().with("'extensionsRequired':['" + name + "']")));
        }
    }

    @Test
    void namesOfFilesLeadNowhereElse() throws IOException {
        Files.write(folder.resolve("secret.bin"), new byte[1000]);
        Path inner = Files.createDirectory(folder.resolve("inner"));
        for (String uri : new String[] {"../secret.bin", "%2e%2e/secret.bin", "http://example.org/a.bin"}) {
            Path file = Files.writeString(inner.resolve("model.gltf"), square().gltf(uri));
            SceneException e =
                    assertThrows(SceneException.class, () -> SceneImporter.read(file, SceneImporter.Options.DEFAULT));
            assertSays("buffers/0: ", e.problems().get(0).message());
        }
        assertSays("no base64", problem(square().gltf("data:application/octet-stream;base64,#!")));
        assertSays("not in base64", problem(square().gltf("data:,hello")));
    }

    @Test
    void noMutationOfAFileDoesMoreThanFailWithALine() throws IOException {
        GltfFile file = GltfFile.ofMaterial("{'name':'m','pbrMetallicRoughness':{'baseColorFactor':[1,0.5,0.5,1],"
                + "'metallicFactor':0.5},'emissiveFactor':[0,0,0],'extensions':{'KHR_materials_ior':{'ior':1.4}}}");
        file.add("cameras", "{'type':'perspective','perspective':{'yfov':1,'aspectRatio':1.5,'znear':0.1}}");
        file.add("nodes", "{'camera':0,'translation':[0,0,3],'rotation':[0,0,0,1],'scale':[1,1,1],'children':[]}");
        byte[] whole = file.glb();
        SplittableRandom random = new SplittableRandom(39);
        int refused = 0;
        for (int n = 0; n < 2000; n++) {
            byte[] mutant = mutated(whole, random);
            Path path = Files.write(folder.resolve("mutant.glb"), mutant);
            try {
                SceneImporter.read(path, SceneImporter.Options.DEFAULT);
            } catch (SceneException e) {
                refused++;
                assertEquals(1, e.problems().size());
                String said = e.problems().get(0).message();
                assertFalse(said.isBlank() || said.contains("\n") || said.contains("Exception"), said);
            }
        }
        assertTrue(refused > 500, "only " + refused + " of the mutants were refused");
    }

    private static byte[] mutated(byte[] whole, SplittableRandom random) {
        byte[] mutant = whole.clone();
        int changes = 1 + random.nextInt(4);
        for (int i = 0; i < changes; i++) {
            int at = random.nextInt(mutant.length);
            switch (random.nextInt(4)) {
                case 0 -> mutant[at] = (byte) random.nextInt(256);
                case 1 -> mutant[at] = (byte) ('0' + random.nextInt(10));
                case 2 -> mutant[at] ^= (byte) (1 << random.nextInt(8));
                default -> {
                    int from = random.nextInt(mutant.length);
                    int length = Math.min(random.nextInt(12), mutant.length - Math.max(at, from));
                    System.arraycopy(whole, from, mutant, at, length);
                }
            }
        }
        return random.nextInt(10) == 0 ? Arrays.copyOf(mutant, random.nextInt(mutant.length)) : mutant;
    }
}
