package enlightenment.importer.gltf;

import enlightenment.importer.SceneImporter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A small glTF file in the making: numbers go into one buffer, all else is JSON by hand. */
final class GltfFile {
    static final int UNSIGNED_BYTE = 5121;
    static final int UNSIGNED_SHORT = 5123;
    static final int UNSIGNED_INT = 5125;
    static final int FLOAT = 5126;

    /** The corners of a square that faces +z, counterclockwise from the lower left. */
    static final float[] SQUARE = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

    static final int[] HALVES = {0, 1, 2, 0, 2, 3};

    private final ByteArrayOutputStream buffer = new ByteArrayOutputStream();
    private final Map<String, List<String>> arrays = new LinkedHashMap<>();
    private final List<String> others = new ArrayList<>();

    /** Adds an object to a list of the document; returns its index. */
    int add(String list, String json) {
        List<String> all = arrays.computeIfAbsent(list, k -> new ArrayList<>());
        all.add(json.replace('\'', '"'));
        return all.size() - 1;
    }

    /** Adds a member of the document, such as {@code 'scene': 1}. */
    GltfFile with(String member) {
        others.add(member.replace('\'', '"'));
        return this;
    }

    int view(byte[] bytes, String more) {
        while (buffer.size() % 4 != 0) {
            buffer.write(0);
        }
        int start = buffer.size();
        buffer.writeBytes(bytes);
        return add("bufferViews", "{'buffer':0,'byteOffset':" + start + ",'byteLength':" + bytes.length + more + "}");
    }

    /** An accessor of the numbers of a view of its own. */
    int accessor(String type, int componentType, int count, byte[] bytes, String more) {
        int view = view(bytes, "");
        return add(
                "accessors",
                "{'bufferView':" + view + ",'type':'" + type + "','componentType':" + componentType + ",'count':"
                        + count + more + "}");
    }

    int floats(String type, int components, float... values) {
        return accessor(type, FLOAT, values.length / components, bytes(values), "");
    }

    int indices(int... values) {
        return accessor("SCALAR", UNSIGNED_INT, values.length, ints(values), "");
    }

    static byte[] bytes(float... values) {
        ByteBuffer b = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (float v : values) {
            b.putFloat(v);
        }
        return b.array();
    }

    static byte[] ints(int... values) {
        ByteBuffer b = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int v : values) {
            b.putInt(v);
        }
        return b.array();
    }

    /** A mesh of the square of two triangles, with texture coordinates whose v runs downwards; more is JSON of its primitive. */
    int square(String more) {
        int p = floats("VEC3", 3, SQUARE);
        int uv = floats("VEC2", 2, 0, 1, 1, 1, 1, 0, 0, 0);
        int i = indices(HALVES);
        return add(
                "meshes",
                "{'primitives':[{'attributes':{'POSITION':" + p + ",'TEXCOORD_0':" + uv + "},'indices':" + i + more
                        + "}]}");
    }

    /** A file with the square of a material that this JSON describes. */
    static GltfFile ofMaterial(String material) {
        GltfFile file = new GltfFile();
        file.add("materials", material);
        file.square(",'material':0");
        file.add("nodes", "{'mesh':0}");
        return file;
    }

    /** Adds a texture that shows a picture file, as it stands in a view; returns the texture's index. */
    int texture(byte[] picture) {
        int view = view(picture, "");
        int image = add("images", "{'bufferView':" + view + ",'mimeType':'image/png'}");
        return add("textures", "{'source':" + image + "}");
    }

    private String json(String buffers) {
        StringBuilder text = new StringBuilder("{\"asset\":{\"version\":\"2.0\"}");
        arrays.forEach((key, all) -> text.append(",\"")
                .append(key)
                .append("\":[")
                .append(String.join(",", all))
                .append(']'));
        others.forEach(o -> text.append(',').append(o));
        return text.append(buffers).append('}').toString();
    }

    /** The document, with the buffer at this URI. */
    String gltf(String uri) {
        return json(",\"buffers\":[{\"byteLength\":" + buffer.size() + ",\"uri\":\"" + uri + "\"}]");
    }

    String withDataUri() {
        return gltf(
                "data:application/octet-stream;base64," + Base64.getEncoder().encodeToString(buffer.toByteArray()));
    }

    byte[] buffer() {
        return buffer.toByteArray();
    }

    byte[] glb() {
        byte[] text =
                json(",\"buffers\":[{\"byteLength\":" + buffer.size() + "}]").getBytes(StandardCharsets.UTF_8);
        int textSize = (text.length + 3) / 4 * 4;
        int binSize = (buffer.size() + 3) / 4 * 4;
        ByteBuffer out = ByteBuffer.allocate(12 + 8 + textSize + 8 + binSize).order(ByteOrder.LITTLE_ENDIAN);
        out.put("glTF".getBytes(StandardCharsets.US_ASCII)).putInt(2).putInt(out.capacity());
        out.putInt(textSize).put("JSON".getBytes(StandardCharsets.US_ASCII)).put(text);
        for (int i = text.length; i < textSize; i++) {
            out.put((byte) ' ');
        }
        out.putInt(binSize).put("BIN\0".getBytes(StandardCharsets.US_ASCII)).put(buffer.toByteArray());
        return out.array();
    }

    /** What the importer makes of it, as a GLB file in a folder; pictures go to the folder "extracted" there. */
    SceneImporter.Result read(Path folder) throws IOException {
        return read(folder, glb());
    }

    static SceneImporter.Result read(Path folder, byte[] glb) throws IOException {
        Path file = folder.resolve("model.glb");
        Files.write(file, glb);
        Path extracted = folder.resolve("extracted" + System.nanoTime());
        return SceneImporter.read(file, SceneImporter.Options.DEFAULT.withExtracted(extracted));
    }
}
