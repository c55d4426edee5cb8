package enlightenment.importer.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.geometry.Mesh;
import enlightenment.importer.SceneImporter;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What meshes and nodes of glTF files become. */
class GltfMeshTest {
    private static final TriangleMesh SQUARE = TriangleMesh.of(GltfFile.SQUARE, GltfFile.HALVES);

    @TempDir
    Path folder;

    private static GltfFile ofPrimitive(GltfFile file, String primitive) {
        file.add("meshes", "{'primitives':[" + primitive + "]}");
        file.add("nodes", "{'mesh':0}");
        return file;
    }

    private Mesh mesh(GltfFile file) throws IOException {
        return mesh(file.read(folder), 0);
    }

    private static Mesh mesh(SceneImporter.Result imported, int index) {
        return (Mesh) imported.scene().objects().get(index).shape();
    }

    private static Vec3 placed(Mesh mesh, Vec3 p) {
        return mesh.transform().apply(p).toVec3();
    }

    @Test
    void theSameModelIsReadFromEveryKindOfFile() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        file.add("nodes", "{'mesh':0,'name':'a square'}");
        Path beside = Files.createDirectory(folder.resolve("beside"));
        Files.write(beside.resolve("the buffer.bin"), file.buffer());
        Path external = Files.writeString(beside.resolve("model.gltf"), file.gltf("the%20buffer.bin"));
        Path inline = Files.writeString(folder.resolve("model.gltf"), file.withDataUri());
        SceneImporter.Result first = file.read(folder);
        TriangleMesh expected = SQUARE.withUv(new float[] {0, 0, 1, 0, 1, 1, 0, 1});
        assertEquals(Mesh.of(expected), mesh(first, 0));
        assertEquals("a square", first.scene().objects().get(0).name());
        assertEquals(first, SceneImporter.read(external, SceneImporter.Options.DEFAULT));
        assertEquals(first, SceneImporter.read(inline, SceneImporter.Options.DEFAULT));
    }

    /** The trap "uv origin": the picture's top, v = 0 in glTF, is v = 1 in our meshes. */
    @Test
    void uvOriginIsAtTheTop() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        file.add("nodes", "{'mesh':0}");
        TriangleMesh mesh = mesh(file).triangles();
        for (int i = 0; i < mesh.vertices(); i++) {
            assertEquals(mesh.position(i).y(), mesh.uv(i, 1), "v grows upwards, as y does");
        }
    }

    @Test
    void stripsAndFansFaceOneSide() throws IOException {
        GltfFile strip = new GltfFile();
        int p = strip.floats("VEC3", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0);
        TriangleMesh ladder = mesh(ofPrimitive(strip, "{'attributes':{'POSITION':" + p + "},'mode':5}"))
                .triangles();
        assertEquals(3, ladder.triangles());
        assertFaces(ladder);
        GltfFile fan = new GltfFile();
        int q = fan.floats("VEC3", 3, GltfFile.SQUARE);
        TriangleMesh round = mesh(ofPrimitive(fan, "{'attributes':{'POSITION':" + q + "},'mode':6}"))
                .triangles();
        assertEquals(2, round.triangles());
        assertFaces(round);
    }

    private static void assertFaces(TriangleMesh mesh) {
        for (int t = 0; t < mesh.triangles(); t++) {
            Vec3 a = mesh.position(mesh.vertex(t, 0));
            Vec3 b = mesh.position(mesh.vertex(t, 1));
            Vec3 c = mesh.position(mesh.vertex(t, 2));
            assertTrue(b.minus(a).cross(c.minus(a)).z() > 0, "triangle " + t + " faces +z");
        }
    }

    @Test
    void pointsAndLinesAreLeftOutWithANote() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        int p = file.floats("VEC3", 3, GltfFile.SQUARE);
        file.add("meshes", "{'primitives':[{'attributes':{'POSITION':" + p + "},'mode':1}]}");
        file.add("nodes", "{'mesh':0}");
        file.add("nodes", "{'mesh':1}");
        assertTrue(file.read(folder).notes().contains("meshes/1/primitives/0: lines are left out"));
    }

    @Test
    void quantizedNumbersAreFractions() throws IOException {
        GltfFile file = new GltfFile();
        byte one = (byte) 255;
        byte[] bytes = {0, 0, 0, 9, one, 0, 0, 9, one, one, 0, 9, 0, one, 0, 9};
        int view = file.view(bytes, ",'byteStride':4");
        file.add(
                "accessors",
                "{'bufferView':" + view + ",'type':'VEC3','componentType':5121,'normalized':true,'count':4}");
        int i = file.accessor("SCALAR", GltfFile.UNSIGNED_BYTE, 6, new byte[] {0, 1, 2, 0, 2, 3}, "");
        file.with("'extensionsRequired':['KHR_mesh_quantization']");
        assertEquals(
                SQUARE,
                mesh(ofPrimitive(file, "{'attributes':{'POSITION':0},'indices':" + i + "}"))
                        .triangles());
    }

    @Test
    void signedQuantizedNumbersEndAtMinusOne() throws IOException {
        GltfFile file = new GltfFile();
        byte[] shorts = new byte[24];
        short[] values = {-32768, -32767, 0, 32767, 0, 0, 0, 32767, 0};
        java.nio.ByteBuffer b = java.nio.ByteBuffer.wrap(shorts).order(java.nio.ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < 9; i++) {
            b.putShort(i / 3 * 8 + i % 3 * 2, values[i]);
        }
        int view = file.view(shorts, ",'byteStride':8");
        file.add(
                "accessors",
                "{'bufferView':" + view + ",'type':'VEC3','componentType':5122,'normalized':true,'count':3}");
        TriangleMesh expected = TriangleMesh.of(new float[] {-1, -1, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        assertEquals(
                expected,
                mesh(ofPrimitive(file, "{'attributes':{'POSITION':0}}")).triangles());
    }

    @Test
    void sparseElementsReplaceThoseOfTheView() throws IOException {
        for (boolean hasView : List.of(true, false)) {
            GltfFile file = new GltfFile();
            // Without a view all are zeros, and three of the four have to be replaced.
            int[] which = hasView ? new int[] {2} : new int[] {1, 2, 3};
            float[] values = hasView ? new float[] {1, 1, 0} : new float[] {1, 0, 0, 1, 1, 0, 0, 1, 0};
            int base = file.view(GltfFile.bytes(0, 0, 0, 1, 0, 0, 7, 7, 7, 0, 1, 0), "");
            int at = file.view(GltfFile.ints(which), "");
            int what = file.view(GltfFile.bytes(values), "");
            file.add(
                    "accessors",
                    "{" + (hasView ? "'bufferView':" + base + "," : "")
                            + "'type':'VEC3','componentType':5126,'count':4,'sparse':{'count':" + which.length
                            + ",'indices':{'bufferView':" + at + ",'componentType':5125},'values':{'bufferView':" + what
                            + "}}}");
            int i = file.indices(GltfFile.HALVES);
            assertEquals(
                    SQUARE,
                    mesh(ofPrimitive(file, "{'attributes':{'POSITION':0},'indices':" + i + "}"))
                            .triangles());
        }
    }

    @Test
    void verticesMayBeInterleavedAndPartOfALargerBuffer() throws IOException {
        GltfFile file = new GltfFile();
        float[] both = new float[24];
        for (int v = 0; v < 4; v++) {
            System.arraycopy(GltfFile.SQUARE, 3 * v, both, 6 * v, 3);
            both[6 * v + 5] = 1;
        }
        int view = file.view(GltfFile.bytes(both), ",'byteStride':24");
        file.add("accessors", "{'bufferView':" + view + ",'type':'VEC3','componentType':5126,'count':4}");
        file.add(
                "accessors",
                "{'bufferView':" + view + ",'byteOffset':12,'type':'VEC3','componentType':5126,'count':4}");
        int i = file.indices(GltfFile.HALVES);
        TriangleMesh expected = SQUARE.withNormals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
        assertEquals(
                expected,
                mesh(ofPrimitive(file, "{'attributes':{'POSITION':0,'NORMAL':1},'indices':" + i + "}"))
                        .triangles());
    }

    @Test
    void aMeshHoldsTheVerticesThatItsTrianglesUse() throws IOException {
        GltfFile file = new GltfFile();
        float[] many = new float[3 * 100];
        for (int i = 0; i < 100; i++) {
            many[3 * i] = i;
            many[3 * i + 1] = i % 7;
        }
        int p = file.floats("VEC3", 3, many);
        int i = file.indices(90, 50, 71);
        TriangleMesh mesh = mesh(ofPrimitive(file, "{'attributes':{'POSITION':" + p + "},'indices':" + i + "}"))
                .triangles();
        assertEquals(3, mesh.vertices());
        assertEquals(new Vec3(90, 90 % 7, 0), mesh.position(mesh.vertex(0, 0)));
    }

    /** The trap "row or column order of matrices": offsets are the last four numbers. */
    @Test
    void columnOrderOfMatrices() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        file.add("nodes", "{'mesh':0,'matrix':[0,2,0,0, -3,0,0,0, 0,0,4,0, 5,6,7,1]}");
        Mesh mesh = mesh(file);
        assertEquals(new Vec3(5, 8, 7), placed(mesh, Vec3.X));
        assertEquals(new Vec3(2, 6, 7), placed(mesh, Vec3.Y));
        assertEquals(new Vec3(5, 6, 11), placed(mesh, Vec3.Z));
    }

    @Test
    void nodesScaleThenTurnThenMove() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        double h = Math.sqrt(0.5);
        // A quarter of a turn about z, counterclockwise; below it a node that moves.
        file.add(
                "nodes",
                "{'children':[1],'translation':[10,0,0],'rotation':[0,0," + h + "," + h + "],'scale':[2,3,1]}");
        file.add("nodes", "{'mesh':0,'translation':[1,0,0]}");
        Vec3 p = placed(mesh(file), Vec3.Y);
        // (1, 1, 0) scaled is (2, 3, 0), turned (-3, 2, 0).
        assertEquals(0, p.minus(new Vec3(7, 2, 0)).length(), 1e-14);
    }

    @Test
    void scalesOfMinusOneMirror() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        file.add("nodes", "{'mesh':0,'scale':[-1,1,1]}");
        Mesh mesh = mesh(file);
        assertEquals(new Vec3(-1, 1, 0), placed(mesh, new Vec3(1, 1, 0)));
        assertTrue(mesh.transform().isMirror());
    }

    @Test
    void whatIsScaledToNothingIsLeftOutWithANote() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        file.add("nodes", "{'mesh':0}");
        file.add("nodes", "{'mesh':0,'scale':[0,0,0]}");
        SceneImporter.Result imported = file.read(folder);
        assertTrue(
                imported.notes().toString().contains("nodes/1: its mesh is left out"),
                imported.notes().toString());
    }

    @Test
    void nodesShareTheTrianglesOfAMesh() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        file.add("nodes", "{'mesh':0,'name':'a'}");
        file.add("nodes", "{'mesh':0,'name':'a','translation':[3,0,0]}");
        SceneImporter.Result imported = file.read(folder);
        assertSame(mesh(imported, 0).triangles(), mesh(imported, 1).triangles());
        assertEquals("a 2", imported.scene().objects().get(1).name());
    }

    @Test
    void instancesAreObjectsOfTheirOwn() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        int t = file.floats("VEC3", 3, 1, 0, 0, 2, 0, 0);
        int s = file.floats("VEC3", 3, 1, 1, 1, 5, 5, 5);
        file.add(
                "nodes",
                "{'mesh':0,'translation':[0,0,7],'extensions':{'EXT_mesh_gpu_instancing':{'attributes':"
                        + "{'TRANSLATION':" + t + ",'SCALE':" + s + "}}}}");
        SceneImporter.Result imported = file.read(folder);
        List<Vec3> seen = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            seen.add(placed(mesh(imported, i), Vec3.Y));
        }
        assertEquals(List.of(new Vec3(1, 1, 7), new Vec3(2, 5, 7)), seen);
    }

    @Test
    void onlyTheSceneThatIsNamedIsRead() throws IOException {
        GltfFile file = new GltfFile().with("'scene':1");
        file.square("");
        file.add("nodes", "{'mesh':0,'name':'first'}");
        file.add("nodes", "{'mesh':0,'name':'second'}");
        file.add("scenes", "{'nodes':[0]}");
        file.add("scenes", "{'nodes':[1]}");
        assertEquals("second", file.read(folder).scene().objects().get(0).name());
    }

    @Test
    void coloursOfVerticesAreLeftOutWithANote() throws IOException {
        GltfFile file = new GltfFile();
        int p = file.floats("VEC3", 3, GltfFile.SQUARE);
        ofPrimitive(file, "{'attributes':{'POSITION':" + p + ",'COLOR_0':" + p + "},'mode':6}");
        assertEquals(
                List.of("meshes/0/primitives/0: colours of vertices are left out"),
                file.read(folder).notes());
    }

    /** What is bound goes with its joints, not with its node. */
    @Test
    void boundMeshesStandWhereTheirJointsAre() throws IOException {
        GltfFile file = new GltfFile();
        file.square("");
        int inverse = file.floats("MAT4", 16, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1);
        file.add("skins", "{'joints':[1],'inverseBindMatrices':" + inverse + "}");
        file.add("nodes", "{'mesh':0,'skin':0,'translation':[100,0,0]}");
        file.add("nodes", "{'translation':[0,2,0],'scale':[3,3,3]}");
        // (0, 1) is at (0, -1) of the joint, which makes it three times as large and stands at (0, 2).
        assertEquals(new Vec3(0, -1, 0), placed(mesh(file), Vec3.Y));
    }
}
