package enlightenment.importer.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/**
 * Reads accessors: numbers of all component types, normalized or not, interleaved or not, with sparse values over them. Each is decoded once.
 * What all of them hold is limited by the size of the file, so that a few bytes cannot ask for much memory.
 */
final class GltfAccessors {
    /** Numbers that any file may have, and how many more for each of its bytes: accessors may share bytes. */
    private static final long FREE = 1_000_000;

    private static final long PER_BYTE = 16;

    private static final Map<String, Integer> COMPONENTS =
            Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4, "MAT2", 4, "MAT3", 9, "MAT4", 16);

    /** Elements of equal size. */
    record Numbers(float[] values, int components) {
        int count() {
            return values.length / components;
        }
    }

    private final GltfElement document;
    private final GltfBuffers buffers;
    private final Map<Integer, Numbers> numbers = new HashMap<>();
    private final Map<Integer, int[]> indices = new HashMap<>();
    private long decoded;

    GltfAccessors(GltfElement document, GltfBuffers buffers) {
        this.document = document;
        this.buffers = buffers;
    }

    /**
     * The numbers of an accessor; whole numbers become floats, normalized ones their fraction of the maximum.
     *
     * @param types the types of elements that are expected, such as VEC3
     */
    Numbers numbers(GltfElement owner, String key, String... types) throws IOException {
        int index = index(owner, key);
        GltfElement accessor = document.item("accessors", index);
        if (!Arrays.asList(types).contains(accessor.text("type", ""))) {
            throw accessor.failure("must be of type " + String.join(" or ", types) + " for " + key);
        }
        if (!numbers.containsKey(index)) {
            numbers.put(index, read(accessor));
        }
        return numbers.get(index);
    }

    private int index(GltfElement owner, String key) throws IOException {
        return owner.index(key, document.size("accessors")).orElseThrow(() -> owner.failure("lacks \"" + key + "\""));
    }

    /** The whole numbers of a scalar accessor: unsigned. Those beyond the range of int become -1. */
    int[] indices(GltfElement owner, String key) throws IOException {
        int index = index(owner, key);
        if (!indices.containsKey(index)) {
            GltfElement accessor = document.item("accessors", index);
            ComponentType type = ComponentType.of(accessor);
            if (!accessor.text("type", "").equals("SCALAR") || !type.isIndex()) {
                throw accessor.failure("must be of type SCALAR and of unsigned whole numbers, for indices");
            }
            indices.put(index, readIndices(accessor, type));
        }
        return indices.get(index);
    }

    private int[] readIndices(GltfElement accessor, ComponentType type) throws IOException {
        int count = count(accessor, 1);
        if (accessor.get("sparse").isPresent() || !accessor.has("bufferView")) {
            Numbers all = read(accessor);
            int[] whole = new int[count];
            for (int i = 0; i < count; i++) {
                whole[i] = all.values[i] <= 1 << 24 ? (int) all.values[i] : -1;
            }
            return whole;
        }
        Strided at = strided(accessor, accessor.whole("byteOffset", 0), count, type.bytes());
        int[] whole = new int[count];
        for (int i = 0; i < count; i++) {
            whole[i] = type.whole(at.bytes, at.offset(i));
        }
        return whole;
    }

    private int components(GltfElement accessor) throws IOException {
        Integer n = COMPONENTS.get(accessor.text("type", ""));
        if (n == null) {
            throw accessor.failure("must have a \"type\": SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
        }
        return n;
    }

    /** How many elements there are, after checking that they are not too many. */
    private int count(GltfElement accessor, int components) throws IOException {
        long count = accessor.whole("count");
        long most = FREE + PER_BYTE * buffers.size();
        if (count < 1 || count > most / components || decoded + count * components > most) {
            throw accessor.failure(
                    "has " + count + " elements: more than a file of " + buffers.size() + " bytes can have, or none");
        }
        decoded += count * components;
        return (int) count;
    }

    private Numbers read(GltfElement accessor) throws IOException {
        int components = components(accessor);
        int count = count(accessor, components);
        ComponentType type = ComponentType.of(accessor);
        if (components > 4 && type != ComponentType.FLOAT) {
            throw accessor.failure("holds matrices of whole numbers, which are not read");
        }
        boolean isNormalized = accessor.flag("normalized");
        float[] values;
        if (accessor.has("bufferView")) {
            Strided at = strided(accessor, accessor.whole("byteOffset", 0), count, components * type.bytes());
            values = new float[count * components];
            for (int i = 0; i < count; i++) {
                read(at, i, i, components, type, isNormalized, values);
            }
        } else {
            values = new float[count * components];
        }
        addSparse(accessor, components, type, isNormalized, values);
        return new Numbers(values, components);
    }

    private static void read(
            Strided from, int element, int to, int components, ComponentType type, boolean normalized, float[] out) {
        int at = from.offset(element);
        for (int c = 0; c < components; c++) {
            out[to * components + c] = type.number(from.bytes, at + c * type.bytes(), normalized);
        }
    }

    private void addSparse(GltfElement accessor, int components, ComponentType type, boolean normalized, float[] out)
            throws IOException {
        GltfElement sparse = accessor.get("sparse");
        if (!sparse.isPresent()) {
            return;
        }
        long count = sparse.whole("count");
        int elements = out.length / components;
        if (count > elements) {
            throw sparse.failure("has " + count + " elements, and its accessor " + elements);
        }
        GltfElement indices = sparse.get("indices");
        GltfElement values = sparse.get("values");
        ComponentType indexType = ComponentType.of(indices);
        if (!indexType.isIndex()) {
            throw indices.failure("must be of unsigned whole numbers");
        }
        int n = (int) count;
        Strided at = strided(indices, indices.whole("byteOffset", 0), n, indexType.bytes());
        Strided from = strided(values, values.whole("byteOffset", 0), n, components * type.bytes());
        for (int i = 0; i < n; i++) {
            int to = indexType.whole(at.bytes, at.offset(i));
            if (to < 0 || to >= elements) {
                throw indices.failure("element " + i + " is beyond the accessor, which has " + elements);
            }
            read(from, i, to, components, type, normalized, out);
        }
    }

    /** Elements in a view, each a number of bytes after the one before. */
    private record Strided(ByteBuffer bytes, long start, long stride) {
        int offset(int element) {
            return (int) (start + element * stride);
        }
    }

    private Strided strided(GltfElement owner, long start, int count, int bytes) throws IOException {
        int view = owner.index("bufferView", document.size("bufferViews"))
                .orElseThrow(() -> owner.failure("lacks \"bufferView\""));
        long stride = document.item("bufferViews", view).whole("byteStride", 0);
        if (stride != 0 && (stride < bytes || stride > 252)) {
            throw owner.failure("has elements of " + bytes + " bytes, which do not fit a byteStride of " + stride);
        }
        stride = stride == 0 ? bytes : stride;
        ByteBuffer all = buffers.view(view);
        if (count > 0 && (start > all.limit() || (count - 1) * stride + bytes > all.limit() - start)) {
            throw owner.failure("reaches beyond its bufferView: " + count + " elements of " + bytes
                    + " bytes from byte " + start + " of " + all.limit());
        }
        return new Strided(all, start, stride);
    }
}
